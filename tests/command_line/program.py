"""Runs the program as a user does: AKTINA names it; each test gets a folder of its own."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["AKTINA"]
REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
STATUS = {"usage": 2, "input": 3, "limit": 4, "check": 5, "stopped": 130}


def commands():
    """Names of the subcommands, read from the program's own help."""
    lines = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout.splitlines()
    start = lines.index("Commands:") + 1
    return [line.split()[0] for line in lines[start : lines.index("", start)] if line.startswith("  ") and line[2] != " "]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="aktina-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *words, **options):
        options.setdefault("cwd", self.folder)
        options.setdefault("timeout", 120)
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("stderr", subprocess.PIPE)
        options.setdefault("stdin", subprocess.DEVNULL)
        return subprocess.run([PROGRAM, *map(str, words)], text=True, **options)

    def succeed(self, *words, **options):
        result = self.run_program(*words, **options)
        self.assertEqual(result.returncode, 0, f"aktina {words}: {result.stderr}")
        return result

    def report(self, *words, **options):
        """Runs with --json: exactly one JSON object on standard output."""
        return json.loads(self.succeed(*words, "--json", **options).stdout)

    def expect_error(self, status, *words, **options):
        """The run ends with `status` and says why in exactly one line, which is returned."""
        result = self.run_program(*words, **options)
        self.assertEqual(result.returncode, STATUS[status], f"aktina {words}: {result.stderr}")
        lines = result.stderr.splitlines()
        errors = [line for line in lines if line.startswith("aktina: error: ")]
        self.assertEqual(len(errors), 1, f"one error line: {result.stderr}")
        self.assertEqual(lines[-1], errors[0], "the error is the last word")
        self.assertTrue(errors[0].isprintable(), "no control characters")
        return errors[0]

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
