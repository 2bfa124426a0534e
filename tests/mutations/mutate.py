#!/usr/bin/env python3
"""Breaks the lines of mutations.txt, one at a time, in a copy of the working tree, and requires that the named tests fail.

usage: mutate.py [--tree FOLDER] [--list] [WORD...]    WORD: only mutations whose file or test contains one of them
Exit status: 0 all were caught, 1 some were not, 2 the table does not fit the sources or the tests fail unbroken.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = pathlib.Path(__file__).with_name("mutations.txt")
SECONDS = 300  # A broken loop may never end.


class Mutation:
    def __init__(self, number, head):
        self.number = number
        self.file, self.target, self.filter = head.split()
        self.old = self.new = None

    def __str__(self):
        return f"{TABLE.name}:{self.number}: {self.file}: {self.new.strip()}"


def read_table():
    mutations = []
    for number, line in enumerate(TABLE.read_text().splitlines(), 1):
        if line.startswith("- "):
            mutations[-1].old = line[2:]
        elif line.startswith("+ "):
            mutations[-1].new = line[2:]
        elif line and not line.startswith("#"):
            mutations.append(Mutation(number, line))
    return mutations


def misfits(mutations):
    """The text of each mutation stands exactly once in its file."""
    for m in mutations:
        path = ROOT / m.file
        found = path.read_text().count(m.old) if path.exists() and m.old and m.new else -1
        if found != 1:
            why = "the file or a line is missing" if found < 0 else f"the text occurs {found} times instead of once"
            yield f"{TABLE.name}:{m.number}: {m.file}: {why}: {m.old}"


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


def build(tree, targets):
    if not (tree / "build/build.ninja").exists():
        subprocess.run(["cmake", "-S", tree, "-B", tree / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DSNELL_TESTS=ON"], check=True, stdout=subprocess.DEVNULL)
    return subprocess.run(["ninja", "-C", tree / "build", "--quiet", *targets], capture_output=True, text=True)


def passes(tree, mutation):
    command = [tree / "build/bin" / mutation.target, f"--gtest_filter={mutation.filter}", "--gtest_brief=1",
               "--gtest_fail_fast"]
    try:
        done = subprocess.run(command, cwd=tree, capture_output=True, text=True, errors="replace", timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0 and " 0 tests" not in done.stdout and "[  PASSED  ] 0" not in done.stdout


def caught(tree, mutation):
    """Whether the tests fail while the line is broken; None if it does not compile."""
    path = tree / mutation.file
    text = path.read_text()
    try:
        path.write_text(text.replace(mutation.old, mutation.new))
        if build(tree, [mutation.target]).returncode != 0:
            return None
        return not passes(tree, mutation)
    finally:
        path.write_text(text)


def main():
    options = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1])
    options.add_argument("--tree", type=pathlib.Path, default=ROOT / "build/mutate")
    options.add_argument("--list", action="store_true")
    options.add_argument("words", nargs="*")
    given = options.parse_args()
    everything = read_table()
    wrong = list(misfits(everything))
    chosen = [m for m in everything if not given.words or any(w in f"{m.file} {m.target} {m.filter}" for w in given.words)]
    if given.list:
        print(*chosen, sep="\n")
    if wrong or given.list:
        print(*wrong, sep="\n", end="\n" if wrong else "", file=sys.stderr)
        return 2 if wrong else 0
    tree = given.tree.resolve()
    copy_tree(tree)
    first = build(tree, sorted({m.target for m in chosen}))
    if first.returncode != 0:
        print(first.stdout, first.stderr, sep="\n", file=sys.stderr)
        return 2
    failing = [m for m in chosen if not passes(tree, m)]
    for m in failing:
        print(f"{TABLE.name}:{m.number}: {m.target} {m.filter} fails or has no test before anything is broken", file=sys.stderr)
    if failing:
        return 2
    escaped = 0
    for m in chosen:
        start = time.monotonic()
        result = caught(tree, m)
        escaped += result is not True
        word = {True: "caught", False: "NOT CAUGHT", None: "DOES NOT COMPILE"}[result]
        print(f"{word:10} {time.monotonic() - start:4.0f} s  {m}", flush=True)
    print(f"{len(chosen) - escaped} of {len(chosen)} caught")
    return 1 if escaped else 0


if __name__ == "__main__":
    sys.exit(main())
