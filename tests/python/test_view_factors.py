"""View-factor matrices from Python."""
import os
import tempfile
import unittest

import numpy as np

import aktina

VERTICES = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
ROOM = {"vertices": VERTICES,
        "triangles": [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [1, 5, 7], [1, 7, 3],
                      [3, 7, 6], [3, 6, 2], [2, 6, 4], [2, 4, 0]]}


class ViewFactors(unittest.TestCase):
    def test_a_cube_closes(self):
        f = aktina.view_factors(aktina.Scene([ROOM]))
        self.assertEqual(f.shape, (6, 6), "pairs of triangles are squares")
        np.testing.assert_allclose(f.F.sum(axis=1), 1, atol=1e-9)
        self.assertAlmostEqual(f.F[0, 1], 0.199824895698, delta=1e-9)
        np.testing.assert_allclose(f.areas, 1)
        self.assertIs(f.certificate["closed"], True)
        self.assertEqual(len(f.names), 6)

    def test_rows_are_compressed_as_scipy_has_them(self):
        f = aktina.view_factors(aktina.Scene([ROOM]))
        dense = np.zeros(f.shape)
        for i in range(6):
            for k in range(f.indptr[i], f.indptr[i + 1]):
                dense[i, f.indices[k]] = f.data[k]
        np.testing.assert_array_equal(dense, f.F)
        self.assertEqual((f.indices.dtype, f.indptr.dtype), (np.int32, np.int64))

    def test_clear_surfaces(self):
        quad = lambda z, up, material: {
            "vertices": [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]], "material": material,
            "triangles": [[0, 1, 2], [0, 2, 3]] if up else [[0, 2, 1], [0, 3, 2]]}
        pane = {"vertices": [[-9, -9, .5], [9, -9, .5], [9, 9, .5], [-9, 9, .5]], "triangles": [[0, 1, 2], [0, 2, 3]],
                "material": {"transmission": 0.25, "base_colour": 1.0, "roughness": 0.0}}
        scene = aktina.Scene([quad(0, True, {"kd": 0.5}), quad(1, False, {"kd": 0.5}), pane])
        self.assertEqual(aktina.view_factors(scene).F[0, 1], 0)
        f = aktina.view_factors(scene, clear=True)
        self.assertAlmostEqual(f.F[0, 1], f.transmittances[2] * 0.199824895698, delta=1e-6)
        self.assertGreater(f.transmittances[2], 0.1)

    def test_a_matrix_larger_than_memory_needs_a_scratch_folder(self):
        scene = aktina.Scene([ROOM])
        with self.assertRaises(aktina.LimitExceeded):
            aktina.view_factors(scene, max_memory=1e-8)
        with tempfile.TemporaryDirectory() as folder:
            f = aktina.view_factors(scene, max_memory=1e-8, scratch=folder)
            self.assertEqual(os.listdir(folder), [])
        np.testing.assert_array_equal(f.F, aktina.view_factors(scene).F)

    def test_by_object(self):
        f = aktina.view_factors(aktina.Scene([ROOM]), by="object")
        np.testing.assert_allclose(f.F, [[1]], atol=1e-9)

    def test_gray_bodies_of_a_cube(self):
        f = aktina.view_factors(aktina.Scene([ROOM]))
        emissivity = np.array([0.3, 0.9, 0.5, 0.7, 1, 0.2])
        heat = f.gray_body(emissivity)
        self.assertEqual(set(heat), {"gebhart", "script_F", "escaped"}, "nothing is known that could be balanced")
        b = np.linalg.solve(np.eye(6) - f.F * (1 - emissivity), f.F * emissivity)
        np.testing.assert_allclose(heat["gebhart"], b, atol=1e-12)
        np.testing.assert_allclose(heat["script_F"], emissivity[:, None] * b, atol=1e-12)
        np.testing.assert_allclose(heat["escaped"], 0, atol=1e-8)
        np.testing.assert_allclose(heat["script_F"], heat["script_F"].T, atol=1e-8)

    def test_balance_of_a_cube(self):
        f = aktina.view_factors(aktina.Scene([ROOM]))
        temperature = np.array([500, np.nan, 300, 320, np.nan, 280])
        flux = np.where(np.isnan(temperature), 0, np.nan)
        heat = f.gray_body(0.8, temperature, flux)
        sigma = 5.670374419e-8
        power = (heat["script_F"] * (heat["temperatures"][:, None] ** 4 - heat["temperatures"] ** 4) * sigma).sum(axis=1)
        np.testing.assert_allclose(heat["fluxes"], power, atol=1e-6)
        np.testing.assert_allclose(heat["fluxes"][[1, 4]], 0, atol=1e-9)
        self.assertAlmostEqual(heat["net"], 0, delta=1e-6)

    def test_faults_of_gray_bodies(self):
        f = aktina.view_factors(aktina.Scene([ROOM]))
        with self.assertRaises(aktina.BadParam):
            f.gray_body(1.5)
        with self.assertRaises(aktina.BadParam):
            f.gray_body(0.5, temperature=[300, 300, 300, 300, 300, np.nan])
        with self.assertRaises(aktina.UsageError):
            f.gray_body([0.5, 0.6])
        with self.assertRaises(aktina.BadInput):
            f.gray_body(0.5, flux=0)

    def test_both_sides_of_a_plate_close_with_the_room(self):
        plate = {"vertices": [[0.3, 0.3, 0.4], [0.7, 0.3, 0.4], [0.7, 0.8, 0.6], [0.3, 0.8, 0.6]],
                 "triangles": [[0, 1, 2], [0, 2, 3]], "material": {"double_sided": True}}
        scene = aktina.Scene([ROOM, plate])
        one, both = aktina.view_factors(scene), aktina.view_factors(scene, two_sided=True)
        self.assertEqual(one.F.shape, (7, 7))
        self.assertEqual(both.F.shape, (8, 8))
        np.testing.assert_allclose(both.F.sum(1), 1, atol=3e-4)
        self.assertLess(one.F[:6].sum(1).min(), 0.99)
        np.testing.assert_allclose(both.F[:7, :7], one.F, atol=2e-4)
        self.assertEqual(both.F[6, 7], 0)
        self.assertTrue(both.names[7].endswith("/back"))

    def test_faults(self):
        with self.assertRaises(aktina.UsageError):
            aktina.view_factors(aktina.Scene([ROOM]), by="vertex")
        with self.assertRaises(aktina.BadParam):
            aktina.view_factors(aktina.Scene([ROOM]), target_error=1)
        with self.assertRaises(aktina.BadInput):
            aktina.view_factors(aktina.Scene())
        with self.assertRaises(aktina.FileError):
            aktina.view_factors("nowhere.obj")


if __name__ == "__main__":
    unittest.main()
