"""Illumination models, evaluated on arrays of directions."""
import numpy as np

from . import _core
from ._arrays import colours, numbers, rows, spread, unit_vectors
from ._errors import BadParam, UsageError

_FIELDS = dict(_core.surface_fields())


def illuminate(model, material, n, l, v=None, light=1.0, ambient=0.0):
    """Radiance that a surface sends to the viewer, lit from one direction: ka Ia + Ip (kd (n.l)+ + ks S).

    The classic lighting equation, with `light` as Ip and `ambient` as Ia. S is the model's highlight. Ip is the
    illuminance on a plane that faces the light divided by pi, so that a white diffuse surface (kd = 1) facing the light
    has radiance Ip; a model that is defined by a BRDF f gives Ip pi f (n.l)+ in place of the bracket. Light from behind
    the surface gives the ambient term alone.

    model : a method of the family "illumination", such as "phong".
    material : dictionary of coefficients, or a material of a scene. The classic models read ka, kd, ks (colours) and
        exponent. Left out: ka 1, kd 0.5, ks 0, exponent 1.
    n, l, v : (..., 3), unit: surface normal, direction to the light, direction to the viewer (n where left out).
    light, ambient : (..., 3), or one number for grey; cd/m^2.
    Returns (..., 3) float32, cd/m^2, of the shape that the arguments broadcast to; coefficients broadcast too.
    Raises NoSuchMethod, UsageError (a shape, an unknown coefficient), BadParam (NaN, a vector that is not unit).
    Source: phong1975, blinn1977 and the model's own.

    >>> import aktina
    >>> lit = aktina.illuminate("phong", {"kd": 0.5, "ks": 0.25, "exponent": 10}, n=[0, 0, 1], l=[0, 0.6, 0.8],
    ...                         v=[0, -0.6, 0.8], light=[1, 1, 2])
    >>> lit.round(4).tolist()
    [0.6499999761581421, 0.6499999761581421, 1.2999999523162842]
    """
    given = _coefficients(material)
    n = unit_vectors("n", n)
    arrays = {"n": n, "l": unit_vectors("l", l), "v": n if v is None else unit_vectors("v", v),
              "light": colours("light", light), "ambient": colours("ambient", ambient)}
    shape, flat = spread(**arrays, **given)
    surfaces = _surfaces(dict(zip(given, flat[len(arrays):])))
    out = np.empty((*shape, 3), np.float32)
    _core.illuminate(model, surfaces, *flat[:len(arrays)], out)
    return out


def highlight(model, n, l, v, exponent):
    """The highlight S of a classic model: the part of `illuminate` that ks multiplies.

    n, l, v : (..., 3), unit.  exponent : (...,), Phong's n.
    Returns (...,) float32, dimensionless.

    >>> import aktina
    >>> float(aktina.highlight("blinn_phong", [0, 0, 1], [0, 0, 1], [0, 0, 1], 50))
    1.0
    """
    return illuminate(model, {"kd": 0, "ks": 1, "exponent": exponent}, n, l, v)[..., 0]


def albedo(model, material, cos_view=1.0):
    """Radiance of a surface in a white furnace: what a viewer sees where everything around has radiance 1.

    model : of the family "illumination".  material : coefficients, as `illuminate` takes them.
    cos_view : (...,), in [0, 1], of the angle between normal and viewer.
    Returns (..., 3) float32: the integral of f n.l over the hemisphere, within about 1e-3; 1e-2 at grazing angles.

    >>> import aktina
    >>> aktina.albedo("lambert", {"kd": 0.5}, [1, 0.2]).round(2).tolist()
    [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]]
    """
    return _energy(_core.albedo, model, material, "cos_view", cos_view)


def reflected_share(model, material, cos_light=1.0):
    """Share of the light of a distant lamp that leaves the surface in any direction. Above 1, the model makes light.

    Arguments and result as `albedo`; the same as that for a reciprocal model.

    >>> import aktina
    >>> round(float(aktina.reflected_share("phong", {"kd": 0, "ks": 1, "exponent": 1})[0]), 3)  # 2 / (n + 2)
    0.667
    """
    return _energy(_core.reflected_share, model, material, "cos_light", cos_light)


def reciprocity(model, material):
    """How far a model is from f(l, v) = f(v, l): (error, a, b).

    error : the largest |f(a, b) - f(b, a)| over the larger of both, for directions up to 85 degrees off the normal; 0:
        reciprocal.  a, b : where it is so large, for the normal (0, 0, 1).

    >>> import aktina
    >>> aktina.reciprocity("lambert", {"kd": 0.5})[0]
    0.0
    """
    return _core.reciprocity(model, surface_rows(material))


def _energy(function, model, material, name, cosines):
    cosines = numbers(name, cosines, np.float32)
    if (cosines < 0).any() or (cosines > 1).any():
        raise BadParam("should be from 0 to 1", name)
    out = np.empty((*cosines.shape, 3), np.float32)
    function(model, surface_rows(material), np.ascontiguousarray(cosines).reshape(-1), out.reshape(-1, 3))
    return out


def schlick_power(t, exponent):
    """Schlick's t / (n - n t + t) in place of t^n; 0 where t is not positive.

    t, exponent : (...,), t in [0, 1]; they broadcast.  Returns (...,) float32.
    Source: schlick1994.

    >>> import aktina
    >>> float(aktina.schlick_power(0.5, 3))
    0.25
    """
    t, exponent = np.broadcast_arrays(numbers("t", t, np.float32), numbers("exponent", exponent, np.float32))
    out = np.empty(t.shape, np.float32)
    _core.schlick_power(np.ascontiguousarray(t).reshape(-1), np.ascontiguousarray(exponent).reshape(-1), out.reshape(-1))
    return out[()]


def surface_rows(material):
    """The core's rows of coefficients: one for all points, or one a point."""
    given = _coefficients(material)
    return _surfaces(dict(zip(given, spread(**given)[1])) if given else {})


def _coefficients(material):
    material = material.get("surface", material)
    unknown = sorted(set(material) - set(_FIELDS))
    if unknown:
        raise UsageError("no such coefficient", f"material.{unknown[0]}", "there are: " + ", ".join(_FIELDS))
    return {name: _coefficient(name, material[name]) for name in material}


def _coefficient(name, values):
    if len(_FIELDS[name]) == 3:
        return colours(name, values)
    return numbers(name, values, np.float32)[..., np.newaxis]


def _surfaces(given):
    """Rows in the order of the core's fields; what is not given keeps its default."""
    count = max([len(values) for values in given.values()], default=1)
    columns = [np.broadcast_to(given.get(name, np.float32(default)), (count, len(default)))
               for name, default in _FIELDS.items()]
    return np.hstack(columns, dtype=np.float32)
