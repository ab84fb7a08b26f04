"""Illumination models and lights on arrays."""
import numpy as np
import pytest

import aktina

UP = [0, 0, 1]


def directions(count, seed):
    """Unit vectors in the upper half space."""
    v = np.random.default_rng(seed).normal(size=(count, 3))
    v[:, 2] = abs(v[:, 2]) + 0.01
    return (v / np.linalg.norm(v, axis=1, keepdims=True)).astype(np.float32)


@pytest.mark.parametrize("model", [method["id"] for method in aktina.methods("illumination")])
def test_many_samples_are_single_samples(model):
    l, v = directions(50, 1), directions(50, 2)
    exponent = np.linspace(1, 80, 50)
    material = {"kd": [0.1, 0.2, 0.3], "ks": np.linspace(0, 1, 50)[:, None] * [1, 1, 0.5], "exponent": exponent}
    together = aktina.illuminate(model, material, UP, l, v, light=[1, 2, 3], ambient=0.1)
    for i in range(50):
        alone = aktina.illuminate(model, {"kd": [0.1, 0.2, 0.3], "ks": material["ks"][i], "exponent": exponent[i]}, UP,
                                  l[i], v[i], light=[1, 2, 3], ambient=0.1)
        assert (together[i] == alone).all()


def test_leading_axes_broadcast():
    l, v = directions(5, 3), directions(4, 4)
    table = aktina.illuminate("phong", {"ks": 1, "exponent": 9}, UP, l[:, None], v)
    assert table.shape == (5, 4, 3) and table.dtype == np.float32
    assert (table[2, 3] == aktina.illuminate("phong", {"ks": 1, "exponent": 9}, UP, l[2], v[3])).all()
    assert aktina.illuminate("lambert", {}, UP, UP).shape == (3,)
    assert aktina.illuminate("lambert", {}, UP, np.empty((0, 3))).shape == (0, 3)


def test_light_is_linear_and_ambient_is_apart():
    l, v = directions(20, 5), directions(20, 6)
    material = {"ka": 0.3, "kd": 0.4, "ks": 0.5, "exponent": 12}
    one = aktina.illuminate("blinn_phong", material, UP, l, v)
    np.testing.assert_allclose(aktina.illuminate("blinn_phong", material, UP, l, v, light=3, ambient=2), 3 * one + 0.6,
                               rtol=1e-6)


def test_light_from_behind_leaves_the_ambient_term():
    np.testing.assert_allclose(aktina.illuminate("phong", {"ka": 0.5}, UP, [0, 0.6, -0.8], ambient=2), [1, 1, 1])


@pytest.mark.parametrize("wrong, error", [
    ({"n": [0, 0, 2]}, aktina.BadParam), ({"n": [0, 0, np.nan]}, aktina.BadParam), ({"n": [0, 1]}, aktina.UsageError),
    ({"n": "up"}, aktina.UsageError), ({"light": [1, 2]}, aktina.UsageError), ({"l": [[0, 0, 1]] * 3}, aktina.UsageError),
    ({"model": "phong:n=3"}, aktina.UsageError), ({"material": {"kd": np.inf}}, aktina.BadParam)])
def test_bad_arguments(wrong, error):
    good = {"model": "phong", "material": {}, "n": [UP] * 2, "l": UP}
    with pytest.raises(error):
        aktina.illuminate(**{**good, **wrong})


def test_irradiance_of_every_type_of_light():
    down = [0, 0, -1]
    below = [[0, 0, 0], [0, 0, 1]]
    point = {"type": "point", "position": [0, 0, 2], "intensity": 8}
    spot = {**point, "type": "spot", "direction": down, "inner_angle": 0.4, "outer_angle": 0.5}
    sun = {"type": "directional", "direction": [0, 0, -3], "illuminance": [1, 2, 3]}
    np.testing.assert_allclose(aktina.irradiance(point, below, UP)[:, 0], [2, 8])
    np.testing.assert_allclose(aktina.irradiance(spot, below, UP)[:, 0], [2, 8])
    assert (aktina.irradiance(spot, [2, 0, 0], UP) == 0).all()
    np.testing.assert_allclose(aktina.irradiance(sun, below, [0, 0.6, 0.8]), [[0.8, 1.6, 2.4]] * 2, rtol=1e-6)
    linear = {**point, "attenuation": [1, 1, 0]}
    np.testing.assert_allclose(aktina.irradiance(linear, below, UP)[:, 0], [8 / 3, 4], rtol=1e-6)


def test_spot_falls_off_smoothly_between_its_cones():
    angles = np.linspace(0, 1, 101)
    l = np.stack([np.sin(angles), np.zeros(101), np.cos(angles)], axis=1)
    falloff = aktina.spot_falloff([0, 0, -1], l, outer_angle=0.8, inner_angle=0.2)
    assert (falloff[angles < 0.2] == 1).all() and (falloff[angles > 0.8] == 0).all()
    assert (np.diff(falloff) <= 0).all() and abs(np.diff(falloff)).max() < 0.05


def test_lamps_with_an_area_and_flaps():
    panel = {"type": "rectangle", "corner": [-0.5, 2, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1], "radiance": 10}
    disc = {"type": "disc", "position": [0, 2, 0], "direction": [0, -2, 0], "radius": 0.5, "radiance": 10}
    up = [0, 1, 0]
    np.testing.assert_allclose(aktina.irradiance(disc, [0, 0, 0], up), 10 * np.pi * 0.25 / 4.25, rtol=1e-5)
    assert (aktina.irradiance(panel, [0, 3, 0], [0, -1, 0]) == 0).all()
    far = aktina.irradiance(panel, [0, -98, 0], up)
    np.testing.assert_allclose(far, 10 / 100**2, rtol=1e-3)
    warn = {"type": "warn", "position": [0, 2, 0], "direction": [0, -1, 0], "intensity": 8, "flap_high": [0.5, 9, 9]}
    assert aktina.irradiance(warn, [[0, 0, 0], [0.6, 0, 0]], up)[:, 0].tolist() == [2, 0]
    room = aktina.Scene([], [panel, disc, warn])
    assert room.triangles == 2 and [lamp["type"] for lamp in room.lights] == ["warn"]
    assert aktina.irradiance(room.lights[0], [0, 0, 0], up)[0] == 2


def test_energy_and_reciprocity():
    material = {"kd": [0.2, 0.4, 0.6], "ks": 0}
    np.testing.assert_allclose(aktina.albedo("phong", material, [[1, 0.5]]), [[[0.2, 0.4, 0.6]] * 2], atol=2e-3)
    assert aktina.reciprocity("ward", {"ks": 0.5})[0] < 1e-5 < aktina.reciprocity("phong", {"ks": 0.5})[0]
    with pytest.raises(aktina.BadParam):
        aktina.albedo("phong", material, 1.1)


def test_normals_of_meshes():
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    assert len(aktina.mesh_normals(cube, triangles, crease=1)["vertices"]) == 24
    smooth = aktina.mesh_normals(cube, triangles, "angle", crease=np.pi)
    np.testing.assert_allclose(smooth["normals"], (2 * cube - 1) / np.sqrt(3), atol=1e-6)
    with pytest.raises(aktina.UsageError):
        aktina.mesh_normals(cube, [[0, 1, 8]])
