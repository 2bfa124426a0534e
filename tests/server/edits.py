#!/usr/bin/env python3
"""Partial edits against a whole-text oracle: after each random edit, what the server says of the text is what it says of
the same text sent whole.

usage: edits.py SNELL [ROUNDS]
"""
import os
import random
import sys
import tempfile

from client import Client

PIECES = ["Sphere 1", "Box 1 2 3", "# ", "é", "𝄞", "😀👩‍👩‍👧", "\r\n", "\n", "\r", " ", "\t", "\\", "Program P uK <0. .5 1.>", "{1. 0. .5}",
          "漢字", "\"a b\"", "uName 5", "ladder", "//", "/*", "*/", "\u2028", "a", ""]


def units(text, encoding):
    return len(text.encode("utf-16-le", "surrogatepass")) // 2 if encoding == "utf-16" else len(text.encode("utf-8"))


def lines_of(text):
    """The lines with their ends; only CR, LF and CRLF end a line."""
    lines, line, i = [], "", 0
    while i < len(text):
        c = text[i]
        line += c
        if c == "\r" and text[i + 1:i + 2] == "\n":
            line += "\n"
            i += 1
        if c in "\r\n":
            lines.append(line)
            line = ""
        i += 1
    return lines + [line]


def place(text, index, encoding):
    lines = lines_of(text[:index])
    return {"line": len(lines) - 1, "character": units(lines[-1], encoding)}


def random_edit(text, encoding):
    """A change, and the text after it."""
    if random.random() < .03:
        whole = "".join(random.choice(PIECES) for _ in range(30))
        return {"text": whole}, whole
    a = random.randrange(len(text) + 1)
    b = min(len(text), a + random.choice([0, 0, 1, 2, 5, 40]))
    # Between CR and LF there is no place.
    while 0 < a < len(text) and text[a - 1] == "\r" and text[a] == "\n":
        a -= 1
    while 0 < b < len(text) and text[b - 1] == "\r" and text[b] == "\n":
        b += 1
    new = "".join(random.choice(PIECES) for _ in range(random.choice([0, 1, 1, 2, 6])))
    return {"range": {"start": place(text, a, encoding), "end": place(text, b, encoding)}, "text": new}, \
        text[:a] + new + text[b:]


def said(client, uri):
    document = {"textDocument": {"uri": uri}}
    return [client.request("textDocument/" + method, document)
            for method in ("documentSymbol", "documentColor", "formatting")]


def main(snell, rounds):
    with tempfile.TemporaryDirectory() as folder:
        for encoding in ("utf-16", "utf-8"):
            random.seed(7)
            client = Client(snell, {"general": {"positionEncodings": [encoding]}})
            text = "# 😀\r\nSphere 1\r\n"
            uri = client.open(os.path.join(folder, "edited.glib"), text)
            oracle = client.open(os.path.join(folder, "whole.glib"), text)
            for version in range(2, rounds + 2):
                changes = []
                for _ in range(random.choice([1, 1, 1, 3])):  # several in one message
                    change, text = random_edit(text, encoding)
                    changes.append(change)
                if len(text) > 4000:
                    text = text[:500]
                    changes.append({"text": text})
                client.change(uri, version, changes)
                client.change(oracle, version, [{"text": text}])
                if said(client, uri) != said(client, oracle):
                    print(f"round {version} in {encoding} differs after {changes}\n{text!r}")
                    return 1
            # Ranges that are not in the text are cut to it.
            client.change(uri, 10**6, [{"range": {"start": {"line": 10**9, "character": 5},
                                                  "end": {"line": 2**31, "character": 2**31}}, "text": "\nBox\n"},
                                       {"range": {"start": {"line": 0, "character": 10**9},
                                                  "end": {"line": 0, "character": 0}}, "text": ""}])
            said(client, uri)
            assert client.end() == 0
    print(f"{rounds} rounds in each encoding agree")
    return 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 500))
