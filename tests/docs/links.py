#!/usr/bin/env python3
"""Links of README.md, CHANGELOG.md, docs/ and scenes/ lead to files and headings that exist: links.py SOURCE_FOLDER"""

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


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [root / "README.md", root / "CHANGELOG.md", *root.glob("docs/**/*.md"), *root.glob("scenes/**/*.md")]
    texts = {page: page.read_text() for page in pages}
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
    print(f"{links} links of {len(pages)} pages, {wrong} wrong")
    # Without this, a change of the pages' form that hides all links would pass.
    return wrong > 0 or links < 100


if __name__ == "__main__":
    sys.exit(main())
