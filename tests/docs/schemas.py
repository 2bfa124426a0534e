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

    bad = "tests/bad/" + sorted(name for name in os.listdir(os.path.join(root, "tests/bad")) if name.endswith(".glib"))[0]
    scene = "tests/cases/Sphere.glib"
    ambient = "scenes/light/ambient/ambient.glib"
    mirror = "scenes/light/mirror/mirror.glib"
    lesson = "docs/teaching/01-colour"
    small = ("--size", "32x32")
    with tempfile.TemporaryDirectory() as folder:
        def written(path, *words):
            run(*words)
            with open(os.path.join(folder, path), encoding="utf-8") as text:
                return text.read()

        file, report = os.path.join(folder, "file.json"), os.path.join(folder, "report")
        made = [
            ("check", run("check", scene, bad, "--json")),
            ("render", run("render", scene, bad, "-o", os.path.join(folder, "{path}.png"), "-q", *small, "--json")),
            ("render", written("file.json", "sweep", scene, "--over", "time=0,1", *small, "-o",
                               os.path.join(folder, "{time}.png"), "--json", file)),
            ("compare", run("compare", scene, "tests/cases/Torus.glib", *small, "--json")),
            ("grade", written("report/results.json", "grade", lesson + "/rubric.toml", lesson + "/submissions", "-o", report)),
            ("explain", run("explain", ambient, *small, "--reps", "3", "--json")),
            ("explain", run("explain", scene, *small, "--no-time", "--without-effect", "--json")),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--reps", "3", "--budget", "2",
                                 "--json", file)),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--from", "lattice", "--knobs",
                                 "samples", "--no-time", "--no-found", "--budget", "2", "--json", file)),
            ("accuracy", written("file.json", "accuracy", mirror, "--size", "16x16", "--reps", "3", "--budget", "8",
                                 "--error", ".5", "--json", file)),
            ("found", written("file.json", "accuracy", mirror, "--list-found", "--json", file)),
            ("commands", run("commands", "--json")),
        ]
    found = []
    if not any("together" in json.loads(text) for name, text in made if name == "accuracy"):
        found.append("no report of accuracy has what was tried together")
    for name, text in made:
        with open(os.path.join(root, "docs/schemas", name + ".json"), encoding="utf-8") as schema:
            found += wrong(json.loads(text), json.load(schema), name)
    schemas = {name.removesuffix(".json") for name in os.listdir(os.path.join(root, "docs/schemas"))}
    found += [f"nothing is compared with docs/schemas/{name}.json" for name in schemas - {name for name, _ in made}]
    if not list(wrong([{"schema": 1}], {"type": "array", "items": {"required": ["other"]}}, "self-test")):
        found.append("this test finds nothing")
    print("\n".join(found))
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
