"""The type stubs say what the module is."""
import os
import subprocess
import sys

import aktina

PACKAGE = os.path.dirname(os.path.abspath(aktina.__file__))

# How a user's program is checked: right code passes, wrong code does not.
PROGRAM = """
import numpy as np
from numpy.typing import NDArray
import aktina

lit: NDArray[np.float32] = aktina.illuminate("phong", {"kd": 0.5}, [0, 0, 1], [0, 0, 1])
rows: list[dict[str, object]] = aktina.methods("light")
try:
    aktina.methods("fog")
except aktina.NoSuchMethod as error:
    print(error.code.upper(), error.hint)
"""
WRONG = {
    'aktina.illuminate(3, {}, [0, 0, 1], [0, 0, 1])': 'incompatible type "int"',
    'aktina.iluminate("phong", {}, [0, 0, 1], [0, 0, 1])': "no attribute",
    'aktina.methods("light").shape': "no attribute",
}


def mypy(tmp_path, *arguments):
    folder = os.path.dirname(PACKAGE)
    environment = dict(os.environ, MYPY_CACHE_DIR=str(tmp_path / "cache"), MYPYPATH=folder, PYTHONPATH=folder)
    command = [sys.executable, "-m", *arguments]
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)


def test_stub_and_module_say_the_same(tmp_path):
    allowed = tmp_path / "allowed"  # the compiled core is checked by its users in this package
    allowed.write_text("aktina\\._core\\..*\n")
    checked = mypy(tmp_path, "mypy.stubtest", "aktina", "--allowlist", str(allowed), "--ignore-unused-allowlist")
    assert checked.returncode == 0, checked.stdout
    public = {name for name in dir(aktina) if not name.startswith("_")}
    assert public == set(aktina.__all__)


def test_stubs_are_strict(tmp_path):
    checked = mypy(tmp_path, "mypy", "--strict", os.path.join(PACKAGE, "__init__.pyi"))
    assert checked.returncode == 0, checked.stdout


def test_a_program_that_uses_the_module(tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM + "\n".join(WRONG))
    checked = mypy(tmp_path, "mypy", "--strict", "program.py")
    lines = checked.stdout.splitlines()
    assert len(lines) == len(WRONG) + 1, checked.stdout  # one error a line, and the count
    for line, said in zip(lines, WRONG.values()):
        assert said in line
