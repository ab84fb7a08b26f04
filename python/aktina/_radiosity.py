"""Radiosity of patches whose form factors are known."""
import numpy as np

from . import _core
from ._arrays import number, numbers
from ._errors import UsageError


def solve_radiosity(F, E, rho, method="matrix", tolerance=1e-12, progress=None):
    """Radiosity B of N diffuse patches: B = E + rho F B, band by band.

    F : (N, N); F[i, j] is the fraction of the light leaving patch i that arrives at j.
    E : (N,) or (N, bands), what each patch emits of itself, lm/m^2 (or W/m^2: any unit of exitance).
    rho : (N,) or (N, bands), diffuse reflectance in [0, 1).
    method : of the family "radiosity": "matrix" (Gauss-Seidel) or "progressive" (progressive refinement).
        "stochastic_jacobi" draws samples: errors of a per cent. "hierarchical", "clustering" and "wavelet_..." take no matrix.
    tolerance : where to stop; relative to the largest B ("matrix") or to the emitted light ("progressive").
    progress : called as progress(stage, unit, done, total, seconds) now and then.
    Returns B like E, float64, in its unit.
    Raises BadParam (negative or not finite; a reflectance that leaves no finite solution), UsageError (shapes).
    Source: goral1984, cohen1988.

    >>> import aktina
    >>> aktina.solve_radiosity([[0, 1], [1, 0]], E=[1, 0], rho=[0.5, 0.8]).round(6).tolist()
    [1.666667, 1.333333]
    """
    F, E, rho = (numbers(name, value, np.float64) for name, value in (("F", F), ("E", E), ("rho", rho)))
    if F.ndim != 2 or F.shape[0] != F.shape[1]:
        raise UsageError(f"has shape {F.shape}", "F", "(N, N)")
    if E.ndim not in (1, 2) or len(E) != len(F):
        raise UsageError(f"has shape {E.shape}", "E", f"({len(F)},) or ({len(F)}, bands)")
    if rho.ndim == 1 and E.ndim == 2:
        rho = rho[:, np.newaxis]
    try:
        rho = np.broadcast_to(rho, E.shape)
    except ValueError:
        raise UsageError(f"has shape {rho.shape}", "rho", f"{E.shape}") from None
    B = np.zeros(E.shape)
    _core.solve_radiosity(method, *(np.ascontiguousarray(values).reshape(-1) for values in (F, E, rho)), B.reshape(-1),
                          number("tolerance", tolerance, 0, 1), progress)
    return B
