"""aktina illuminance."""
import json
import unittest

from scene_commands import CORNELL, SceneCommandTest
from test_radiosity import read_csv, read_vtu

LAMP = """{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
"scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"translation": [0, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}]}"""


class Illuminance(SceneCommandTest):
    command, extension = "illuminance", "csv"
    grid = ["--grid", "0.05,0.1,-0.05:0.4,0,0:0,0,-0.4"]
    quick = [*grid, "--spacing", "0.2", "--target-error", "0.2"]
    endless = [*grid, "--spacing", "0.1", "--target-error", "1e-6", "--max-samples", "16777216"]

    def test_output_is_required(self):
        """It is not: the summary is a result."""
        self.assertIn("uniformity", self.succeed("illuminance", CORNELL, *self.quick).stdout)

    def test_every_format_tells_the_same(self):
        result = json.loads(self.succeed("illuminance", CORNELL, *self.quick, "-o", "a.csv", "-o", "a.vtu", "-o",
                                         "a.png", "--json").stdout)["result"]
        comments, points = read_csv(self.folder / "a.csv")
        lux = [float(p["illuminance_lx"]) for p in points]
        self.assertEqual(len(lux), result["points"])
        self.assertTrue(any("cornell.glb" in line for line in comments))
        self.assertAlmostEqual(sum(lux) / len(lux), result["average_lx"], delta=1e-4 * result["average_lx"])
        self.assertAlmostEqual(min(lux), result["minimum_lx"], delta=1e-4 * result["average_lx"])
        self.assertAlmostEqual(result["uniformity"], min(lux) / result["average_lx"], delta=1e-4)
        for a, b in zip(lux, read_vtu(self.folder / "a.vtu")["CellData", "illuminance"]):
            self.assertAlmostEqual(a, b, delta=1e-4 * b)
        self.assertEqual((self.folder / "a.png").read_bytes()[:4], b"\x89PNG")

    def test_points_of_a_file(self):
        (self.folder / "lamp.gltf").write_text(LAMP)
        (self.folder / "meters.csv").write_text("x,y,z,nx,ny,nz\n# a comment\n0,0,0,0,1,0\n2,2,0,-1,0,0\n0,0,0,1,0,0\n")
        self.succeed("illuminance", "lamp.gltf", "--points", "meters.csv", "-o", "a.csv")
        lux = [float(p["illuminance_lx"]) for p in read_csv(self.folder / "a.csv")[1]]
        for value, wanted in zip(lux, (25, 25, 0)):
            self.assertAlmostEqual(value, wanted, delta=0.01)

    def test_grid_and_surface(self):
        for way in (["--plane", "0.3"], ["--plane", "0.3", "--margin", "0"], ["--surface", "floor"]):
            result = json.loads(self.succeed("illuminance", CORNELL, *way, "--target-error", "0.2", "--json").stdout)
            self.assertGreater(result["result"]["average_lx"], 0)

    def test_mistakes(self):
        (self.folder / "bad.csv").write_text("1,2\n")
        (self.folder / "far.csv").write_text("1,2,inf\n")
        for status, *words in (("usage", "--grid", "1,2,3"), ("usage", "--grid", "0,0,0:1,0,0:2,0,0"),
                               ("usage", "--plane", "9"), ("usage", "--surface", "nothing"),
                               ("input", "--points", "bad.csv"), ("input", "--points", "far.csv"),
                               ("input", "--points", "none.csv"), ("limit", "--plane", "0.1", "--spacing", "1e-9"),
                               ("usage", "--plane", "0.1", "--grid", "0,0,0:1,0,0:0,0,1"),
                               ("usage", "--surface", "floor", "-o", "a.png"), ("usage", "-o", "a.txt")):
            with self.subTest(words):
                self.expect_error(status, "illuminance", CORNELL, *words)


del SceneCommandTest  # a base class only

if __name__ == "__main__":
    unittest.main()
