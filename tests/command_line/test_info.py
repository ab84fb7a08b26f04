"""aktina info: scenes, images, luminaires."""
import unittest

from program import REPOSITORY, ProgramTest

CUBE = "".join(f"v {i & 1} {i >> 1 & 1} {i >> 2 & 1}\n" for i in range(8))
FACES = ["1 3 2", "2 3 4", "5 6 7", "6 8 7", "1 2 5", "2 6 5", "3 7 4", "4 7 8", "1 5 3", "3 5 7", "2 4 6", "4 8 6"]
IES = "IESNA:LM-63-2002\n[LUMINAIRE] Even\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 180\n0\n100 100\n"


class Info(ProgramTest):
    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def obj(self, text):
        return self.report("info", self.write("a.obj", text))["result"]

    def test_closed_cube(self):
        info = self.obj(CUBE + "".join(f"f {face}\n" for face in FACES))
        self.assertEqual((info["kind"], info["counts"]["triangles"]), ("scene", 12))
        cube = info["objects"][0]
        self.assertTrue(cube["closed"])
        self.assertAlmostEqual(cube["area_m2"], 6)
        self.assertAlmostEqual(cube["volume_m3"], 1)
        self.assertEqual({estimate["job"] for estimate in info["estimates"]}, {"render raster", "render path", "radiosity"})

    def test_open_cube_says_so(self):
        path = self.write("a.obj", CUBE + "".join(f"f {face}\n" for face in FACES[2:]))
        self.assertIn("open, 4 boundary edges", self.succeed("info", path).stdout)

    def test_emissive_flux(self):
        self.write("a.mtl", "newmtl lamp\nKe 10 10 10\n")
        info = self.obj("mtllib a.mtl\nusemtl lamp\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        self.assertAlmostEqual(info["emissive_flux_lm"], 31.4159, 3)  # pi L A

    def test_suspicious_scale(self):
        info = self.obj("v 0 0 0\nv 3000 0 0\nv 0 3000 0\nf 1 2 3\n")
        self.assertIn("--units 0.001", info["suspicious_scale"])
        again = self.report("info", self.folder / "a.obj", "--units", "0.001")["result"]
        self.assertNotIn("suspicious_scale", again)
        self.assertAlmostEqual(again["bounds_m"]["size"][0], 3, 4)

    def test_repairs_are_warnings(self):
        report = self.report("info", self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"))
        self.assertTrue(any("out of range" in warning["text"] for warning in report["warnings"]))

    def test_luminaire(self):
        info = self.report("info", self.write("a.ies", IES))["result"]
        self.assertEqual(info["kind"], "luminaire")
        self.assertAlmostEqual(info["flux_lm"], 1256.637, 2)  # 4 pi I
        self.assertEqual(info["peak_cd"], 100)
        self.assertIn("1256.6 lm", self.succeed("info", self.folder / "a.ies").stdout)

    def test_own_scene(self):
        info = self.report("info", REPOSITORY / "scenes" / "cornell.glb")["result"]
        self.assertEqual(info["counts"]["triangles"], 36)

    def test_faults(self):
        self.assertIn("a.ies:4", self.expect_error("input", "info", self.write("a.ies", IES.replace("1 -1 1 2", "1 x 1 2"))))
        self.expect_error("input", "info", self.folder / "missing.obj")
        self.expect_error("input", "info", self.folder)
        self.expect_error("input", "info", self.write("a.ply", "ply\n"))


if __name__ == "__main__":
    unittest.main()
