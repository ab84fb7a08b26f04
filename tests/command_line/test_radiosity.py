"""aktina radiosity."""
import csv
import re
import struct
import unittest

from scene_commands import CORNELL, SceneCommandTest


# A floor under two lamps.
LAMPS = """mtllib lamps.mtl
v 0 0 0
v 0 0 1
v 1 0 1
v 1 0 0
v 0.1 1 0.4
v 0.3 1 0.4
v 0.3 1 0.6
v 0.1 1 0.6
v 0.7 1 0.4
v 0.9 1 0.4
v 0.9 1 0.6
v 0.7 1 0.6
o floor
usemtl white
f 1 2 3 4
o left
usemtl shining
f 5 6 7 8
o right
usemtl shining
f 9 10 11 12
"""
LAMPS_MTL = "newmtl white\nKd 0.7 0.7 0.7\nnewmtl shining\nKd 0 0 0\nKe 10 10 10\n"


def read_csv(path):
    """Comments, and records as dictionaries."""
    lines = path.read_text().splitlines()
    return [line for line in lines if line.startswith("# ")], list(csv.DictReader(line for line in lines if line[:2] != "# "))


def read_vtu(path):
    """Arrays of a VTU by VTK's rules: (section, name) -> values."""
    data = path.read_bytes()
    head, raw = data.split(b'<AppendedData encoding="raw">\n_', 1)
    arrays, section = {}, None
    for tag in re.findall(r"<[^>]*>", head.decode()):
        name = tag[1:].split()[0].rstrip(">")
        if name in ("PointData", "CellData", "Points", "Cells"):
            section = name
        if name == "DataArray":
            fields = dict(re.findall(r'(\w+)="([^"]*)"', tag))
            at = int(fields["offset"])
            (size,) = struct.unpack_from("<Q", raw, at)
            code = {"Float32": "f", "Float64": "d", "Int64": "q", "UInt8": "B"}[fields["type"]]
            arrays[section, fields["Name"]] = struct.unpack_from(f"<{size // struct.calcsize(code)}{code}", raw, at + 8)
    return arrays


class Radiosity(SceneCommandTest):
    command, extension = "radiosity", "vtu"
    quick = ["--patch-size", "0.2", "--tolerance", "0.05"]
    endless = ["--patch-size", "0.05", "--tolerance", "1e-12"]

    def provenance(self, path):
        head = path.read_bytes().split(b"<AppendedData")[0].decode()
        texts = re.findall(r'<Array type="String"[^>]*>([0-9 ]*)</Array>', head)
        return b"\n".join(bytes(map(int, text.split())) for text in texts)

    def test_every_format_tells_the_same(self):
        self.succeed("radiosity", CORNELL, *self.quick, "-o", "a.csv", "-o", "a.vtu", "-o", "a.glb")
        self.assertEqual(self.files(), ["a.csv", "a.glb", "a.vtu"])
        comments, patches = read_csv(self.folder / "a.csv")
        arrays = read_vtu(self.folder / "a.vtu")
        self.assertTrue(any("cornell.glb" in line for line in comments))
        self.assertEqual(len(patches), len(arrays["CellData", "area"]))
        self.assertIn("tall block", {patch["instance"] for patch in patches})
        for patch, lux, area in zip(patches, arrays["CellData", "illuminance"], arrays["CellData", "area"]):
            self.assertAlmostEqual(float(patch["illuminance_lx"]), lux, delta=1e-3 * lux + 1e-6)
            self.assertAlmostEqual(float(patch["area_m2"]), area, delta=1e-6)
        floor = sum(float(patch["area_m2"]) for patch in patches if patch["instance"] == "floor")
        self.assertAlmostEqual(floor, 0.556 * 0.5592, delta=1e-5)

    def test_energy_is_accounted_for(self):
        counts = self.report("radiosity", CORNELL, *self.quick, "-o", "a.csv")["counts"]
        emitted, absorbed, escaped = (counts[name]["value"] for name in ("emitted", "absorbed", "escaped"))
        self.assertAlmostEqual(emitted, 3000 * 3.14159265 * 0.130 * 0.105, delta=0.01 * emitted)  # pi L A, lm
        self.assertGreater(absorbed + escaped, 0.9 * emitted)
        self.assertLess(absorbed + escaped, 1.001 * emitted)

    def test_each_light_and_lights_dimmed(self):
        lamp = self.folder / "lamps.obj"
        lamp.write_text(LAMPS), (self.folder / "lamps.mtl").write_text(LAMPS_MTL)
        solve = ["radiosity", "lamps.obj", *self.quick, "--solver", "matrix", "--tolerance", "1e-5"]
        self.succeed(*solve, "-o", "all.csv", "--each-light")
        self.assertEqual(self.files(), ["all.0.left.csv", "all.1.right.csv", "lamps.mtl", "lamps.obj"])
        self.succeed(*solve, "-o", "dim.csv", "--dim", "left=0.25", "--dim", "right=3")
        lux = [[float(patch["illuminance_lx"]) for patch in read_csv(self.folder / name)[1]]
               for name in ("all.0.left.csv", "all.1.right.csv", "dim.csv")]
        self.assertGreater(max(lux[0]), 0)
        for left, right, mixed in zip(*lux):
            self.assertAlmostEqual(0.25 * left + 3 * right, mixed, delta=1e-3 * mixed + 1e-6)
        for text in ("left", "left=", "left=-1", "left=nan", "=1x", "nobody=1"):
            self.expect_error("usage", *solve, "-o", "no.csv", "--dim", text)
        self.expect_error("usage", *solve, "-o", "no.csv", "--dim", "left=1", "--each-light")
        self.expect_error("input", *solve, "-o", "no.csv", "--dim", "left=1", "--indirect-size", "0")
        self.assertNotIn("no.csv", self.files())

    def test_importance_of_a_camera(self):
        self.succeed("radiosity", CORNELL, *self.quick, "--solver", "hierarchical", "--importance", "0", "-o", "a.csv")
        self.assertIn("no camera", self.refuse("usage", CORNELL, None, "--solver", "hierarchical", "--importance", "x"))
        self.refuse("input", CORNELL, None, "--importance", "0")

    def test_not_converged_is_an_exit_status(self):
        result = self.run_program("radiosity", CORNELL, "-o", "a.csv", "--patch-size", "0.2", "--max-steps", "1")
        self.assertEqual(result.returncode, 5)
        self.assertIn("not converged", result.stderr)
        self.assertEqual(self.files(), ["a.csv"])

    def test_unknown_methods(self):
        self.assertIn("did you mean progressive?", self.refuse("usage", CORNELL, None, "--solver", "progresive"))
        self.assertIn("uniform", self.refuse("usage", CORNELL, None, "--mesher", "unifrm"))

    def test_a_huge_mesh_is_refused_before_memory_is_taken(self):
        self.assertIn("patch", self.refuse("limit", CORNELL, None, "--patch-size", "1e-6"))


del SceneCommandTest  # a base class only

if __name__ == "__main__":
    unittest.main()
