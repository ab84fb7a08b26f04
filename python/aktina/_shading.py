"""Shading interpolation: light at points of a triangle, from what is known at its corners."""
import numpy as np

from . import _core
from ._arrays import colours, number, numbers, one_vector, rows, unit_vectors
from ._errors import BadParam, UsageError
from ._illumination import surface_rows

_LATTICE_DEGREE = {1: 0, 3: 1, 6: 2, 10: 3}


def interpolate(method, normals, barycentric, lights, v=(0, 0, 1), eye=None, material=None, model="phong", ambient=0.0,
                positions=((0, 0, 0), (1, 0, 0), (0, 1, 0)), screen=None, weights=(1, 1, 1)):
    """Radiance that a shading method gives points of one triangle.

    method : a method of the family "shading", such as "gouraud".
    normals : (3, 3), unit, at the corners.
    barycentric : (..., 3), points on the screen, each summing to 1.
    lights : list of dictionaries, as `irradiance` takes them.
    v, eye : unit direction towards a viewer at infinity; or, where `eye` is given, the viewer's place, m.
    material, model, ambient : as for `illuminate`.
    positions : (3, 3), m, counter-clockwise seen from the front.
    screen : (3, 2), px, y downwards; x and -y of the positions where left out. Only methods defined on scanlines care.
    weights : (3,), 1 / w of the perspective division at the corners.
    Returns (..., 3) float32, cd/m^2.
    Raises NoSuchMethod, UsageError (a shape), BadParam (a sum that is not 1, NaN).
    Source: the method's own.

    >>> import aktina
    >>> up, tilted = [0, 0, 1], [0.6, 0, 0.8]
    >>> lamp = {"type": "directional", "direction": [0, 0, -1], "illuminance": 3.141593}
    >>> aktina.interpolate("gouraud", [up, tilted, up], [0.5, 0.5, 0], [lamp], material={"kd": 1}).round(3).tolist()
    [0.8999999761581421, 0.8999999761581421, 0.8999999761581421]
    """
    barycentric = rows("barycentric", barycentric, 3, np.float32)
    if (abs(barycentric.sum(-1) - 1) > 1e-3).any():
        raise BadParam("coordinates do not sum to 1", "barycentric")
    positions = _corners("positions", positions, 3)
    screen = positions[:, :2] * np.float32([1, -1]) if screen is None else _corners("screen", screen, 2)
    corners = np.hstack([positions, unit_vectors("normals", _corners("normals", normals, 3)), screen,
                         _corners("weights", np.reshape(weights, (-1, 1)), 1)], dtype=np.float32)
    viewer = unit_vectors("v", one_vector("v", v, np.float32)) if eye is None else one_vector("eye", eye, np.float32)
    out = np.empty(barycentric.shape, np.float32)
    _core.interpolate(method, model, surface_rows(material or {}), list(lights), colours("ambient", ambient), viewer,
                      eye is None, corners, np.ascontiguousarray(barycentric).reshape(-1, 3), out.reshape(-1, 3))
    return out


def interpolate_samples(samples, barycentric):
    """The polynomial through samples on the lattice of a triangle: of degree 0, 1, 2 or 3.

    samples : (n,) or (n, channels): 1 at the centroid; 3 at the corners; 6 at the corners and the middles of the edges
        01, 12, 20; 10 at the corners, at 1/3 and 2/3 of the edges 01, 12, 20, and at the centroid.
    barycentric : (..., 3).
    Returns (...,) or (..., channels) float32.
    Raises UsageError.

    >>> import aktina
    >>> float(aktina.interpolate_samples([0, 0, 1, 0, 0.25, 0.25], [0, 0.5, 0.5]))
    0.25
    """
    samples = np.asarray(samples, np.float32)
    if samples.ndim not in (1, 2) or len(samples) not in _LATTICE_DEGREE:
        raise UsageError(f"has shape {samples.shape}", "samples", "1, 3, 6 or 10 samples")
    barycentric = rows("barycentric", barycentric, 3, np.float32)
    weights = np.empty((*barycentric.shape[:-1], len(samples)), np.float32)
    _core.lagrange(_LATTICE_DEGREE[len(samples)], np.ascontiguousarray(barycentric).reshape(-1, 3),
                   weights.reshape(-1, len(samples)))
    return weights @ samples


def slerp(a, b, t):
    """Unit vectors a share t of the way along great circles: spherical linear interpolation.

    a, b : (..., 3), unit.
    t : (...), 0 at a, 1 at b.
    Returns (..., 3) float32.
    Raises UsageError, BadParam.

    >>> import aktina
    >>> aktina.slerp([1, 0, 0], [0, 1, 0], 1 / 3).round(3).tolist()
    [0.8659999966621399, 0.5, 0.0]
    """
    a, b, t = np.broadcast_arrays(unit_vectors("a", rows("a", a, 3, np.float32)),
                                  unit_vectors("b", rows("b", b, 3, np.float32)),
                                  numbers("t", t, np.float32)[..., np.newaxis])
    out = np.empty(a.shape, np.float32)
    _core.slerp(_flat(a), _flat(b), np.ascontiguousarray(t[..., :1]).reshape(-1, 1), out.reshape(-1, 3))
    return out


def arc_angle(a, b):
    """Angles between unit vectors, rad, accurate for small ones, too.

    a, b : (..., 3), unit.
    Returns (...) float32.
    Raises UsageError, BadParam.

    >>> import aktina
    >>> round(float(aktina.arc_angle([1, 0, 0], [0, 0, 1])), 4)
    1.5708
    """
    a, b = np.broadcast_arrays(unit_vectors("a", rows("a", a, 3, np.float32)),
                               unit_vectors("b", rows("b", b, 3, np.float32)))
    out = np.empty(a.shape[:-1], np.float32)
    _core.arc_angle(_flat(a), _flat(b), out.reshape(-1, 1))
    return out


def interpolate_cosine(method, p, q, t, steps=None):
    """The cosine between two vectors that turn along a span, as a shading method on scanlines has it.

    method : "angular", "angular_decomposed", "angular_combined", "euler" or "lin".
    p, q : (2, 3), unit vectors at the left and the right end.
    t : (...), 0 at the left end, 1 at the right one.
    steps : for "euler": the plain, uncorrected method with so many steps along the span.
    Returns (...) float32, not cut off at 0.
    Raises NoSuchMethod, UsageError, BadParam.
    Source: the method's own.

    >>> import aktina
    >>> n, l = [[0, 0, 1], [1, 0, 0]], [[0, 0, 1], [0, 0, 1]]
    >>> aktina.interpolate_cosine("angular", n, l, [0, 2 / 3, 1]).round(3).tolist()
    [1.0, 0.5, -0.0]
    """
    ends = [unit_vectors(name, rows(name, values, 3, np.float32)) for name, values in (("p", p), ("q", q))]
    if any(end.shape != (2, 3) for end in ends):
        raise UsageError(f"have shapes {ends[0].shape} and {ends[1].shape}", "p, q", "(2, 3)")
    t = numbers("t", t, np.float32)
    out = np.empty(t.shape, np.float32)
    _core.interpolate_cosine(method, _flat(np.stack(ends, axis=1)), 0 if steps is None else number("steps", steps, 1),
                             np.ascontiguousarray(t).reshape(-1, 1), out.reshape(-1, 1))
    return out


def fast_phong_series(screen, normals, l):
    """Bishop and Weimer's coefficients of N.l / |N| on a triangle, X and Y from its centroid on the screen:
    T5 X^2 + T4 X Y + T3 Y^2 + T2 X + T1 Y + T0.

    screen : (3, 2), px; normals : (3, 3), unit, at the corners; l : (3,), unit, towards a light at infinity.
    Returns (6,) float64: T0 .. T5.
    Raises UsageError, BadParam (a triangle without area).
    Source: G. Bishop, D. M. Weimer, "Fast Phong Shading", SIGGRAPH 1986.

    >>> import aktina
    >>> up = [0, 0, 1]
    >>> aktina.fast_phong_series([[0, 0], [0, 3], [3, 0]], [up, up, up], [0, 0.6, 0.8]).round(6).tolist()
    [0.8, 0.0, 0.0, 0.0, 0.0, 0.0]
    """
    out = np.empty((1, 6))
    _core.fast_phong_series(_corners("screen", screen, 2), unit_vectors("normals", _corners("normals", normals, 3)),
                            unit_vectors("l", one_vector("l", l, np.float32)), out)
    return out[0]


def _flat(vectors):
    return np.ascontiguousarray(vectors, np.float32).reshape(-1, 3)


def _corners(name, values, columns):
    array = rows(name, values, columns, np.float32)
    if array.shape != (3, columns):
        raise UsageError(f"has shape {array.shape}", name, f"(3, {columns})")
    return array
