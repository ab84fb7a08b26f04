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

    def test_khronos_validator_on_lightmaps(self):
        for form in ("emissive", "lightmap"):
            for scene in (ROOM, CORNELL):
                self.succeed("bake", scene, "-o", f"{form}{scene.stem}.glb", "-o", f"{form}{scene.stem}.gltf", "--as", form,
                             "--patch-size", "1", "--tolerance", "0.2", "--lightmap-size", "256", "--direct-samples", "1")
        models = [name for name in self.files() if name.endswith(("glb", "gltf"))]
        self.assertEqual(len(models), 8)
        self.validate(*models)

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

    # Lightmaps.

    def bake_cornell(self, form, *more):
        return self.report("bake", CORNELL, *self.quick, "--as", form, "-o", "lit.glb", "--lightmap-size", "128",
                           "--direct-samples", "1", *more)

    def test_lightmap_has_an_exr_in_lux_beside_it(self):
        report = self.bake_cornell("lightmap", "--exposure", "0.002")
        self.assertEqual([output["file"] for output in report["outputs"]], ["lit.glb", "lit.exr"])
        self.assertEqual(report["counts"]["pages"]["value"], 1)
        self.assertLess(report["counts"]["texel size"]["value"], 0.05)
        scene, _ = read_glb(self.folder / "lit.glb")
        used = scene["extensionsUsed"]
        self.assertIn("MOZ_lightmap", used)
        self.assertNotIn("extensionsRequired", scene)
        primitive = next(mesh for mesh in scene["meshes"] if mesh["name"] == "floor")["primitives"][0]
        material = scene["materials"][primitive["material"]]
        self.assertAlmostEqual(material["extensions"]["MOZ_lightmap"]["intensity"], 3.14159265, places=5)
        self.assertEqual(material["extensions"]["MOZ_lightmap"]["texCoord"], 1)
        self.assertIn("TEXCOORD_1", primitive["attributes"])
        self.assertEqual(material["name"], scene["materials"][material["extras"]["aktina"]["original"]]["name"])

    def test_emissive_is_black_but_for_its_texture(self):
        self.bake_cornell("emissive")
        scene, _ = read_glb(self.folder / "lit.glb")
        for primitive in (p for mesh in scene["meshes"] for p in mesh["primitives"]):
            material = scene["materials"][primitive["material"]]
            self.assertEqual(material["pbrMetallicRoughness"]["baseColorFactor"][:3], [0, 0, 0])
            self.assertEqual(material["emissiveTexture"]["texCoord"], 1)
        [lamp] = [m for m in scene["materials"][: len(scene["materials"]) // 2] if m["name"] == "light"]
        self.assertGreater(lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 1)

    def test_baked_lamps_do_not_shine_a_second_time(self):
        self.succeed("bake", ROOM, "-o", "room.glb", "--as", "lightmap", "--patch-size", "1", "--tolerance", "0.2",
                     "--lightmap-size", "256", "--direct-samples", "1")
        (before, _), (after, _) = read_glb(ROOM), read_glb(self.folder / "room.glb")
        lights = [scene["extensions"]["KHR_lights_punctual"]["lights"] for scene in (before, after)]
        for old, new in zip(*lights):
            self.assertEqual(new["intensity"], 0)
            self.assertAlmostEqual(new["extras"]["aktina"]["intensity"], old["intensity"], places=3)

    def test_the_picture_alone(self):
        self.run_quick(CORNELL, "map.exr", "--lightmap-size", "64", "--direct-samples", "0")
        self.assertEqual(self.files(), ["map.exr"])

    def test_lightmap_that_does_not_fit(self):
        error = self.expect_error("limit", "bake", CORNELL, "-o", "lit.glb", *self.quick, "--as", "emissive",
                                  "--texel-size", "1e-5", "--lightmap-size", "64")
        self.assertIn("--texel-size", error.split("(")[-1])
        self.assertEqual(self.files(), [])

    def test_lightmap_options_out_of_range(self):
        for option, value in (("--lightmap-size", "0"), ("--texel-size", "-1"), ("--padding", "1e9"), ("--as", "disc")):
            self.assertIn(option, self.refuse("usage", CORNELL, None, option, value))

    def test_sidecar_that_cannot_be_written(self):
        (self.folder / "lit.exr").mkdir()
        self.expect_error("input", "bake", CORNELL, *self.quick, "--as", "lightmap", "-o", "lit.glb",
                          "--lightmap-size", "64", "--direct-samples", "0")
        self.assertEqual(self.files(), ["lit.exr"])


del SceneCommandTest  # a base class only

if __name__ == "__main__":
    unittest.main()
