"""aktina bake: what it writes is valid glTF, and shows what the solution says."""
import json
import struct
import subprocess
import unittest

from program import REPOSITORY
from scene_commands import CORNELL, ROOM, SceneCommandTest


def read_glb(path):
    """JSON and binary chunk."""
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + length]), data[28 + length :]


class Bake(SceneCommandTest):
    command, extension = "bake", "glb"
    quick = ["--patch-size", "0.2", "--tolerance", "0.05"]
    endless = ["--patch-size", "0.05", "--tolerance", "1e-12"]

    def validate(self, *names):
        script = REPOSITORY / "tests" / "export" / "validate.mjs"
        result = subprocess.run(["node", script, *names], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)

    def test_khronos_validator_has_no_errors_and_no_warnings(self):
        self.succeed("bake", ROOM, "-o", "room.glb", "-o", "room ü.gltf", "--patch-size", "1", "--tolerance", "0.2")
        self.run_quick(CORNELL, "cornell.glb")
        self.validate("room.glb", "room ü.gltf", "cornell.glb")

    def test_names_cameras_lights_and_textures_stay(self):
        self.succeed("bake", ROOM, "-o", "room.glb", "--patch-size", "1", "--tolerance", "0.2")
        (before, old), (after, new) = read_glb(ROOM), read_glb(self.folder / "room.glb")
        names = lambda scene, what: sorted(item.get("name", "") for item in scene[what])
        self.assertEqual(names(before, "nodes"), names(after, "nodes"))
        self.assertEqual(before["cameras"][0]["perspective"]["znear"], round(after["cameras"][0]["perspective"]["znear"], 6))
        lights = [scene["extensions"]["KHR_lights_punctual"]["lights"][0] for scene in (before, after)]
        self.assertAlmostEqual(lights[0]["intensity"], lights[1]["intensity"], places=3)
        picture = lambda scene, data: [data[v["byteOffset"] :][: v["byteLength"]] for v in
                                       (scene["bufferViews"][image["bufferView"]] for image in scene["images"])]
        self.assertEqual(sorted(picture(before, old)), sorted(picture(after, new)))

    def test_original_materials_can_be_restored(self):
        self.run_quick(CORNELL, "lit.glb")
        scene, _ = read_glb(self.folder / "lit.glb")
        originals = {}
        for primitive in (p for mesh in scene["meshes"] for p in mesh["primitives"]):
            material = scene["materials"][primitive["material"]]
            self.assertIn("KHR_materials_unlit", material["extensions"])
            original = scene["materials"][material["extras"]["aktina"]["original"]]
            self.assertEqual(original["name"], material["name"])
            originals[original["name"]] = original
        self.assertEqual(originals["light"]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 3000)
        for value, expected in zip(originals["red"]["pbrMetallicRoughness"]["baseColorFactor"], (0.61, 0.06, 0.06, 1)):
            self.assertAlmostEqual(value, expected, places=6)

    def test_exposure_is_recorded_and_scales_the_colours(self):
        def first_colours(exposure):
            report = self.report("bake", CORNELL, *self.quick, "-o", "lit.glb", "--exposure", exposure)
            self.assertAlmostEqual(report["counts"]["exposure"]["value"], float(exposure))
            scene, data = read_glb(self.folder / "lit.glb")
            self.assertAlmostEqual(scene["asset"]["extras"]["aktina"]["exposure"], float(exposure), places=9)
            [mesh] = [mesh for mesh in scene["meshes"] if mesh["name"] == "floor"]
            accessor = scene["accessors"][mesh["primitives"][0]["attributes"]["COLOR_0"]]
            at = scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
            return struct.unpack_from(f"<{3 * accessor['count']}f", data, at)

        for dim, bright in zip(first_colours("0.0001"), first_colours("0.0002")):
            self.assertAlmostEqual(2 * dim, bright, delta=1e-6)


del SceneCommandTest  # a base class only

if __name__ == "__main__":
    unittest.main()
