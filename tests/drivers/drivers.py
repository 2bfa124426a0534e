"""Pictures of the same scenes by several drivers, compared with llvmpipe's.

drivers.py compare REFERENCE OUT NAME    what draw.sh left in OUT for the driver NAME, against the folder REFERENCE
drivers.py quick BIN                     softpipe and a few small scenes: the test of every run
drivers.py es30 BIN                      OpenGL ES 3.0 and every scene: the test of every run
drivers.py all BIN PAGE                  every driver that starts, the tests of OpenGL on some, and the page about it
"""
import fnmatch
import glob
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from table import BUGS, DRIVERS, EXCEPTIONS, QUICK, REFUSED_BY_ES30, RUNGS, TESTS

HERE = os.path.dirname(os.path.abspath(__file__))
ALLOWED = .001  # of the pixels may differ by more than 2 of 255
SAID = {"wireframe-unsupported": "faces instead of wireframes", "thin-lines": "thin lines"}


def read(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


def draw(driver, program, out, **variables):
    """Whether the driver starts."""
    environment = {**os.environ, **driver["environment"], **variables}
    environment["LD_LIBRARY_PATH"] = ":".join(filter(None, [driver.get("libraries"), os.environ.get("LD_LIBRARY_PATH")]))
    command = [f"{HERE}/draw.sh", program, out] + ([driver["context"]] if "context" in driver else [])
    subprocess.run(command, env=environment, check=False)
    return driver["renderer"] in read(f"{out}/info.txt")


def differences(bin_folder, reference, out):
    lines = subprocess.run([f"{bin_folder}/compare_pictures", reference, out], check=True, text=True,
                           capture_output=True).stdout.splitlines()
    rows = [line.split("\t") for line in lines]
    return {name.removesuffix(".png"): (int(over) / int(pixels), int(largest), float(mean))
            for _, name, pixels, over, largest, mean in rows}


def excepted(driver, scene):
    for exception in EXCEPTIONS:
        if driver in exception["drivers"] and any(fnmatch.fnmatch(scene, p) for p in exception["scenes"].split()):
            return exception
    return None


def judge(bin_folder, reference, out, driver):
    """Each scene's verdict: (kind, why); kinds: same, excepted, said, failed."""
    found = differences(bin_folder, reference, out)
    verdicts = {}
    for folder, _, files in sorted(os.walk(out)):
        for status in sorted(name for name in files if name.endswith(".status")):
            scene = os.path.relpath(os.path.join(folder, status), out).removesuffix(".status")
            verdicts[scene] = verdict(driver, scene, int(read(f"{out}/{scene}.status")), read(f"{out}/{scene}.txt"),
                                      found.get(scene))
    return verdicts


def verdict(driver, scene, status, messages, difference):
    for code, what in SAID.items():
        if f"[{code}]" in messages and status <= 1 and (not difference or difference[0] > ALLOWED):
            return "said", what
    if status or not difference:
        first = messages.strip().splitlines()[0] if messages.strip() else "no picture"
        return "failed", f"status {status}: {first}"
    share, largest, mean = difference
    measured = f"{share:.2%} of the pixels, by at most {largest} of 255, {mean:.2f} on average"
    if share <= ALLOWED:
        return "same", measured
    exception = excepted(driver, scene)
    if exception and share <= exception["share"]:
        return "excepted", measured
    return "failed", measured


def report(verdicts):
    for scene, (kind, why) in verdicts.items():
        if kind != "same":
            print(f"{kind:9} {scene}: {why}")
    counts = {kind: sum(v[0] == kind for v in verdicts.values()) for kind in ("same", "excepted", "said", "failed")}
    print(", ".join(f"{count} {kind}" for kind, count in counts.items()))
    return counts


def quick(bin_folder):
    """Status 77 where there is no softpipe: a test that is skipped."""
    with tempfile.TemporaryDirectory() as folder:
        variables = {"SCENES": " ".join(QUICK), "SIZE": "64x64"}
        for name in ("llvmpipe", "softpipe"):
            if not draw(DRIVERS[name], f"{bin_folder}/snell", f"{folder}/{name}", **variables):
                print(f"SKIP: {name} does not start:\n" + read(f"{folder}/{name}/info.txt"))
                return 77
        counts = report(judge(bin_folder, f"{folder}/llvmpipe", f"{folder}/softpipe", "softpipe"))
        return int(counts["failed"] > 0 or counts["same"] < len(QUICK) / 2)


class Drawing:
    """One process that draws the scenes, and those with other rungs."""

    def __init__(self, name, program, out, scenes, rungs=None):
        self.scenes, self.log = scenes, f"{out}/{'log' if rungs is None else rungs}.txt"
        driver = DRIVERS[name]
        context = ["--context", driver["context"]] if "context" in driver else []
        stem = "{stem}" if rungs is None else "{stem} " + rungs
        os.makedirs(out, exist_ok=True)
        with open(self.log, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(
                [program, "render", *scenes, "-o", f"{out}/{stem}.png", "--size", "100x100", "--timeout", "60", *context]
                + (["--ladder", rungs] if rungs else []),
                env={**os.environ, **driver["environment"], "LP_NUM_THREADS": "0"}, stdout=log, stderr=log)

    def messages(self):
        """Of each scene, and those that are no scene's own."""
        self.process.wait()
        own, others = {scene: "" for scene in self.scenes}, ""
        for line in read(self.log).splitlines():
            scene = line.split(":")[0]
            if scene in own:
                own[scene] += line + "\n"
            elif "error:" in line:
                others += line + "\n"
        return own, others


def name_of(scene, rungs=""):
    return f"{os.path.basename(scene).removesuffix('.glib')}{rungs and ' ' + rungs}"


def es30(bin_folder):
    """Status 77 where no driver can be held to OpenGL ES 3.0."""
    driver, program = DRIVERS["es30"], f"{bin_folder}/snell"
    info = subprocess.run([program, "info", "--context", driver["context"]], check=False, capture_output=True, text=True,
                          env={**os.environ, **driver["environment"]}).stdout
    if driver["renderer"] not in info:
        print("SKIP: no OpenGL ES 3.0:\n" + info)
        return 77
    scenes = sorted(glob.glob("tests/cases/*.glib")) + sorted(glob.glob("scenes/**/*.glib", recursive=True))
    assert len({name_of(scene) for scene in scenes}) == len(scenes), "two scenes have one name"
    with tempfile.TemporaryDirectory() as folder:
        runs = [[Drawing(name, program, f"{folder}/{name}", *what) for name in ("llvmpipe", "es30")]
                for what in [(scenes,), *(([scene], rungs) for scene, rungs in RUNGS)]]
        said, failed = {}, []
        for (core, es), rungs in zip(runs, ["", *(rungs for _, rungs in RUNGS)]):
            core.messages()
            own, others = es.messages()
            failed += others.splitlines()
            said |= {name_of(scene, rungs): text for scene, text in own.items()}
        found = differences(bin_folder, f"{folder}/llvmpipe", f"{folder}/es30")
    failed += [complaint for name, text in said.items() if (complaint := es30_complaint(name, text, found.get(name)))]
    print(f"{len(said)} pictures", *failed, sep="\n")
    return int(bool(failed))


def es30_complaint(name, messages, difference):
    """What is not as it should be: pictures are the same, or REFUSED_BY_ES30 says why not."""
    code = REFUSED_BY_ES30.get(name)
    kind, why = verdict("es30", name, int("error:" in messages), messages, difference)
    if code is None:
        return None if kind == "same" else f"{name}: {why}"
    if kind != "said" or f"[{code}]" not in messages:
        return f"{name}: {code} was to be said, and is not needed or not said: {why}"
    return None


def run_tests(bin_folder, name):
    """Lines for the page, and the failures that no exception names."""
    lines, unexplained = [], []
    for tests, which, allowed in TESTS.get(name, []):
        done = subprocess.run([f"{bin_folder}/{tests}_tests", "--gtest_brief=1", f"--gtest_filter={which}"], check=False,
                              env={**os.environ, **DRIVERS[name]["environment"]}, capture_output=True, text=True,
                              errors="replace")
        failed = re.findall(r"^\[  FAILED  \] (\S+) \(", done.stdout, re.M)
        passed = re.search(r"^\[  PASSED  \] (\d+)", done.stdout, re.M)
        new = [test for test in failed if not any(fnmatch.fnmatch(test, p) for p in allowed)]
        if not passed or (done.returncode and not failed):
            new.append(f"{tests}_tests ended with {done.returncode}")
        why = "; ".join(f"`{pattern}`: {reason}" for pattern, reason in allowed.items())
        lines.append(f"| `{tests}_tests{'' if which == '*' else ' ' + which}` | {name} | {passed[1] if passed else 0} | {len(failed)} | {why or '-'} |")
        unexplained += new
        print(name, lines[-1], *new, sep="\n  ")
    return lines, unexplained


def fact(info, name):
    found = re.search(rf"^{name} +(.*)$", info, re.M)
    return found[1] if found else ""


def page(results, absent, tests):
    text = read(f"{HERE}/page.md") + "\n| driver | renderer, version | same | excepted | said | failed |\n"
    text += "|---|---|---:|---:|---:|---:|\n"
    for name, (info, verdicts) in results.items():
        counts = [sum(v[0] == kind for v in verdicts.values()) for kind in ("same", "excepted", "said", "failed")]
        text += f"| {name} | {fact(info, 'renderer')}; {fact(info, 'OpenGL')} | " + " | ".join(map(str, counts)) + " |\n"
    for name, why in absent.items():
        text += f"| {name} | does not start: {why} | | | | |\n"
    text += "\n## What differs, and why\n\n| driver | scenes | at most | why |\n|---|---|---:|---|\n"
    for exception in EXCEPTIONS:
        scenes = exception["scenes"].replace("tests/cases/", "").replace("*", r"\*")
        text += f"| {', '.join(exception['drivers'])} | {scenes} | {exception['share']:.0%} | {exception['why']} |\n"
    text += "\n## What is not drawn as asked, and said\n\n| driver | scene | instead |\n|---|---|---|\n"
    for name, (_, verdicts) in results.items():
        for why in SAID.values():
            scenes = [os.path.basename(scene) for scene, v in verdicts.items() if v == ("said", why)]
            if scenes:
                text += f"| {name} | {', '.join(scenes)} | {why} |\n"
    if tests:
        text += "\n## Tests\n\n| tests | driver | passed | failed | failures that are known |\n|---|---|---:|---:|---|\n"
        text += "\n".join(tests) + "\n"
    return text + "\n## Faults found\n\n" + "".join(f"- {bug}\n" for bug in BUGS)


def every(bin_folder, path):
    out = "build/drivers/out"
    results, absent, tests, failed = {}, {}, [], []
    for name, driver in DRIVERS.items():
        print(f"{name}:", flush=True)
        subprocess.run(["rm", "-rf", f"{out}/{name}"], check=True)
        if not draw(driver, f"{bin_folder}/snell", f"{out}/{name}", LIMIT="300"):
            absent[name] = read(f"{out}/{name}/info.txt").strip().splitlines()[-1]
            print(f"does not start: {absent[name]}")
            continue
        verdicts = judge(bin_folder, f"{out}/llvmpipe", f"{out}/{name}", name)
        if report(verdicts)["failed"]:
            failed.append(name)
        results[name] = (read(f"{out}/{name}/info.txt"), verdicts)
        lines, unexplained = run_tests(bin_folder, name)
        tests += lines
        failed += unexplained
    with open(path, "w", encoding="utf-8") as file:
        file.write(page(results, absent, tests))
    print("failed: " + ", ".join(failed) if failed else "nothing unexplained")
    return int(bool(failed))


def main(arguments):
    if len(arguments) == 4 and arguments[0] == "compare":
        return int(report(judge("build/release/bin", *arguments[1:]))["failed"] > 0)
    if len(arguments) == 2 and arguments[0] == "quick":
        return quick(arguments[1])
    if len(arguments) == 2 and arguments[0] == "es30":
        return es30(arguments[1])
    if len(arguments) == 3 and arguments[0] == "all":
        return every(*arguments[1:])
    print(__doc__, file=sys.stderr)
    return 2


sys.exit(main(sys.argv[1:]))
