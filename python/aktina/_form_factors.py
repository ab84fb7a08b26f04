"""Form factors of polygons and simple shapes."""
import numpy as np

from . import _core, _shapes
from ._arrays import rows
from ._errors import UsageError


def form_factor(a, b, method="contour", occluders=()):
    """The fraction of the light leaving `a` that arrives at `b` directly, both diffuse.

    a, b : polygons, (K, 3), m: planar, counter-clockwise seen from the front, which is the only side that takes part;
        or dictionaries:
        {"type": "point", "position", "normal"}: a differential area; as `a` only, to polygons, discs and spheres;
        {"type": "disc", "centre", "normal", "radius"}: from a point, or from a disc on the same axis that faces it;
        {"type": "sphere", "centre", "radius", "inside"}: from a point to its outside, or between two of one centre,
        the outer one of which has "inside" true: outer to inner, inner to outer, or outer to itself past the inner one
        as its only occluder;
        {"type": "sphere_band", "radius", "from", "to"}: the inside of a sphere between two polar angles, rad, from
        anywhere on that sphere's inside;
        {"type": "cap", "radius", "half_angle"} and {"type": "cap_base", ...}: the inside of a spherical cap and the
        disc that closes it.
    method : of the family "formfactor", for polygons; the other shapes have closed forms.
    occluders : polygons that hide, on both sides.
    Returns a float in [0, 1].
    Raises BadInput (a polygon without area, not planar), BadParam, NoSuchMethod, UsageError, Unsupported (a pair of
        shapes that has no closed form).
    Source: schroder1993, baum1989, howell2010.

    >>> import aktina
    >>> floor = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> ceiling = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]]
    >>> round(aktina.form_factor(floor, ceiling), 12)
    0.199824895698
    >>> here = {"type": "point", "position": [0.5, 0.5, 0], "normal": [0, 0, 1]}
    >>> round(aktina.form_factor(here, ceiling), 12)
    0.239456470461
    """
    if isinstance(b, dict) or (isinstance(a, dict) and a.get("type") != "point"):
        return _shapes.form_factor(a, b, list(occluders))
    blocking = [_polygon("occluders", occluder) for occluder in occluders]
    if isinstance(a, dict):
        x, n = _shapes.point(a)
        return _core.form_factor_from_point(x, n, [_polygon("b", b)], blocking, method)
    return _core.form_factor_pair([_polygon("a", a), _polygon("b", b)], blocking, method)


def form_factors(surfaces, occluders=(), method="contour", progress=None):
    """All form factors among N polygons, which hide each other on both sides.

    surfaces : N polygons, each (K, 3), m, as for form_factor().
    occluders : polygons that only hide.
    method : of the family "formfactor"; parameters follow the name: "hemicube:resolution=256".
    progress : called as progress(stage, unit, done, total, seconds) now and then.
    Returns (F, errors), both (N, N) float64: F[i, j] is the fraction of the light leaving i that arrives at j, errors
        the method's own estimate of its absolute error (one standard deviation where it samples).
    Raises BadInput (a polygon without area, not planar), BadParam, NoSuchMethod, LimitExceeded (more than 20,000).

    >>> import aktina
    >>> floor = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> wall = [[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]]
    >>> F, errors = aktina.form_factors([floor, wall])
    >>> F.round(6).tolist()
    [[0.0, 0.200044], [0.200044, 0.0]]
    """
    faces = [_polygon("surfaces", surface) for surface in surfaces]
    blocking = [_polygon("occluders", occluder) for occluder in occluders]
    if len(faces) > 20000:
        _core.form_factor_matrix(faces, blocking, method, progress, np.empty(0), np.empty(0))  # refuses
    F, errors = np.empty((len(faces), len(faces))), np.empty((len(faces), len(faces)))
    _core.form_factor_matrix(faces, blocking, method, progress, F.reshape(-1), errors.reshape(-1))
    return F, errors


def polygon_area(polygon):
    """Area of a planar polygon of any form, m^2.

    polygon : (K, 3), m.  Returns a float.

    >>> import aktina
    >>> aktina.polygon_area([[0, 0, 0], [2, 0, 0], [2, 3, 0]])
    3.0
    """
    return _core.polygon_area(_polygon("polygon", polygon))


def _polygon(name, vertices):
    vertices = np.ascontiguousarray(rows(name, vertices, 3, np.float64))
    if vertices.ndim != 2:
        raise UsageError(f"has shape {vertices.shape}", name, "(K, 3)")
    return vertices
