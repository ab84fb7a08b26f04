"""Which of Aktina's methods compute which kinds of reference values, and how: one file a family.

A file of reference values is `{family, cases: [{id, kind, inputs, expected, tolerance, ...}]}`; a kind is looked up here by
its name, whatever file it comes from.
"""
from . import illumination, lights, normals, radiosity, rays
from .cases import Method, tolerance_of

KINDS = {kind: methods
         for family in (illumination, lights, normals, radiosity, rays)
         for kind, methods in family.kinds().items()}

__all__ = ["KINDS", "Method", "tolerance_of"]
