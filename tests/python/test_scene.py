"""Scenes built from dictionaries, and rays through them."""
import os
import pathlib
import signal
import threading
import time

import numpy as np
import pytest

import aktina

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
FLOOR = {"vertices": [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, -9]], "triangles": [[0, 1, 2], [0, 2, 3]]}


def test_hits_say_what_and_where():
    lifted = np.eye(4)
    lifted[1, 3] = 3
    scene = aktina.Scene([FLOOR, {"shape": {"type": "sphere", "radius": 1}, "to_world": lifted}])
    hits = aktina.trace(scene, [[0, 9, 0], [5, 9, 0], [20, 9, 0]], [0, -2, 0])
    assert hits.distance.tolist() == [2.5, 4.5, np.inf]
    assert hits.instance.tolist() == [1, 0, -1]
    assert np.allclose(hits.point[:2], [[0, 4, 0], [5, 0, 0]], atol=1e-6)
    assert np.allclose(hits.normal[:2], [[0, 1, 0], [0, 1, 0]])
    assert np.isnan(hits.normal[2]).all()
    assert not aktina.trace(scene, [0, 9, 0], [0, -1, 0], far=4).hit


def test_every_integrator_lights_a_floor():
    lamp = {"type": "point", "position": [0, 2, 0], "intensity": [40, 40, 20]}
    scene = aktina.Scene([{**FLOOR, "material": {"kd": [1, 0.5, 1]}}], [lamp])
    for row in aktina.methods("integrator"):
        seen = aktina.radiance(scene, [0, 1, 0.1], [0, -1, -0.1], row["id"], samples=4)
        assert np.allclose(seen, [10 / np.pi, 5 / np.pi, 5 / np.pi], rtol=1e-3), row["id"]


def test_what_is_no_mesh_and_no_light_is_refused():
    for triangles in ([[0, 1, 2]], [[0, 1, -2]]):
        with pytest.raises(aktina.BadInput, match="vertex"):
            aktina.Scene([{"vertices": [[0, 0, 0], [1, 0, 0]], "triangles": triangles}])
    for light in ({"type": "point", "intensity": -1}, {"type": "point", "attenuation": [0, 0, 0]},
                  {"type": "point", "attenuation": [1, -1, 0]}, {"type": "disc", "radius": -1, "direction": [0, -1, 0]}):
        with pytest.raises(aktina.BadParam):
            aktina.irradiance(light, [0, 0, 1], [0, 0, -1])


def test_a_picture_of_the_sky_shines(tmp_path):
    sky = np.zeros((90, 180, 3), np.float32)
    sky[10:14, 88:92] = [1e3, 2e3, 4e3]  # towards -z
    scene = aktina.Scene([{**FLOOR, "material": {"kd": 1}}], sky=sky)
    seen = aktina.radiance(scene, [0, 1, 0], [[0, -1, 0.01]], "path", samples=256)[0]
    assert seen[0] > 0 and np.allclose(seen / seen[0], [1, 2, 4], rtol=1e-3)
    turned = aktina.Scene([{**FLOOR, "material": {"kd": 1}}], sky=sky, sky_rotation=np.pi / 2)
    first, second = (aktina.radiance(s, [0, 1, 0], [[0, 0.9, -0.43], [-0.43, 0.9, 0], [0.43, 0.9, 0]], "direct")
                     for s in (scene, turned))
    assert first[0, 0] > 0 and second[0, 0] == 0 and (second[1:, 0] > 0).sum() == 1
    aktina.write_image(tmp_path / "sky.exr", sky)
    (tmp_path / "floor.obj").write_text("v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n")
    lit = aktina.load(tmp_path / "floor.obj", environment=tmp_path / "sky.exr", environment_scale=2)
    np.testing.assert_allclose(aktina.radiance(lit, [0, 1, 0], [[0, 0.9, -0.43]], "direct"), 2 * first[:1], rtol=1e-3)
    for wrong in (np.zeros((4, 4, 2)), -np.ones((4, 4, 3)), np.full((2, 2, 3), np.nan)):
        with pytest.raises(aktina.Error):
            aktina.Scene(sky=wrong)


def test_shapes_of_arguments_broadcast():
    scene = aktina.Scene(sky=[1, 2, 3])
    seen = aktina.radiance(scene, np.zeros((4, 1, 3)), np.full((1, 5, 3), 0.5), "direct")
    assert seen.shape == (4, 5, 3) and seen.dtype == np.float32
    assert (seen == [1, 2, 3]).all()


def test_seeds_repeat():
    scene = aktina.Scene([{**FLOOR, "material": {"kd": 1}}], sky=1)
    rays = scene, np.tile([0, 1, 0.1], (50, 1)), [0.5, -1, 0]
    first, again, other = (aktina.radiance(*rays, samples=2, seed=seed) for seed in (1, 1, 2))
    assert (first == again).all() and (first != other).any()


@pytest.mark.parametrize("arguments, where", [
    ({"objects": [{}]}, "object"),
    ({"objects": [{**FLOOR, "colour": 1}]}, "object.colour"),
    ({"objects": [{**FLOOR, "material": {"shininess": 1}}]}, "material.shininess"),
    ({"objects": [{**FLOOR, "material": {"kd": "red"}}]}, "material.kd"),
    ({"objects": [{**FLOOR, "vertices": [[0, 0], [1, 1]]}]}, "vertices"),
    ({"objects": [{"shape": {"type": "sphere", "size": 1}}]}, "shape.size"),
    ({"camera": {"lens": 50}}, "camera.lens"),
])
def test_wrong_fields_are_named(arguments, where):
    with pytest.raises(aktina.UsageError) as error:
        aktina.Scene(**arguments)
    assert error.value.where == where


def test_wrong_rays_and_methods():
    scene = aktina.Scene()
    with pytest.raises(aktina.UsageError):
        aktina.radiance(scene, [0, 0, 0], [0, 0, 0])
    with pytest.raises(aktina.NoSuchMethod):
        aktina.radiance(scene, [0, 0, 0], [0, 0, 1], "photons")
    with pytest.raises(aktina.BadParam):
        aktina.radiance(scene, [0, 0, 0], [0, 0, 1], "path", samples=0)
    with pytest.raises(aktina.Error):
        aktina.trace(aktina.Scene([{**FLOOR, "triangles": [[0, 1, 9]]}]), [0, 0, 0], [0, 0, 1])


def test_ctrl_c_stops_the_work():
    scene = aktina.Scene([{**FLOOR, "material": {"kd": 1}}], sky=1)
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        aktina.radiance(scene, np.tile([0, 1, 0.1], (1000, 1)), [0.5, -1, 0], samples=1 << 20)
    assert time.monotonic() - begun < 20


def test_files_become_scenes():
    scene = aktina.load(SCENES / "cornell.glb")
    assert scene.triangles > 10 and len(scene.hash) == 16
