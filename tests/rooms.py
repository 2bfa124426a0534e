#!/usr/bin/env python3
"""The rooms of parser/, src/ and tools/: each has its row in docs/architecture.md, and no include runs back up.

usage: rooms.py ROOT
"""
import collections
import os
import re
import sys

# The rooms of src/app may include these of each other; a room and those above it are free to include other folders.
APP = {
    "open": "",
    "picture": "open",
    "desktop": "",
    "batch": "open picture",
    "page": "open picture",
    "grade": "open picture grade/rubric",
    "grade/rubric": "",
    "grade/report": "open grade picture page",
    "commands": "open picture batch page grade grade/report window",
    "commands/explain": "open picture commands",
    "create": "open commands",
    "help": "open commands create",
    "lsp": "open desktop commands",
    "window/measure": "open",
    "window/survive": "open desktop",
    "window": "open picture desktop batch page window/measure window/survive",
}


def read_tree(root):
    """Returns the folders with units, and the includes between folders as {(from, to): [include]}."""
    rooms, includes = set(), collections.defaultdict(list)
    for top in ("parser", "src", "tools"):
        for folder, _, files in os.walk(os.path.join(root, top)):
            room = os.path.relpath(folder, root)
            for name in files:
                if name.endswith(".cpp"):
                    rooms.add(room)
                if name.endswith((".cpp", ".h")):
                    with open(os.path.join(folder, name), encoding="utf-8") as text:
                        for path in re.findall(r'#include "((?:parser|src|tools)/[^"]+)"', text.read()):
                            if os.path.dirname(path) != room:
                                includes[room, os.path.dirname(path)].append(f"{room}/{name} includes {path}")
    return rooms, includes


def cycles(includes):
    """Returns the includes that lead back to where they came from."""
    to = collections.defaultdict(set)
    for a, b in includes:
        to[a].add(b)

    def reachable(start):
        seen, open_ = set(), [start]
        while open_:
            for room in to[open_.pop()] - seen:
                seen.add(room)
                open_.append(room)
        return seen

    return [line for (a, b), lines in includes.items() if a in reachable(b) for line in lines]


def main(root):
    rooms, includes = read_tree(root)
    with open(os.path.join(root, "docs/architecture.md"), encoding="utf-8") as text:
        page = text.read()
    wrong = [f"docs/architecture.md has no row for {room}/" for room in sorted(rooms)
             if not re.search(rf"^\| .*\b{room}/", page, re.M)]
    wrong += [f"a circle: {line}" for line in cycles(includes)]
    for (a, b), lines in includes.items():
        if a.startswith("src/app/") and b.startswith("src/app/"):
            if b.removeprefix("src/app/") not in APP[a.removeprefix("src/app/")].split():
                wrong += lines
    print("\n".join(wrong))
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
