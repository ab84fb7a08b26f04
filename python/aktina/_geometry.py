"""Rays against single shapes, and the normal of one vertex."""
import numpy as np

from . import _core
from ._arrays import number, one_vector, rows, spread, unit_vectors
from ._errors import UsageError


class Hits:
    """What rays meet: arrays with the leading axes of the rays.

    `distance` : in units of the directions' length; infinity where nothing was hit.
    `point` : (..., 3), m; NaN where nothing was hit, as are `normal` and `uv`.
    `normal` : (..., 3), unit, on the front side of the surface.
    `uv` : (..., 2); on triangles the weights of the second and third corner.
    `hit` : (...,) bool.
    `instance`, `triangle` : (...,) int64, of a scene's: which of its instances, and which triangle of that one's mesh;
        -1 where nothing was hit; None for a single shape.
    """

    def __init__(self, distance, point, normal, uv, instance=None, triangle=None):
        self.distance, self.point, self.normal, self.uv = distance, point, normal, uv
        self.instance, self.triangle = instance, triangle

    @property
    def hit(self):
        return np.isfinite(self.distance)

    def __repr__(self):
        return f"<aktina.Hits: {np.count_nonzero(self.hit)} of {self.distance.size} rays hit>"


def intersect(shape, origins, directions, near=0.0, far=np.inf, **sizes):
    """Where rays meet one shape, in double precision. Both sides of a surface count.

    shape, sizes : "plane" (normal, d: normal . x = d), "sphere" (centre, radius), "triangle" (vertices (3, 3)),
        "polygon" (vertices (K, 3): planar, of any form), or a method of the family "primitive" in its own space: "disc"
        (radius; in y = 0), "cylinder" (radius, height; about y), "cone" (radius, top_radius, height; about y).
    origins, directions : (..., 3); m, directions need not be unit.
    near, far : only hits between them count, in units of the directions' length.
    Returns Hits.  Raises NoSuchMethod (shape), UsageError (sizes), BadParam.

    >>> import aktina
    >>> hits = aktina.intersect("sphere", [[0, 0, -3], [2, 0, -3]], [0, 0, 1], centre=[0, 0, 0], radius=1)
    >>> hits.distance.tolist(), hits.normal[0].tolist()
    ([2.0, inf], [0.0, 0.0, -1.0])
    """
    shape_of_rays, (origins, directions) = spread(origins=rows("origins", origins, 3, np.float64),
                                                  directions=rows("directions", directions, 3, np.float64))
    distance = np.full(shape_of_rays, np.inf)
    normal, uv = np.full((*shape_of_rays, 3), np.nan), np.full((*shape_of_rays, 2), np.nan)
    flat = distance.reshape(-1)
    _core.intersect({"type": shape, **sizes}, origins, directions, number("near", near), float(far), flat, normal, uv)
    with np.errstate(invalid="ignore"):
        point = (origins + flat[:, np.newaxis] * directions).reshape(normal.shape)
    point[np.isinf(distance)] = np.nan
    return Hits(distance, point, normal, uv)


def vertex_normal(method, vertex, rim, closed=True):
    """Unit normal of a vertex from the facets around it.

    method : of the family "normals": "plain", "area", "angle", "max".
    vertex : (3,), m.  rim : (K, 3), the other corners of the facets, counter-clockwise seen from outside; facet i has
        the corners vertex, rim[i], rim[i + 1].
    closed : whether the last and the first of the rim share a facet too.
    Returns (3,) float64; zeros where the facets cancel out.

    >>> import aktina
    >>> aktina.vertex_normal("angle", [0, 0, 1], [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]).tolist()
    [0.0, 0.0, 1.0]
    """
    rim = np.ascontiguousarray(rows("rim", rim, 3, np.float64))
    return np.array(_core.vertex_normal(method, one_vector("vertex", vertex), rim, bool(closed)))


def mesh_normals(vertices, triangles, method="angle", crease=np.pi / 6):
    """A triangle mesh with vertex normals: smooth, but split at edges sharper than `crease`, at edges of more than two
    triangles and where triangles touch in a point only. Triangles without area count for nothing.

    vertices : (V, 3), m; those in the same place are one.  triangles : (T, 3), indices, counter-clockwise.
    method : of the family "normals".  crease : rad, [0, pi]; 0: flat triangles, pi: smooth everywhere.
    Returns a dictionary as `Scene` takes it: "vertices" (W, 3), "normals" (W, 3), "triangles" (T, 3); vertices are
    doubled where normals differ.
    Raises NoSuchMethod, UsageError (an index), BadParam.

    >>> import aktina
    >>> roof = aktina.mesh_normals([[0, 0, 0], [0, 0, 1], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 3, 1]], crease=0.5)
    >>> len(roof["vertices"])  # a right angle between two triangles: both vertices of its edge are doubled
    6
    """
    vertices = np.ascontiguousarray(rows("vertices", vertices, 3, np.float32))
    triangles = np.ascontiguousarray(rows("triangles", triangles, 3, np.uint32))
    moved, normals, corners = _core.mesh_normals(vertices, triangles, method, number("crease", crease, 0, np.pi))
    return {"vertices": np.asarray(moved), "normals": np.asarray(normals),
            "triangles": np.asarray(corners)}


def reflect(incident, normal):
    """Direction of the mirrored ray.

    incident, normal : (..., 3), unit; incident runs towards the surface.  Returns (..., 3) float64, unit.

    >>> import aktina
    >>> aktina.reflect([0.6, -0.8, 0], [0, 1, 0]).round(12).tolist()
    [0.6, 0.8, 0.0]
    """
    shape, (incident, normal) = spread(incident=unit_vectors("incident", incident, np.float64),
                                       normal=unit_vectors("normal", normal, np.float64))
    out = np.empty((*shape, 3))
    _core.reflect(incident, normal, out)
    return out


def refract(incident, normal, n1, n2, form="snell"):
    """Direction of the ray that passes a boundary, and the shares of light that are reflected instead.

    incident, normal : (..., 3), unit; incident runs towards the surface, the normal may be on either side.
    n1, n2 : indices of refraction of the medium that is left and of the one that is entered.
    form : "snell", or "whitted" for the formula of whitted1980; they agree within rounding.
    Returns (direction, reflectance): (..., 3) float64, unit, NaN at total internal reflection; (..., 2) float64, for light
    polarized across and along the plane of incidence, 1 at total internal reflection. Their mean is Fresnel's
    reflectance of unpolarized light.

    >>> import aktina
    >>> direction, reflectance = aktina.refract([0, -1, 0], [0, 1, 0], 1, 1.5)
    >>> direction.tolist(), reflectance.round(4).tolist()
    ([0.0, -1.0, 0.0], [0.04, 0.04])
    """
    if form not in ("snell", "whitted"):
        raise UsageError(f"got {form!r}", "form", "snell or whitted")
    shape, (incident, normal) = spread(incident=unit_vectors("incident", incident, np.float64),
                                       normal=unit_vectors("normal", normal, np.float64))
    direction, reflectance = np.full((*shape, 3), np.nan), np.empty((*shape, 2))
    _core.refract(incident, normal, number("n1", n1, 1e-6), number("n2", n2, 1e-6), form == "whitted", direction,
                  reflectance)
    return direction, reflectance
