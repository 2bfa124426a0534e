#!/usr/bin/env python3
"""What code lenses and menus call: pictures and costs are of the texts that are open, and so is the window until
they are saved; why it fails is said.

usage: commands.py SNELL
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from client import Client, path_of

SNELL = ""
FRAGMENT = "uniform float uKa;\nvoid main() { gl_FragColor = vec4(uKa, 0., 0., 1.); }\n"
SCENE = "WindowSize 64 48\nPerspective 50\nFragment a.frag\nProgram P uKa .2\nSphere 1\n"


class Commands(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.client = Client(SNELL, {"window": {"showDocument": {"support": True}}}, environment={"TMPDIR": str(self.folder)},
                             without=("DISPLAY", "WAYLAND_DISPLAY"), driver=False)
        self.scene = self.write("a.glib", SCENE)
        self.shader = self.write("a.frag", FRAGMENT)

    def tearDown(self):
        self.assertEqual(self.client.garbage, b"")
        self.assertEqual(self.client.end(), 0)
        for stream in (self.client.process.stdin, self.client.process.stdout):
            stream.close()
        self.temporary.cleanup()

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return str(self.folder / name)

    def drawn(self):
        """The picture that snell draws of the files."""
        subprocess.run([SNELL, "render", self.scene, "-o", self.folder / "files.png"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return (self.folder / "files.png").read_bytes()

    def shown(self, uri):
        before = len(self.client.asked)
        self.client.request("workspace/executeCommand", {"command": "snell.render", "arguments": [uri]})
        self.client.wait_for(lambda: len(self.client.asked) > before, 60)
        asked = self.client.asked[-1]
        self.assertEqual(asked["method"], "window/showDocument")
        return pathlib.Path(path_of(asked["params"]["uri"])).read_bytes()

    def said(self, command, *arguments):
        before = len(self.client.notes)
        self.client.request("workspace/executeCommand", {"command": command, "arguments": list(arguments)})
        def message():
            return [n["params"] for n in self.client.notes[before:] if n["method"] == "window/showMessage"]
        return self.client.wait_for(message, 60)[0]

    def test_pictures_are_of_the_texts_that_are_open(self):
        scene, shader = self.client.open(self.scene), self.client.open(self.shader)
        saved = self.drawn()
        self.assertEqual(self.shown(scene), saved)
        texts = SCENE.replace(".2", ".9"), FRAGMENT.replace("0., 0.", "0., .5")
        self.client.change(scene, 2, [{"text": texts[0]}])
        self.client.change(shader, 2, [{"text": texts[1]}])
        unsaved = self.shown(shader)
        self.assertEqual(pathlib.Path(self.scene).read_text(), SCENE)
        self.write("a.glib", texts[0])
        self.write("a.frag", texts[1])
        self.assertNotEqual(unsaved, saved)
        self.assertEqual(unsaved, self.drawn())

    def test_costs_are_of_the_texts_that_are_open(self):
        scene = self.client.open(self.scene)
        said = self.said("snell.cost", scene, 4)
        self.assertEqual(said["type"], 3)
        self.assertRegex(said["message"], r"^mesh Sphere .* triangles\. A frame takes [0-9.]+ ms\.$")
        self.client.change(scene, 2, [{"text": SCENE.replace("Sphere 1", "Torus .4 1")}])
        self.assertIn("Torus", self.said("snell.cost", scene, 4)["message"])

    def test_a_window_that_fails_says_why(self):
        said = self.said("snell.open", self.client.open(self.scene))
        self.assertEqual(said["type"], 1)
        self.assertRegex(said["message"], r"^The window of a\.glib failed: no window: .*DISPLAY")

    def test_a_display_that_is_not_there_is_reported(self):
        other = Client(SNELL, environment={"DISPLAY": ":65000"}, without=("WAYLAND_DISPLAY",), driver=False)
        self.replace_client(other)
        self.assertIn(":65000", self.said("snell.open", other.open(self.scene))["message"])

    @unittest.skipUnless(shutil.which("Xvfb") and shutil.which("import"), "Xvfb or ImageMagick is not installed")
    def test_the_window_shows_open_texts_until_they_are_saved(self):
        ends = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(ends[1]), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
                                  pass_fds=ends[1:], stderr=subprocess.DEVNULL)
        os.close(ends[1])
        with os.fdopen(ends[0]) as number:
            display = ":" + number.readline().strip()
        try:
            self.replace_client(Client(SNELL, environment={"DISPLAY": display, "XDG_STATE_HOME": str(self.folder)},
                                       without=("WAYLAND_DISPLAY",), driver=False))
            shown = "WindowSize 200 200\nBackground %s\n"
            self.write("a.glib", shown % "0 0 1")
            scene = self.client.open(self.scene)
            self.client.change(scene, 2, [{"text": shown % "1 0 0"}])
            self.client.request("workspace/executeCommand", {"command": "snell.open", "arguments": [scene]})
            self.until_filled(display, b"\xff\0\0")
            self.write("a.glib", shown % "0 1 0")
            self.until_filled(display, b"\0\xff\0")
        finally:
            server.terminate()
            server.wait()

    def until_filled(self, display, color):
        """Waits until a large part of the screen has this colour."""
        for _ in range(100):
            screen = subprocess.run(["import", "-display", display, "-window", "root", "-depth", "8", "rgb:-"],
                                    capture_output=True).stdout
            pixels = [screen[i:i + 3] for i in range(0, len(screen), 3 * 97)]
            if pixels.count(color) > len(pixels) / 20:
                return
            time.sleep(.1)
        self.fail(f"no {color} on the screen")

    def replace_client(self, other):
        first, self.client = self.client, other
        self.assertEqual(first.end(), 0)
        for stream in (first.process.stdin, first.process.stdout):
            stream.close()


if __name__ == "__main__":
    SNELL = os.path.abspath(sys.argv.pop(1))
    unittest.main()
