"""Illumination models."""
import numpy as np

import aktina

from .cases import FLOAT, Method, ids

# Kind of case -> the model that it describes.
MODELS = {"lambert": "lambert", "phong": "phong", "blinn": "blinn_phong"}


def kinds():
    kinds = {kind: [Method(model, FLOAT, lambda case, model=model: lit(model, case))]
             for kind, model in MODELS.items() if model in ids("illumination")}
    kinds["schlick_specular"] = [Method("schlick", FLOAT, schlick)]
    kinds["torrance_sparrow"] = [Method("torrance_sparrow", FLOAT, facets)]
    return kinds


def lit(model, case):
    given = case.inputs
    n, l, v = given["N"], given["L"], given.get("V", given["N"])
    material = {name: given[name] for name in ("ka", "kd", "ks") if name in given}
    values = {}
    if "n" in given:
        material["exponent"] = given["n"]
        values["S"] = aktina.highlight(model, n, l, v, given["n"])
    values["I"] = aktina.illuminate(model, material, n, l, v, light=given["Ip"], ambient=given.get("Ia", 0))
    return values


def schlick(case):
    given = case.inputs
    n, l, v = (np.array(given[name]) for name in "NLV")
    h = (l + v) / np.linalg.norm(l + v)
    values = {"t_phong": max(0.0, (2 * (n @ l) * n - l) @ v), "t_blinn": max(0.0, n @ h)}
    values["S_phong"] = aktina.schlick_power(values["t_phong"], given["n"])
    values["S_blinn"] = aktina.schlick_power(values["t_blinn"], given["n"])
    if n @ l > 0:  # the model itself, dark where the light is behind
        values["S_phong"] = aktina.highlight("schlick:half=0", n, l, v, given["n"])
        values["S_blinn"] = aktina.highlight("schlick:half=1", n, l, v, given["n"])
    return values


def facets(case):
    """Blinn's s = D G F / n.v and the two BRDFs from the parts, and the Cook-Torrance model itself."""
    given = case.inputs
    n, l, v = (np.array(given[name]) for name in "NLV")
    h = (l + v) / np.linalg.norm(l + v)
    alpha = np.arctan2(np.linalg.norm(np.cross(n, h)), n @ h)
    d = aktina.facet_distribution("beckmann", alpha, given["m"])
    f = aktina.fresnel(v @ h, given["eta"])
    g = aktina.groove_masking(n, l, v)
    # radiance for Ip = 1 without diffuse light: pi f n.l
    material = {"kd": 0, "ks": 1, "ior": given["eta"]}
    cook_torrance = aktina.illuminate(f"cook_torrance:slope={given['m']}", material, n, l, v)[0] / (np.pi * (n @ l))
    return {"D": d, "F": f, "G": g, "blinn1977": d * g * f / (n @ v), "cook_torrance": cook_torrance,
            "microfacet_brdf": cook_torrance / 4,
            "D1": aktina.facet_distribution("phong", alpha, given["c1"]),
            "D2": aktina.facet_distribution("gaussian", alpha, given["c2"]),
            "D3": aktina.facet_distribution("trowbridge_reitz", alpha, given["c3"])}
