"""Radiosity of patches by each solver; form factors as the case gives them, or of the box that it describes."""
import numpy as np

import aktina

from .cases import ANALYTIC, SAMPLED, Method, ids


def kinds():
    computed = {"given_F": given, "sphere_interior": given, "box_enclosure": box, "box_enclosure_rgb": box,
                "subdivided_room": subdivided_room, "incremental": incremental}
    given_factors = [id for id in ids("radiosity") if not cuts_surfaces(id)]
    return {kind: [solver(id, compute) for id in given_factors] for kind, compute in computed.items()}


def cuts_surfaces(id):
    """Such solvers find form factors of their own: these cases state them, or ask for one value on each face."""
    return id == "hierarchical" or id.startswith("wavelet_")


def solver(id, compute):
    sampled = id == "stochastic_jacobi"
    return Method(id, SAMPLED if sampled else ANALYTIC, lambda case: compute(id, case),
                  lambda case: not sampled or bool(case.tolerance_sampled))


def given(method, case):
    F, E, rho = (np.array(case.inputs[name]) for name in ("F", "E", "rho"))
    B = aktina.solve_radiosity(F, E, rho, method=method)
    return {"B": B, "H": (F @ B)[0]}


def box(method, case):
    F = factors(case.inputs["dims"])
    return {"B": aktina.solve_radiosity(F, case.inputs["E"], case.inputs["rho"], method=method), "F": F}


def factors(dims):
    """Of the inside of the box [0, a] x [0, b] x [0, c]: floor, ceiling, x = 0, x = a, y = 0, y = b."""
    corner = {name: np.array(name, float) * dims for name in np.ndindex(2, 2, 2)}
    faces = [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1)],
             [(0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1)], [(1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0)],
             [(0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 0, 0)], [(0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1)]]
    return aktina.form_factors([[corner[name] for name in face] for face in faces])[0]


_factors_of_rooms = {}  # the same room stands in several cases


def room_factors(name, inputs):
    if name not in _factors_of_rooms:
        _factors_of_rooms[name] = aktina.form_factors(inputs["corners"])[0]
    return _factors_of_rooms[name]


def subdivided_room(method, case):
    return {"B": aktina.solve_radiosity(room_factors(case.id, case.inputs), case.inputs["E"], case.inputs["rho"], method=method)}


def incremental(method, case):
    base = case.others[case.inputs["base_case"]]
    F, E = room_factors(base["id"], base["inputs"]), np.array(base["inputs"]["E"])
    rho = np.array(base["inputs"]["rho"])
    before = aktina.solve_radiosity(F, E, rho, method=method)
    if case.inputs["change"] == "face_rho":
        changed = (np.array(base["inputs"]["face"]) == case.inputs["face"]) & (E == 0).all(1)
        rho[changed] = case.inputs["new_rho"]
    else:
        E[base["inputs"]["light_B"]] = 0
    B = aktina.solve_radiosity(F, E, rho, method=method)
    return {"B": B, "delta_B": B - before}
