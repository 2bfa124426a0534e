#!/usr/bin/env python3
"""The JSON that the program prints is as docs/schemas describes it, and nothing else.

usage: schemas.py PROGRAM ROOT
"""
import json
import os
import subprocess
import sys
import tempfile

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
KNOWN = {"$schema", "title", "description", "type", "properties", "required", "additionalProperties", "items", "enum",
         "const", "minimum", "$ref", "$defs"}


def is_type(value, name):
    if name in ("number", "integer"):
        return not isinstance(value, bool) and isinstance(value, int if name == "integer" else (int, float))
    return isinstance(value, TYPES[name])


def wrong(value, schema, at, defs=None):
    """Yields what in a value is not as the schema says: of JSON Schema, the words that are used here."""
    defs = schema.get("$defs", {}) if defs is None else defs
    if "$ref" in schema:
        yield from wrong(value, defs[schema["$ref"].removeprefix("#/$defs/")], at, defs)
        return
    assert set(schema) <= KNOWN, set(schema) - KNOWN
    types = schema.get("type", [])
    types = [types] if isinstance(types, str) else types
    if types and not any(is_type(value, name) for name in types):
        yield f"{at}: {value!r} is no {types}"
        return
    if "const" in schema and value != schema["const"] or "enum" in schema and value not in schema["enum"]:
        yield f"{at}: {value!r}"
    if "minimum" in schema and value < schema["minimum"]:
        yield f"{at}: {value!r} is too small"
    if isinstance(value, dict):
        yield from (f"{at}: {name} is missing" for name in schema.get("required", []) if name not in value)
        for name, part in value.items():
            if name in schema.get("properties", {}):
                yield from wrong(part, schema["properties"][name], f"{at}.{name}", defs)
            elif not schema.get("additionalProperties", True):
                yield f"{at}.{name} is not described"
    if isinstance(value, list) and "items" in schema:
        for index, part in enumerate(value):
            yield from wrong(part, schema["items"], f"{at}[{index}]", defs)


def main(program, root):
    def run(*words):
        done = subprocess.run([program, *words], capture_output=True, text=True, cwd=root, timeout=120)
        return done.stdout

    def scenes_in(folder):
        return sorted(os.path.join(folder, name) for name in os.listdir(os.path.join(root, folder)) if name.endswith(".glib"))

    bad, cases = scenes_in("tests/bad"), scenes_in("tests/cases")
    scene = "tests/cases/Sphere.glib"
    ambient = "scenes/light/ambient/ambient.glib"
    mirror = "scenes/light/mirror/mirror.glib"
    small = ("--size", "32x32")
    with tempfile.TemporaryDirectory() as folder:
        def written(path, *words):
            path = os.path.join(folder, path)
            if os.path.exists(path):
                os.remove(path)
            run(*words)
            with open(path, encoding="utf-8") as text:
                return text.read()

        def graded(lesson):
            lesson = os.path.join("docs/teaching", lesson)
            report = os.path.join(folder, os.path.basename(lesson))
            of_class = [os.path.join(lesson, "submissions", name) for name in ("passing", "failing")]
            return written(os.path.join(report, "results.json"), "grade", lesson + "/rubric.toml", *of_class, broken, "-o", report)

        file, broken = os.path.join(folder, "file.json"), os.path.join(folder, "broken.zip")
        with open(broken, "w", encoding="utf-8") as text:
            text.write("no archive")
        for name in ("a", "b"):
            os.mkdir(os.path.join(folder, name))
        for name, picture in (("a", scene), ("b", "tests/cases/Torus.glib")):
            run("render", picture, "-o", os.path.join(folder, name, "one.png"), "-q", *small)
        colour = "docs/teaching/01-colour/solution/colour.glib"

        def swept(over, *words):
            return written("file.json", "sweep", over, *small, "-o", os.path.join(folder, "{index}.png"), "--json", file, *words)

        made = [
            ("check", run("check", *bad, *cases, ambient, "--json")),
            ("render", run("render", *cases[::4], *bad[::8], "-o", os.path.join(folder, "{path}.png"), "-q", *small, "--json")),
            ("render", run("render", ambient, "-o", os.path.join(folder, "{frame}.png"), "--frames", "3", "--fps", "2", *small, "-q", "--json")),
            ("render", swept(mirror, "--over", "LOCALITY=infinite,box", "--over", "time=0:1:3", "--shard", "1/2")),
            ("render", swept(colour, "--over", "uColor=[1,0,0],[0,1,0]", "--set", "uKd=.5", "--samples", "2")),
            ("render", swept(colour, "--over", "uColor=[1,0,0],[0,1,0]", "--skip-existing")),
            ("compare", run("compare", scene, "tests/cases/Torus.glib", *small, "--json")),
            ("compare", run("compare", os.path.join(folder, "a"), os.path.join(folder, "b"), "--max-rmse", "0", "--json")),
            *(("grade", graded(lesson)) for lesson in ("01-colour", "08-accuracy")),
            ("explain", run("explain", ambient, *small, "--reps", "3", "--json")),
            ("explain", run("explain", scene, *small, "--no-time", "--without-effect", "--json")),
            *(("explain", run("explain", case, *small, "--no-time", "--json")) for case in cases[::12]),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--reps", "3", "--budget", "2",
                                 "--json", file)),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--from", "lattice", "--knobs",
                                 "samples", "--no-time", "--no-found", "--budget", "2", "--json", file)),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--reps", "7", "--budget", "4",
                                 "--error", ".5", "--json", file)),
            ("found", written("file.json", "accuracy", mirror, "--list-found", "--json", file)),
            ("commands", run("commands", "--json")),
        ]
    found = []
    for name, text in made:
        with open(os.path.join(root, "docs/schemas", name + ".json"), encoding="utf-8") as file:
            schema = json.load(file)
        found += wrong(json.loads(text), schema, name)
        if "schema" not in schema.get("items", schema).get("required", []):
            found.append(f"{name}: what is printed does not tell its schema")
    schemas = {name.removesuffix(".json") for name in os.listdir(os.path.join(root, "docs/schemas"))}
    found += [f"nothing is compared with docs/schemas/{name}.json" for name in schemas - {name for name, _ in made}]
    if not list(wrong([{"schema": 1}], {"type": "array", "items": {"required": ["other"]}}, "self-test")):
        found.append("this test finds nothing")
    print("\n".join(found))
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
