#!/usr/bin/env python3
"""Breaks the lines of mutations.txt, one at a time, in a copy of the working tree, and requires that the named tests fail.
With --stability: those of stability.txt, and the named hard cases must fail.

usage: mutate.py [--stability] [--tree FOLDER] [--in-place BUILD] [--list] [WORD...]
WORD: only mutations whose file or test contains one of them, or of that hard case. BUILD: a build folder of the working
tree; lines are broken in the working tree itself and restored.
Exit status: 0 all were caught, 1 some were not, 2 the table does not fit the sources or the tests fail unbroken.
"""
import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(__file__).parent
SECONDS = 300  # A broken loop may never end.
LEAST = 3  # rows of a room
# One file that only calls the others, and three rooms that only a browser or another driver runs.
FEWER = set("""
src/app src/platform/epoxy src/platform/web src/platform/web/opengl
""".split())


class Mutation:
    def __init__(self, table, number, head):
        self.place = f"{table.name}:{number}"
        *cases, self.file, self.target, self.filter = head.split()
        self.cases = cases[0].split(",") if cases else []
        self.old = self.new = None

    def __str__(self):
        cases = "".join(f"hard case {c}: " for c in self.cases)
        return f"{self.place}: {cases}{self.file}: {self.new.strip()}"

    def chosen_by(self, words):
        text = f"{self.file} {self.target} {self.filter}"
        return not words or any(w in (self.cases if re.fullmatch(r"A?\d+", w) else text) for w in words)


def read_table(table):
    mutations = []
    for number, line in enumerate(table.read_text().splitlines(), 1):
        if line.startswith("- "):
            mutations[-1].old = line[2:]
        elif line.startswith("+ "):
            mutations[-1].new = line[2:]
        elif line and not line.startswith("#"):
            mutations.append(Mutation(table, number, line))
    return mutations


def misfits(mutations):
    """The text of each mutation stands exactly once in its file."""
    for m in mutations:
        path = ROOT / m.file
        found = path.read_text().count(m.old) if path.exists() and m.old and m.new else -1
        if found != 1:
            why = "the file or a line is missing" if found < 0 else f"the text occurs {found} times instead of once"
            yield f"{m.place}: {m.file}: {why}: {m.old}"


def misjudged_rooms(mutations):
    """Folders of sources that have too few rows, or enough of them though they are among FEWER."""
    rooms = {str(path.parent.relative_to(ROOT)) for top in ("parser", "src") for path in (ROOT / top).rglob("*.cpp")}
    rows = collections.Counter(str(pathlib.Path(m.file).parent) for m in mutations)
    for room in sorted(rooms | FEWER):
        if room not in rooms or (rows[room] >= LEAST) == (room in FEWER):
            yield f"{room}: {rows[room]} rows, and {'is' if room in FEWER else 'is not'} among those that have few"


def cases_without(mutations):
    page = re.findall(r"^\| (A?\d+) \|", (ROOT / "docs/stability.md").read_text(), re.MULTILINE)
    have = {c for m in mutations for c in m.cases}
    return [c for c in dict.fromkeys(page) if c not in have]


def copy_tree(tree):
    """Files that are the same keep their times, so that the copy is built again only where it differs."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True).stdout.decode().split("\0")
    for name in filter(None, listed):
        source, copy = ROOT / name, tree / name
        if not source.is_file() or (copy.is_file() and source.read_bytes() == copy.read_bytes()):
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, copy)
    for old in set(files_below(tree)) - set(listed):
        (tree / old).unlink()


def files_below(tree):
    for folder, folders, names in os.walk(tree):
        folders[:] = [f for f in folders if pathlib.Path(folder, f) != tree / "build"]
        yield from (str(pathlib.Path(folder, name).relative_to(tree)) for name in names)


def build(tree, folder, targets):
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DSNELL_TESTS=ON", "-DSNELL_TOGETHER=OFF"], check=True, stdout=subprocess.DEVNULL)
    return subprocess.run(["ninja", "-C", folder, "--quiet", *targets], capture_output=True, text=True)


def passes(tree, folder, mutation):
    """Whether the tests pass, and each of the mutation's hard cases, if it has any."""
    program = folder / "bin" / mutation.target
    command = [program, f"--gtest_filter={mutation.filter}", "--gtest_brief=1"]
    if mutation.filter.endswith(".py"):
        command = [sys.executable, "-B", "-W", "ignore", tree / mutation.filter, program]
    try:
        done = subprocess.run(command, cwd=tree, capture_output=True, text=True, errors="replace", timeout=SECONDS,
                              env={**os.environ, "LP_NUM_THREADS": "0"})
    except subprocess.TimeoutExpired:
        return False
    if done.returncode < 0:
        return False  # It crashed.
    if mutation.cases and done.returncode != 0:
        return any(f"hard case {c}: " not in done.stdout for c in mutation.cases)
    return done.returncode == 0 and " 0 tests" not in done.stdout and "[  PASSED  ] 0" not in done.stdout


def caught(tree, folder, mutation):
    """Whether the tests fail while the line is broken; None if it does not compile."""
    path = tree / mutation.file
    text = path.read_text()
    try:
        path.write_text(text.replace(mutation.old, mutation.new))
        if build(tree, folder, [mutation.target]).returncode != 0:
            return None
        return not passes(tree, folder, mutation)
    finally:
        path.write_text(text)


def main():
    options = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1])
    options.add_argument("--stability", action="store_true")
    options.add_argument("--tree", type=pathlib.Path, default=ROOT / "build/mutate")
    options.add_argument("--in-place", type=pathlib.Path)
    options.add_argument("--list", action="store_true")
    options.add_argument("words", nargs="*")
    given = options.parse_args()
    everything = read_table(FOLDER / ("stability.txt" if given.stability else "mutations.txt"))
    wrong = list(misfits(everything))
    if not given.stability:
        wrong += misjudged_rooms(everything)
    chosen = [m for m in everything if m.chosen_by(given.words)]
    if given.stability and (missing := cases_without(everything)):
        print("hard cases without a mutation:", *missing)
    if given.list:
        print(*chosen, sep="\n")
    if wrong or given.list:
        print(*wrong, sep="\n", end="\n" if wrong else "", file=sys.stderr)
        return 2 if wrong else 0
    tree = ROOT if given.in_place else given.tree.resolve()
    folder = given.in_place.resolve() if given.in_place else tree / "build"
    if not given.in_place:
        copy_tree(tree)
    first = build(tree, folder, sorted({m.target for m in chosen}))
    if first.returncode != 0:
        print(first.stdout, first.stderr, sep="\n", file=sys.stderr)
        return 2
    filters = {(m.target, m.filter): m for m in chosen}
    failing = [m for m in filters.values() if not passes(tree, folder, m)]
    for m in failing:
        print(f"{m.place}: {m.target} {m.filter} fails or has no test before anything is broken", file=sys.stderr)
    if failing:
        return 2
    escaped = 0
    for m in chosen:
        start = time.monotonic()
        result = caught(tree, folder, m)
        escaped += result is not True
        word = {True: "caught", False: "NOT CAUGHT", None: "DOES NOT COMPILE"}[result]
        print(f"{word:10} {time.monotonic() - start:4.0f} s  {m}", flush=True)
    print(f"{len(chosen) - escaped} of {len(chosen)} caught")
    return 1 if escaped else 0


if __name__ == "__main__":
    sys.exit(main())
