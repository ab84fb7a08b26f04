"""Radiosity of patches whose form factors are known: truths that hold for any of them."""
import numpy as np
import pytest

import aktina
from reference.cases import ids

METHODS = ids("radiosity")
SAMPLED = ["stochastic_jacobi"]  # draw samples: right to about a per cent
ON_SURFACES = [method for method in METHODS if method in ("hierarchical", "clustering")
               or method.startswith("wavelet_")]
EXACT = [method for method in METHODS if method not in SAMPLED and method not in ON_SURFACES]


def enclosure(patches, seed, bands=3):
    """A closed enclosure with random areas and form factors that keep reciprocity; E and rho of several bands."""
    random = np.random.default_rng(seed)
    exchange = random.random((patches, patches)) ** 4
    exchange += exchange.T
    for _ in range(500):  # Sinkhorn's scaling: rows of equal sum, still symmetric
        scale = 1 / np.sqrt(exchange.sum(1))
        exchange *= scale[:, np.newaxis] * scale
    E = np.where(random.random((patches, bands)) < 0.2, random.random((patches, bands)) * 100, 0)
    E[0] = 50
    return exchange, E, random.random((patches, bands)) * 0.9


@pytest.mark.parametrize("method", EXACT)
def test_equals_the_direct_solution(method):
    F, E, rho = enclosure(40, 1)
    B = aktina.solve_radiosity(F, E, rho, method=method)
    direct = np.stack([np.linalg.solve(np.eye(40) - rho[:, [b]] * F, E[:, b]) for b in range(3)], axis=-1)
    np.testing.assert_allclose(B, direct, rtol=1e-10)


@pytest.mark.parametrize("method", EXACT)
def test_energy_balances_in_a_closed_scene(method):
    F, E, rho = enclosure(30, 2)
    B = aktina.solve_radiosity(F, E, rho, method=method)
    np.testing.assert_allclose(E.sum(0), ((1 - rho) * (F @ B)).sum(0), rtol=1e-10)


@pytest.mark.parametrize("method", SAMPLED)
def test_sampled_methods_come_near_the_direct_solution(method):
    F, E, rho = enclosure(40, 1)
    B, direct = (aktina.solve_radiosity(F, E, rho, method=m) for m in (method, "matrix"))
    assert np.sqrt(np.mean((B / direct - 1) ** 2)) < 0.01
    np.testing.assert_allclose(B, direct, rtol=0.05)


@pytest.mark.parametrize("method", [m for m in EXACT if m != "substructured"])
@pytest.mark.parametrize("rho", [0.999, 0.9999])
def test_bright_walls_converge_all_the_same(method, rho):
    B = aktina.solve_radiosity([[0, 1], [1, 0]], [1, 0], [rho, rho], method=method)
    np.testing.assert_allclose(B, np.array([1, rho]) / (1 - rho**2), rtol=1e-9)


@pytest.mark.parametrize("method", EXACT)
def test_furnace(method):
    F, _, _ = enclosure(25, 3)
    np.testing.assert_allclose(aktina.solve_radiosity(F, np.ones(25), np.full(25, 0.75), method=method), 4, rtol=1e-9)


@pytest.mark.parametrize("method", SAMPLED + EXACT)
def test_black_surfaces_only_emit_and_more_reflectance_is_more_light(method):
    F, E, rho = enclosure(20, 4)
    assert (aktina.solve_radiosity(F, E, rho * 0, method=method) == E).all()
    darker, brighter = (aktina.solve_radiosity(F, E, rho * k, method=method) for k in (0.5, 1))
    assert (E <= darker + 1e-9).all() and (darker <= brighter + 1e-9).all()


@pytest.mark.parametrize("method", SAMPLED + EXACT)
def test_reflectances_without_a_finite_solution_are_refused(method):
    with pytest.raises(aktina.BadParam, match="no finite solution"):
        aktina.solve_radiosity([[0, 1], [1, 0]], [1, 0], [0.5, 1.0], method=method)
    with pytest.raises(aktina.BadParam, match="no finite solution"):
        aktina.solve_radiosity([[0, 2], [1, 0]], [1, 0], [0.5, 0.5], method=method)


def test_shapes_are_checked():
    for F, E, rho in (([[0, 1]], [1], [0]), (np.zeros((2, 2)), [1], [0]), (np.zeros((2, 2)), [1, 1], [0, 0, 0])):
        with pytest.raises(aktina.UsageError):
            aktina.solve_radiosity(F, E, rho)
    assert aktina.solve_radiosity(np.zeros((0, 0)), [], []).shape == (0,)


@pytest.mark.parametrize("method", ON_SURFACES)
def test_solvers_that_cut_surfaces_take_no_matrix(method):
    with pytest.raises(aktina.Error, match="ray_cast"):
        aktina.solve_radiosity([[0, 1], [1, 0]], E=[1, 0], rho=[0.5, 0.8], method=method)
