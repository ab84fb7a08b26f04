"""Errors carry code, place and hint, and are one line."""
import pickle

import pytest

import aktina
from aktina import _core


def test_classes_follow_the_table_of_codes():
    assert [(each.code, each.__name__) for each in aktina.Error.__subclasses__()] == _core.error_classes()


def test_an_error_of_the_core_arrives_whole():
    with pytest.raises(aktina.NoSuchMethod) as caught:
        aktina.illuminate("fong", {}, [0, 0, 1], [0, 0, 1])
    error = caught.value
    assert isinstance(error, (aktina.Error, ValueError))
    assert (error.code, error.where) == ("no_such_method", "fong")
    assert "phong" in error.hint
    assert str(error).startswith("fong: ") and "\n" not in str(error)


def test_an_unread_parameter_is_an_error_that_lists_the_choices():
    for call in (lambda: aktina.illuminate("phong", {"kq": 1}, [0, 0, 1], [0, 0, 1]),
                 lambda: aktina.irradiance({"intensty": 1}, [0, 0, 1], [0, 0, 1]),
                 lambda: aktina.intersect("sphere", [0, 0, 0], [0, 0, 1], raius=1)):
        with pytest.raises(aktina.UsageError, match="there are: "):
            call()


def test_errors_survive_a_process_border():
    error = pickle.loads(pickle.dumps(aktina.FileError("cannot be read", "room.glb", "check the path")))
    assert isinstance(error, OSError)
    assert (str(error), error.hint) == ("room.glb: cannot be read (check the path)", "check the path")
