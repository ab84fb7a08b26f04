"""Reference cases, what computes them, and when a value passes."""
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

import aktina

# What a method's numbers are, and so which tolerance they are held to.
ANALYTIC = "analytic"  # double precision: the case's own tolerance
SAMPLED = "sampled"    # by samples, or approximate by design: the case's tolerance_sampled
FLOAT = "float"        # 32-bit: 1e-5 + 1e-4 |x|, whatever the case says

TOLERANCE_FLOAT = {"abs": 1e-5, "rel": 1e-4}


@dataclass
class Case:
    """One case, and what stands in its file beside the cases."""

    id: str
    kind: str
    inputs: dict
    expected: dict
    tolerance: dict
    tolerance_sampled: dict
    header: dict
    others: dict = field(repr=False, default_factory=dict)  # by id, of the same file


@dataclass
class Method:
    """Computes some of the expected values of a kind: `compute(case)` gives {key of expected: value}. `resolves(case)`
    is false for cases that are too fine for what the method can do by design."""

    id: str
    accuracy: str
    compute: Callable
    resolves: Callable = lambda case: True


def ids(family):
    """The methods of a family; none where the catalogue does not hold it."""
    return [method["id"] for method in aktina.methods() if method["family"] == family]


def tolerance_of(case, accuracy):
    if accuracy == FLOAT:
        return TOLERANCE_FLOAT
    if accuracy == SAMPLED and case.tolerance_sampled:
        return case.tolerance_sampled
    return case.tolerance


def error_over_tolerance(value, expected, tolerance):
    """max |x - expected| / (abs + rel |expected|), at most 1 where it passes; infinity where shapes differ or a value
    is not a finite number."""
    if isinstance(expected, (bool, np.bool_)):
        return 0.0 if bool(value) == expected else np.inf
    expected = np.asarray(expected, np.float64)
    value = np.asarray(value, np.float64)
    if value.shape != expected.shape or expected.size == 0:
        return np.inf
    error = abs(value - expected)
    allowed = tolerance["abs"] + tolerance["rel"] * abs(expected)
    if not (np.isfinite(error).all() and np.isfinite(allowed).all()):
        return np.inf
    ratio = np.divide(error, allowed, out=np.where(error > 0, np.inf, 0.0), where=allowed > 0)
    return float(ratio.max())
