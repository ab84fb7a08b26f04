"""Lights: what arrives at points, and the factors that light is made of."""
import numpy as np

from . import _core
from ._arrays import number, numbers, rows, spread, unit_vectors


def irradiance(light, points, normals):
    """Irradiance of surfaces under one light, without shadows: intensity, fall-off and the cosine of incidence.

    light : dictionary. {"type": "point", "position", "intensity"}, {"type": "spot", "position", "direction" (out of
        the lamp), "intensity", "inner_angle", "outer_angle" (rad, from the axis), "exponent"} or {"type": "directional",
        "direction" (of travel), "illuminance"} or {"type": "luminaire", "position", "direction" (gamma = 0), "c0"
        (gamma = 90 in plane C0), "colour", "c", "gamma" (degrees), "candela" (plane by plane)} or {"type": "warn",
        "position", "direction", "intensity", "exponent", "cone_angle", "flap_low", "flap_high" (corners of the box that is
        lit, m)} or {"type": "rectangle", "corner", "edge_u", "edge_v" (shining towards edge_u x edge_v), "radiance",
        "both_sides"} or {"type": "disc", "position", "direction", "radius", "radiance", "both_sides"}. Intensities in cd,
        radiance in cd/m^2; a point, spot or Warn light may have "attenuation", the (a0, a1, a2) of
        1 / (a0 + a1 d + a2 d^2), which is (0, 0, 1) unless stated, and "clamp". Lights of a scene fit.
    points, normals : (..., 3), m; unit.
    Returns (..., 3) float32, lx.
    Raises NoSuchMethod (type), UsageError (a field), BadParam.

    >>> import aktina
    >>> lamp = {"type": "point", "position": [0, 2, 0], "intensity": [100, 100, 50]}
    >>> aktina.irradiance(lamp, points=[0, 0, 0], normals=[0, 1, 0]).tolist()
    [25.0, 25.0, 12.5]
    """
    shape, (points, normals) = spread(points=rows("points", points, 3, np.float32),
                                      normals=unit_vectors("normals", normals))
    out = np.empty((*shape, 3), np.float32)
    _core.irradiance(dict(light), points, normals, out)
    return out


def spot_falloff(axis, l, outer_angle, inner_angle=None, exponent=0.0):
    """Share of its intensity that a spot light sends in a direction.

    axis : (..., 3), unit, out of the lamp.  l : (..., 3), unit, from the lit point to the lamp.
    outer_angle, inner_angle : rad, from the axis: nothing beyond the outer one, all within the inner one, smooth
        between them (KHR_lights_punctual); a hard edge where inner_angle is left out.
    exponent : of the cosine to the axis, inside the cone (warn1983).
    Returns (...,) float32 in [0, 1].

    >>> import aktina
    >>> aktina.spot_falloff([0, 0, -1], [0, 0.6, 0.8], outer_angle=1, exponent=2).round(4)
    0.64
    """
    outer_angle = number("outer_angle", outer_angle, 0, np.pi)
    inner_angle = outer_angle if inner_angle is None else number("inner_angle", inner_angle, 0, np.pi)
    cosine = -np.sum(unit_vectors("axis", axis) * unit_vectors("l", l), axis=-1, dtype=np.float32)
    return _each(_core.spot_falloff, cosine, inner_angle, outer_angle, number("exponent", exponent, 0))


def attenuation(distance, a0=0.0, a1=0.0, a2=1.0, clamp=False):
    """The classic factor 1 / (a0 + a1 d + a2 d^2), at most 1 if `clamp`; by default the inverse square law.

    distance : (...,), m, not negative.  Returns (...,) float32; m^-2 for the inverse square law.

    >>> import aktina
    >>> aktina.attenuation([1, 2, 4]).tolist()
    [1.0, 0.25, 0.0625]
    """
    distance = numbers("distance", distance, np.float32)
    return _each(_core.attenuation, distance, *(number(f"a{i}", a, 0) for i, a in enumerate((a0, a1, a2))), bool(clamp))


def depth_cue(distance, k1, k2):
    """Depth cueing 1 / (k1 + k2 d): a factor on diffuse and specular light, d from the projection plane.

    distance : (...,), m.  Returns (...,) float32.

    >>> import aktina
    >>> aktina.depth_cue([0, 1, 3], 1, 1).tolist()
    [1.0, 0.5, 0.25]
    """
    return _each(_core.depth_cue, numbers("distance", distance, np.float32), number("k1", k1), number("k2", k2))


def _each(function, values, *parameters):
    """function(parameters..., value) of each value."""
    flat = np.ascontiguousarray(values).reshape(-1)
    out = np.empty_like(flat)
    function(*parameters, flat, out)
    return out.reshape(np.shape(values))[()]
