#!/usr/bin/env python3
"""The language server's life: what the protocol asks for when nothing, or everything, goes wrong.

usage: protocol.py SNELL
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import client
from client import Client, frame

SNELL = ""


def conversation(data, seconds=30):
    """Starts the server with these bytes as its whole input; returns its messages and its exit status."""
    done = subprocess.run([SNELL, "lsp"], input=data, capture_output=True, timeout=seconds)
    messages, rest = [], done.stdout
    while rest:
        head, rest = rest.split(b"\r\n\r\n", 1)
        length = int(head.split(b":")[1])
        messages.append(json.loads(rest[:length]))
        rest = rest[length:]
    return messages, done.returncode


def request(id, method, params=None):
    return {"jsonrpc": "2.0", "id": id, "method": method, "params": params}


def notification(method, params=None):
    return {"jsonrpc": "2.0", "method": method, "params": params}


INITIALIZE = frame(request(1, "initialize", {"capabilities": {}}))
EXIT = frame(notification("exit"))
END = frame(request(2, "shutdown")) + EXIT


def code(message):
    return message["error"]["code"]


class Life(unittest.TestCase):
    def test_ends_with_its_editor(self):
        # The pipe stays open: a process that the editor started may hold it.
        editor = subprocess.Popen(["sleep", "60"])
        server = subprocess.Popen([SNELL, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        server.stdin.write(frame(request(1, "initialize", {"processId": editor.pid, "capabilities": {}})))
        server.stdin.flush()
        with self.assertRaises(subprocess.TimeoutExpired):
            server.wait(.5)
        editor.kill()
        editor.wait()
        self.assertEqual(server.wait(20), 1)
        server.stdin.close()

    def test_ends_if_its_editor_has_ended_already(self):
        editor = subprocess.Popen(["true"])
        editor.wait()
        server = subprocess.Popen([SNELL, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        server.stdin.write(frame(request(1, "initialize", {"processId": editor.pid, "capabilities": {}})))
        server.stdin.flush()
        self.assertEqual(server.wait(10), 1)
        server.stdin.close()

    def test_an_editor_need_not_name_its_process(self):
        messages, status = conversation(frame(request(1, "initialize", {"processId": None, "capabilities": {}})) + END)
        self.assertEqual([len(messages), status], [2, 0])

    def test_ends_with_0_after_shutdown(self):
        messages, status = conversation(INITIALIZE + END)
        self.assertEqual([m["id"] for m in messages], [1, 2])
        self.assertIsNone(messages[1]["result"])
        self.assertEqual(status, 0)

    def test_ends_with_1_without_shutdown(self):
        self.assertEqual(conversation(INITIALIZE + EXIT)[1], 1)
        self.assertEqual(conversation(EXIT)[1], 1)
        self.assertEqual(conversation(INITIALIZE)[1], 1)  # the editor is gone
        self.assertEqual(conversation(b"")[1], 1)

    def test_refuses_requests_before_initialize(self):
        messages, _ = conversation(frame(request(7, "textDocument/hover", {})) + INITIALIZE + END)
        self.assertEqual(code(messages[0]), -32002)
        self.assertIn("capabilities", messages[1]["result"])

    def test_refuses_what_comes_after_shutdown(self):
        messages, status = conversation(INITIALIZE + frame(request(2, "shutdown")) +
                                        frame(request(3, "textDocument/hover", {})) + EXIT)
        self.assertEqual(code(messages[2]), -32600)
        self.assertEqual(status, 0)

    def test_refuses_a_second_initialize(self):
        messages, _ = conversation(INITIALIZE + INITIALIZE + END)
        self.assertEqual(code(messages[1]), -32600)

    def test_chooses_an_encoding_that_the_editor_offers(self):
        for offered, chosen in ((None, "utf-16"), (["utf-16"], "utf-16"), (["utf-32", "utf-8", "utf-16"], "utf-8")):
            capabilities = {"general": {"positionEncodings": offered}} if offered else {}
            messages, _ = conversation(frame(request(1, "initialize", {"capabilities": capabilities})) + END)
            self.assertEqual(messages[0]["result"]["capabilities"]["positionEncoding"], chosen)


class Wrong(unittest.TestCase):
    def answers(self, data):
        messages, status = conversation(INITIALIZE + data + END)
        self.assertEqual(status, 0)
        return messages[1:-1]

    def test_unknown_methods(self):
        answers = self.answers(frame(request(5, "textDocument/unheardOf", {})) + frame(request(6, "$/unheardOf")) +
                               frame(notification("$/unheardOf")) + frame(notification("unheardOf", [1])))
        self.assertEqual([(m["id"], code(m)) for m in answers], [(5, -32601), (6, -32601)])

    def test_params_of_a_wrong_shape(self):
        shapes = [None, 1, [], "x", {}, {"textDocument": 1}, {"textDocument": {}}, {"textDocument": {"uri": 5}},
                  {"textDocument": {"uri": "file:///nowhere.glib"}, "position": {"line": "x"}}]
        methods = ["hover", "completion", "rename", "codeAction", "documentSymbol", "formatting"]
        data = b"".join(frame(request(10 + i, "textDocument/" + m, p))
                        for i, (m, p) in enumerate((m, p) for m in methods for p in shapes))
        answers = self.answers(data)
        self.assertEqual({code(m) for m in answers}, {-32602})
        self.assertEqual(len(answers), len(shapes) * len(methods))
        self.assertIn("the parameters of 'textDocument/hover' have another form",
                      {m["error"]["message"] for m in answers})
        self.assertNotIn("json.", str(answers))
        for method in ("didOpen", "didChange", "didClose", "didSave"):
            self.assertEqual(self.answers(b"".join(frame(notification("textDocument/" + method, p)) for p in shapes)),
                             [])

    def test_what_is_no_json(self):
        for body in (b"{", b"nonsense", b'{"a":"\xff"}', b"", b"[1,2", b"{\"id\":1,}", b"\x00"):
            answers = self.answers(frame(body))
            self.assertEqual([code(m) for m in answers], [-32700], body)
            self.assertIsNone(answers[0]["id"])

    def test_what_is_no_request(self):
        for message in ({}, 5, "x", None, {"id": 1}, {"id": [1], "method": 5}, {"method": None}):
            self.assertEqual([code(m) for m in self.answers(frame(message))], [-32600], message)

    def test_deep_nesting(self):
        # What is nested is copied and printed by functions that call themselves.
        for place in (b'"id":9,"method":"x","params":', b'"method":"x","id":', b'"id":9,"method":"textDocument/codeAction",'
                      b'"params":{"textDocument":{"uri":"file:///a.glib"},"context":'):
            for opens, closes in ((b"[", b"]"), (b'{"a":', b"}")):
                deep = b"{" + place + opens * 200000 + b"0" + closes * 200000 + b"}" * (1 + place.count(b"{") - place.count(b"}"))
                self.assertEqual([code(m) for m in self.answers(frame(deep))], [-32700], place)
        fine = b'{"jsonrpc":"2.0","id":9,"method":"x","params":["' + b"[" * 5000 + b'\\"]", ' + b"[" * 90 + b"]" * 90 + b"]}"
        self.assertEqual([code(m) for m in self.answers(frame(fine))], [-32601])

    def test_batches(self):
        answers = self.answers(frame([request(5, "a"), notification("b"), request(6, "c"), 7]) + frame([]) +
                               frame([notification("b")]))
        self.assertEqual([code(m) for m in answers[0]], [-32601, -32601, -32600])
        self.assertEqual(code(answers[1]), -32600)
        self.assertEqual(len(answers), 2)

    def test_headers(self):
        fine = frame(request(8, "x"))
        for bad in (b"Content-Length: x\r\n\r\n", b"Content-Length: -5\r\n\r\n", b"Hello\r\n\r\n",
                    b"Content-Length: 99999999999999999999999999\r\n\r\n", b"A" * 100000 + b"\r\n\r\n",
                    b"Content-Type: x\r\n\r\n"):
            answers = self.answers(bad + fine)
            self.assertEqual([code(m) for m in answers], [-32700, -32601], bad[:40])

    def test_header_fields_in_any_case_and_order(self):
        body = json.dumps(request(8, "x")).encode()
        head = b"content-type: application/vscode-jsonrpc; charset=utf-8\ncontent-length:%d\n\n" % len(body)
        self.assertEqual([code(m) for m in self.answers(head + body)], [-32601])

    def test_absurd_lengths_take_no_memory(self):
        # Two terabytes are promised, and a few come.
        limited = f"ulimit -v 4000000; exec '{SNELL}' lsp"
        data = INITIALIZE + b"Content-Length: 2000000000000\r\n\r\n" + b"x" * 1000000
        done = subprocess.run(["bash", "-c", limited], input=data, capture_output=True, timeout=30)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"-32700", done.stdout)
        # A message that is only too long is passed over.
        answers = self.answers(b"Content-Length: 300000000\r\n\r\n" + b"x" * 300000000 + frame(request(8, "x")))
        self.assertEqual([code(m) for m in answers], [-32700, -32601])

    def test_messages_in_pieces(self):
        c = Client(SNELL)
        for byte in frame(request(50, "x")):
            c.raw(bytes([byte]))
        self.assertEqual(code(c.answer(50)), -32601)
        self.assertEqual(c.end(), 0)

    def test_random_bytes(self):
        import random
        random.seed(1)
        for _ in range(30):
            data = INITIALIZE
            for _ in range(20):
                good = bytearray(frame(request(random.randrange(9), random.choice(["textDocument/hover", "shutdown"]))))
                for _ in range(random.randrange(3)):
                    good[random.randrange(len(good))] = random.randrange(256)
                data += bytes(good)
            done = subprocess.run([SNELL, "lsp"], input=data, capture_output=True, timeout=30)
            self.assertIn(done.returncode, (0, 1))


class Requests(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = os.path.join(self.folder.name, "a.glib")
        with open(self.scene, "w") as text:
            text.write("Sphere 1\n" * 2000)

    def tearDown(self):
        self.folder.cleanup()

    def test_cancelled_requests_are_answered_so(self):
        c = Client(SNELL)
        uri = c.open(self.scene)
        document = {"textDocument": {"uri": uri}}
        # In one write, so that the cancellation is there before the request is looked at.
        c.raw(b"".join(frame(request(f"r{i}", "textDocument/documentSymbol", document)) for i in range(20)) +
              b"".join(frame(notification("$/cancelRequest", {"id": f"r{i}"})) for i in range(1, 20)))
        answers = [c.answer(f"r{i}") for i in range(20)]
        self.assertEqual({code(a) for a in answers[1:] if "error" in a}, {-32800})
        self.assertGreater(sum("error" in a for a in answers), 15)
        c.notify("$/cancelRequest", {"id": "never asked"})
        self.assertEqual(c.end(), 0)

    def test_no_answers_about_texts_that_are_gone(self):
        c = Client(SNELL)
        uri = c.open(self.scene)
        c.raw(frame(request("old", "textDocument/documentSymbol", {"textDocument": {"uri": uri}})) +
              frame(notification("textDocument/didChange", {"textDocument": {"uri": uri, "version": 2},
                                                            "contentChanges": [{"text": "Box\n"}]})) +
              frame(request("new", "textDocument/documentSymbol", {"textDocument": {"uri": uri}})))
        self.assertEqual(code(c.answer("old")), -32801)
        self.assertEqual(len(c.answer("new")["result"]), 1)
        self.assertEqual(c.end(), 0)

    def test_editors_without_snippets_get_text(self):
        texts = ["", "Texture2D 5 8 8\nTexture2D 6 8 8\nFragment a.frag\nProgram P "]
        with open(os.path.join(self.folder.name, "a.frag"), "w") as shader:
            shader.write("uniform sampler2D uUnit;\nuniform vec4 uColor;\nuniform float uKa;\n"
                         "void main() { gl_FragColor = uKa * uColor * texture(uUnit, vec2(.5)); }\n")

        def inserted(capabilities):
            c = Client(SNELL, capabilities)
            uri, items = c.open(self.scene), {}
            for version, text in enumerate(texts, 2):
                c.change(uri, version, [{"text": text}])
                place = {"line": text.count("\n"), "character": len(text.split("\n")[-1])}
                for item in c.request("textDocument/completion", {"textDocument": {"uri": uri}, "position": place})["items"]:
                    items[version, item["sortText"]] = item["insertTextFormat"], item["textEdit"]["newText"]
            self.assertEqual(c.end(), 0)
            return items

        plain = inserted({})
        snippets = inserted({"textDocument": {"completion": {"completionItem": {"snippetSupport": True}}}})
        self.assertEqual(plain.keys(), snippets.keys())
        of_choices = [text for form, text in snippets.values() if form == 2 and "|" in text]
        of_names = [text for form, text in snippets.values() if form == 2 and ":" in text]
        self.assertTrue(len(of_choices) > 3 and len(of_names) > 20, snippets)
        for key, (form, text) in snippets.items():
            if form == 2:  # an escaped character; the first choice, or what stands in its place; a place to type
                text = re.sub(r"\\(.)|\$\{\d+(?::([^}]*)|\|([^,|]*)[^}]*)?\}|\$\d+",
                              lambda m: m[1] or m[2] or m[3] or "", text)
            self.assertEqual(plain[key], (1, text))

    def test_only_the_protocol_is_printed(self):
        c = Client(SNELL, environment={"EGL_LOG_LEVEL": "debug", "MESA_DEBUG": "1", "LIBGL_DEBUG": "verbose"})
        uri = c.open(self.scene, "Verbose\nMessageBox hello\nSphere 1\n")
        c.diagnostics(uri)
        c.rest(1)  # the driver is asked .3 s after a change
        self.assertEqual(c.garbage, b"")
        self.assertEqual(c.end(), 0)


if __name__ == "__main__":
    SNELL = os.path.abspath(sys.argv.pop(1))
    unittest.main()
