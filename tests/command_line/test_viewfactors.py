"""aktina viewfactors."""
import csv
import json
import math
import pathlib
import struct
import unittest
import zipfile

from program import REPOSITORY, ProgramTest

VIEW3D = REPOSITORY.parent / "shared" / "scenes" / "ref-view3d"

CUBE = """o room
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 2 3 4
f 8 7 6 5
f 1 5 6 2
f 2 6 7 3
f 3 7 8 4
f 4 8 5 1
"""
# A block of another material in it, as another object.
BLOCK = """o block
v .3 .2 .1
v .7 .2 .1
v .7 .6 .1
v .3 .6 .1
v .3 .2 .5
v .7 .2 .5
v .7 .6 .5
v .3 .6 .5
f 12 11 10 9
f 13 14 15 16
f 10 14 13 9
f 11 15 14 10
f 12 16 15 11
f 9 13 16 12
"""
OPPOSED, BESIDE = 0.199824895698, 0.200043776075  # closed forms of unit squares


def read_npz(path):
    """Arrays by NumPy's rules, without NumPy: name -> flat list of numbers or texts."""
    arrays = {}
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            data = archive.read(name)
            assert data[:8] == b"\x93NUMPY\x01\x00"
            (length,) = struct.unpack_from("<H", data, 8)
            head = eval(data[10 : 10 + length])  # a dictionary literal
            body, kind = data[10 + length :], head["descr"]
            if kind.startswith("<U"):
                size = 4 * int(kind[2:])
                values = [body[i : i + size].decode("utf-32-le").rstrip("\0") for i in range(0, len(body), size)]
            elif kind.startswith("|S"):
                values = [body]
            else:
                code = {"<f8": "d", "<f4": "f", "<i8": "q", "<i4": "i"}[kind]
                values = list(struct.unpack(f"<{len(body) // struct.calcsize(code)}{code}", body))
            assert len(values) == math.prod(head["shape"])
            arrays[name[:-4]] = values
    return arrays


class ViewFactors(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cube.obj").write_text(CUBE)
        (self.folder / "block.obj").write_text("mtllib a.mtl\nusemtl white\n" + CUBE + "usemtl black\n" + BLOCK)
        (self.folder / "a.mtl").write_text("newmtl white\nnewmtl black\n")

    def test_polygons_stay_polygons(self):
        self.succeed("viewfactors", "cube.obj", "-o", "F.npz")
        arrays = read_npz(self.folder / "F.npz")
        self.assertEqual(arrays["names"], [f"room:{i}" for i in range(6)])
        self.assertEqual(arrays["areas"], [1] * 6)
        F = [arrays["F"][6 * i : 6 * i + 6] for i in range(6)]
        self.assertAlmostEqual(F[0][1], OPPOSED, delta=1e-9)
        self.assertAlmostEqual(F[0][2], BESIDE, delta=1e-9)
        for row in F:
            self.assertAlmostEqual(sum(row), 1, delta=1e-9)

    def test_every_format_tells_the_same(self):
        formats = ["npz", "h5", "csv", "vtu", "txt"]
        self.succeed("viewfactors", "cube.obj", *(word for f in formats for word in ("-o", f"F.{f}")))
        F = read_npz(self.folder / "F.npz")["F"]
        lines = [line for line in (self.folder / "F.csv").read_text().splitlines() if line[:2] != "# "]
        table = list(csv.reader(lines))
        self.assertEqual([float(x) for row in table[1:7] for x in row[2:]], F)
        text = (self.folder / "F.txt").read_text().splitlines()
        self.assertEqual(text[0].split(), ["View3D", "3.3", "0", "0", "0", "6"])
        self.assertEqual([float(x) for line in text[2:8] for x in line.split()], F)
        self.assertEqual((self.folder / "F.h5").read_bytes()[:8], b"\x89HDF\r\n\x1a\n")
        self.assertIn(struct.pack("<6d", *F[:6]), (self.folder / "F.h5").read_bytes())
        self.assertIn(b"row_sum", (self.folder / "F.vtu").read_bytes())

    def test_same_bytes_for_any_number_of_threads(self):
        for extension in ("npz", "h5", "csv", "vtu"):
            for threads in ("1", "2"):
                self.succeed("viewfactors", "block.obj", "-o", f"{threads}.{extension}", "--threads", threads)
            one, two = ((self.folder / f"{threads}.{extension}").read_bytes() for threads in ("1", "2"))
            self.assertEqual(one, two, extension)

    def test_the_certificate_is_in_the_report_and_in_the_file(self):
        report = self.report("viewfactors", "cube.obj", "-o", "F.npz")
        certificate = report["result"]
        self.assertIs(certificate["closed"], True)
        self.assertAlmostEqual(certificate["closure"]["least_row_sum"], 1, delta=1e-9)
        self.assertLess(certificate["reciprocity"]["largest_difference"], 1e-15)
        self.assertEqual(certificate["bounds"]["outside"], 0)
        self.assertEqual(len(certificate["worst_rows"]), 6)
        self.assertEqual(json.loads(read_npz(self.folder / "F.npz")["certificate"][0]), certificate)
        self.assertEqual(report["counts"]["surfaces"]["value"], 6)
        self.assertIn("closure", self.succeed("viewfactors", "cube.obj", "-o", "F.npz").stdout)

    def test_an_open_scene_is_reported_not_repaired(self):
        (self.folder / "open.obj").write_text(CUBE.rsplit("f", 1)[0])
        self.assertIs(self.report("viewfactors", "open.obj", "-o", "F.npz")["result"]["closed"], False)
        self.assertIn("enclosure", self.expect_error("input", "viewfactors", "open.obj", "-o", "G.npz", "--repair"))
        self.assertFalse((self.folder / "G.npz").exists())

    def test_objects_and_materials(self):
        self.succeed("viewfactors", "block.obj", "--by", "object", "-o", "F.npz")
        arrays = read_npz(self.folder / "F.npz")
        self.assertEqual(arrays["names"], ["room", "block"])
        F, areas = arrays["F"], arrays["areas"]
        self.assertAlmostEqual(F[3], 0, delta=1e-9)
        self.assertAlmostEqual(F[2], 1, delta=1e-4)
        self.assertAlmostEqual(F[1], areas[1] / areas[0], delta=1e-4)
        self.succeed("viewfactors", "block.obj", "--by", "material", "-o", "F.npz")
        self.assertEqual(read_npz(self.folder / "F.npz")["names"], ["white", "black"])

    def test_gray_bodies(self):
        (self.folder / "heat.csv").write_text(
            "surface,emissivity,temperature_K,flux_W_m2\r\nroom:0,0.5,400,\r\n"
            + "".join(f"room:{i},,300,\r\n" for i in range(1, 6)))
        words = ["viewfactors", "cube.obj", "--gray-body", "--surfaces", "heat.csv", "--emissivity", "1"]
        self.succeed(*words, "-o", "F.npz", "-o", "F.h5", "-o", "F.csv", "-o", "F.vtu")
        arrays = read_npz(self.folder / "F.npz")
        self.assertEqual(arrays["emissivities"], [0.5] + 5 * [1])
        # A grey floor in a black room loses e sigma (T^4 - T_room^4).
        self.assertAlmostEqual(arrays["fluxes"][0], 0.5 * 5.670374419e-8 * (400**4 - 300**4), delta=1e-6)
        self.assertAlmostEqual(sum(arrays["fluxes"]), 0, delta=1e-6)
        self.assertAlmostEqual(sum(arrays["gebhart"][:6]), 1, delta=1e-9)
        (self.folder / "heat.csv").write_text("roof,1,300,\n")
        self.assertIn("roof", self.expect_error("input", *words, "-o", "G.npz"))

    def test_memory_is_foreseen(self):
        error = self.expect_error("limit", "viewfactors", "cube.obj", "-o", "F.npz", "--max-memory", "1e-7")
        self.assertIn("fit", error)
        self.assertFalse((self.folder / "F.npz").exists())

    def test_faults(self):
        self.expect_error("input", "viewfactors", "none.obj", "-o", "F.npz")
        self.expect_error("usage", "viewfactors", "cube.obj", "-o", "F.xyz")
        self.expect_error("usage", "viewfactors", "cube.obj", "-o", "F.npz", "--by", "vertex")
        self.expect_error("usage", "viewfactors", "cube.obj", "-o", "F.npz", "--target-error", "1")
        (self.folder / "bad.vs3").write_text("F 3\nV 1 0 0 0\nS 1 1 2 3 4 0 0 0.9 a\n")
        self.assertIn("bad.vs3:3", self.expect_error("input", "viewfactors", "bad.vs3", "-o", "F.npz"))

    @unittest.skipUnless(VIEW3D.is_dir(), f"{VIEW3D} is not here")
    def test_view3d_files(self):
        # Subsurfaces are cut out of their bases, and combined surfaces are one: closed rooms stay closed.
        for name, surfaces in (("facet", 8), ("test4", 8), ("wdwdoor", 10)):
            report = self.report("viewfactors", VIEW3D / "examples" / f"{name}.vs3", "-o", "F.npz")
            self.assertEqual(report["counts"]["surfaces"]["value"], surfaces, name)
            self.assertIs(report["result"]["closed"], True, name)
            for row in report["result"]["worst_rows"]:
                self.assertAlmostEqual(row["sum"], 1, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
