"""Which of Aktina's methods compute which kinds of reference values, and how: one file a family.

A file of reference values is `{family, cases: [{id, kind, inputs, expected, tolerance, ...}]}`; a kind is looked up here by
its name, whatever file it comes from. Each module of this folder but `cases` gives `kinds()`: {kind: [Method, ...]}.
"""
import importlib
import pkgutil

from .cases import Method, tolerance_of

_FAMILIES = [importlib.import_module(f".{module.name}", __name__)
             for module in pkgutil.iter_modules(__path__) if module.name != "cases"]
KINDS = {kind: methods for family in _FAMILIES for kind, methods in family.kinds().items()}

__all__ = ["KINDS", "Method", "tolerance_of"]
