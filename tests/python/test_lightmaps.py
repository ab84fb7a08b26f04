"""Lightmaps of solutions, and models that carry their light."""
import pathlib

import numpy as np
import pytest

import aktina

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"


@pytest.fixture(scope="module")
def cornell():
    return aktina.load(SCENES / "cornell.glb").radiosity(patch_size=0.05)


def area(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]].astype(float) for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def test_charts_keep_the_scale_of_the_surfaces(cornell):
    lightmap = cornell.lightmap(texel_size=0.01, direct_samples=0)
    assert lightmap.texel_size == 0.01 and len(lightmap.pages) == 1
    height, width, channels = lightmap.pages[0].shape
    assert channels == 3 and lightmap.pages[0].dtype == np.float32
    for mesh in lightmap.meshes:
        texels = np.column_stack([mesh["uv"] * [width, height], np.zeros(len(mesh["uv"]))])
        metres = area(texels * lightmap.texel_size, mesh["triangles"])
        assert abs(metres / area(mesh["vertices"], mesh["triangles"]) - 1) < 0.2  # whole texels on each side
    flux = sum(area(m["vertices"], m["triangles"]) for m in lightmap.meshes)
    assert abs(flux - cornell.areas.sum()) < 1e-3 * flux


def look_up(page, uv):
    """Between the middles of texels, as a viewer reads them."""
    x, y = uv[0] * page.shape[1] - 0.5, uv[1] * page.shape[0] - 0.5
    column, row = int(np.floor(x)), int(np.floor(y))
    fx, fy = x - column, y - row
    four = page[row : row + 2, column : column + 2]
    return (four[0, 0] * (1 - fx) + four[0, 1] * fx) * (1 - fy) + (four[1, 0] * (1 - fx) + four[1, 1] * fx) * fy


def test_corners_have_the_light_of_the_solution(cornell):
    lightmap = cornell.lightmap(texel_size=0.005, direct_samples=0)
    for mesh in lightmap.meshes:
        for corner, uv in zip(mesh["vertices"], mesh["uv"]):
            lux = look_up(lightmap.pages[mesh["page"]], uv)
            here = np.linalg.norm(cornell.vertices - corner, axis=1) < 1e-5
            apart = np.abs(cornell.vertex_irradiances[here] - lux).max(axis=1)  # one of the surfaces that meet there
            assert apart.min() < 0.02 * cornell.irradiances.max()


def test_bad_options_are_refused(cornell):
    with pytest.raises(aktina.BadParam):
        cornell.lightmap(size=4)
    with pytest.raises(aktina.LimitExceeded) as caught:
        cornell.lightmap(texel_size=1e-6, size=64)
    assert "--texel-size" in caught.value.hint
    with pytest.raises(aktina.UsageError):
        cornell.bake("x.glb", form="disc")


def test_bake_writes_every_form(cornell, tmp_path):
    quick = {"size": 64, "direct_samples": 0}
    for form, names in ("vertex", ["m.glb"]), ("emissive", ["m.glb"]), ("lightmap", ["m.glb", "m.exr"]):
        written = cornell.bake(tmp_path / "m.glb", form, **quick)
        assert [pathlib.Path(name).name for name in written] == names
        assert aktina.load(tmp_path / "m.glb").triangles > 0
    pages = cornell.lightmap(**quick).pages
    assert (aktina.read_image(tmp_path / "m.exr") == pages[0]).all()


def test_given_coordinates_are_reported():
    corners = {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]}
    scene = aktina.Scene([corners], lights=[{"type": "point", "position": [0, 0, 2], "intensity": 40}])
    lightmap = scene.radiosity(patch_size=0.5).lightmap(size=64)
    assert lightmap.warnings == [] and lightmap.seams == (0, 0)
    assert "64 x 64" in repr(lightmap)
