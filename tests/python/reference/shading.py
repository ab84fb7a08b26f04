"""Shading interpolation."""
import numpy as np

import aktina

from .cases import FLOAT, Method, ids

# Kind of case -> the method that it describes.
METHODS = {"phong_interp": "phong", "gouraud": "gouraud", "quadratic": "quadratic"}


def kinds():
    kinds = {kind: [Method(method, FLOAT, lambda case, method=method: interpolated(method, case))]
             for kind, method in METHODS.items() if method in ids("shading")}
    kinds["cubic"] = [Method("interpolate_samples", FLOAT, cubic)]
    return kinds


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
