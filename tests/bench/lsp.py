#!/usr/bin/env python3
"""How long the language server takes to answer after an edit of a scene and of a shader of 20,000 lines.

usage: lsp.py SNELL [ROUNDS]     fails if the median is above 50 ms, or the longest above 200 ms
"""
import os
import pathlib
import random
import statistics
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../server"))
from client import Client  # noqa: E402

LINES = 20000
MEDIAN, WORST = 50, 200  # milliseconds

VERTEX = "void main() { gl_Position = ftransform(); }\n"


def long_scene():
    lines = ["Perspective 50", "LookAt 0. 0. 3. 0. 0. 0. 0. 1. 0.", "Vertex a.vert", "Fragment a.frag",
             "Program P uKa <0. .2 1.> uColor {1. .5 0.}"]
    shapes = ["Sphere .1 8 8", "Box .1 .1 .1", "Torus .1 .05 8 8", "Cone .1 .2 8", "Translate .01 0. 0.", "Color 1. .5 0."]
    while len(lines) < LINES:
        lines.append(shapes[len(lines) % len(shapes)] + ("  # a remark" if len(lines) % 7 == 0 else ""))
    return "\n".join(lines) + "\n"


def long_shader():
    lines = ["uniform float uKa;", "uniform vec4 uColor;"]
    functions = 0
    while len(lines) < LINES - 10:
        functions += 1
        lines += [f"float f{functions}(float x, vec3 v) {{", "    float sum = x * uKa;",
                  "    for (int i = 0; i < 3; ++i)", "        sum += dot(v, v) * 2.;",
                  "    if (sum > 1.) sum = 1. / sum;  // a remark", "    return mix(sum, x, .5);", "}", ""]
    lines += ["void main() {", f"    gl_FragColor = uColor * f{functions}(1., vec3(1.));", "}"]
    return "\n".join(lines) + "\n"


def processor_ms(client):
    """What the server has computed so far."""
    return int(pathlib.Path(f"/proc/{client.process.pid}/schedstat").read_text().split()[0]) / 1e6


def rounds_of(client, uri, text, rounds):
    """Types a letter somewhere and asks, as an editor does. Returns the milliseconds of each answer, until its
    last byte, by method, and those that the server computed."""
    lines = text.split("\n")
    took, worked = {}, {}
    random.seed(3)
    asks = {"completion": lambda at: {"position": at}, "hover": lambda at: {"position": at},
            "signatureHelp": lambda at: {"position": at}, "definition": lambda at: {"position": at},
            "documentHighlight": lambda at: {"position": at}, "references": lambda at: {
                "position": at, "context": {"includeDeclaration": True}},
            "documentColor": lambda at: {}, "documentSymbol": lambda at: {}}
    version = 1
    for round in range(rounds):
        line = random.randrange(10, len(lines) - 20)
        at = {"line": line, "character": min(5, len(lines[line]))}
        for method, more in asks.items():
            version += 1
            edit = {"range": {"start": at, "end": at}, "text": "x"}
            if version % 2:
                edit = {"range": {"start": at, "end": {"line": line, "character": at["character"] + 1}}, "text": ""}
            before, begin = processor_ms(client), time.perf_counter()
            client.change(uri, version, [edit])
            id = client.begin("textDocument/" + method, {"textDocument": {"uri": uri}, **more(at)})
            reply = client.answer(id)
            took.setdefault(method, []).append((client.came - begin) * 1000)
            worked.setdefault(method, []).append((processor_ms(client) - before))
            assert "error" not in reply, reply
            time.sleep(random.choice((0, .02, .1)))
    return took, worked


def main(snell, rounds):
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        scene, shader = long_scene(), long_shader()
        for name, text in (("long.glib", scene), ("a.vert", VERTEX), ("a.frag", long_shader()),
                           ("short.glib", "Vertex a.vert\nFragment a.frag\nProgram P uKa <0. .2 1.>\nSphere 1\n")):
            pathlib.Path(folder, name).write_text(text)
        for what, texts in (("scene", ["long.glib"]), ("shader", ["short.glib", "a.frag"])):
            client = Client(snell)
            uris = [client.open(os.path.join(folder, name)) for name in texts]
            client.diagnostics(uris[-1])
            took, worked = rounds_of(client, uris[-1], scene if what == "scene" else shader, rounds)

            def row(name, times, computed):
                print(f"{what:7} {name:22} median {statistics.median(times):7.1f} ms  longest {max(times):7.1f} ms   "
                      f"computed: median {statistics.median(computed):6.1f} ms  longest {max(computed):6.1f} ms")

            for method, times in took.items():
                row(method, times, worked[method])
            everything = [t for times in took.values() for t in times]
            row("all", everything, [t for times in worked.values() for t in times])
            median, longest = statistics.median(everything), max(everything)
            failed = failed or median > MEDIAN or longest > WORST
            begin = time.perf_counter()
            client.change(uris[-1], 100000, [{"text": (scene if what == "scene" else shader) + "\n"}])
            client.diagnostics(uris[-1], 100000)
            print(f"{what:7} {'diagnostics':22} {(time.perf_counter() - begin) * 1000:7.1f} ms")
            client.end()
    return failed


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 10))
