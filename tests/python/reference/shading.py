"""Shading interpolation."""
import numpy as np

import aktina

from .cases import FLOAT, Method, ids

# Kind of case -> the methods that it describes, some with parameters that make them it.
METHODS = {"phong_interp": ["phong"], "quadratic": ["quadratic"],
           "gouraud": ["gouraud", "tai_hsu:strong=2,weak=2", "cho_neumann_woo:depth=0"]}


def kinds():
    kinds = {kind: [Method(method, FLOAT, lambda case, method=method: interpolated(method, case))
                    for method in methods if method.split(":")[0] in ids("shading")]
             for kind, methods in METHODS.items()}
    kinds["cubic"] = [Method("interpolate_samples", FLOAT, cubic)]
    on_scanlines = {"bishop_weimer": ("fast_phong", bishop_weimer), "slerp_scanline": ("spherical", slerp_scanline),
                    "angular": ("angular", angular), "euler": ("euler", euler)}
    return kinds | {kind: [Method(method, FLOAT, compute)] for kind, (method, compute) in on_scanlines.items()
                    if method in ids("shading")}


def bishop_weimer(case):
    given = case.inputs
    corners, offsets = np.array(given["vertices_xy"]), np.array(given["offsets_from_centroid"])
    t = aktina.fast_phong_series(corners, given["normals"], given["L"])
    x, y = offsets.T
    edges = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=1)
    share = 1 / 3 + np.linalg.solve(edges, offsets.T).T
    barycentric = np.column_stack([1 - share.sum(axis=1), share])
    return {**{f"T{k}": t[k] for k in range(6)}, "centroid": corners.mean(axis=0),
            "taylor": t[5] * x * x + t[4] * x * y + t[3] * y * y + t[2] * x + t[1] * y + t[0],
            "exact": signed_diffuse("phong", given["normals"], given["L"], barycentric)}


def signed_diffuse(method, normals, l, barycentric, **options):
    """N.l, also where the light is behind the surface: then a light from the other side shines."""
    def lit(direction):
        lamp = {"type": "directional", "direction": [-x for x in direction], "illuminance": np.pi}
        return aktina.interpolate(method, normals, barycentric, [lamp], material={"kd": 1}, model="lambert",
                                  **options)[..., 0]
    return lit(l) - lit([-x for x in l])


def slerp_scanline(case):
    """Normals by slerp alone; the diffuse light by a triangle whose edges the scanline y = 1 meets at t_left and
    t_right."""
    given = case.inputs
    n, t = given["normals"], np.array(given["t"])
    left, right = given["t_left"], given["t_right"]
    na, nb = aktina.slerp(n[0], n[1], left), aktina.slerp(n[0], n[2], right)
    values = {"Na": na, "Nb": nb, "N": aktina.slerp(na, nb, t)}
    if left > 0 and right > 0:
        screen = [[0, 0], [-1 / left, 1 / left], [1 / right, 1 / right]]
        points = np.stack([1 - (1 - t) * left - t * right, (1 - t) * left, t * right], axis=-1)
        values["diffuse"] = signed_diffuse("spherical", n, given["L"], points, screen=screen)
    return values


def angular(case):
    given, t = case.inputs, np.array(case.inputs["t"])
    n, l = [given["Na"], given["Nb"]], [given["La"], given["Lb"]]
    ends = aktina.arc_angle(n, l)
    values = {"cos_a": aktina.interpolate_cosine("angular", n, l, t), "arc_N": aktina.arc_angle(*n),
              "arc_L": aktina.arc_angle(*l), "linear_angle": np.cos((1 - t) * ends[0] + t * ends[1])}
    if "beta" in case.expected:  # a lamp that stands still: its elevation and azimuth about the normal's circle
        tangent = aktina.slerp(*n, np.pi / 2 / values["arc_N"])
        values["beta"] = np.arcsin(np.dot(l[0], np.cross(n[0], tangent)))
        values["t0"] = np.arctan2(np.dot(l[0], tangent), np.dot(l[0], n[0]))
    return values


def euler(case):
    given, steps = case.inputs, case.inputs["steps"]
    pair, t = ([given["Na"], given["Nb"]], [given["L"]] * 2), np.arange(steps + 1) / steps
    return {"plain": aktina.interpolate_cosine("euler", *pair, t, steps=steps),
            "corrected": aktina.interpolate_cosine("euler", *pair, t)}


def interpolated(method, case):
    """Ip = 1 from infinity: an illuminance of pi."""
    given = case.inputs
    lamp = {"type": "directional", "direction": [-x for x in given["L"]], "illuminance": np.pi}
    material = {"ka": given["ka"], "kd": given["kd"], "ks": given["ks"], "exponent": given["n"]}
    model = {"phong": "phong", "blinn": "blinn_phong"}[given["specular"]]

    def at(points):
        return aktina.interpolate(method, given["normals"], points, [lamp], v=given["V"], material=material, model=model,
                                  ambient=1)[..., 0]
    middles = [[0.5, 0.5, 0], [0, 0.5, 0.5], [0.5, 0, 0.5]]
    return {"I": at(given["barycentric"]), "I_vertices": at(np.eye(3)), "I_midedges_01_12_20": at(middles)}


def cubic(case):
    """The case lists its samples in an order of its own."""
    third, order = np.array(case.inputs["lattice"]) / 3, []
    corners = np.eye(3)
    edges = [(1 - t) * corners[i] + t * corners[(i + 1) % 3] for i in range(3) for t in (1 / 3, 2 / 3)]
    for point in [*corners, *edges, np.full(3, 1 / 3)]:
        order.append(int(np.argmin(abs(third - point).sum(axis=1))))
    samples = np.array(case.inputs["samples"])[order]
    return {"I": aktina.interpolate_samples(samples, case.inputs["barycentric"])}
