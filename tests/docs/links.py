#!/usr/bin/env python3
"""Links of README.md, CHANGELOG.md, docs/ and scenes/ lead to files and headings that exist, and so do the names of files
and tests in docs/: links.py SOURCE_FOLDER"""

import collections
import pathlib
import re
import sys

FENCE = re.compile(r"^( *)```[^\n]*\n.*?^\1```", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(([^()\s]*(?:\([^()\s]*\))?[^()\s]*)\)")


def anchors(text):
    """The anchors of a page, as GitHub names them: those of headings, and those that it names itself."""
    found, times = set(re.findall(r'<a id="([^"]+)"', text)), collections.Counter()
    for heading in re.findall(r"^#+ +(.*?) *$", FENCE.sub("", text), re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        found.add(f"{name}-{times[name]}" if times[name] else name)
        times[name] += 1
    return found


# A file of the repository as prose names it; a placeholder such as NAME or … in it stands for any text.
FILE = re.compile(r"(?<![\w./-])((?:src|tests|parser|tools|shaders|cmake|editors)/[\w./…-]*\w)")
# One without its folder, but for that of glman, and one that a page tells the reader to write.
BARE = re.compile(r"`(?!gstap\.h|job\.sh)([\w-]+\.(?:cpp|h|py|sh|mjs|ts))`")
TEST = re.compile(r"`([A-Z]\w+)\.([A-Z]\w+|(?=\*))(\*?)`")


def missing_names(text, root, tests, files):
    """The files and tests that a page names and that are not there."""
    for name in BARE.findall(text):
        if name not in files:
            yield name, "there is no such file"
    for name in FILE.findall(LINK.sub("]", text)):
        pattern = re.sub(r"NAME|…", "*", name)
        if not any(root.glob(pattern)) and not any(root.glob(pattern + ".*")):
            yield name, "there is no such file"
    for suite, test, more in TEST.findall(text):
        if not any(one == test or more and one.startswith(test) for one in tests[suite]):
            yield f"{suite}.{test}", "there is no such test"


def read_tests(root):
    tests = collections.defaultdict(set)
    for file in root.glob("tests/**/*.cpp"):
        for suite, test in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", file.read_text(), re.MULTILINE):
            tests[suite].add(test)
    return tests


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [root / "README.md", root / "CHANGELOG.md", *root.glob("docs/**/*.md"), *root.glob("scenes/**/*.md")]
    texts = {page: page.read_text() for page in pages}
    tests = read_tests(root)
    files = {file.name for part in ("parser", "src", "tests", "web", "editors") for file in (root / part).rglob("*.*")}
    links = wrong = 0
    for page, text in sorted(texts.items()):
        for link in LINK.findall(CODE.sub("", FENCE.sub("", text))):
            if re.match(r"[a-z]+:", link):
                continue
            links += 1
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if not target.exists():
                reason = "there is no such file"
            elif anchor and target.suffix == ".md" and anchor not in anchors(texts.get(target) or target.read_text()):
                reason = "the page has no such heading"
            else:
                continue
            wrong += 1
            print(f"{page.relative_to(root)}: {link}: {reason}")
        if root / "docs" in page.parents:
            for name, reason in missing_names(text, root, tests, files):
                wrong += 1
                print(f"{page.relative_to(root)}: {name}: {reason}")
    print(f"{links} links of {len(pages)} pages, {wrong} wrong")
    # Without this, a change of the pages' form that hides all links would pass.
    return wrong > 0 or links < 100


if __name__ == "__main__":
    sys.exit(main())
