"""aktina study."""
import csv
import html.parser
import json
import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM, STATUS, ProgramTest
from scene_commands import CORNELL, ROOM

QUICK = ["--size", "48x32", "--samples", "1", "--rounds", "1", "--no-growth"]
FILES = ["report.csv", "report.html", "report.json"]


class Page(html.parser.HTMLParser):
    """Which elements a page has, whether each is closed, and what it points to."""

    VOID = {"meta", "img", "input", "br", "circle", "line", "polyline"}

    def __init__(self, text):
        super().__init__()
        self.open, self.faults, self.count, self.targets = [], [], {}, []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.count[tag] = self.count.get(tag, 0) + 1
        self.targets += [value for name, value in attributes if name in ("src", "href")]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.count[tag] = self.count.get(tag, 0) + 1

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(tag)


class Study(ProgramTest):
    def study(self, *words, scene=CORNELL, **options):
        return self.succeed("study", scene, "-o", "report", *QUICK, *words, **options)

    def written(self, name):
        return (self.folder / "report" / name).read_text(encoding="utf-8")

    def refuse(self, status, *words):
        before = self.files()
        error = self.expect_error(status, "study", *words)
        self.assertEqual(self.files(), before, "nothing half-written")
        return error

    def test_three_files_that_agree(self):
        self.study("--methods", "gouraud,phong")
        self.assertEqual(sorted(p.name for p in (self.folder / "report").iterdir()), FILES)
        report = json.loads(self.written("report.json"))
        self.assertEqual(report["schema_version"], 1)
        [study] = report["studies"]
        self.assertEqual((study["scene"], study["width"], study["height"]), ("cornell.glb", 48, 32))
        rows = list(csv.DictReader(self.written("report.csv").splitlines()))
        self.assertEqual([row["method"] for row in rows], ["gouraud", "phong"])
        for row, method in zip(rows, study["methods"]):
            self.assertAlmostEqual(float(row["rmse"]), method["quality"]["rmse"], delta=1e-6)
        self.assertEqual(study["methods"][1]["quality"]["rmse"], 0)
        self.assertGreater(study["methods"][0]["quality"]["rmse"], 0)

    def test_the_page_needs_nothing_else(self):
        self.study("--methods", "gouraud,phong")
        page = Page(self.written("report.html"))
        self.assertEqual((page.faults, page.open), ([], []), "every element is closed")
        self.assertEqual((page.count["section"], page.count["svg"], page.count["script"]), (1, 1, 1))
        for target in page.targets:
            self.assertTrue(target.startswith(("data:image/png;base64,", "#")), target[:40])

    def test_every_method_of_the_catalogue(self):
        self.study()
        known = json.loads(self.succeed("methods", "--family", "shading", "--json").stdout)["families"][0]["methods"]
        studied = json.loads(self.written("report.json"))["studies"][0]["methods"]
        self.assertEqual([m["id"] for m in studied], [m["id"] for m in known])

    def test_parameters_with_commas(self):
        self.study("--family", "illumination", "--methods", "ward:along=0.1,across=0.3,lambert")
        studied = json.loads(self.written("report.json"))["studies"][0]["methods"]
        self.assertEqual([m["method"] for m in studied], ["ward:along=0.1,across=0.3", "lambert"])

    def test_families_that_trace(self):
        self.study("--family", "integrator", "--methods", "direct")
        [study] = json.loads(self.written("report.json"))["studies"]
        self.assertEqual(study["reference"], "path")

    def test_classic_comparison(self):
        self.succeed("study", "--paper", "-o", "report", "--methods", "gouraud,phong", *QUICK)
        studies = json.loads(self.written("report.json"))["studies"]
        self.assertEqual([study["scene"] for study in studies], ["sphere", "torus", "strip", "teapot"])

    def test_report_on_standard_output(self):
        result = self.study("--methods", "gouraud,phong", "--seed", "7", "--json")
        report = json.loads(result.stdout)
        self.assertEqual((report["command"], report["seed"], report["complete"]), ("study", 7, True))
        self.assertEqual(sorted(os.path.basename(o["file"]) for o in report["outputs"]), FILES)

    def test_same_pictures_and_errors_for_any_number_of_threads(self):
        def quality(threads):
            self.study("--methods", "gouraud,cubic", "--threads", threads)
            return [m["quality"] for m in json.loads(self.written("report.json"))["studies"][0]["methods"]]

        self.assertEqual(quality("1"), quality("2"))

    def test_mistakes(self):
        self.assertIn("--paper", self.refuse("usage", "-o", "report"))
        self.assertIn("--paper", self.refuse("usage", CORNELL, "--paper", "-o", "report"))
        self.assertIn("shading", self.refuse("usage", CORNELL, "-o", "report", "--family", "light"))
        self.assertIn("gouraud", self.refuse("usage", CORNELL, "-o", "report", "--methods", "gurod"))
        self.refuse("usage", CORNELL, "-o", "report", *QUICK, "--reference", "nothing")
        self.refuse("input", "no_such.glb", "-o", "report")
        self.refuse("input", CORNELL, "-o", "no/such/folder")
        self.refuse("usage", CORNELL, "-o", "report", *QUICK, "--methods", "gouraud", "--samples", "3")

    def test_a_folder_with_other_files_is_left_alone(self):
        (self.folder / "report").mkdir()
        (self.folder / "report" / "mine.txt").write_text("mine")
        self.assertIn("mine.txt", self.refuse("usage", CORNELL, "-o", "report", *QUICK))
        self.assertEqual([p.name for p in (self.folder / "report").iterdir()], ["mine.txt"])

    def test_first_interrupt_writes_what_is_known(self):
        words = [PROGRAM, "study", str(ROOM), "-o", "report", "--size", "96x", "--rounds", "1000", "--progress=json"]
        with subprocess.Popen(words, cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
            for line in process.stderr:
                if line.startswith("{") and json.loads(line)["stage"] == "timing":
                    break
            began = time.monotonic()
            process.send_signal(signal.SIGINT)
            _, said = process.communicate(timeout=60)
            self.assertLess(time.monotonic() - began, 20)
        self.assertEqual(process.returncode, STATUS["stopped"], said)
        self.assertIn("the best result so far was written", said)
        [study] = json.loads(self.written("report.json"))["studies"]
        self.assertIs(study["report"]["complete"], False)
        self.assertIsNotNone(study["methods"][0]["quality"]["rmse"])
        self.assertEqual(self.files(), ["report"])


if __name__ == "__main__":
    unittest.main()
