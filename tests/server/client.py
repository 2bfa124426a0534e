"""A client of the language server, for its tests: starts the program and speaks the protocol through its pipes."""
import json
import os
import pathlib
import queue
import subprocess
import threading
import time
import urllib.parse


def uri_of(path):
    return "file://" + urllib.parse.quote(os.path.abspath(path))


def path_of(uri):
    assert uri.startswith("file://"), uri
    return urllib.parse.unquote(uri[len("file://"):])


def frame(message):
    body = message if isinstance(message, bytes) else json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


class Client:
    def __init__(self, program, capabilities=None, initialize=True, environment=None, driver=True,
                 without=()):
        self.process = subprocess.Popen([program, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL,
                                        env={name: value for name, value in {**os.environ, **(environment or {})}.items()
                                             if name not in without})
        self.messages = queue.Queue()
        self.garbage = b""
        self.waiting = {}
        self.published = {}  # by URI: the params of the last publication
        self.notes = []
        self.asked = []
        self.next_id = 0
        threading.Thread(target=self._read, daemon=True).start()
        if initialize:
            self.server = self.request("initialize", {"processId": os.getpid(), "rootUri": None,
                                                      "capabilities": capabilities or {},
                                                      "initializationOptions": {"driver": driver}})
            self.notify("initialized", {})

    def _read(self):
        out = self.process.stdout
        while True:
            length = None
            while True:
                line = out.readline()
                if not line:
                    self.messages.put(None)
                    return
                if line == b"\r\n":
                    break
                if line.lower().startswith(b"content-length:"):
                    length = int(line.split(b":")[1])
                else:
                    self.garbage += line
            body = out.read(length)
            came = time.perf_counter()
            self.messages.put((came, json.loads(body)))

    def raw(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        self.raw(frame(message))

    def notify(self, method, params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def begin(self, method, params):
        self.next_id += 1
        self.send({"jsonrpc": "2.0", "id": self.next_id, "method": method, "params": params})
        return self.next_id

    def pump(self, seconds):
        """Takes one message; returns False if none came."""
        try:
            message = self.messages.get(timeout=max(seconds, 0.001))
        except queue.Empty:
            return False
        if message is None:
            self.messages.put(None)
            raise EOFError("the server ended")
        came, message = message
        if isinstance(message, dict) and "method" in message:
            if "id" in message:
                self.asked.append(message)
                self.send({"jsonrpc": "2.0", "id": message["id"], "result": None})
            elif message["method"] == "textDocument/publishDiagnostics":
                self.published[message["params"]["uri"]] = message["params"]
                self.notes.append(message)
            else:
                self.notes.append(message)
        else:
            self.waiting[message.get("id") if isinstance(message, dict) else "batch"] = message
            self.came = came  # the last byte of it
        return True

    def wait_for(self, wanted, seconds=30):
        end = time.monotonic() + seconds
        while True:
            found = wanted()
            if found:
                return found
            if time.monotonic() > end:
                raise TimeoutError("no answer")
            self.pump(end - time.monotonic())

    def answer(self, id, seconds=30):
        return self.wait_for(lambda: self.waiting.pop(id, None), seconds)

    def request(self, method, params, seconds=30, fails=False):
        reply = self.answer(self.begin(method, params), seconds)
        if "error" in reply and fails:
            return None
        if "error" in reply:
            raise RuntimeError(reply["error"])
        return reply["result"]

    def error(self, method, params):
        """The error that a request is answered with."""
        return self.answer(self.begin(method, params))["error"]["code"]

    # ---- texts ----

    def open(self, path, text=None, language=None, version=1, uri=None):
        uri = uri or uri_of(path)
        if text is None:
            text = pathlib.Path(path).read_bytes().decode("utf-8", "replace")
        language = language or ("glib" if str(path).endswith(".glib") else "glsl")
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": language, "version": version,
                                                              "text": text}})
        return uri

    def change(self, uri, version, changes):
        self.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": version},
                                               "contentChanges": changes})

    def close(self, uri):
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def diagnostics(self, uri, version=None, seconds=30):
        """The diagnostics of a text, of that version."""
        def there():
            params = self.published.get(uri)
            return params if params and (version is None or params.get("version") == version) else None
        return self.wait_for(there, seconds)["diagnostics"]

    def rest(self, seconds=1.0):
        """Takes what comes until nothing came, and nothing was checked, for so long."""
        since = time.monotonic()
        while time.monotonic() - since < seconds:
            if self.pump(.02) or self.checks():
                since = time.monotonic()

    def checks(self):
        """Whether the server has a child: each check is a process of its own."""
        pid = self.process.pid
        return bool(pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii"))

    def end(self):
        """Ends the server as the protocol asks, and returns its exit status."""
        self.request("shutdown", None)
        self.notify("exit", None)
        return self.process.wait(30)
