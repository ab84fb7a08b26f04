"""Vertex normals."""
import aktina

from .cases import ANALYTIC, Method, ids


def kinds():
    return {"vertex_normals": [Method(id, ANALYTIC, lambda case, id=id: normal(id, case)) for id in ids("normals")]}


def normal(method, case):
    return {method: aktina.vertex_normal(method, case.inputs["vertex"], case.inputs["rim"])}
