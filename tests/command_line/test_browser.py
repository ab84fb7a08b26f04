"""Baked models in three.js in a real browser, against Aktina's own pictures of the same view.

Needs chromium, which scripts/setup.sh does not install (hundreds of megabytes), and three.js in node_modules/, which --tests
does. Where one is missing the tests say so and are skipped. AKTINA_KEEP=FOLDER keeps the pictures.
"""
import base64
import functools
import http.server
import json
import os
import pathlib
import queue
import shutil
import struct
import subprocess
import threading
import unittest
import urllib.parse

from program import REPOSITORY, ProgramTest

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
THREE = REPOSITORY / "node_modules" / "three" / "build" / "three.module.js"
FORMS = ("vertex", "emissive", "lightmap")


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files of the repository, and under /models/ those of the test; takes the page's answer."""

    def __init__(self, *words, models, answers, **more):
        self.models, self.answers = models, answers
        super().__init__(*words, directory=REPOSITORY, **more)

    def translate_path(self, path):
        name = urllib.parse.unquote(urllib.parse.urlparse(path).path)
        if name.startswith("/models/"):
            return str(self.models / pathlib.PurePosixPath(name).name)
        return super().translate_path(path)

    def do_POST(self):
        self.answers.put(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()

    def log_message(self, *words):
        pass


@unittest.skipUnless(BROWSER, "no chromium on this machine: models are not looked at in a browser")
@unittest.skipUnless(THREE.exists(), "three.js is not in node_modules: scripts/setup.sh --tests gets it")
class Browser(ProgramTest):
    def setUp(self):
        super().setUp()
        self.answers = queue.Queue()
        handler = functools.partial(Handler, models=self.folder, answers=self.answers)
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)

    def show(self, model, width, height):
        """What the browser's canvas shows, as a file."""
        query = urllib.parse.urlencode({"model": f"/models/{model}", "width": width, "height": height})
        url = f"http://127.0.0.1:{self.server.server_port}/tests/browser/view.html?{query}"
        words = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", "--no-first-run", "--disable-extensions", "--disable-background-networking",
                 "--disable-component-update", f"--user-data-dir={self.folder / 'profile'}", url]
        browser = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env=dict(os.environ, HOME=str(self.folder)))
        try:
            answer = self.answers.get(timeout=120)
        finally:
            browser.terminate()
            browser.wait(30)
        head = "data:image/png;base64,"
        self.assertTrue(answer.startswith(head), answer[:500])
        shot = self.folder / f"{pathlib.Path(model).stem}.shot.png"
        shot.write_bytes(base64.b64decode(answer[len(head) :]))
        return shot

    def compare(self, picture, reference):
        return json.loads(self.succeed("compare", picture, reference, "--json").stdout)["result"]

    def matt(self, scene):
        """A copy of a scene whose materials have no gloss: all that they reflect is what a lightmap can light."""
        data = (REPOSITORY / "scenes" / f"{scene}.glb").read_bytes()
        (length,) = struct.unpack_from("<I", data, 12)
        contents, rest = json.loads(data[20 : 20 + length]), data[20 + length :]
        for material in contents["materials"]:
            material.setdefault("extensions", {})["KHR_materials_specular"] = {"specularFactor": 0}
        contents.setdefault("extensionsUsed", []).append("KHR_materials_specular")
        text = json.dumps(contents).encode()
        text += b" " * (-len(text) % 4)
        head = struct.pack("<IIIII", 0x46546C67, 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A)
        (self.folder / f"{scene}.glb").write_bytes(head + text + rest)
        return f"{scene}.glb"

    def test_every_form_shows_the_solution_and_the_path_traced_picture(self):
        scene, width, height = self.matt("cornell"), 192, 192
        patches = ("--patch-size", "0.025")
        for method, options in ("radiosity", (*patches, "--samples", "16")), ("path", ("--samples", "256")):
            self.succeed("render", scene, "--method", method, "--size", f"{width}x{height}", "--exposure", "0.006",
                         *options, "-o", f"{method}.png")
        for form in FORMS:
            with self.subTest(form):
                self.succeed("bake", scene, "-o", f"{form}.glb", "--as", form, "--lightmap-size", "512",
                             "--exposure", "0.006", *patches)
                shot = self.show(f"{form}.glb", width, height)
                solution, traced = self.compare(shot, "radiosity.png"), self.compare(shot, "path.png")
                self.keep(f"cornell.{form}", solution, traced)
                self.assertLess(solution["flip"], 0.03)
                self.assertLess(traced["flip"], 0.06, "the path-traced picture has noise of its own")

    def keep(self, name, *found):
        if folder := os.environ.get("AKTINA_KEEP"):
            for path in self.folder.glob("*.png"):
                shutil.copy(path, pathlib.Path(folder) / f"{name}.{path.name}")
            print(name, *found)


if __name__ == "__main__":
    unittest.main()
