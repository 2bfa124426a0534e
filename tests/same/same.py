#!/usr/bin/env python3
"""What two builds of snell make of the same files, and where it differs: pictures, messages, costs, errors, texts, grades and
the answers of the language server. For a change after which everything should be as before.

usage: same.py OLD NEW [--jobs N] [--only WORD] [KIND...]

OLD and NEW are programs in their build folders, with their modules next to them. Without a KIND,
all of KINDS are tried. --only takes the scenes whose path has the word. The status is 1 if anything differs.
"""
import argparse
import concurrent.futures
import difflib
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 600  # for one command

# Measured, or of the run: equal in no two runs.
VARYING = [(re.compile(rb'("(?:\w*_ms|\w*milliseconds|\w*seconds|\w*_us|load_before|load_after)": )-?[\d.eE+-]+'), rb"\1#"),
           (re.compile(rb"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ"), b"DATE"),
           (re.compile(rb"load [\d.]+ before, [\d.]+ after"), b"load"),
           (re.compile(rb"\b\d+(\.\d+)? m?s\b"), b"# s")]


def files(*patterns):
    """Files of the repository that match."""
    listed = subprocess.run(["git", "ls-files", "-z", *patterns], cwd=ROOT, capture_output=True, check=True).stdout
    return sorted(name for name in listed.decode().split("\0") if name)


def scenes():
    return files("scenes/**/*.glib", "tests/cases/*.glib", "docs/teaching/**/*.glib", "templates/**/*.glib")


def tried(path, program):
    """Two settings of the sliders of a scene, as options; the same ones whichever program reads the scene."""
    dump = subprocess.run([program, "check", "--no-lint", "--dump", "scene", path], cwd=ROOT, capture_output=True, text=True,
                          errors="replace", timeout=SECONDS).stdout
    number = r"(-?[\d.]+(?:e[+-]?\d+)?)"
    sliders = re.findall(rf"^\s+(\w+) <{number} {number} {number}>", dump, re.M)
    dice = random.Random(path)
    for _ in range(2 if sliders else 0):
        yield [word for name, low, _, high in sliders
               for word in ("--set", f"{name}={dice.uniform(float(low), float(high)):.4g}")]


# A task is a name and words behind the program's name. OUT in them is a folder, whose files are compared, too; '-' is the
# file of the task's name.
def pictures(old):
    for path in scenes():
        for index, sets in enumerate([[], *tried(path, old)]):
            yield f"{path} #{index}", ["render", path, "--size", "200x150", "-o", "OUT/picture.png", *sets]


def check(old):
    for path in files("*.glib"):
        yield path, ["check", "--json", path]
        yield path + " as text", ["check", path]


def accuracy(old):
    """Only scenes with ladders: the others have nothing but found rungs, of which time decides how many are tried."""
    for path in scenes():
        if re.search(r"^\s*Ladder\b", (ROOT / path).read_text(errors="replace"), re.M | re.I):
            yield path, ["accuracy", path, "--no-time", "--no-found", "--size", "32x24", "--budget", "600", "--json",
                         "OUT/numbers.json"]


def texts(old):
    yield "commands", ["commands", "--json"]
    yield "help", ["--help"]
    shown = subprocess.run([old, "--help"], capture_output=True, text=True, timeout=SECONDS).stdout
    for name in re.findall(r"^  (\w+) ", shown.partition("Subcommands:\n")[2].partition("\n\n")[0], re.M):
        yield "help " + name, [name, "--help"]


def grade(old):
    for rubric in files("docs/teaching/*/rubric.toml"):
        yield rubric, ["grade", rubric, os.path.dirname(rubric) + "/submissions", "-o", "OUT/report"]


KINDS = {
    "pictures": pictures,
    "check": check,
    "explain": lambda old: ((path, ["explain", "--json", "--no-time", path]) for path in scenes()),
    "accuracy": accuracy,
    "found": lambda old: ((path, ["accuracy", path, "--list-found", "--json", "OUT/found.json"]) for path in scenes()),
    "format": lambda old: ((path, ["format", "-"]) for path in files("*.glib")),
    "texts": texts,
    "grade": grade,
    "server": lambda old: ((path, ["lsp"]) for path in files("scenes/**/*.glib", "docs/teaching/**/*.glib", "tests/bad/*.glib")),
}


class Session:
    """A client that waits for each answer, so that the order of messages is always the same."""

    def __init__(self, program, folder):
        self.process = subprocess.Popen([program, "lsp"], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, env=environment(folder))
        self.number, self.log = 0, []

    def send(self, method, params, number=None):
        body = json.dumps({"jsonrpc": "2.0", "method": method, "params": params} | ({"id": number} if number else {})).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def until(self, ends):
        """Others, such as diagnostics of the files that the scene names, come in any order."""
        while True:
            length = 0
            while (line := self.process.stdout.readline()) not in (b"\r\n", b""):
                length = int(line.split(b":")[1]) if line.startswith(b"Content-Length") else length
            if not length:
                raise EOFError("the language server ended")
            message = json.loads(self.process.stdout.read(length))
            if ends(message):
                return message

    def note(self, title, said):
        self.log.append(title + "\n" + json.dumps(said, indent=1, sort_keys=True))

    def ask(self, method, params):
        self.number += 1
        self.send(method, params, self.number)
        answer = self.until(lambda m: m.get("id") == self.number and "method" not in m)
        self.note(f"{method} {json.dumps(params, sort_keys=True)}", answer.get("result", answer.get("error")))


def session(program, path, folder):
    """What the server says of a scene: its answers about the whole and at some words, and its diagnostics, with an edit."""
    client = Session(program, folder)
    uri = (ROOT / path).as_uri()
    text = (ROOT / path).read_text(errors="replace")
    document = {"textDocument": {"uri": uri}}

    def change(method, version, words):
        extra = {"contentChanges": [{"text": words}]} if version > 1 else {}
        about = {"uri": uri, "version": version} | ({} if extra else {"languageId": "glib", "text": words})
        client.send(method, {"textDocument": about} | extra)
        said = client.until(lambda m: (now := m.get("params", {})).get("uri") == uri and now.get("version") in (None, version))
        client.note(f"diagnostics {version}", said["params"]["diagnostics"])

    client.ask("initialize", {"processId": None, "rootUri": ROOT.as_uri(), "capabilities": {}})
    client.send("initialized", {})
    change("textDocument/didOpen", 1, text)
    for name in ("documentSymbol", "foldingRange", "codeLens", "documentColor", "documentLink"):
        client.ask("textDocument/" + name, document)
    client.ask("textDocument/semanticTokens/full", document)
    client.ask("textDocument/formatting", document | {"options": {"tabSize": 4, "insertSpaces": True}})
    lines = text.split("\n")
    whole = {"start": {"line": 0, "character": 0}, "end": {"line": len(lines), "character": 0}}
    client.ask("textDocument/codeAction", document | {"range": whole, "context": {"diagnostics": []}})
    words = [(row, word.start() + 1) for row, line in enumerate(lines) for word in re.finditer(r"[A-Za-z_]\w+", line)]
    for row, column in random.Random(path).sample(words, min(12, len(words))):
        at = document | {"position": {"line": row, "character": column}}
        for name in ("hover", "definition", "completion", "signatureHelp", "documentHighlight", "prepareRename"):
            client.ask("textDocument/" + name, at)
        client.ask("textDocument/references", at | {"context": {"includeDeclaration": True}})
        client.ask("textDocument/rename", at | {"newName": "uOther"})
    change("textDocument/didChange", 2, text + "\nSphare 1\nProgram Q uNone 1.\n")
    change("textDocument/didChange", 3, text)
    client.ask("shutdown", None)
    client.send("exit", None)
    client.process.stdin.close()
    return {"answers": "\n".join(client.log).encode(), "status": str(client.process.wait(SECONDS)).encode()}


def environment(folder):
    home = {name: folder for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")}
    return os.environ | home | {"LP_NUM_THREADS": "0", "LC_ALL": "C.UTF-8"}


def results(program, kind, name, words):
    """Returns all that the program says and writes for a task, by what it is."""
    with tempfile.TemporaryDirectory(prefix="snell-same-") as folder:
        os.mkdir(out := os.path.join(folder, "out"))
        try:
            if kind == "server":
                parts = session(program, name, folder)
            else:
                read = ROOT / name if words[-1] == "-" else os.devnull
                with open(read, "rb") as given:
                    ran = subprocess.run([program, *(word.replace("OUT", out) for word in words)], cwd=ROOT, stdin=given,
                                         env=environment(folder), capture_output=True, timeout=SECONDS)
                parts = {"status": str(ran.returncode).encode(), "output": ran.stdout, "errors": ran.stderr}
        except (subprocess.TimeoutExpired, EOFError, BrokenPipeError) as error:
            parts = {"status": type(error).__name__.encode()}
        for path in sorted(pathlib.Path(out).rglob("*")):
            if path.is_file():
                parts[str(path.relative_to(out))] = path.read_bytes()
        for part, data in parts.items():
            if not part.endswith((".png", ".zip")):
                data = data.replace(folder.encode(), b"FOLDER").replace(program.encode(), b"PROGRAM")
                for pattern, instead in VARYING:
                    data = pattern.sub(instead, data)
                parts[part] = data
        return parts


def difference(old, new, part):
    """The first lines that differ, or of pictures how many bytes do."""
    if part.endswith(".png"):
        return f"{len(old)} and {len(new)} bytes"
    lines = [data.decode(errors="replace").splitlines() for data in (old, new)]
    changed = [line for line in difflib.unified_diff(*lines, lineterm="", n=0) if not line.startswith(("---", "+++", "@@"))]
    return "\n      ".join(line[:160] for line in changed[:6]) + (f"\n      … {len(changed)} lines" if len(changed) > 6 else "")


def compare(task, programs):
    kind, name, words = task
    old, new = (results(program, kind, name, words) for program in programs)
    return [f"{kind}: {name}: {part}\n      {difference(old.get(part, b''), new.get(part, b''), part)}"
            for part in sorted(old.keys() | new.keys()) if old.get(part) != new.get(part)]


def main():
    words = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    words.add_argument("programs", nargs=2)
    words.add_argument("kinds", nargs="*")
    words.add_argument("--jobs", type=int, default=2)
    words.add_argument("--only", default="")
    given = words.parse_intermixed_args()
    programs = [os.path.abspath(program) for program in given.programs]
    kinds = given.kinds or list(KINDS)
    if wrong := [kind for kind in kinds if kind not in KINDS]:
        words.error(f"there is no kind {wrong[0]}; there are {', '.join(KINDS)}")
    tasks = [(kind, *task) for kind in kinds for task in KINDS[kind](programs[0]) if given.only in task[0]]
    told, count = [], dict.fromkeys(kinds, 0)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for done, (task, found_here) in enumerate(zip(tasks, pool.map(lambda t: compare(t, programs), tasks)), 1):
            count[task[0]] += bool(found_here)
            told += found_here
            progress = f"\r\033[K{done} of {len(tasks)}: {task[0]} {task[1]}\r" if sys.stderr.isatty() else ""
            print("".join(f"\033[K{line}\n" if progress else f"{line}\n" for line in found_here) + progress, end="",
                  file=sys.stderr, flush=True)
    for kind in kinds:
        print(f"{kind}: {count[kind]} of {sum(task[0] == kind for task in tasks)} differ")
    return bool(told)


if __name__ == "__main__":
    sys.exit(main())
