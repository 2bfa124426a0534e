#!/usr/bin/env python3
"""Every quick fix that is offered on broken scenes is applied: it makes the diagnostic go that it is for, and brings no
new one that is as severe.

usage: actions.py SNELL
"""
import collections
import concurrent.futures
import glob
import os
import pathlib
import random
import sys
import tempfile

from client import Client, path_of
from undone import ALL, SHADERS, damaged

# What else people write, by name: files, of which scene.glib is open, and how many fixes there must be at least.
VERTEX = "varying vec3 vN;\nvoid main() {\n    vN = gl_Normal;\n    gl_Position = ftransform();\n}\n"
FRAGMENT = "uniform float uKa;\nvarying vec3 vN;\nvoid main() {\n    gl_FragColor = vec4(uKa * vN, 1.);\n}\n"
# A picture of one pixel, in ASCII.
RED = "BM\x3a" + "\0" * 7 + "\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18" + "\0" * 27 + "\x7f\0"
SCENE = "Vertex a.vert\nFragment a.frag\nProgram P uKa <0. .5 1.>\nSphere 1\n"


# `fixes`: at least so many; None: none at all
def case(scene=SCENE, vertex=VERTEX, fragment=FRAGMENT, fixes=1, encoding="utf-8", **more):
    files = {"scene.glib": scene, "a.vert": vertex, "a.frag": fragment, **more}
    return {name: text.encode(encoding) for name, text in files.items()}, fixes


OWN = {
    "command": case("Spher 1\n"),
    "command, Windows": case("Perspectiv 50\r\nSphere 1\r\nTorsu 1 .5\r\n", fixes=2),
    "command, wide characters": case("# 😀 漢字\n/* é😀 */\nSpher 1 # 😀\n"),
    "command after a mark of UTF-8": case("\ufeffSpher 1\n"),
    "primitive": case("glBegin gl_triangel\nglVertex 0. 0. 0.\nglVertex 1. 0. 0.\nglVertex 0. 1. 0.\nglEnd\n"),
    "choice": case("CullFace bakc\nSphere 1\n"),
    "shader: two equals signs": case(fragment=FRAGMENT.replace("main() {", "main() {\n    float k == 1.;")),
    "shader: no equals sign": case(fragment="const float K 2.;\n" + FRAGMENT),
    "shader: elseif": case(fragment=FRAGMENT.replace("gl_F", "if (uKa > 1.) return; elseif (uKa < .1) discard;\n    gl_F")),
    "shader: macro that assigns": case(fragment="#define K = 2.\n" + FRAGMENT.replace("uKa *", "uKa * K *")),
    "backslash": case(SCENE.replace(" uKa", "\n    uKa")),
    "backslashes": case(SCENE.replace("uKa <0. .5 1.>", "\n  uKa <0. .5 1.>\n  uKb 1."), fragment=FRAGMENT.replace(
        "uniform", "uniform float uKb;\nuniform", 1).replace("uKa *", "uKa * uKb *")),
    "backslash, Windows": case(SCENE.replace(" uKa", "\n    uKa").replace("\n", "\r\n")),
    "backslash before a comment": case(SCENE.replace(" uKa", "  # a remark\n    uKa")),
    "backslash before a line of comment": case(SCENE.replace(" uKa", "\n  // a remark\n    uKa")),
    "range, maximum before the value": case(SCENE.replace("<0. .5 1.>", "<0. 1. .5>")),
    "range, value first": case(SCENE.replace("<0. .5 1.>", "<.5 0. 1.>")),
    "range, reversed": case(SCENE.replace("<0. .5 1.>", "<1. .5 0.>")),
    "range, maximum, minimum, value": case(SCENE.replace("<0. .5 1.>", "<10. -1. 5.>")),
    "range, reversed whole numbers": case(SCENE.replace("<0. .5 1.>", "<3 2 1>")),
    "uniform that is there already": case(SCENE.replace("<0. .5 1.>", "1. uKaa 2."), fixes=None),
    "backslash behind a blank line": case(SCENE.replace(" uKa", "\n\n  uKb 1."), fixes=None),
    "shader: function like a variable": case(fragment=FRAGMENT.replace("gl_Frag", "float x = .5; gl_Frag").replace(
        "uKa *", "mx(uKa, x) *")),
    "range of whole numbers": case(SCENE.replace("<0. .5 1.>", "<0 10 5>")),
    "uniform": case(SCENE.replace("uKa", "uKaa")),
    "uniform of another case": case(SCENE.replace("uKa", "uka")),
    "file of another case": case(SCENE.replace("a.vert", "A.vert")),
    "file with another extension": case(SCENE.replace("a.frag", "a.fragment")),
    "picture with another extension": case("Texture2D 5 red.bpm\nTexture2D 6 red.png\nSphere 1\n", fixes=2,
                                           **{"red.bmp": RED}),
    "mesh with another extension": case("Obj ball.oj\n", **{"ball.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}),
    "file without extension": case(SCENE.replace("a.frag", "a")),
    "file": case(SCENE.replace("phong.frag", "phon.frag").replace("a.frag", "phon.frag"), **{"phong.frag": FRAGMENT}),
    "file in quotes": case(SCENE.replace("a.frag", '"my shadr.frag"'), **{"my shader.frag": FRAGMENT}),
    "file twice": case(SCENE.replace("a.vert", "A.vert") * 2, fixes=1),
    "include with another extension": case("Include common.in\nSphere 1\n", **{"common.inc": "Perspective 50\n"}),
    "include": case("Include comon.inc\nSphere 1\n", **{"common.inc": "Perspective 50\n"}),
    "mesh": case("Obj Ball.obj\n", **{"ball.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}),
    "picture": case("Texture2D 5 Image.bmp\nSphere 1\n", **{"image.bmp": "BM"}, fixes=0),
    "shader: uniform": case(fragment=FRAGMENT.replace("uKa *", "uKaa *")),
    "shader: function": case(fragment=FRAGMENT.replace("uKa *", "normalise(vN).x *")),
    "shader: type": case(fragment=FRAGMENT.replace("uniform float", "uniform flaot")),
    "shader: semicolon": case(vertex=VERTEX.replace("gl_Normal;", "gl_Normal")),
    "shader: parenthesis": case(fragment=FRAGMENT.replace("1.);", "1.;")),
    "shader: main": case(fragment=FRAGMENT.replace("main", "mian")),
    "shader: macro": case(fragment="#define HALF .5;\n" + FRAGMENT.replace("uKa *", "uKa * HALF *")),
    "shader, Windows": case(vertex=VERTEX.replace("gl_Normal;", "gl_Normal").replace("\n", "\r\n")),
    "many": case("Spher 1\nBoxx 1 1 1\nTorsu 1 .5\nCylindr 1 1\nPerspectiv 50\n", fixes=5),
}


def every(client):
    return [(uri, d) for uri, p in client.published.items() for d in p["diagnostics"]]


def messages(client, severity):
    """How often each message is said, of those that are as severe."""
    same = "the same here"
    return collections.Counter((d["code"], d["message"]) for _, d in every(client) if d["severity"] <= severity for _ in
                               [0] + [r for r in d.get("relatedInformation", []) if r["message"] == same])


def offset(text, place):
    """The index of a place in the text, whose columns are of UTF-16."""
    lines = text.replace("\r\n", "\n\0").replace("\r", "\n").split("\n")
    at = sum(len(line) + 1 for line in lines[:place["line"]])
    line = lines[place["line"]] if place["line"] < len(lines) else ""
    skip = 1 if line.startswith("\0") else 0
    column, i = 0, skip
    while i < len(line) and column < place["character"]:
        column += 2 if ord(line[i]) > 0xFFFF else 1
        i += 1
    return at + i


def applied(text, edits):
    for edit in sorted(edits, key=lambda e: offset(text, e["range"]["start"]), reverse=True):
        begin, end = (offset(text, edit["range"][side]) for side in ("start", "end"))
        text = text[:begin] + edit["newText"] + text[end:]
    return text


class Scene:
    """A scene that is open with all its texts."""

    def __init__(self, client, folder, driver):
        self.client, self.driver, self.version, self.uris = client, driver, 1, []
        for path in sorted(glob.glob(folder + "/*"), key=lambda p: not p.endswith("scene.glib")):
            if path.endswith((".glib", ".vert", ".frag", ".inc")):
                self.uris.append(client.open(path))
        self.versions = {uri: 1 for uri in self.uris}
        self.texts = {uri: pathlib.Path(path_of(uri)).read_bytes().decode("utf-8", "replace") for uri in self.uris}

    def settle(self):
        if self.driver:
            return self.client.rest(.6)  # the driver is asked .3 s after a change
        self.client.wait_for(lambda: all(
            self.client.published.get(uri, {}).get("version") == self.versions[uri] for uri in self.uris
            if uri in self.client.published or uri == self.uris[0]))

    def change(self, texts):
        self.version += 1
        for uri, text in texts.items():
            self.versions[uri] = self.version
            self.client.change(uri, self.version, [{"text": text}])
        self.settle()

    def close(self):
        for uri in self.uris:
            self.client.close(uri)
        self.client.request("textDocument/none", {}, fails=True)
        self.client.published.clear()

    def actions(self):
        found = []
        for uri, d in every(self.client):
            if uri not in self.texts:
                continue
            for action in self.client.request("textDocument/codeAction", {
                    "textDocument": {"uri": uri}, "range": d["range"], "context": {"diagnostics": [d]}}):
                if action not in found:
                    found.append(action)
        return found


def try_all(client, name, folder, least, driver):
    scene = Scene(client, folder, driver)
    scene.settle()
    actions, wrong = scene.actions(), []
    for _ in range(3):  # fixes that a busy machine could not try in time are not offered
        if len(actions) >= (least or 0):
            break
        scene.change(scene.texts)
        actions = scene.actions()
    if len(actions) < (least or 0) or (least is None and actions):
        wrong.append(f"{name}: {len(actions)} fixes instead of {least}: {every(client)}")
    for action in actions:
        one = action["diagnostics"][0]
        before = messages(client, one["severity"])
        now = {uri: applied(scene.texts[uri], edits) for uri, edits in action["edit"]["changes"].items()}
        ends = [text.count("\r\n") for text in now.values()]
        if ends != [scene.texts[uri].count("\r\n") for uri in now]:
            wrong.append(f"{name}: {action['title']}: line ends differ")
        scene.change(now)
        after, fixed = messages(client, one["severity"]), (one["code"], one["message"])
        if after - before:
            wrong.append(f"{name}: {action['title']} brings {list(after - before)}")
        if after[fixed] >= before[fixed]:
            wrong.append(f"{name}: {action['title']}: it stays: {one['message']}")
        scene.change({uri: scene.texts[uri] for uri in now})
    scene.close()
    return len(actions), wrong


def try_some(snell, cases, top):
    """The number of fixes of these cases, and what is wrong with them."""
    clients = {driver: Client(snell, driver=driver) for driver in (False, True)}
    fixes, wrong = 0, []
    for index, (name, files, least) in cases:
        folder = os.path.join(top, str(index))
        os.mkdir(folder)
        for file, text in files.items():
            pathlib.Path(folder, file).write_bytes(text)
        driver = name.startswith("shader")
        count, more = try_all(clients[driver], name, folder, least, driver)
        fixes, wrong = fixes + count, wrong + more
    return fixes, wrong + [f"a server ends with {status}" for status in (c.end() for c in clients.values()) if status]


def slips(count):
    """Scenes of the repository with one slip in a scene or a shader."""
    rand = random.Random(3)
    for i in range(count):
        scene = pathlib.Path(rand.choice([path for path in ALL if not path.startswith(("tests/bad", "tests/odd"))]))
        files = {path.name: path.read_bytes() for path in scene.parent.iterdir()
                 if path.is_file() and path.suffix != ".glib" and path.stat().st_size < 1 << 18}
        files["scene.glib"] = scene.read_bytes()
        text = scene.read_text("utf-8", "replace")
        name = rand.choice(["scene.glib"] * 2 + sorted(name for name in files if name.endswith(SHADERS) and name in text))
        files[name] = damaged(files[name].decode("utf-8", "replace"), rand).encode()
        yield f"{scene} with a slip in {name}", files, 0


def main(snell):
    cases = [(name, files, least) for name, (files, least) in OWN.items()]
    cases += [(path, {"scene.glib": pathlib.Path(path).read_bytes()}, 0)
              for path in sorted(glob.glob("tests/bad/*.glib") + glob.glob("tests/odd/*.glib"))]
    cases += slips(int(os.environ.get("SNELL_SLIPS", "60")))
    cases = list(enumerate(cases))
    at_once = 6  # they wait most of the time
    with tempfile.TemporaryDirectory() as top, concurrent.futures.ThreadPoolExecutor(at_once) as pool:
        tried = list(pool.map(lambda i: try_some(snell, cases[i::at_once], top), range(at_once)))
    wrong = [line for _, lines in tried for line in lines]
    print(*wrong, f"{sum(fixes for fixes, _ in tried)} fixes of {len(cases)} scenes", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
