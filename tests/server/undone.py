#!/usr/bin/env python3
"""What is said of the open texts is a function of them. A server whose texts are edited at random, with requests of all
kinds between the edits, and then as they were, says what a server says that was never asked anything.

usage: undone.py SNELL
SNELL_UNDONE=N tries N scenes instead of a few; SNELL_UNDONE_SEED=N others.
"""
import concurrent.futures
import glob
import os
import pathlib
import random
import re
import sys

from client import Client, path_of

ALL = [path for pattern in ("scenes/**/*.glib", "tests/cases/*.glib", "tests/bad/*.glib", "tests/odd/*.glib", "templates/**/*.glib")
       for path in sorted(glob.glob(pattern, recursive=True))]
SHADERS = (".vert", ".frag", ".geom", ".tesc", ".tese", ".tcs", ".glsl")
PIECES = ["Sphere 1\n", "Program P uA <0. .5 1.>\n", "Fragment nowhere.frag\n", "PushMatrix\n", "#include \"nothing.glsl\"\n", "}", "{", ";",
          " uNot ", "1.0.", "<", "#if 0\n", "/*", "é😀", "\\\n", "vec3 ", "discard;"]
AT_PLACES = ["completion", "definition", "documentHighlight", "hover", "prepareRename", "signatureHelp"]
OF_TEXTS = ["documentColor", "documentSymbol", "formatting"]


def damaged(text, rand):
    """The text with a small slip, such as people make."""
    names = list(re.finditer(r"\w+\.(vert|frag|geom|tesc|tese|tcs|glsl|glib)\b", text))
    kind = rand.randrange(10 if names else 5)
    words = names if kind > 4 else list(re.finditer(r"[A-Za-z_]\w{2,}", text))
    if (kind < 2 or kind > 4) and words:  # a name loses a letter, as "a.frag" becomes "a.fra"
        at = rand.choice(words)
        cut = rand.choice([at.start() + 1, at.end() - 1])
        return text[:cut] + text[cut + 1:]
    lines = text.splitlines(keepends=True) or [""]
    at = rand.randrange(len(lines))
    if kind == 2:
        del lines[at]
    elif kind == 3:
        lines.insert(at, lines[rand.randrange(len(lines))])
    else:
        lines[at] = lines[at][:rand.randrange(len(lines[at]) + 1)] + rand.choice(PIECES)
    return "".join(lines)


def files_of(scene, rand):
    """Scenes and shaders that an editor has open: some that the scene names, a neighbour, a part that others include."""
    near = sorted(str(path) for path in pathlib.Path(scene).parent.iterdir()
                  if path.is_file() and path.suffix in (".glib",) + SHADERS and str(path) != scene)
    text = pathlib.Path(scene).read_bytes().decode("utf-8", "replace")
    own = [path for path in near if os.path.basename(path) in text]
    more = [path for path in near if path not in own]
    return [scene] + rand.sample(own, min(len(own), 3)) + rand.sample(more, min(len(more), rand.choice([0, 0, 1, 2])))


class Editor:
    def __init__(self, client, texts):
        self.client, self.texts, self.version = client, texts, 1
        self.scene = next(iter(texts))
        self.uris = {path: client.open(path, text) for path, text in texts.items()}

    def set(self, path, text):
        self.version += 1
        self.client.change(self.uris[path], self.version, [{"text": text}])

    def reopen(self, path):
        self.client.close(self.uris[path])
        self.client.open(path, self.texts[path])

    def ask(self, rand):
        uri = self.uris[rand.choice(list(self.uris))]
        params = {"textDocument": {"uri": uri}}
        place = {"line": rand.randrange(60), "character": rand.randrange(30)}
        kind = rand.randrange(5)
        if kind == 0:
            method, params["options"] = rand.choice(OF_TEXTS), {"tabSize": 4, "insertSpaces": True}
        elif kind == 1:
            method, params["context"] = "codeAction", {"diagnostics": []}
            params["range"] = {"start": {"line": 0, "character": 0}, "end": place}
        elif kind == 2:
            method, params["position"], params["newName"] = "rename", place, "uOther"
        elif kind == 3:
            method, params["position"], params["context"] = "references", place, {"includeDeclaration": True}
        else:
            method, params["position"] = rand.choice(AT_PLACES), place
        self.client.request("textDocument/" + method, params, seconds=120, fails=True)

    def said(self):
        """What is shown. A busy machine has no time to try fixes, or all sliders."""
        every = {uri: sorted(str((d["range"], d["severity"], d["code"], d["message"])) for d in params["diagnostics"]
                             if d["code"] != "slider-without-effect") for uri, params in self.client.published.items()}
        return {uri: lines for uri, lines in every.items() if lines}

    def close(self):
        for uri in self.uris.values():
            self.client.close(uri)
        self.client.request("textDocument/none", {}, fails=True)


def edit(editor, rand):
    path = rand.choice(list(editor.texts) + [editor.scene] * (len(editor.texts) - 1))  # half of the edits
    editor.set(path, damaged(editor.texts[path], rand) if rand.random() < .9 else "")
    for _ in range(rand.choice([1, 1, 2])):
        editor.ask(rand)
    if rand.random() < .2:
        editor.client.rest(.05)  # checks begin, and some end
    if rand.random() < .3:
        editor.set(path, editor.texts[path])
    if rand.random() < .1:
        editor.client.notify("textDocument/didSave", {"textDocument": {"uri": editor.uris[path]}})
    if rand.random() < .05:
        editor.reopen(rand.choice(list(editor.texts)))


def agree(edited, still, wrong):
    """Waits until both say the same, and still do when they have nothing left to say."""
    def same():
        still.client.pump(.01)
        edited.client.pump(.01)
        return edited.said() == still.said()
    for _ in range(20):
        try:
            edited.client.wait_for(same, 60)
        except TimeoutError:
            break
        still.client.rest(.4)
        edited.client.rest(.4)
        if same():
            return
    first, now = still.said(), edited.said()
    for uri in sorted(first.keys() | now.keys()):
        for line in sorted(set(first.get(uri, [])) ^ set(now.get(uri, []))):
            wrong.append(f"  {'lost' if line in first.get(uri, []) else 'new'} in {path_of(uri)}: {line}")


def try_one(snell, seed, index):
    rand = random.Random(f"{seed} {index}")
    scene = rand.choice(ALL)
    texts = {os.path.abspath(path): pathlib.Path(path).read_bytes().decode("utf-8", "replace")
             for path in files_of(scene, rand)}
    for path in texts:
        if rand.random() < .6:
            texts[path] = damaged(texts[path], rand)
    driver = rand.random() < .7
    still, edited = (Editor(Client(snell, driver=driver), texts) for _ in range(2))
    wrong = []
    for _ in range(rand.choice([1, 2, 3, 8])):
        edit(edited, rand)
    for path, text in texts.items():
        edited.set(path, text)
    agree(edited, still, wrong)
    found = sum(map(len, still.said().values()))
    for editor in (still, edited):
        editor.close()
        editor.client.wait_for(lambda e=editor: not e.said(), 60)  # what was said is taken back
        if status := editor.client.end():
            wrong.append(f"  a server ends with {status}")
    return found, [f"{scene}, scene {index} of seed {seed}, {len(texts)} texts are open:"] + wrong if wrong else []


def main(snell):
    seed, count = os.environ.get("SNELL_UNDONE_SEED", "1"), int(os.environ.get("SNELL_UNDONE", "24"))
    with concurrent.futures.ThreadPoolExecutor(4) as pool:  # they wait most of the time
        tried = list(pool.map(lambda index: try_one(snell, seed, index), range(count)))
    found = sum(1 for said, _ in tried if said)
    wrong = [line for _, lines in tried for line in lines]
    if found < count / 4:
        wrong.append(f"only {found} of {count} have a diagnostic")
    print(*wrong, f"{count} scenes, {found} with diagnostics", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
