"""Help, usage errors, and the standard streams."""
import json
import os
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest, commands


class Help(ProgramTest):
    def test_program(self):
        text = self.succeed("--help").stdout
        self.assertIn("Commands:", text)
        self.assertIn("Exit status:", text)
        self.assertEqual(self.succeed("help").stdout, text)

    def test_every_command_has_help_with_examples(self):
        for name in commands():
            text = self.succeed(name, "--help").stdout
            self.assertIn("Usage: aktina " + name, text)
            self.assertIn("Examples:\n", text)
            self.assertIn(f"  aktina {name}", text.split("Examples:\n")[1])
            self.assertTrue(all(len(line) <= 110 for line in text.splitlines()), "lines fit a terminal")

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"^aktina \d+\.\d+\.\d+\n$")

    def test_without_arguments(self):
        result = self.run_program()
        self.assertEqual(result.returncode, 2)
        self.assertIn("Usage:", result.stderr)
        self.assertEqual(result.stdout, "")

    def test_completion_knows_every_command(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.succeed("--completion", shell).stdout
            for name in commands():
                self.assertIn(name, script)
        self.expect_error("usage", "--completion", "tcsh")

    def test_bash_completion_completes(self):
        script = self.succeed("--completion", "bash").stdout
        ask = 'COMP_WORDS=(aktina methods --fam); COMP_CWORD=2; _aktina; echo "${COMPREPLY[*]}"'
        answer = subprocess.run(["bash", "-c", script + ask], capture_output=True, text=True, check=True)
        self.assertEqual(answer.stdout.split(), ["--family"])

    def test_man_page(self):
        page = self.succeed("--man").stdout
        for name in commands():
            self.assertIn(f".SS {name}\n", page)


class Mistakes(ProgramTest):
    def test_unknown_command_suggests_the_nearest(self):
        self.assertIn("did you mean aktina methods?", self.expect_error("usage", "metods"))
        self.assertIn("aktina --help", self.expect_error("usage", "zzzzzzzzz"))

    def test_unknown_option_suggests_the_nearest(self):
        self.assertIn("did you mean --family?", self.expect_error("usage", "methods", "--famly", "light"))
        self.assertIn("did you mean --json?", self.expect_error("usage", "methods", "--jsn"))

    def test_unknown_names_list_the_choices(self):
        self.assertIn("illumination", self.expect_error("usage", "methods", "--family", "iluminatoin"))

    def test_missing_value(self):
        self.expect_error("usage", "methods", "--family")
        self.assertIn("needs a value", self.expect_error("usage", "methods", "--family", "--json"))

    def test_too_many_arguments(self):
        self.assertIn("one argument too many", self.expect_error("usage", "methods", "light"))

    def test_hostile_words_stay_on_one_line(self):
        self.expect_error("usage", "two\nlines\x1b[31m")
        self.expect_error("usage", "methods", "--family", "x" * 100000)
        self.expect_error("usage", b"\xff\xfe".decode("utf-8", "surrogateescape"))


class Streams(ProgramTest):
    def test_full_disk_on_standard_output(self):
        with open("/dev/full", "w") as full:
            self.assertIn("No space left", self.expect_error("input", "methods", stdout=full))

    def test_closed_standard_output_is_an_error(self):
        result = subprocess.run(["sh", "-c", f"'{PROGRAM}' methods >&-"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 3)
        self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_closed_standard_error_is_none(self):
        result = subprocess.run(["sh", "-c", f"'{PROGRAM}' methods 2>&-"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0)

    def test_reader_that_went_away(self):
        read, write = os.pipe()
        os.close(read)
        result = self.run_program("methods", stdout=write)
        os.close(write)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_no_escape_codes_on_pipes(self):
        for words in (["--help"], ["methods"], ["methods", "--help"]):
            self.assertNotIn("\x1b", self.succeed(*words).stdout)


class Methods(ProgramTest):
    def test_catalogue_as_json(self):
        catalogue = json.loads(self.succeed("methods", "--json").stdout)
        self.assertEqual(catalogue["schema_version"], 1)
        for family in catalogue["families"]:
            self.assertTrue(family["methods"], family["id"])
            for method in family["methods"]:
                self.assertTrue(method["summary"].endswith("."), method["id"])
                for parameter in method["parameters"]:
                    self.assertLessEqual(parameter["minimum"], parameter["default"])
                    self.assertLessEqual(parameter["default"], parameter["maximum"])

    def test_one_family(self):
        catalogue = json.loads(self.succeed("methods", "--family", "light", "--json").stdout)
        self.assertEqual([family["id"] for family in catalogue["families"]], ["light"])
        self.assertIn("Point light", self.succeed("methods", "--family", "light").stdout)


if __name__ == "__main__":
    unittest.main()
