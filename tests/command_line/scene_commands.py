"""What holds for every command that reads a scene and writes files: a base class for their tests."""
import json
import os
import pathlib
import pty
import shutil
import signal
import struct
import subprocess
import time

from program import PROGRAM, REPOSITORY, STATUS, ProgramTest

ROOM = REPOSITORY / "scenes" / "room.glb"
CORNELL = REPOSITORY / "scenes" / "cornell.glb"


def glb(scene):
    """A .glb that consists of its JSON alone."""
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<IIIII", 0x46546C67, 2, 20 + len(text), len(text), 0x4E4F534A) + text


class SceneCommandTest(ProgramTest):
    """A subclass says which command, the extension of an output, and quick() and endless() options."""

    command, extension, quick, endless = None, None, [], []

    def words(self, scene, output, *more):
        return [self.command, scene, "-o", output, *more]

    def run_quick(self, scene=CORNELL, output=None, *more, **options):
        return self.succeed(*self.words(scene, output or f"out.{self.extension}", *self.quick, *more), **options)

    def refuse(self, status, scene=CORNELL, output=None, *more):
        """Fails with `status`, and leaves nothing behind."""
        before = self.files()
        error = self.expect_error(status, *self.words(scene, output or f"out.{self.extension}", *self.quick, *more))
        self.assertEqual(self.files(), before, "nothing half-written")
        return error

    # Input.

    def test_missing_scene(self):
        self.assertIn("no_such.glb", self.refuse("input", "no_such.glb"))

    def test_folder_as_scene(self):
        self.refuse("input", self.folder)

    def test_truncated_scene(self):
        data = CORNELL.read_bytes()
        for length in (0, 3, 11, 100, len(data) // 2, len(data) - 1):
            (self.folder / "cut.glb").write_bytes(data[:length])
            self.assertIn("cut.glb", self.refuse("input", "cut.glb"))

    def test_names_with_unicode_blanks_and_parents(self):
        folder = self.folder / "ein Ördner" / "b"
        folder.mkdir(parents=True)
        shutil.copy(CORNELL, folder / "szene ✓.glb")
        output = f"ein Ördner/b/../bild ü.{self.extension}"
        self.run_quick("ein Ördner/b/../b/szene ✓.glb", output)
        self.assertTrue((self.folder / output).is_file())

    # Output.

    def test_missing_folder(self):
        self.refuse("input", CORNELL, f"nowhere/out.{self.extension}")

    def test_read_only_folder(self):
        folder = self.folder / "closed"
        folder.mkdir(mode=0o555)
        if os.access(folder, os.W_OK):  # as root, who may write anywhere; /proc refuses even root
            folder = pathlib.Path("/proc")
        self.refuse("input", CORNELL, folder / f"out.{self.extension}")

    def test_folder_as_output(self):
        (self.folder / f"out.{self.extension}").mkdir()
        self.refuse("input")

    def test_full_disk(self):
        (self.folder / f"out.{self.extension}").symlink_to("/dev/full")
        self.assertIn("No space left", self.refuse("input"))

    def test_unknown_extension(self):
        self.assertIn(f".{self.extension}", self.refuse("usage", CORNELL, "out.xyz"))
        self.refuse("usage", CORNELL, "out")

    def test_the_old_output_stays_where_the_new_one_fails(self):
        (self.folder / f"out.{self.extension}").write_text("old")
        self.refuse("input", "no_such.glb")
        self.assertEqual((self.folder / f"out.{self.extension}").read_text(), "old")

    def test_output_is_required(self):
        self.assertIn("--output", self.expect_error("usage", self.command, CORNELL))

    # Options.

    def test_unknown_option_suggests_the_nearest(self):
        self.assertIn("did you mean --seed?", self.refuse("usage", CORNELL, None, "--sed", "1"))

    # What comes out.

    def test_same_bytes_for_any_number_of_threads(self):
        for threads in ("1", "2"):
            self.run_quick(CORNELL, f"{threads}.{self.extension}", "--threads", threads)
        one, two = ((self.folder / f"{threads}.{self.extension}").read_bytes() for threads in ("1", "2"))
        self.assertEqual(one, two)

    def test_report(self):
        report = json.loads(self.run_quick(CORNELL, None, "--json", "--seed", "7").stdout)
        self.assertEqual(report["schema_version"], 1)
        self.assertEqual(report["command"], self.command)
        self.assertIn("--seed 7", report["settings"])
        self.assertEqual(report["seed"], 7)
        self.assertEqual(report["scene"]["file"], "cornell.glb")
        self.assertRegex(report["scene"]["hash"], "^[0-9a-f]{16}$")
        self.assertIs(report["complete"], True)
        for stage in ("load", "write", "total"):
            self.assertGreaterEqual(report["timings"][stage], 0)
        for count in report["counts"].values():
            self.assertEqual(sorted(count), ["unit", "value"])
        [output] = report["outputs"]
        self.assertEqual(output["bytes"], (self.folder / output["file"]).stat().st_size)

    def test_the_output_records_how_it_was_made(self):
        self.run_quick(CORNELL, None, "--seed", "7")
        data = self.provenance(self.folder / f"out.{self.extension}")
        for word in (b"Aktina", b"cornell.glb", b"--seed 7"):
            self.assertTrue(word in data, word)
        self.assertFalse(os.fsencode(REPOSITORY) in data, "no folders of this machine")

    def provenance(self, path):
        """Bytes of an output among which its metadata stand in plain text."""
        return path.read_bytes()

    def test_quiet(self):
        result = self.run_quick(CORNELL, None, "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))

    def test_progress_as_json(self):
        lines = self.run_quick(CORNELL, None, "--progress=json").stderr.splitlines()
        states = [json.loads(line) for line in lines if line.startswith("{")]
        self.assertTrue(states)
        for state in states:
            self.assertLessEqual(state["done"], state["total"] or state["done"])

    def test_a_terminal_gets_a_bar_a_pipe_none(self):
        self.assertNotIn("\x1b", self.run_quick().stderr)
        ours, theirs = pty.openpty()
        words = [PROGRAM, *map(str, self.words(CORNELL, f"out.{self.extension}", *self.quick))]
        environment = dict(os.environ, TERM="xterm", NO_COLOR="1")
        with subprocess.Popen(words, cwd=self.folder, stderr=theirs, env=environment) as process:
            self.assertEqual(process.wait(60), 0)
        os.close(theirs)
        shown = b""
        try:
            while chunk := os.read(ours, 65536):
                shown += chunk
        except OSError:  # the other end is closed
            pass
        os.close(ours)
        self.assertIn(b"\r\x1b[K", shown)
        self.assertNotIn(b"\x1b[33m", shown, "NO_COLOR")

    def test_scene_without_camera_or_light_is_said(self):
        (self.folder / "bare.glb").write_bytes(bare_triangle())
        warnings = json.loads(self.run_quick("bare.glb", None, "--json").stdout)["warnings"]
        self.assertTrue(any("camera" in warning["text"] for warning in warnings), warnings)
        self.assertTrue(any("shines" in warning["text"] for warning in warnings), warnings)

    # Interruption.

    def start_endless(self):
        """A run that would take hours, as soon as it is at work."""
        words = [PROGRAM, *map(str, self.words(ROOM, f"out.{self.extension}", *self.endless, "--progress=json"))]
        process = subprocess.Popen(words, cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        for line in process.stderr:
            if line.startswith("{") and json.loads(line)["done"] >= 1:
                return process
        self.fail_here("it ended by itself")

    def test_first_interrupt_writes_the_result_so_far(self):
        if not self.endless:
            self.skipTest("this command has nothing that lasts")
        process = self.start_endless()
        began = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertLess(time.monotonic() - began, 20, "hours were asked for")
        self.assertEqual(process.returncode, STATUS["stopped"], said)
        self.assertIn("the best result so far was written", said)
        self.assertEqual([name for name in self.files() if "partial" in name], [])
        self.assertTrue((self.folder / f"out.{self.extension}").is_file())

    def test_second_interrupt_writes_nothing(self):
        if not self.endless:
            self.skipTest("this command has nothing that lasts")
        process = self.start_endless()
        os.kill(process.pid, signal.SIGSTOP)  # both signals are there before it can react to the first
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        os.kill(process.pid, signal.SIGCONT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, STATUS["stopped"], said)
        self.assertIn("nothing was written", said)
        self.assertEqual(self.files(), [])

    def fail_here(self, message):
        raise AssertionError(message)


def bare_triangle():
    """Geometry and nothing else; positions in a data URI."""
    import base64

    positions = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    uri = "data:application/octet-stream;base64," + base64.b64encode(positions).decode()
    return glb({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": uri, "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}]})
