"""scripts/demo.sh: a second call does no needless work."""
import os
import subprocess
import unittest

from program import PROGRAM, REPOSITORY, ProgramTest

FILES = ("gouraud.png", "phong.png", "whitted.png", "path.png", "path.exr", "radiosity.png", "two_pass.png", "room.lit.glb")


class Demo(ProgramTest):
    def test_up_to_date_files_are_kept(self):
        for name in FILES:  # as if drawn just now: newer than the program
            (self.folder / name).write_text("drawn before")
        script = REPOSITORY / "scripts" / "demo.sh"
        result = subprocess.run([script, os.path.dirname(PROGRAM), self.folder], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("nothing to do", result.stdout)
        self.assertEqual(self.files(), sorted(FILES), "the list here is the script's")
        for name in FILES:
            self.assertEqual((self.folder / name).read_text(), "drawn before")


if __name__ == "__main__":
    unittest.main()
