"""Runs that are killed at any moment, and go on: aktina radiosity and bake with --checkpoint."""
import json
import random
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest
from scene_commands import CORNELL, ROOM


class Checkpoint(ProgramTest):
    def killed_again_and_again(self, words, seconds, kills, seed):
        """Runs `words` with a checkpoint, each time ended by SIGKILL a moment later, until one run gets to its end."""
        moments = random.Random(seed)
        words = [*map(str, words), "--checkpoint", "run.checkpoint", "--every", "0s", "--resume", "--quiet"]
        for _ in range(kills):
            run = subprocess.Popen([PROGRAM, *words], cwd=self.folder, stderr=subprocess.PIPE)
            time.sleep(moments.uniform(0, seconds))
            run.kill()
            self.assertEqual(run.communicate()[1], b"")
            self.assertIn(run.returncode, (0, -9))
        self.succeed(*words)

    def test_every_solver_ends_with_the_same_bytes(self):
        families = json.loads(self.succeed("methods", "--json").stdout)["families"]
        solvers = [m["id"] for family in families if family["id"] == "radiosity" for m in family["methods"]]
        self.assertIn("gmres", solvers)
        for number, solver in enumerate(solvers):
            words = ["radiosity", CORNELL, "--solver", solver, "--patch-size", "0.15", "--tolerance", "1e-3"]
            begun = time.monotonic()
            self.succeed(*words, "-o", "whole.aktina")
            seconds = time.monotonic() - begun
            (self.folder / "run.checkpoint").unlink(missing_ok=True)
            self.killed_again_and_again([*words, "-o", "killed.aktina"], 1.5 * seconds, 3, number)
            self.assertEqual((self.folder / "killed.aktina").read_bytes(), (self.folder / "whole.aktina").read_bytes(), solver)

    def test_bake(self):
        words = ["bake", CORNELL, "--patch-size", "0.1"]
        self.succeed(*words, "-o", "whole.glb")
        self.killed_again_and_again([*words, "-o", "killed.glb"], 0.4, 3, 1)
        self.assertEqual((self.folder / "killed.glb").read_bytes(), (self.folder / "whole.glb").read_bytes())

    def test_mistakes_are_one_line(self):
        words = ["radiosity", CORNELL, "-o", "a.csv", "--patch-size", "0.2"]
        self.assertIn("--checkpoint FILE", self.expect_error("usage", *words, "--resume"))
        self.assertIn("5min", self.expect_error("usage", *words, "--checkpoint", "c", "--every", "soon"))
        self.expect_error("input", *words, "--checkpoint", "nowhere/c")
        self.succeed(*words, "--checkpoint", "c", "--every", "0s")
        resumed = ["--checkpoint", "c", "--resume"]
        self.assertIn("other settings", self.expect_error("input", *words, *resumed, "--seed", "1"))
        self.assertIn("another scene", self.expect_error("input", "radiosity", ROOM, *words[2:], *resumed))
        (self.folder / "c").write_bytes((self.folder / "c").read_bytes()[:-1])
        self.assertIn("damaged", self.expect_error("input", *words, *resumed))

    def test_a_first_run_may_ask_to_go_on(self):
        words = ["radiosity", CORNELL, "-o", "a.csv", "--patch-size", "0.2", "--checkpoint", "c", "--resume"]
        self.assertIn("c is not there yet", self.succeed(*words).stderr)
        self.assertEqual(self.files(), ["a.csv"], "too short a run for a checkpoint")


if __name__ == "__main__":
    unittest.main()
