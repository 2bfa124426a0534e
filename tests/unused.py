#!/usr/bin/env python3
"""Functions of the product that only tests call: prints them, and fails if there are any.

A function is listed if a test's object file refers to it, a library of the product defines it, and the sources of the
product name it nowhere but where it is declared and defined. Needs binutils.

usage: unused.py ROOT BUILD
"""
import collections
import pathlib
import re
import subprocess
import sys


def symbols(kind, files):
    """Returns the mangled names of snell's functions that the object files define, or refer to."""
    found = set()
    for line in subprocess.run(["nm", "-g", kind, *map(str, files)], capture_output=True, text=True).stdout.splitlines():
        words = line.split()
        if len(words) >= 2 and words[-2] in "TU" and re.match(r"_ZNK?5snell", words[-1]):
            found.add(words[-1])
    return found


def words_of_product(root):
    """Returns how often each word occurs in the product's sources, comments and strings aside."""
    count = collections.Counter()
    for top in ("parser", "src", "shaders", "tools", "web/interface"):
        for path in pathlib.Path(root, top).rglob("*"):
            if path.suffix in (".h", ".cpp"):
                text = re.sub(r'"(?:\\.|[^"\\\n])*"|//[^\n]*', " ", path.read_text(encoding="utf-8"))
                count.update(re.findall(r"\w+", text))
    return count


def main(root, build):
    archives = [a for a in pathlib.Path(build).glob("[ps]*/**/libsnell_*.a")
                if pathlib.Path(root, a.relative_to(build).parent).is_dir()]  # of folders that still exist
    defined = symbols("--defined-only", archives)
    used = symbols("--undefined-only", pathlib.Path(build, "tests").rglob("*.o"))
    if not defined or not used:
        print("there are no object files to compare")
        return 1
    count = words_of_product(root)
    names = subprocess.run(["c++filt"], input="\n".join(sorted(defined & used)), capture_output=True, text=True).stdout
    only = []
    for name in names.splitlines():
        path = re.sub(r"\[abi:\w+\]", "", name).split("(")[0].split("<")[0].split("::")
        if len(path) < 2 or path[-1] == path[-2] or not path[-1].isidentifier():
            continue  # constructors, destructors and operators have no name of their own to look for
        if count[path[-1]] <= 2:
            only.append(name)
    print("\n".join(only))
    return bool(only)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
