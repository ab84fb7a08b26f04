"""Form factors of shapes that are no polygons: which pair has which closed form."""
import numpy as np

from . import _core
from ._arrays import number, one_vector, unit_vectors
from ._errors import Unsupported, UsageError


def form_factor(a, b, occluders):
    a, b = _shape("a", a), _shape("b", b)
    pair = a["type"], b["type"]
    if pair == ("sphere", "sphere"):
        return _spheres(a, b, [_shape("occluders", occluder) for occluder in occluders])
    if pair not in PAIRS or occluders:
        hidden = " past occluders" if occluders else ""
        raise Unsupported(f"from {pair[0]} to {pair[1]}{hidden} has no closed form", "form_factor",
                          "there are: " + ", ".join(f"{x} to {y}" for x, y in [*PAIRS, ("sphere", "sphere")]))
    return PAIRS[pair](a, b)


def point(shape):
    """Position and unit normal."""
    shape = _shape("point", shape)
    return shape["position"], shape["normal"]


def _point_to_disc(a, b):
    return _core.point_to_disc(a["position"], a["normal"], b["centre"], b["normal"], b["radius"])


def _point_to_sphere(a, b):
    to_centre = b["centre"] - a["position"]
    distance = np.linalg.norm(to_centre)
    if b["inside"] or distance < b["radius"]:
        raise Unsupported("from a point to the inside of a sphere has no closed form here", "form_factor")
    angle = np.arctan2(np.linalg.norm(np.cross(a["normal"], to_centre)), a["normal"] @ to_centre)
    return _core.point_to_sphere(b["radius"], distance, angle)


def _discs(a, b):
    axis = b["centre"] - a["centre"]
    distance = np.linalg.norm(axis)
    near = 1e-9 * distance
    if not (distance > 0 and np.linalg.norm(np.cross(a["normal"], axis)) <= near
            and np.linalg.norm(np.cross(b["normal"], axis)) <= near):
        raise Unsupported("only discs on one axis have a closed form", "form_factor")
    if a["normal"] @ axis < 0 or b["normal"] @ axis > 0:
        return 0.0
    return _core.coaxial_discs(a["radius"], b["radius"], distance)


def _spheres(a, b, occluders):
    if a["inside"] and b["inside"]:  # one sphere to itself, past what is within
        inner = occluders[0] if occluders else None
        fits = a["radius"] == b["radius"] and len(occluders) <= 1
        fits = fits and all(o["type"] == "sphere" and o["radius"] <= a["radius"] for o in occluders)
        result = 1 - (_core.sphere_to_inner_sphere(inner["radius"], a["radius"]) if inner and fits else 0)
    else:
        fits, inner = not occluders, None
        outside, inside = (b, a) if a["inside"] else (a, b)
        fits = fits and inside["inside"] and outside["radius"] <= inside["radius"]
        result = _core.sphere_to_inner_sphere(outside["radius"], inside["radius"]) if a["inside"] else 1.0
    centres = np.array([shape["centre"] for shape in (a, b, *([inner] if inner else []))])
    if not fits or np.ptp(centres, axis=0).max() > 1e-9 * max(a["radius"], b["radius"]):
        raise Unsupported("only spheres within each other around one centre have a closed form", "form_factor")
    return result


def _band(a, b):
    if not a["inside"] or a["radius"] != b["radius"]:
        raise Unsupported("a band is seen from the inside of its own sphere", "form_factor", "\"inside\": True")
    return _core.sphere_band(b["from"], b["to"])


def _cap(index):
    def factor(a, b):
        if (a["radius"], a["half_angle"]) != (b["radius"], b["half_angle"]):
            raise Unsupported("a cap sees its own base only", "form_factor")
        return _core.spherical_cap(a["half_angle"])[index]
    return factor


PAIRS = {
    ("point", "disc"): _point_to_disc, ("point", "sphere"): _point_to_sphere, ("disc", "disc"): _discs,
    ("sphere", "sphere_band"): _band,
    ("cap", "cap"): _cap(0), ("cap", "cap_base"): _cap(1), ("cap_base", "cap"): _cap(2)}


def _length(name, value):
    value = number(name, value, 0)
    if value == 0:
        raise UsageError("is 0", name, "a length")
    return value


def _unit(name, value):
    vector = unit_vectors(name, one_vector(name, value), np.float64)
    return vector / np.linalg.norm(vector)


def _angle(name, value):
    return number(name, value, 0, np.pi)


# Shape -> its fields: how each is read, and its default where it has one.
FIELDS = {
    "point": {"position": (one_vector,), "normal": (_unit,)},
    "disc": {"centre": (one_vector,), "normal": (_unit,), "radius": (_length,)},
    "sphere": {"centre": (one_vector, (0, 0, 0)), "radius": (_length,), "inside": (lambda name, value: bool(value), False)},
    "sphere_band": {"radius": (_length,), "from": (_angle,), "to": (_angle,)},
    "cap": {"radius": (_length, 1), "half_angle": (_angle,)},
    "cap_base": {"radius": (_length, 1), "half_angle": (_angle,)},
}


def _shape(name, given):
    """The shape's fields, checked."""
    kind = given.get("type") if isinstance(given, dict) else None
    if kind not in FIELDS:
        raise UsageError(f"is no shape: {kind!r}" if isinstance(given, dict) else "is a polygon beside a shape", name,
                         "there are: " + ", ".join(FIELDS))
    fields = FIELDS[kind]
    for field in given:
        if field != "type" and field not in fields:
            raise UsageError("no such field", f"{name}.{field}", "there are: " + ", ".join(fields))
    shape = {"type": kind}
    for field, (read, *default) in fields.items():
        if field not in given and not default:
            raise UsageError("is missing", f"{name}.{field}")
        shape[field] = read(f"{name}.{field}", given.get(field, *default))
    return shape
