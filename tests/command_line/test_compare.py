"""aktina compare: metrics, the map, formats against each other, and the check."""
import json
import struct
import unittest
import zlib

from program import ProgramTest


def png(width, height, pixel):
    """An 8-bit RGB PNG from a function of x and y."""
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def pfm(width, height, value):
    return f"Pf\n{width} {height}\n-1\n".encode() + struct.pack("<f", value) * (width * height)


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "grey.png").write_bytes(png(16, 8, lambda x, y: (128, 128, 128)))
        (self.folder / "spot.png").write_bytes(png(16, 8, lambda x, y: (255, 0, 0) if x < 4 else (128, 128, 128)))
        (self.folder / "white.png").write_bytes(png(16, 8, lambda x, y: (255, 255, 255)))
        (self.folder / "half.pfm").write_bytes(pfm(16, 8, 0.5))
        (self.folder / "third.pfm").write_bytes(pfm(16, 8, 0.3))
        (self.folder / "bright.pfm").write_bytes(pfm(16, 8, 7))

    def test_equal_pictures(self):
        result = self.report("compare", "grey.png", "grey.png", "--max-error", "0")["result"]
        self.assertEqual((result["flip"], result["rmse"], result["max_error"], result["ssim"]), (0, 0, 0, 1))
        self.assertIsNone(result["psnr"], "infinite")

    def test_a_uniform_shift(self):
        result = self.report("compare", "half.pfm", "third.pfm")["result"]
        self.assertAlmostEqual(result["rmse"], 0.2, 6)
        self.assertAlmostEqual(result["max_error"], 0.2, 6)
        self.assertIn("rmse          0.2\n", self.succeed("compare", "half.pfm", "third.pfm").stdout)

    def test_a_picture_that_clips_is_compared_where_it_does_not(self):
        result = self.report("compare", "white.png", "bright.pfm")["result"]
        self.assertEqual((result["range"], result["flip"]), ("low", 0))
        result = self.report("compare", "white.png", "bright.pfm", "--range", "high")["result"]
        self.assertEqual((result["range"], result["max_error"]), ("high", 6))

    def test_the_map(self):
        report = self.report("compare", "spot.png", "grey.png", "-o", "map.png")
        self.assertEqual(report["outputs"][0]["file"], "map.png")
        self.assertEqual((self.folder / "map.png").read_bytes()[:4], b"\x89PNG")

    def test_the_check(self):
        line = self.expect_error("check", "compare", "spot.png", "grey.png", "--max-error", "0.01")
        self.assertIn("flip: ", line)
        self.assertIn("exceeds 0.01", line)
        self.succeed("compare", "spot.png", "grey.png", "--max-error", "1")
        self.assertIn("rmse", self.expect_error("check", "compare", "half.pfm", "third.pfm", "--metric", "rmse", "--max-error", "0.19"))
        self.succeed("compare", "half.pfm", "third.pfm", "--metric", "rmse", "--max-error", "0.21")
        result = self.run_program("compare", "spot.png", "grey.png", "--max-error", "0.01", "--json")
        self.assertEqual(result.returncode, 5)
        self.assertGreater(json.loads(result.stdout)["result"]["flip"], 0.01, "the report comes all the same")

    def test_a_value_that_is_no_number_fails_the_check(self):
        (self.folder / "nan.pfm").write_bytes(pfm(16, 8, float("nan")))
        (self.folder / "zero.pfm").write_bytes(pfm(16, 8, 0))
        self.assertEqual(self.report("compare", "nan.pfm", "zero.pfm")["result"]["non_finite_a"], 128)
        self.assertIn("non-finite", self.expect_error("check", "compare", "nan.pfm", "zero.pfm", "--max-error", "1"))

    def test_mistakes(self):
        (self.folder / "small.pfm").write_bytes(pfm(2, 2, 0))
        (self.folder / "broken.png").write_bytes((self.folder / "grey.png").read_bytes()[:50])
        self.assertIn("differ in size: 16 x 8 and 2 x 2", self.expect_error("usage", "compare", "half.pfm", "small.pfm"))
        self.assertIn("broken.png", self.expect_error("input", "compare", "broken.png", "grey.png"))
        self.expect_error("input", "compare", "missing.png", "grey.png")
        self.expect_error("usage", "compare", "grey.png")
        self.expect_error("usage", "compare", "grey.png", "grey.png", "-o", "map.tif")
        self.expect_error("input", "compare", "grey.png", "grey.png", "-o", "no/folder/map.png")
        (self.folder / "claim.pfm").write_bytes(b"PF\n60000 60000\n-1\n")
        self.expect_error("limit", "compare", "claim.pfm", "claim.pfm")
        self.assertNotIn("map.tif", self.files())


if __name__ == "__main__":
    unittest.main()
