"""Rays against single shapes, and vertex normals."""
import numpy as np
import pytest

import aktina
from reference.cases import ids


def rays(count, seed):
    generator = np.random.default_rng(seed)
    return generator.normal(size=(count, 3)) * 3, generator.normal(size=(count, 3))


@pytest.mark.parametrize("shape, sizes, distance_to", [
    ("sphere", {"centre": [0.5, 0, 0], "radius": 1.5}, lambda p: np.linalg.norm(p - [0.5, 0, 0], axis=1) - 1.5),
    ("plane", {"normal": [1, 2, 2], "d": 1}, lambda p: p @ [1, 2, 2] - 1),
    ("triangle", {"vertices": [[-4, -4, 1], [4, -4, 1], [0, 5, 1]]}, lambda p: p[:, 2] - 1),
    ("disc", {"radius": 2}, lambda p: p[:, 1]),
    ("cylinder", {"radius": 1, "height": 3}, lambda p: np.hypot(p[:, 0], p[:, 2]) - 1),
    ("cone", {"radius": 1, "top_radius": 0.5, "height": 2}, lambda p: np.hypot(p[:, 0], p[:, 2]) - 1 + p[:, 1] / 4)])
def test_hits_lie_on_the_surface(shape, sizes, distance_to):
    origins, directions = rays(2000, 7)
    hits = aktina.intersect(shape, origins, directions, **sizes)
    assert 20 < hits.hit.sum() < 2000
    assert abs(distance_to(hits.point[hits.hit])).max() < 1e-9
    np.testing.assert_allclose(np.linalg.norm(hits.normal[hits.hit], axis=1), 1, rtol=1e-12)
    assert np.isnan(hits.point[~hits.hit]).all() and np.isnan(hits.normal[~hits.hit]).all()


def test_near_and_far_bound_a_hit():
    def distance(**bounds):
        return aktina.intersect("sphere", [0, 0, -3], [0, 0, 1], **bounds).distance
    assert distance() == 2 and distance(near=2.5) == 4 and np.isinf(distance(far=1.5))


def test_a_concave_polygon_has_its_notch():
    arrow = [[0, 0, 0], [2, -2, 0], [0, 3, 0], [-2, -2, 0]]
    below, inside = aktina.intersect("polygon", [[0, -1, 5], [0, 1, 5]], [0, 0, -1], vertices=arrow).hit
    assert inside and not below


@pytest.mark.parametrize("method", ids("normals"))
def test_a_symmetric_fan_has_its_axis_as_normal(method):
    turn = np.linspace(0, 2 * np.pi, 7)[:-1]
    rim = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    np.testing.assert_allclose(aktina.vertex_normal(method, [0, 0, 1], rim), [0, 0, 1], atol=1e-15)
    np.testing.assert_allclose(aktina.vertex_normal(method, [0, 0, 1], rim[::-1]), [0, 0, -1], atol=1e-15)


def test_an_open_fan_leaves_out_the_last_facet():
    corner = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    np.testing.assert_allclose(aktina.vertex_normal("plain", [0, 0, 0], corner[:2], closed=False), [0, 0, 1])
    np.testing.assert_allclose(aktina.vertex_normal("plain", [0, 0, 0], corner), np.ones(3) / np.sqrt(3))
