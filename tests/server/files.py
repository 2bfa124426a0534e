#!/usr/bin/env python3
"""Scenes and shaders as files: whose diagnostics go where, names with anything in them, files that vanish.

usage: files.py SNELL
"""
import os
import pathlib
import sys
import tempfile
import unittest

from client import Client, path_of, uri_of

SNELL = ""

VERTEX = "varying vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = ftransform(); }\n"
FRAGMENT = "uniform float uKa;\nvarying vec3 vN;\nvoid main() { gl_FragColor = vec4(uKa * vN, 1.); }\n"
BROKEN = FRAGMENT.replace("void main() {", "#include \"nothing.glsl\"\nvoid main() {")
SCENE = "Vertex a.vert\nFragment a.frag\nProgram P uKa <0. .5 1.>\nSphere 1\n"


def codes(diagnostics):
    return sorted(d["code"] for d in diagnostics)


class Files(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        self.client = Client(SNELL, {"workspace": {"didChangeWatchedFiles": {"dynamicRegistration": True}}})

    def tearDown(self):
        self.assertEqual(self.client.garbage, b"")
        self.assertEqual(self.client.end(), 0)
        for stream in (self.client.process.stdin, self.client.process.stdout):
            stream.close()
        self.temporary.cleanup()

    def write(self, name, text):
        path = pathlib.Path(self.folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return str(path)

    def write_scene(self, folder=".", scene=SCENE, fragment=FRAGMENT, name="a.glib"):
        self.write(os.path.join(folder, "a.vert"), VERTEX)
        self.write(os.path.join(folder, "a.frag"), fragment)
        return self.write(os.path.join(folder, name), scene)

    def touched(self, path, kind=2):
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri_of(path), "type": kind}]})

    def until(self, uri, wanted, seconds=20):
        """Waits until the diagnostics of a text have these codes."""
        def there():
            found = self.client.published.get(uri)
            return found is not None and codes(found["diagnostics"]) == sorted(wanted)
        try:
            self.client.wait_for(there, seconds)
        except TimeoutError:
            self.fail(f"{uri}: {self.client.published.get(uri)} instead of {wanted}")
        return self.client.published[uri]["diagnostics"]

    def test_asks_to_watch_files(self):
        self.client.wait_for(lambda: self.client.asked)
        self.assertEqual(self.client.asked[0]["method"], "client/registerCapability")

    def test_shaders_have_their_diagnostics_at_their_own_files(self):
        scene = self.write_scene(fragment=BROKEN)
        uri = self.client.open(scene)
        shader = uri_of(os.path.join(self.folder, "a.frag"))
        found = self.until(shader, ["missing-include"])
        self.assertEqual(found[0]["range"]["start"]["line"], 2)
        self.assertEqual(found[0]["severity"], 1)
        self.assertNotIn("version", self.client.published[shader])
        self.until(uri, [])
        self.assertEqual(self.client.published[uri]["version"], 1)
        # The editor mends it, without writing it.
        self.client.open(os.path.join(self.folder, "a.frag"), FRAGMENT, version=9)
        self.until(shader, [])
        self.client.close(shader)
        self.until(shader, ["missing-include"])
        self.client.close(uri)
        self.until(shader, [])

    def test_a_shader_alone_finds_its_scene(self):
        self.write_scene("scenes", SCENE.replace("a.frag", "../shaders/deep/b.frag"))
        shader = self.write("shaders/deep/b.frag", FRAGMENT)
        self.write("shaders/deep/other.glib", "Sphere 1\n")
        uri = self.client.open(shader, FRAGMENT.replace("uKa", "uKb"))
        self.client.diagnostics(uri)
        # In a folder beside the one above: it is found only from the scene.
        scene = uri_of(os.path.join(self.folder, "scenes/a.glib"))
        self.assertNotIn(scene, self.client.published)
        self.client.open(path_of(scene))
        self.until(scene, ["unknown-uniform"])

        near = self.write("scenes/inner/c.frag", FRAGMENT.replace("uKa", "uKc"))
        self.write("scenes/c.glib", SCENE.replace("a.frag", "inner/c.frag"))
        self.client.open(near)
        self.until(uri_of(os.path.join(self.folder, "scenes/c.glib")), ["unknown-uniform"])

    def test_a_scene_is_found_among_many(self):
        for i in range(300):
            self.write(f"up/in/{i}.glib", "Sphere 1\n")
        self.write_scene("up", SCENE.replace("a.frag", "in/b.frag"))
        uri = self.client.open(self.write("up/in/b.frag", FRAGMENT))
        found = self.client.request("textDocument/references", {
            "textDocument": {"uri": uri}, "position": {"line": 0, "character": 15},
            "context": {"includeDeclaration": True}})
        self.assertIn(uri_of(os.path.join(self.folder, "up/a.glib")), {place["uri"] for place in found})

    def test_an_included_text_finds_its_scene(self):
        self.write_scene(fragment='#include "lib/light.glsl"\n' + FRAGMENT.replace("uKa *", "uKa * light() *"))
        part = self.write("lib/light.glsl", "float light() { return 1.; }\n")
        uri = self.client.open(part, '#include "missing.glsl"\nfloat light() { return 1.; }\n')
        self.until(uri, ["missing-include"])

    def test_a_shader_without_a_scene_is_a_program_of_itself(self):
        path = self.write("alone.frag", "varying vec3 vN;\nvoid main() { gl_FragColor = vec4(vN, 1.); }\n")
        uri = self.client.open(path)
        self.until(uri, [])
        self.client.change(uri, 2, [{"text": '#include "x.glsl"\nvoid main() {}\n'}])
        self.until(uri, ["missing-include"])

    def test_a_shared_shader_belongs_to_the_scene_that_was_open_last(self):
        first = self.write_scene()
        second = self.write("b.glib", SCENE.replace("uKa", "uKx").replace("Sphere 1", ""))
        shader = self.client.open(os.path.join(self.folder, "a.frag"))
        a, b = self.client.open(first), self.client.open(second)
        self.until(b, ["program-not-drawn", "unknown-uniform"])
        def definition():
            found = self.client.request("textDocument/references", {
                "textDocument": {"uri": shader}, "position": {"line": 0, "character": 15},
                "context": {"includeDeclaration": True}})
            return {place["uri"] for place in found}
        self.assertEqual(definition(), {shader})  # b.glib does not name it
        self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": a}})
        self.assertEqual(definition(), {shader, a})

    def test_what_is_said_does_not_depend_on_what_was_asked(self):
        # A shader that no scene names for a moment is one of its scene again: the driver knows what is wrong with it.
        scene = self.client.open(self.write_scene(fragment=FRAGMENT.replace("uKa * vN", "uKa * lost * vN")))
        shader = self.client.open(os.path.join(self.folder, "a.frag"))
        self.until(shader, ["glsl-undeclared"])
        self.client.change(scene, 2, [{"text": SCENE.replace("a.frag", "a.fra")}])
        self.until(scene, ["file-not-found"])
        self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": shader}})
        self.until(shader, [])
        self.client.change(scene, 3, [{"text": SCENE}])
        self.until(scene, [])
        self.until(shader, ["glsl-undeclared"])

    def test_a_text_of_several_scenes_has_what_each_says(self):
        both = {name: self.client.open(self.write_scene(scene=SCENE.replace("uKa", name), name=f"{name}.glib"))
                for name in ("uKa", "uKb")}
        shader = self.client.open(os.path.join(self.folder, "a.frag"), FRAGMENT.replace("uniform", "#include \"x.glsl\"\nuniform"))
        self.until(shader, ["missing-include"])  # once, though both say it
        self.client.change(both["uKb"], 2, [{"text": SCENE.replace("Vertex a.vert", "")}])
        self.client.change(shader, 2, [{"text": FRAGMENT}])
        for asked in both.values():
            self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": asked}})
            self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": shader}})
            self.until(shader, ["input-without-output"])

    def test_a_uniform_that_is_declared_is_not_mistyped(self):
        # uKd resembles uKz, but is set itself: with it, its line would say it twice.
        scene = self.write_scene(scene=SCENE.replace("uKa", "uKz 1. uNot 2. uKa"), fragment="\nuniform float uKz, uKd;\n" + FRAGMENT)
        uri = self.client.open(scene)
        self.until(uri, ["unknown-uniform", "unknown-uniform"])  # while one writes, only what is not declared
        found = {d["message"].split("\n")[0]: d for d in self.client.published[uri]["diagnostics"]}
        self.assertEqual(set(found), {"'uKz' is declared in a.frag:2 and never used", "no shader of program 'P' declares 'uNot'"})
        for one in found.values():
            self.assertNotIn("data", one)
        related = found["'uKz' is declared in a.frag:2 and never used"]["relatedInformation"][0]["location"]
        self.assertEqual([related["uri"], related["range"]["start"]],
                         [uri_of(os.path.join(self.folder, "a.frag")), {"line": 1, "character": 14}])

    def test_tags_and_related_places(self):
        scene = self.write_scene(scene=SCENE.replace("Sphere 1\n", ""))
        found = self.until(self.client.open(scene), ["program-not-drawn"])
        self.assertEqual(found[0]["tags"], [1])
        lost = self.write("lost.glib", SCENE.replace(" uKa", "\n uKa <0. .5 1.>\n uKb"))
        found = [d for d in self.client.diagnostics(self.client.open(lost)) if d["code"] == "unknown-command"]
        related = found[0]["relatedInformation"]
        self.assertEqual([r["location"]["range"]["start"]["line"] for r in related], [2, 4])
        self.assertTrue(os.path.exists(path_of(found[0]["codeDescription"]["href"].split("#")[0])))

    def test_columns_are_of_utf_16(self):
        scene = self.write_scene()
        uri = self.client.open(scene, 'Texture2D 5 "😀é.png" surplus\nSphere 1\n')
        found = {d["code"]: d["range"] for d in self.client.diagnostics(uri)}
        self.assertEqual(found["file-not-found"]["end"], {"line": 0, "character": 12 + 9})
        self.assertEqual(found["surplus-arguments"]["start"], {"line": 0, "character": 22})

    def test_folders_with_anything_in_their_names(self):
        for folder in ("with blank", "per%cent%20", "ha#sh?", "Übung 漢字 😀", "plus+and&amp;=;,"):
            scene = self.write_scene(folder, fragment=BROKEN)
            uri = self.client.open(scene)
            shader = uri_of(os.path.join(self.folder, folder, "a.frag"))
            self.until(uri, [])
            self.until(shader, ["missing-include"])
            # Editors encode more, or less, than others.
            less = shader.replace("%28", "(").replace("%2B", "+").replace("%3D", "=").replace("%2C", ",")
            self.client.open("", FRAGMENT, "glsl", 3, uri=less)
            self.until(less, [])
            self.client.close(less)
            self.client.close(uri)

    def test_files_that_vanish(self):
        scene = self.write_scene()
        uri = self.client.open(scene)
        self.until(uri, [])
        fragment = os.path.join(self.folder, "a.frag")
        os.remove(fragment)
        self.touched(fragment, 3)
        self.until(uri, ["file-not-found"])
        self.write("a.frag", FRAGMENT.replace("uKa", "uKb"))
        self.touched(fragment, 1)
        self.until(uri, ["unknown-uniform"])
        self.write("a.frag", FRAGMENT)
        self.touched(fragment)
        self.until(uri, [])
        # The scene itself, and its folder: what is open is still read.
        self.temporary.cleanup()
        self.touched(scene, 3)
        self.until(uri, ["file-not-found", "file-not-found"])
        self.client.change(uri, 2, [{"text": "Spher 1\n"}])
        self.until(uri, ["unknown-command"])

    def test_what_is_open_need_not_exist(self):
        uri = self.client.open("", "Spher 1\n", "glib", uri="untitled:Untitled-1")
        self.until(uri, ["unknown-command"])
        missing = self.client.open(os.path.join(self.folder, "no/such/folder/a.glib"), SCENE)
        self.until(missing, ["file-not-found", "file-not-found"])
        self.client.open(os.path.join(self.folder, "b.frag"), FRAGMENT)
        self.client.open("/", "Sphere\n")
        self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": uri}})

    def test_one_file_through_a_link(self):
        self.write_scene("real", fragment=BROKEN)
        os.symlink("real", os.path.join(self.folder, "link"))
        uri = self.client.open(os.path.join(self.folder, "link/a.glib"))
        shader = os.path.join(self.folder, "real/a.frag")
        self.until(uri_of(shader), ["missing-include"])
        self.client.open(os.path.join(self.folder, "link/a.frag"), FRAGMENT)
        self.until(uri_of(os.path.join(self.folder, "link/a.frag")), [])
        self.until(uri, [])
        self.until(uri_of(shader), [])

    def test_cycles_of_includes(self):
        self.write("a.glib", "Include b.glib\nSphere 1\n")
        self.write("b.glib", "Include a.glib\n")
        found = self.client.diagnostics(self.client.open(os.path.join(self.folder, "a.glib")))
        self.client.rest(.5)
        inner = self.client.published[uri_of(os.path.join(self.folder, "b.glib"))]["diagnostics"]
        self.assertEqual(codes(found) + codes(inner), ["include-cycle"])

    def test_the_driver_speaks_after_a_rest(self):
        scene = self.write_scene(fragment=FRAGMENT.replace("uKa * vN", "uKaa * vN"))
        uri = self.client.open(scene)
        self.client.diagnostics(uri)
        shader = uri_of(os.path.join(self.folder, "a.frag"))
        found = self.client.wait_for(lambda: self.client.published.get(shader, {}).get("diagnostics"))
        self.assertEqual(found[0]["range"]["start"]["line"], 2)
        self.assertIn("uKaa", found[0]["message"])
        self.assertEqual(found[0]["data"]["fixes"][0]["newText"], "uKa")

    def test_without_a_driver_nothing_is_missed(self):
        scene = self.write_scene(fragment=FRAGMENT.replace("uKa * vN", "uKaa * vN"))
        other = Client(SNELL, environment={"__EGL_VENDOR_LIBRARY_FILENAMES": "/nowhere.json"})
        uri = other.open(scene)
        self.assertEqual(other.diagnostics(uri), [])
        other.rest(1.5)
        self.assertEqual({uri: p["diagnostics"] for uri, p in other.published.items()}, {uri: []})
        self.assertEqual([n["method"] for n in other.notes], ["textDocument/publishDiagnostics"])
        self.assertEqual(other.garbage, b"")
        self.assertEqual(other.end(), 0)


if __name__ == "__main__":
    SNELL = os.path.abspath(sys.argv.pop(1))
    unittest.main()
