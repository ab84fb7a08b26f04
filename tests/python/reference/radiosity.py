"""Radiosity of patches by each solver; form factors as the case gives them, or of the box that it describes."""
import numpy as np

import aktina

from .cases import ANALYTIC, SAMPLED, Method, ids


def kinds():
    computed = {"given_F": given, "sphere_interior": given, "box_enclosure": box, "box_enclosure_rgb": box,
                "subdivided_room": subdivided_room, "incremental": incremental}
    methods = {kind: [solver(id, compute) for id in ids("radiosity") if not cuts_surfaces(id)]
               for kind, compute in computed.items()}
    methods["box_enclosure"] += [on_surfaces(id, furnace) for id in ids("radiosity") if cuts_surfaces(id)]
    methods["subdivided_room"] += [on_surfaces(id, room_of_quads) for id in CONSTANT_ON_PATCHES if id in ids("radiosity")]
    return methods


CONSTANT_ON_PATCHES = ["hierarchical", "clustering", "wavelet_haar"]  # as the light of subdivided_room is


def cuts_surfaces(id):
    """Such solvers find form factors of their own, between surfaces; they take no matrix."""
    return id in ("hierarchical", "clustering") or id.startswith("wavelet_")


def on_surfaces(id, compute):
    return Method(id, SAMPLED, lambda case: compute(id, case), lambda case: bool(case.tolerance_sampled))


def solved_on_quads(method, quads, E, rho, patch_size=1e3):
    """Radiosities of patches; by default each quadrilateral is one."""
    objects = [{"vertices": quad, "triangles": [[0, 1, 2], [0, 2, 3]],
                "material": {"base_colour": np.broadcast_to(r, 3), "metallic": 0, "specular_weight": 0,
                             "emission": np.broadcast_to(e, 3) / np.pi}} for quad, e, r in zip(quads, E, rho)]
    solution = aktina.Scene(objects).radiosity(solver=method, patch_size=patch_size, indirect_size=0,
                                               tolerance=1e-6, target_error=3e-3)
    return np.asarray(solution.radiosities)


def furnace(method, case):
    """The same on all faces, so on all patches: the worst of them."""
    B = solved_on_quads(method, faces(case.inputs["dims"]), case.inputs["E"], case.inputs["rho"],
                        max(case.inputs["dims"]) / 4)[:, 1]
    expected = case.expected["B"][0]
    return {"B": np.full(6, B[np.argmax(abs(B - expected))])}


def room_of_quads(method, case):
    return {"B": solved_on_quads(method, case.inputs["corners"], case.inputs["E"], case.inputs["rho"])}


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


def faces(dims):
    """The inside of the box [0, a] x [0, b] x [0, c]: floor, ceiling, x = 0, x = a, y = 0, y = b."""
    corner = {name: np.array(name, float) * dims for name in np.ndindex(2, 2, 2)}
    names = [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1)],
             [(0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1)], [(1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0)],
             [(0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 0, 0)], [(0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1)]]
    return [[corner[name] for name in face] for face in names]


def factors(dims):
    return aktina.form_factors(faces(dims))[0]


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
