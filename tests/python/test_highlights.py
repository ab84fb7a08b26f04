"""Shading methods that look for highlights, on single triangles."""
import numpy as np
import pytest

import aktina

METHODS = ["h_test", "cho_neumann_woo", "lai_tai", "tai_hsu", "overveld_highlights", "vlasic", "brown"]
NORMALS = np.array([[-0.4, -0.4, 1], [0.4, -0.1, 1], [-0.1, 0.4, 1]])
NORMALS /= np.linalg.norm(NORMALS, axis=1, keepdims=True)
LAMPS = [{"type": "point", "position": [1, 2, 3], "intensity": [9, 6, 3]},
         {"type": "directional", "direction": [0.1, 0, -1], "illuminance": [1, 2, 3]},
         {"type": "spot", "position": [-1, 0, 2], "direction": [0.5, 0.1, -1], "intensity": 5, "outer_angle": 1}]
MATERIAL = {"kd": [0.5, 0.4, 0.3], "ks": 0.5, "exponent": 8}
POINTS = np.random.default_rng(1).dirichlet([1, 1, 1], 40)


def interpolated(method, **more):
    given = {"lights": LAMPS, "eye": [0, 0, 3], "material": MATERIAL, "model": "blinn_phong"} | more
    return aktina.interpolate(method, NORMALS, POINTS, **given)


@pytest.mark.parametrize("model", ["phong", "blinn_phong", "schlick", "schlick:half=1"])
@pytest.mark.parametrize("method", METHODS)
def test_highlights_come_near_to_phongs(method, model):
    phong = interpolated("phong", model=model)
    error = abs(interpolated(method, model=model) - phong).max()
    assert 0 < error < 0.6 * abs(interpolated("gouraud", model=model) - phong).max() + 0.1


@pytest.mark.parametrize("model", ["lambert", "oren_nayar", "constant", "ambient"])
@pytest.mark.parametrize("method", METHODS)
def test_without_highlights_they_are_gouraud(method, model):
    np.testing.assert_allclose(interpolated(method, model=model), interpolated("gouraud:perspective=1", model=model),
                               rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("method", METHODS)
def test_models_whose_highlight_is_no_function_of_one_angle(method):
    interpolating = method in ("overveld_highlights", "vlasic", "brown")
    for model in ["ggx", "ward"] + ["cook_torrance", "torrance_sparrow", "phong:fresnel=1"] * interpolating:
        with pytest.raises(aktina.Error, match="blinn_phong") as error:
            interpolated(method, model=model)
        assert "\n" not in str(error.value)


@pytest.mark.parametrize("model", ["cook_torrance", "torrance_sparrow", "phong:fresnel=1"])
def test_facets_pass_the_test_for_highlights(model):
    hybrid = interpolated("hybrid", model=model)
    for method in ["h_test", "lai_tai"]:
        np.testing.assert_allclose(interpolated(method, model=model), hybrid, atol=0.01)


@pytest.mark.parametrize("exponent", [0, -3, 1e6])
@pytest.mark.parametrize("method", METHODS)
def test_any_exponent_gives_finite_light(method, exponent):
    assert np.isfinite(interpolated(method, material=MATERIAL | {"exponent": exponent})).all()
