"""What the README tells newcomers to type works as it stands."""
import os
import re
import shlex
import subprocess
import sys
import unittest

from program import PROGRAM, REPOSITORY, ProgramTest

README = (REPOSITORY / "README.md").read_text(encoding="utf-8")


def block(language):
    [text] = re.findall(rf"^```{language}\n(.*?)^```", README, re.M | re.S)
    return text.strip().splitlines()


class Readme(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "scenes").symlink_to(REPOSITORY / "scenes")

    def test_commands(self):
        lines = block("sh")
        self.assertEqual(len(lines), 5)
        for line in lines:
            program, *words = shlex.split(line)
            self.assertEqual(program, "aktina")
            self.succeed(*words)
        for name in ("room.png", "fast.png", "difference.png", "light.csv", "cornell.lit.glb"):
            self.assertIn(name, self.files())

    def test_python(self):
        lines = block("python")
        self.assertEqual(len(lines), 5)
        module = os.path.join(os.path.dirname(PROGRAM), "python")
        if not os.path.isdir(module):
            self.skipTest("the Python module is not built")
        result = subprocess.run([sys.executable, "-c", "\n".join(lines)], capture_output=True, text=True,
                                cwd=REPOSITORY, env=dict(os.environ, PYTHONPATH=module))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("0.1998", result.stdout)

    def test_links_lead_somewhere(self):
        for page in [REPOSITORY / "README.md", *(REPOSITORY / "docs").glob("*.md")]:
            for link in re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8")):
                if "://" not in link:
                    self.assertTrue((page.parent / link).exists(), f"{page.name}: {link}")


if __name__ == "__main__":
    unittest.main()
