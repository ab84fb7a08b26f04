"""Every example is run: docstrings, and the Python blocks of docs/python.md."""
import doctest
import inspect
import pathlib
import re

import pytest

import aktina

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"


def examples():
    finder = doctest.DocTestFinder(exclude_empty=True)
    for name in aktina.__all__:
        for test in finder.find(getattr(aktina, name), name, module=False, globs={}):
            if test.examples:
                yield test


@pytest.mark.parametrize("test", examples(), ids=lambda test: test.name)
def test_docstring(test):
    report = []
    assert doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=report.append).failed == 0, "".join(report)


def test_every_public_function_has_an_example():
    with_example = {test.name.split(".")[0] for test in examples()}
    functions = {name for name in aktina.__all__ if inspect.isfunction(getattr(aktina, name))}
    assert functions and functions <= with_example, functions - with_example


def test_the_page(tmp_path, monkeypatch):
    """Blocks share one namespace, in order, as a reader would type them; `# ->` comments are what is printed."""
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    assert blocks
    names = {}
    for block in blocks:
        exec(compile(block, PAGE.name, "exec"), names)
