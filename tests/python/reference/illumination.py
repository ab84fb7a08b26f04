"""Illumination models."""
import aktina

from .cases import FLOAT, Method, ids

# Kind of case -> the model that it describes.
MODELS = {"lambert": "lambert", "phong": "phong", "blinn": "blinn_phong"}


def kinds():
    return {kind: [Method(model, FLOAT, lambda case, model=model: lit(model, case))]
            for kind, model in MODELS.items() if model in ids("illumination")}


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
