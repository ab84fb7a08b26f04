"""Studies of scenes."""
import pytest

import aktina


def ball():
    shape = {"shape": {"type": "sphere"}, "material": {"kd": [0.6, 0.4, 0.2], "ks": 0.5, "exponent": 20}}
    return aktina.Scene([shape], lights=[{"type": "point", "position": [2, 3, 4], "intensity": 40}])


def test_methods_against_a_reference(tmp_path):
    stages = set()
    found = ball().study(methods=["flat", "gouraud", "phong"], width=64, samples=4, rounds=1, growth=False,
                         folder=tmp_path / "report", progress=lambda stage, *_: stages.add(stage))
    flat, gouraud, phong = found["methods"]
    assert phong["quality"]["rmse"] == 0 < gouraud["quality"]["rmse"] < flat["quality"]["rmse"]
    assert phong["quality"]["psnr"] is None and phong["pareto"]
    assert all(method["cost"]["frame_1"] > 0 for method in found["methods"])
    assert sorted(path.name for path in (tmp_path / "report").iterdir()) == ["report.csv", "report.html", "report.json"]


def test_mistakes():
    with pytest.raises(aktina.UsageError):
        ball().study("light")
    with pytest.raises(aktina.NoSuchMethod):
        ball().study(methods=["no_such"], width=32)
    with pytest.raises(aktina.BadParam):
        ball().study(methods=["gouraud"], width=32, samples=3)
