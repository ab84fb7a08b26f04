"""Rays against single shapes."""
import aktina

from .cases import ANALYTIC, Method


def kinds():
    return {f"ray_{shape}": [Method("intersect", ANALYTIC, lambda case, shape=shape: ray(shape, case))]
            for shape in ("sphere", "plane", "triangle", "polygon")}


def ray(shape, case):
    sizes = {("d" if name == "D" else name): value for name, value in case.inputs.items()
             if name not in ("origin", "direction")}
    hits = aktina.intersect(shape, case.inputs["origin"], case.inputs["direction"], near=1e-9, **sizes)
    if not hits.hit:
        return {"hit": False}
    u, v = hits.uv
    return {"hit": True, "t": hits.distance, "point": hits.point, "normal": hits.normal, "u": u, "v": v}
