"""Radiosity of patches by each solver; form factors given by the case, or by closed forms of rectangles."""
import numpy as np

import aktina

from .cases import ANALYTIC, Method, ids

KINDS = ("given_F", "sphere_interior")


def kinds():
    return {kind: [Method(id, ANALYTIC, lambda case, id=id: solve(id, case)) for id in ids("radiosity")]
            for kind in KINDS}


def solve(method, case):
    given = case.inputs
    F, E, rho = np.array(given["F"]), np.array(given["E"]), np.array(given["rho"])
    B = aktina.solve_radiosity(F, E, rho, method=method)
    return {"B": B, "H": (F @ B)[0]}
