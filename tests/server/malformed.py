#!/usr/bin/env python3
"""Messages that can't be read: a request is answered with its id, and after a change that could not be read, the server
refuses to answer about the text until it has it whole. Both never have different texts without saying so.

usage: malformed.py SNELL [ROUNDS]
"""
import json
import os
import random
import sys
import tempfile

from client import Client, frame
from edits import place, random_edit

METHODS = ["documentSymbol", "documentColor", "formatting"]
CONTENT_MODIFIED, PARSE_ERROR = -32801, -32700
HALVES = ["\ud83d", "\ude00"]


def joined(text):
    """Halves that stand together are one character."""
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "surrogatepass")


def fail(what, *more):
    raise AssertionError("\n".join([what, *map(repr, more)]))


def said(client, uri):
    """The answers about a text; None: they are refused."""
    answers = [client.answer(client.begin("textDocument/" + method, {"textDocument": {"uri": uri}})) for method in METHODS]
    codes = {answer["error"]["code"] for answer in answers if "error" in answer}
    if codes and (codes != {CONTENT_MODIFIED} or any("result" in answer for answer in answers)):
        fail("refused in part, or by other codes", answers)
    return None if codes else [answer["result"] for answer in answers]


def damaged(message, rand):
    """The bytes of a message that is no longer one."""
    body = json.dumps(message).encode()
    kind = rand.randrange(6)
    if kind == 0:
        return frame(body[:rand.randrange(len(body) - 1)])
    if kind == 1:
        at = body.index(b'"text":') + 9
        return frame(body[:at] + bytes([rand.choice([0x80, 0xFF, 0xC3, 0x01])]) + body[at:])
    if kind == 2:
        return b"Content-Length: x\r\n\r\n"
    changes = message["params"]["contentChanges"]
    if kind == 3:
        del (changes[-1]["range"] if "range" in changes[-1] else changes[-1])[rand.choice(["end", "start"]) if "range" in changes[-1] else "text"]
    elif kind == 4:
        changes[-1]["text"] = rand.choice([5, None, ["a"], {"a": 1}])
    else:
        message["params"][rand.choice(["textDocument", "contentChanges"])] = rand.choice([7, None, "x", [1]])
    return frame(message)


class Texts:
    """A text as an editor has it, in a server that is attacked, and in another one that is always sent all of it."""

    def __init__(self, snell, encoding, folder, rand):
        capabilities = {"general": {"positionEncodings": [encoding]}}
        self.attacked, self.still = (Client(snell, capabilities, driver=False) for _ in range(2))
        self.encoding, self.rand, self.version, self.text = encoding, rand, 1, "# 😀\r\nSphere 1\r\n"
        path = os.path.join(folder, encoding + ".glib")
        self.uri = self.attacked.open(path, self.text)
        self.still.open(path, self.text)
        self.may_be_lost = self.lost = False

    def message(self, changes):
        self.version += 1
        return {"jsonrpc": "2.0", "method": "textDocument/didChange",
                "params": {"textDocument": {"uri": self.uri, "version": self.version}, "contentChanges": changes}}

    def edit(self):
        if len(self.text) > 2000:
            return self.whole()
        change, text = random_edit(self.text, self.encoding)
        self.text = joined(text)
        if "range" not in change:
            self.may_be_lost = False
        self.attacked.send(self.message([change]))

    def half(self):
        """Half a character somewhere; another edit may add what lacks, or bring two halves together."""
        at = self.rand.randrange(len(self.text) + 1)
        if self.rand.random() < .5:  # beside one that is there
            at = max(at, *(self.text.rfind(half) + 1 for half in HALVES))
        while 0 < at < len(self.text) and self.text[at - 1:at + 1] == "\r\n":
            at -= 1
        where, new = place(self.text, at, self.encoding), self.rand.choice(HALVES)
        self.text = joined(self.text[:at] + new + self.text[at:])
        self.may_be_lost = True
        self.attacked.send(self.message([{"range": {"start": where, "end": where}, "text": new}]))

    def attack(self):
        change, text = random_edit(self.text, self.encoding)
        self.text = joined(text)
        self.attacked.raw(damaged(self.message([change]), self.rand))
        self.may_be_lost = True

    def whole(self):
        self.text = "".join(c for c in self.text if c not in HALVES)[:500]
        if self.rand.random() < .5:
            self.attacked.send(self.message([{"text": self.text}]))
        else:
            self.attacked.notify("textDocument/didSave", {"textDocument": {"uri": self.uri}, "text": self.text})
        self.may_be_lost = False

    def compare(self):
        self.still.change(self.uri, self.version, [{"text": self.text}])
        now, right = said(self.attacked, self.uri), said(self.still, self.uri)
        if now is None and not self.may_be_lost:
            fail("refused for nothing", self.text)
        if now is not None and now != right:
            fail("both have different texts", self.text, now, right)
        return now is None


def requests_are_answered(client):
    """Requests that can't be read have answers with their ids."""
    for i, broken in enumerate(('{"id":%d,"method":"x","params":{"a":}}', '{"params":[1,,],"method":"x","id":%d}',
                                '{"id":%d,"method":"textDocument/hover","params":{"textDocument":{"uri":"a\\x"}}}',
                                '{"id":%d,"method":"x","params":{"text":"\xff"}}', '{"id":%d,"method":"x","params":' + "[" * 500)):
        client.raw(frame((broken % (900 + i)).encode("latin-1")))
        if client.answer(900 + i)["error"]["code"] != PARSE_ERROR:
            fail("no answer", broken)
    # Half a character can be read.
    answer = client.answer(client.begin("textDocument/hover", {"textDocument": {"uri": "file:///\ud83d"}}))
    if "is not open" not in answer["error"]["message"]:
        fail("half a character", answer)


def main(snell, rounds):
    refused = 0
    with tempfile.TemporaryDirectory() as folder:
        for encoding in ("utf-16", "utf-8"):
            rand = random.Random(5)
            random.seed(5)
            texts = Texts(snell, encoding, folder, rand)
            requests_are_answered(texts.attacked)
            for i in range(rounds):
                steps = [texts.edit] * 12 + [texts.attack] * 2 + [texts.whole] * 3
                # Editors that count bytes have no halves.
                rand.choice(steps + [texts.half] * 3 if encoding == "utf-16" else steps)()
                refused += texts.compare()
            texts.whole()
            if texts.compare():
                fail("a whole text is not taken")
            told = sum(note["method"] == "window/showMessage" for note in texts.attacked.notes)
            if not told:
                fail("nobody was told")
            if any(client.end() for client in (texts.attacked, texts.still)):
                fail("a server ends with another status than 0")
    print(f"{rounds} rounds in each encoding, {refused} refused")
    if not rounds / 10 < refused < 1.5 * rounds:
        fail("refused too seldom, or too often")
    return 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 400))
