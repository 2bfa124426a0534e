#!/usr/bin/env python3
"""Messages of commits that name an absolute path, which only their author's machine has: prints them, and fails if there
are any. Looks at the commits that HEAD has since BASE, and at all that are there in a shallow clone without BASE.

usage: messages.py ROOT [BASE]
"""
import os
import re
import subprocess
import sys

# Older messages stay as they are.
BASE = "7d4febccb4836af7ddf4b452b3c8221a1b838062"

# Folders that every machine has may be named. No path begins within a word, an address, a tag or an expression.
EVERYWHERE = r"(?:bin|dev|etc|lib\d*|proc|run|sys|usr|var(?!/tmp))\b"
PATH = re.compile(rf"(?:(?<![\w./~<>)}}*\]-])|(?<=file://))/(?!{EVERYWHERE})[A-Za-z][\w./+-]*|\b[A-Z]:\\[\w.\\]+")


def git(root, *words):
    return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, errors="replace")


def main(root, base=BASE):
    if not os.path.exists(os.path.join(root, ".git")):
        print("messages of commits: not a clone, so there are none")
        return 0
    known = git(root, "cat-file", "-e", base + "^{commit}").returncode == 0
    log = git(root, "log", "-z", "--format=%h%n%B", "HEAD", *(["^" + base] if known else []))
    if log.returncode:
        print(log.stderr)
        return 1
    commits = [commit.split("\n", 1) for commit in log.stdout.split("\0") if commit]
    wrong = [f"{name} names {path.group()}: {text.splitlines()[0]}"
             for name, text in commits if (path := PATH.search(text))]
    print("\n".join(wrong) or f"messages of commits: {len(commits)}, none names a folder of a machine")
    if wrong:
        print("say what the commit brings instead: git commit --amend, or git rebase")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
