"""aktina render."""
import json
import struct
import unittest
import zlib

from scene_commands import CORNELL, ROOM, SceneCommandTest


def read_png(path):
    """Width, height, and rows of an 8-bit RGB PNG."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, header, packed = 8, None, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    return header[0], header[1], zlib.decompress(packed)


class Render(SceneCommandTest):
    command, extension = "render", "png"
    quick = ["--method", "raster", "--size", "48x32", "--samples", "1"]
    endless = ["--method", "path", "--size", "96x64", "--samples", "1000000"]

    def test_names_that_begin_with_a_dash(self):
        (self.folder / "-dash.obj").write_text("v -1 0 1\nv 1 0 1\nv 0 0 -1\nf 1 2 3\n")
        self.succeed("render", "-o", "d.png", "-m", "raster", "--size", "8x8", "--", "-dash.obj")
        self.expect_error("usage", "render", "-o", "d.png", "--", "-dash.obj", "--", "another.obj")

    def test_links_that_lead_nowhere(self):
        (self.folder / "loop.png").symlink_to(self.folder / "loop.png")
        error = self.expect_error("input", "render", CORNELL, "-o", "loop.png", "-m", "raster", "--size", "8x8")
        self.assertIn("loop.png", error)

    def test_environment(self):
        (self.folder / "a.obj").write_text("v -1 0 1\nv 1 0 1\nv 0 0 -1\nf 1 2 3\n")
        self.succeed("render", "a.obj", "-m", "direct", "--size", "16x16", "-o", "plain.exr")
        self.succeed("render", "a.obj", "-m", "direct", "--size", "16x16", "-o", "sky.png", "--exposure", "1",
                     "--environment", "plain.exr", "--environment-scale", "3", "--environment-rotation", "90")
        self.assertNotIn("default", self.succeed("render", "a.obj", "-m", "direct", "--size", "8x8", "-o", "b.png",
                                                 "--environment", "plain.exr").stderr.replace("default camera", ""))
        self.expect_error("input", "render", "a.obj", "-o", "c.png", "--environment", "no.hdr")
        self.expect_error("input", "render", "a.obj", "-o", "c.png", "--environment", "a.obj")
        self.assertNotIn("c.png", self.files())

    def test_size(self):
        for text, size in (("48x32", (48, 32)), ("30x", (30, 30)), ("x20", (20, 20))):  # the camera's aspect is 1
            self.run_quick(CORNELL, None, "--size", text)
            self.assertEqual(read_png(self.folder / "out.png")[:2], size)

    def test_bad_sizes(self):
        for text in ("48", "x", "48x32x1", "-1x5", "0x5", "axb", "1e3x5", " 5x5"):
            self.refuse("usage", CORNELL, None, f"--size={text}")
        for text in ("100000x100000", "99999999999999999999x1", "60000x60000"):
            self.refuse("limit", CORNELL, None, "--size", text)

    def test_several_outputs_of_one_run(self):
        self.succeed("render", CORNELL, *self.quick, "-o", "a.png", "-o", "b.pfm")
        self.assertEqual(self.files(), ["a.png", "b.pfm"])

    def test_cameras_by_name_and_number(self):
        self.run_quick(CORNELL, None, "--camera", "view")
        self.run_quick(CORNELL, None, "--camera", "0")
        self.assertIn("view", self.refuse("usage", CORNELL, None, "--camera", "elsewhere"))
        self.refuse("usage", CORNELL, None, "--camera", "1")

    def test_exposure(self):
        def mean(*words):
            self.run_quick(CORNELL, None, *words)
            return sum(read_png(self.folder / "out.png")[2])

        self.assertLess(mean("--exposure", "0.001"), mean("--exposure", "0.002"))
        for text in ("0", "-1", "nan", "inf", "much", "1x"):
            self.refuse("usage", CORNELL, None, f"--exposure={text}")

    def test_depth_cue(self):
        self.run_quick(CORNELL, None, "--depth-cue", "0.5,0.2")
        for text in ("1", "a,b", "1,2,3", "1;2"):
            self.refuse("usage", CORNELL, None, f"--depth-cue={text}")
        self.refuse("usage", CORNELL, None, "--depth-cue", "0,0")
        self.assertIn("raster", self.refuse("usage", CORNELL, None, "--method", "path", "--depth-cue", "1,1"))

    def test_normals(self):
        def picture(*words):
            self.run_quick(ROOM, None, "--size", "60x40", *words)
            return read_png(self.folder / "out.png")[2]

        self.assertEqual(picture(), picture("--normals", "file"))
        flat = picture("--normals", "angle", "--crease", "0")
        self.assertNotEqual(flat, picture("--normals", "angle", "--crease", "180"))
        self.assertEqual(flat, picture("--normals", "max", "--crease", "0"))
        self.refuse("usage", CORNELL, None, "--normals", "best")
        self.refuse("usage", CORNELL, None, "--crease", "181")

    def test_unknown_names(self):
        self.assertIn("did you mean raster?", self.refuse("usage", CORNELL, None, "--method", "rastr"))
        self.assertIn("gouraud", self.refuse("usage", CORNELL, None, "--shading", "gurod"))
        self.assertIn("lambert", self.refuse("usage", CORNELL, None, "--illumination", "lambrt"))
        self.assertIn("albedo", self.refuse("usage", CORNELL, None, "--layers", "albedi"))


del SceneCommandTest  # a base class only

if __name__ == "__main__":
    unittest.main()
