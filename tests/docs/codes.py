#!/usr/bin/env python3
"""Every code of a diagnostic is explained, and every explanation is of a code: codes.py PROGRAM ROOT

A code is a word in kebab-case within quotes in parser/ or src/, or in brackets at the end of a message there. Words
that are something else are listed below.
"""
import pathlib
import re
import subprocess
import sys

OTHERS = {"a-b", "built-in", "depth-test", "depth-write", "point-size-mode", "cube-size", "cube-precision",
          "x-terminal-emulator", "xdg-open", "max-flip", "max-pixels", "max-rmse",
          "utf-8"}  # dumps, knobs, programs, options, encodings


def main(program, root):
    root = pathlib.Path(root)
    limits = set(re.findall(r"^\| `([a-z0-9-]+)`", (root / "docs/limits.md").read_text(), re.MULTILINE))
    anchors = set(re.findall(r"teaching.md#([a-z0-9-]+)", (root / "docs/lints.md").read_text()))
    codes = set()
    for top in ("parser", "src"):
        for path in (root / top).rglob("*.cpp"):
            text = path.read_text(encoding="utf-8")
            codes |= set(re.findall(r'"([a-z][a-z0-9]*(?:-[a-z0-9]+)+)"', text))
            codes |= set(re.findall(r"\[([a-z]+(?:-[a-z]+)*)\]\\n", text))
    kinds = set(re.findall(r'Aim::[a-z]+, "([a-z-]+)"', (root / "src/accuracy/found/change.cpp").read_text()))
    page = (root / "docs/accuracy.md").read_text()
    unnamed = sorted(kind for kind in kinds if f"`{kind}`" not in page)
    for kind in unnamed:
        print(f"'{kind}' is a kind of found rungs that docs/accuracy.md does not name")
    codes -= OTHERS | limits | anchors | kinds
    listed = subprocess.run([program, "complete", "help"], capture_output=True, text=True, check=True).stdout
    explained = {line.partition("\t")[0] for line in listed.splitlines() if line.endswith("\tcode")}
    for code in sorted(codes - explained):
        print(f"'{code}' has no section in docs/diagnostics.md and no row in docs/lints.md")
    for code in sorted(explained - codes):
        print(f"'{code}' is explained, and no message has it")
    for code in sorted(explained):  # each has an anchor in docs/
        pages = (root / "docs/diagnostics.md").read_text(), (root / "docs/lints.md").read_text()
        if f"\n### {code}\n" not in pages[0] and f'<a id="{code}">' not in pages[1]:
            print(f"'{code}' has no anchor in docs/")
            return 1
    return codes != explained or len(codes) < 150 or len(kinds) < 20 or bool(unnamed)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
