"""Pictures and radiosity solutions of scenes."""
import _thread
import pathlib
import threading

import numpy as np
import pytest

import aktina

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
QUAD = [[0, 1, 2], [0, 2, 3]]


def box(emission=1.0, rho=0.5):
    """A closed cube of 1 m whose inside shines and reflects evenly: a white furnace."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    objects = []
    for face in faces:
        p = corners[face]
        if np.cross(p[1] - p[0], p[2] - p[0]) @ (np.full(3, 0.5) - p[0]) < 0:
            p = p[::-1]
        objects.append({"vertices": p, "triangles": QUAD,
                        "material": {"base_colour": rho, "metallic": 0, "specular_weight": 0, "emission": emission}})
    return aktina.Scene(objects, camera={"position": [0.2, 0.3, 0.4], "target": [0.6, 0.5, 0.5]})


def test_a_furnace_is_the_same_by_every_way_of_computing_it():
    scene = box()
    radiance = 1 / (1 - 0.5)  # E / (1 - rho), over pi both
    path = scene.render("path", width=16, height=16, samples=64)
    assert abs(path.mean() - radiance) < 0.02
    solution = scene.radiosity(patch_size=0.5, tolerance=1e-4)
    assert np.allclose(solution.radiosities / np.pi, radiance, rtol=2e-3)
    assert solution.converged and abs(solution.emitted - solution.absorbed) < 2e-3 * solution.emitted
    assert np.allclose(solution.render(16, 16), radiance, rtol=5e-3)


def test_layers_and_cameras():
    scene = aktina.Scene([{"shape": {"type": "disc", "radius": 2}}], sky=1)
    above = {"position": [0, 3, 0], "target": [0, 0, 0], "up": [0, 0, -1]}
    layers = scene.render("raster", width=9, height=9, camera=above, layers=["Z", "N"])
    assert sorted(layers) == ["", "N", "Z"]
    assert abs(layers["Z"][4, 4, 0] - 3) < 1e-4 and np.allclose(layers["N"][4, 4], [0, 1, 0])
    with pytest.raises(aktina.UsageError):
        scene.render("raster", width=9, height=9, camera=7)
    with pytest.raises(aktina.NoSuchMethod):
        scene.render("magic")


def test_a_solution_is_saved_loaded_and_bound_to_its_scene(tmp_path):
    scene = box()
    solution = scene.radiosity(patch_size=0.5)
    solution.save(tmp_path / "box.aktina")
    again = aktina.load_solution(tmp_path / "box.aktina", scene)
    assert (again.radiosities == solution.radiosities).all() and again.steps == solution.steps
    with pytest.raises(aktina.BadInput):
        aktina.load_solution(tmp_path / "box.aktina", box(emission=2))
    for name in ("box.glb", "box.vtu", "box.csv"):
        solution.save(tmp_path / name)
    assert len((tmp_path / "box.csv").read_text().splitlines()) > len(solution.areas)
    lit = aktina.load(tmp_path / "box.glb")
    assert lit.triangles > 0


def test_lights_apart_add_up_and_are_dimmed():
    floor = {"vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]}
    lamps = [{"type": "point", "position": [0, 2, 0], "intensity": 40, "name": "lamp"},
             {"type": "rectangle", "corner": [-0.1, 1, -0.1], "edge_u": [0.2, 0, 0], "edge_v": [0, 0, 0.2],
              "radiance": 100, "name": "panel"}]
    scene = aktina.Scene([floor], lights=lamps, sky=2)
    lights = scene.radiosity_by_light(patch_size=0.25, solver="matrix", tolerance=1e-6)
    assert list(lights) == ["lamp", "panel", "environment"]
    together = scene.radiosity(patch_size=0.25, solver="matrix", tolerance=1e-6)
    np.testing.assert_allclose(aktina.mix(lights).irradiances, together.irradiances, rtol=1e-4, atol=1e-4)
    dimmed = aktina.mix(lights, {"panel": 0, "environment": 0.5})
    expected = lights["lamp"].irradiances + 0.5 * lights["environment"].irradiances
    np.testing.assert_allclose(dimmed.irradiances, expected, rtol=1e-5, atol=1e-5)
    with pytest.raises(aktina.UsageError, match="nobody"):
        aktina.mix(lights, {"nobody": 1})
    with pytest.raises(aktina.UsageError):
        aktina.mix({})
    with pytest.raises(aktina.BadParam):
        aktina.mix(lights, {"lamp": -1})
    with pytest.raises(aktina.Unsupported):
        scene.radiosity_by_light(patch_size=0.25, indirect_size=0)


def test_importance_of_a_view():
    walls = [{"vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]},
             {"vertices": [[-1, 0, -1], [1, 0, -1], [1, 2, -1], [-1, 2, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]}]
    scene = aktina.Scene(walls, lights=[{"type": "point", "position": [0, 2, 0], "intensity": 40}])
    camera = {"position": [0, 1, 3], "target": [0, 0.5, 0]}
    for view in (camera, 0):
        solution = scene.radiosity(solver="hierarchical", patch_size=0.2, importance=view)
        assert solution.converged
    with pytest.raises(aktina.Unsupported):
        scene.radiosity(patch_size=0.2, importance=camera)
    with pytest.raises(aktina.UsageError):
        scene.radiosity(solver="hierarchical", patch_size=0.2, importance=7)


def test_illuminance_agrees_with_the_solution():
    scene = box()
    solution = scene.radiosity(patch_size=0.5, tolerance=1e-4)
    lux = scene.illuminance([0.5, 1e-4, 0.5], [0, 1, 0], samples=4096)
    assert np.allclose(lux, solution.irradiances.mean(axis=0), rtol=0.03)


def test_one_thread_or_many_give_the_same_picture():
    scene = aktina.load(SCENES / "cornell.glb")
    pictures = []
    threads = aktina.thread_count()
    try:
        for count in (1, 2):
            aktina.set_thread_count(count)
            pictures.append(scene.render(width=40, height=40, samples=4))
    finally:
        aktina.set_thread_count(threads)
    assert (pictures[0] == pictures[1]).all()


def test_progress_is_reported_and_an_interrupt_stops():
    scene = aktina.load(SCENES / "cornell.glb")
    seen = []
    scene.render(width=64, height=64, samples=64, progress=lambda *state: seen.append(state))
    assert all(len(state) == 5 for state in seen)
    timer = threading.Timer(0.4, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        scene.render(width=1024, height=1024, samples=4096)
