"""The reference runner fails where it should: no comparison passes because nothing was compared."""
import json
import pathlib
import subprocess
import sys

import pytest

RUNNER = pathlib.Path(__file__).resolve().parents[1] / "run_reference.py"

LIT = {"id": "a", "kind": "lambert", "tolerance": {"abs": 1e-9, "rel": 1e-9},
       "inputs": {"N": [0, 0, 1], "L": [0, 0, 1], "kd": [0.5, 0.5, 0.5], "Ip": [2, 2, 2]}, "expected": {"I": [1, 1, 1]}}


def run(folder, *options):
    import aktina
    build = pathlib.Path(aktina.__file__).parents[2]
    return subprocess.run([sys.executable, "-B", RUNNER, folder, "--build", build, *options], capture_output=True, text=True)


def cases(folder, *listed, family="illumination"):
    (folder / "cases.json").write_text(json.dumps({"family": family, "schema_version": 1, "cases": listed}))


def changed(case, **changes):
    return {**case, **changes}


def test_a_right_value_passes(tmp_path):
    cases(tmp_path, LIT, changed(LIT, id="b"))
    ran = run(tmp_path, "--json")
    assert ran.returncode == 0, ran.stderr
    (kind,) = json.loads(ran.stdout)["kinds"]
    assert (kind["cases"], kind["methods"][0]["passed"], kind["methods"][0]["values_compared"]) == (2, 2, 2)


@pytest.mark.parametrize("expected", [
    {"I": [1, 1, 1.1]}, {"I": [1, 1]}, {"I": 1}, {"I": [1, 1, float("nan")]}, {"I": []}, {"Q": [1, 1, 1]}])
def test_a_wrong_value_or_shape_or_name_fails(tmp_path, expected):
    cases(tmp_path, changed(LIT, expected=expected))
    ran = run(tmp_path)
    assert ran.returncode == 1, ran.stdout
    assert "FAILED lambert a by lambert" in ran.stdout


def test_a_method_that_throws_has_failed(tmp_path):
    cases(tmp_path, changed(LIT, inputs={**LIT["inputs"], "N": [0, 0, 5]}))
    assert run(tmp_path).returncode == 1


def test_a_value_that_nothing_computes_is_named(tmp_path):
    cases(tmp_path, changed(LIT, expected={"I": [1, 1, 1], "Q": 2}))
    ran = run(tmp_path)
    assert ran.returncode == 0
    assert "not yet computed: lambert: Q" in ran.stdout


def test_an_unknown_kind_is_only_noted(tmp_path):
    cases(tmp_path, LIT, changed(LIT, id="b", kind="moonlight"))
    ran = run(tmp_path)
    assert ran.returncode == 0
    assert "moonlight: 1 cases not yet computed by any method" in ran.stdout


def test_nothing_to_compare_is_not_a_success(tmp_path):
    assert run(tmp_path).returncode == 2
    (tmp_path / "notes.json").write_text("{}")
    assert run(tmp_path).returncode == 2
    cases(tmp_path, changed(LIT, kind="moonlight"))
    assert run(tmp_path).returncode == 2
    cases(tmp_path, LIT)
    assert run(tmp_path, "--kind", "phong").returncode == 2
    assert run(tmp_path / "absent").returncode == 2


def test_a_broken_file_is_said(tmp_path):
    (tmp_path / "broken.json").write_text('{"cases": [')
    ran = run(tmp_path)
    assert ran.returncode == 2 and "broken.json" in ran.stderr
