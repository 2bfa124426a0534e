#!/usr/bin/env python3
"""Runs the examples of README.md, docs/ and scenes/*.md, and of every --help: examples.py PROGRAM SOURCE_FOLDER

An example is a line of a fenced block that begins with `snell `, or such a span of code that names a scene. It runs in
a folder with a copy of scenes/ and an empty out/, at a small size, and must end with status 0, or N where its comment
says "status N". Those of docs/teaching/ run in a copy of their lesson, in the order of the page, and those of its README
in the first lesson. A command that opens a window is replaced by `snell check`. Lines with a `$` belong to a job scheduler
and are skipped (tests/farm runs them). A fenced block that begins with `##OpenGL GLIB` is a scene: it must have neither
errors nor warnings.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Of the program's table, hidden ones among them.
TABLE = pathlib.Path(__file__).resolve().parents[2] / "src/app/help/program.cpp"
SUBCOMMANDS = set(re.findall(r'^    \{"(\w+)", ".*", add_\w+,$', TABLE.read_text(), re.MULTILINE))
# What `snell web` fills in, in the place of the browser's part, which need not be built.
PAGE = """<title>snell</title><script type="application/json" id="scene">null</script>
<script type="text/plain" id="archive"></script>"""
FENCE = re.compile(r"^```[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
SPAN = re.compile(r"`(snell [^`…]*\.glib[^`…]*)`")


def commands(text):
    lines = [line.strip() for line in text.replace("\\\n", " ").splitlines()]
    return [line for line in lines if line.startswith("snell ") and "$" not in line]


def examples(root, program, folder):
    """Pairs of a page and a command. Scenes of the pages are written into the folder, and checked."""
    found = []
    pages = [root / "README.md", *sorted(root.glob("docs/*.md")), *sorted(root.glob("scenes/**/*.md"))]
    for page in pages:
        text, name = page.read_text(), str(page.relative_to(root))
        for block in FENCE.findall(text):
            found += [(name, command) for command in commands(block)]
            if block.startswith("##OpenGL GLIB"):
                scene = f"example-{len(found)}.glib"
                pathlib.Path(folder, scene).write_text(block)
                found.append((name, f"snell check {scene} |& diff /dev/null -"))  # prints nothing if all is well
        found += [(name, " ".join(command.split())) for command in SPAN.findall(FENCE.sub("", text))]
    for options in ["--help"], *([name, "--help"] for name in sorted(SUBCOMMANDS)):
        shown = subprocess.run([program, *options], capture_output=True, text=True, check=True).stdout
        own = commands(shown.partition("Examples")[2])
        found += [(" ".join(options), command) for command in own or ["exit 1 # without examples"]]
    return found


def lessons(root):
    """Pairs of a page of docs/teaching and all of its commands, as one that runs in its folder."""
    found = []
    for page in sorted(root.glob("docs/teaching/**/README.md")):
        # What lessons' rubrics say is tests/commands/teaching.cpp's.
        own = [command for block in FENCE.findall(page.read_text()) for command in commands(block)
               if not command.startswith("snell grade rubric.toml ")]
        lesson = min(page.parent.glob("01-*"), default=page.parent).relative_to(root)
        found.append((str(page.relative_to(root)), " && ".join([f"cd {lesson}", "mkdir -p out", *map(small, own)])))
    return found


def small(command):
    """The same command without a window, and with less to draw and to measure."""
    # The gallery of all scenes is tests/commands/web_gallery.cpp's, and what all scenes look like is tests/pictures'.
    words = command.partition("#")[0].replace("scenes/light/*/", "scenes/light/m*/").split()
    if "--gallery" in words:
        words = [word.replace("scenes/light", "scenes/light/mirror") for word in words]
    if words[1] not in SUBCOMMANDS:
        return "snell check " + next(word for word in words if word.endswith(".glib"))
    less = {"render": {"--size": "48x36"}, "sweep": {"--size": "48x36"}, "explain": {"--size": "48x36", "--reps": "3"},
            "accuracy": {"--size": "16x12", "--no-time": "", "--no-found": "", "--budget": "2"}}.get(words[1], {})
    if {"--list-found", "--apply"} & set(words):
        less = {}  # nothing is drawn
    if {"--within", "--error", "--save-quality"} & set(words):
        less = {"--size": "24x18", "--reps": "7", "--no-found": "", "--budget": "60"}
    if words[1] == "compare" and any(word.endswith(".glib") for word in words):
        less = {"--size": "24x18"}
    if "--frames" in words:
        less |= {"--frames": "3"}
    for option in less:
        if option in words:
            del words[words.index(option):words.index(option) + 2]
    return " ".join(words[:2] + [word for pair in less.items() for word in pair if word] + words[2:])


def main():
    program, root = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    failed = 0
    with tempfile.TemporaryDirectory(prefix="snell-examples-") as folder:
        shutil.copytree(root / "scenes", folder + "/scenes")
        shutil.copytree(root / "docs/teaching", folder + "/docs/teaching")
        os.mkdir(folder + "/out")
        web = pathlib.Path(folder, "web")
        web.mkdir()
        for name in ("page.html", "gallery.html", "runtime.js"):
            (web / name).write_text(PAGE)
        environment = {**os.environ, "PATH": f"{program.parent}{os.pathsep}{os.environ['PATH']}", "HOME": folder,
                       "SNELL_WEB": str(web), "LP_NUM_THREADS": "0"}

        def run(command):
            return subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)

        found = [(page, command, small(command)) for page, command in examples(root, program, folder)]
        found += [(page, command, command) for page, command in lessons(root)]
        unlike = list(dict.fromkeys(run_as for _, _, run_as in found))
        # Those that write into scenes, alone: two of them would find the other's text.
        done = {command: run(command) for command in unlike if re.search(r"\bsnell (save|format)\b", command)}
        rest = [command for command in unlike if command not in done]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            done |= zip(rest, pool.map(run, rest))
        for page, command, run_as in found:
            ended = done[run_as]
            told = re.search(r"#.*\bstatus (\d)", command)
            if ended.returncode != int(told[1] if told else 0):
                failed += 1
                print(f"{page}: {command}\n  run as: {run_as}\n  status {ended.returncode}\n{ended.stdout}")
    pages = len({page for page, _, _ in found})
    print(f"{len(unlike)} examples of {pages} pages, {failed} failed")
    # Without this, a change of the pages' form that hides all examples would pass.
    return failed > 0 or pages < 5


if __name__ == "__main__":
    sys.exit(main())
