"""Shading interpolation: light at points of a triangle, from what is known at its corners."""
import numpy as np

from . import _core
from ._arrays import colours, one_vector, rows, unit_vectors
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


def _corners(name, values, columns):
    array = rows(name, values, columns, np.float32)
    if array.shape != (3, columns):
        raise UsageError(f"has shape {array.shape}", name, f"(3, {columns})")
    return array
