"""Rays against single shapes, at boundaries of media, and through a scene by Whitted's method."""
import numpy as np

import aktina

from .cases import ANALYTIC, FLOAT, Method


def kinds():
    return {
        **{f"ray_{shape}": [Method("intersect", ANALYTIC, lambda case, shape=shape: ray(shape, case))]
           for shape in ("sphere", "plane", "triangle", "polygon")},
        "refraction": [Method(f"refract_{form}", ANALYTIC, lambda case, form=form: refraction(form, case))
                       for form in ("snell", "whitted")],
        "whitted_ray": [Method("whitted", FLOAT, whitted)],
    }


def ray(shape, case):
    sizes = {("d" if name == "D" else name): value for name, value in case.inputs.items()
             if name not in ("origin", "direction")}
    hits = aktina.intersect(shape, case.inputs["origin"], case.inputs["direction"], near=1e-9, **sizes)
    if not hits.hit:
        return {"hit": False}
    u, v = hits.uv
    return {"hit": True, "t": hits.distance, "point": hits.point, "normal": hits.normal, "u": u, "v": v}


def refraction(form, case):
    given = case.inputs
    direction, (across, along) = aktina.refract(given["incident"], given["normal"], given["n1"], given["n2"], form=form)
    tir = bool(np.isnan(direction).any())
    values = {"reflect": aktina.reflect(given["incident"], given["normal"]), "tir": tir,
              "Rs": across, "Rp": along, "R": (across + along) / 2}
    return values if tir else {**values, "refract": direction}


SCENES = {}  # by the file's header, which all of its cases share


def whitted(case):
    """The header's scene. Its ks is our kr (there are no highlights), its light does not fall off and has the classic
    colour E / pi; T is black at total internal reflection and shadows of clear bodies are kt, once a body."""
    header = case.header["scene"]
    key = id(header)
    if key not in SCENES:
        SCENES[key] = header, whitted_scene(header)
    method = f"whitted:depth={header['max_depth']},cutoff=0,tir=0,shadows=1"
    return {"I": aktina.radiance(SCENES[key][1], case.inputs["origin"], case.inputs["direction"], method, samples=1)}


def whitted_scene(header):
    light = header["light"]
    lamp = {"type": "point", "position": light["position"], "attenuation": [1, 0, 0],
            "intensity": [np.pi * channel for channel in light["intensity"]]}
    return aktina.Scene([whitted_object(item) for item in header["objects"]], [lamp], ambient=header["ambient"],
                        background=header["background"])


def whitted_object(item):
    colour = np.array(item.get("color", [1, 1, 1]))
    material = {"ka": item["ka"] * colour, "kd": item["kd"] * colour, "kr": item["ks"], "kt": item["kt"],
                "index": item["index"]}
    if item["type"] == "sphere":
        to_world = np.eye(4)
        to_world[:3, 3] = item["centre"]
        return {"shape": {"type": "sphere", "radius": item["radius"]}, "to_world": to_world, "material": material}
    return plane(item, material)


def plane(item, material, reach=1024):
    """A square that is large against the scene, checkered by a texture of two by two texels that repeats; z up."""
    assert item["normal"] == [0, 0, 1]
    even, odd = item["color0"], item["color1"]
    texture = [[odd, even], [even, odd]]  # v runs down: the lower row is that of 0 <= y < 1
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * reach
    uv = corners / (2 * item["checker"]) * [1, -1]
    return {"vertices": np.column_stack([corners, np.full(4, item["d"])]), "triangles": [[0, 1, 2], [0, 2, 3]], "uv": uv,
            "material": {**material, "texture": texture, "filter": "nearest"}}
