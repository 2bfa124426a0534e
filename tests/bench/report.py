"""Writes docs/performance.md from what the benchmarks left in a folder: report.py FOLDER PAGE"""
import json
import os
import re
import statistics
import subprocess
import sys

ORDER = ["process", "first picture", "frame", "growth", "parse", "plan", "translate", "OBJ", "shapes", "noise", "images",
         "cube maps"]
ABOUT = {
    "process": "From the start of a process to its end, its pictures written as PNG. The wall's time.",
    "first picture": "In a process that has a context, at 512 x 512: read, plan, compile, load, draw. Beside it: copying "
                     "as many bytes as are read, decoded and uploaded.",
    "frame": "Nothing changes from one frame to the next, and all is drawn. Beside it: a clear of colour and depth.",
    "growth": "Opening a scene, and a frame of it at 256 x 256. Beside them: copying what is read, decoded and uploaded; "
              "a clear.",
    "parse": "Beside it: copying the text.",
    "plan": "Reading and parsing the scene, and reading its shaders. Beside it: copying their bytes.",
    "translate": "A program of two shaders from the dialects of GLSL. Beside it: copying their text.",
    "OBJ": "From the file's text to a mesh. Beside it: copying the text.",
    "shapes": "Beside it: copying the mesh.",
    "noise": "Beside it: copying the texels.",
    "images": "From or to the bytes of a file. Beside it: copying the pixels.",
    "cube maps": "Beside it: copying the pixels.",
}


def number(value):
    """Three digits that count."""
    if value == 0:
        return "0"
    digits = max(0, 2 - int(f"{abs(value):e}".split("e")[1]))
    return f"{value:.{digits}f}" if digits else f"{value:,.0f}"


def milliseconds(value, unit="ms"):
    value *= {"ns": 1e-6, "us": 1e-3, "ms": 1}[unit]
    return number(value) + " ms" if value >= .1 else number(value * 1e3) + " µs"


def read_benchmarks(folder):
    with open(os.path.join(folder, "benchmarks.json"), encoding="utf-8") as file:
        data = json.load(file)
    runs = {}
    for run in data["benchmarks"]:
        if run.get("run_type") == "aggregate":
            continue
        if run.get("error_occurred"):
            sys.exit(f"{run['name']}: {run['error_message']}")
        name = re.sub(r"/(process_time|real_time|manual_time|repeats:\d+)", "", run.get("run_name", run["name"]))
        runs.setdefault(re.sub(r":/", ": ", name), []).append(run)
    return data["context"], runs


def median(runs, key):
    return statistics.median(run.get(key, 0) for run in runs)


def process_rows(runs):
    yield "| | CPU | wall | limit, wall |\n|---|--:|--:|--:|\n"
    walls = {}
    for name, group in runs.items():
        wall = walls[name] = median(group, "real_time")
        pictures = median(group, "pictures")
        limit = "80 ms" if pictures == 1 else ""
        rate = f" ({number(1e3 * pictures / wall)} pictures a second)" if pictures > 1 else ""
        yield f"| {name}{rate} | {milliseconds(median(group, 'process_cpu_ms'))} | {milliseconds(wall)} | {limit} |\n"
        if name.startswith("100 trivial"):
            first = next(v for k, v in walls.items() if k.startswith("a trivial"))
            yield f"| each of them beyond the first | | {milliseconds((wall - first) / (pictures - 1))} | 3 ms |\n"


def rows(runs):
    yield "| | CPU | wall | the least, CPU | times as much |\n|---|--:|--:|--:|--:|\n"
    for name, group in runs.items():
        unit = group[0]["time_unit"]
        cpu, bound = median(group, "cpu_time"), median(group, "bound_cpu_ms")
        ratio = number(cpu * {"ns": 1e-6, "us": 1e-3, "ms": 1}[unit] / bound) if bound else ""
        yield (f"| {name} | {milliseconds(cpu, unit)} | {milliseconds(median(group, 'real_time'), unit)} "
               f"| {milliseconds(bound) if bound else ''} | {ratio} |\n")


def for_values(folder):
    with open(os.path.join(folder, "pairs.json"), encoding="utf-8") as file:
        data = json.load(file)
    quotients = sorted(row["cpu"][1] for row in data["scenes"])
    yield "## Programs for the values that uniforms have\n\n"
    yield ("Frames of 400 x 400 by programs that are compiled for the values of the scene's text, beside frames by programs "
           f"for any values (`--no-specialise`), in {data['rounds']} rounds. Medians of the quotients of the CPU's time; the "
           f"median of all is {quotients[len(quotients) // 2]:.3f}. Scenes whose programs have no such uniforms are left "
           "out.\n\n")
    yield "| scene | for its values | for any | quotient |\n|---|--:|--:|--:|\n"
    for row in data["scenes"]:
        yield (f"| {row['what']} | {milliseconds(row['snell_cpu_ms'])} | {milliseconds(row['other_cpu_ms'])} "
               f"| {quotient(row)} |\n")
    yield "\n"


def quotient(row, clock="cpu"):
    low, middle, high = row[clock]
    return f"{middle:.3f} ({low:.3f} to {high:.3f})"


def without_stages(folder):
    with open(os.path.join(folder, "pairs.json"), encoding="utf-8") as file:
        data = json.load(file)
    table, medians = {}, {}
    for row in data["stages"]:
        scene, *turning, side = row["what"].split(", ")
        table.setdefault(scene, []).append(quotient(row))
        medians.setdefault(side, []).append(row["cpu"][1])
    of_all = " and ".join(f"{statistics.median(values):.2f} at {side} x {side}" for side, values in medians.items())
    yield "## Geometry and tessellation stages that the context lacks\n\n"
    yield ("Frames for which vertex shaders stand for these stages ([glsl.md](glsl.md#stages-that-the-context-lacks)), beside "
           f"frames by the driver's stages, in {data['rounds']} rounds. Medians of the quotients of the CPU's time, still and "
           f"while the view turns; the median of all is {of_all}.\n\n")
    yield "| scene | 48 x 48 | turning | 512 x 512 | turning |\n|---|--:|--:|--:|--:|\n"
    for scene, quotients in table.items():
        yield f"| {scene.removesuffix('.glib')} | {' | '.join(quotients)} |\n"
    yield "\n"


def by_hand(folder):
    with open(os.path.join(folder, "pairs.json"), encoding="utf-8") as file:
        data = json.load(file)
    yield "## Beside a program for one scene\n\n"
    yield ("`tests/bench/handwritten` draws the refraction room and nothing else: its matrices, meshes and shaders are in "
           "its text. The pictures differ by "
           f"{data['largest_difference']} of 255 at most. {data['rounds']} rounds in which everybody takes part, in turns; "
           "medians of the quotients of a round, and where 95 % of such medians lie. CPU: all threads of the process, the "
           "driver's included.\n\n")
    yield "| | snell, CPU | by hand, CPU | CPU: quotient | aim | wall: quotient |\n|---|--:|--:|--:|--:|--:|\n"
    for row in data["rows"]:
        missed = row["limit"] and row["cpu"][0] > row["limit"]
        limit = f"{row['limit']:.2f}{', missed' if missed else ''}" if row["limit"] else ""
        yield (f"| {row['what']} | {milliseconds(row['snell_cpu_ms'])} | {milliseconds(row['other_cpu_ms'])} "
               f"| {quotient(row)} | {limit} | {quotient(row, 'wall')} |\n")
    yield ("\nThe scene has the ball's five numbers on sliders; snell compiles its programs for their values. By hand they are "
           "uniforms, or constants of the shader's text. piglit's shader_runner, which runs shader tests, is the nearest program in "
           "Debian; it writes no file.\n\n")
    own = data["own"]
    counted = {}
    with open(os.path.join(folder, "instructions.txt"), encoding="utf-8") as file:
        for line in file:
            who, count = line.split()
            counted[who] = f", {count} instructions" if count != "0" else ""
    yield "Of that, with every function of OpenGL replaced by one that does nothing, a frame takes "
    yield " and ".join(
        f"{prefix}{number(own[key]['microseconds'])} µs{counted.get(name, '')}, {own[key]['gl_calls']:.0f} calls of OpenGL"
        for prefix, key, name in (("", "snell", "snell"), ("by hand ", "by_hand", "by-hand")))
    yield ".\n\n"


def commit():
    """Unknown where git is not installed, or the sources are an archive's."""
    try:
        return subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True,
                              check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def cpu_name():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "unknown CPU")


def page(folder):
    context, runs = read_benchmarks(folder)
    load = " ".join(f"{value:.1f}" for value in context["load_avg"])
    yield ("# What things cost\n\nMade by `./dev bench`, which also leaves all figures as JSON in build/bench-results.\n\n"
           f"- machine: {cpu_name()}, {context['num_cpus']} cores; {context['renderer']}\n"
           f"- date: {context['date'][:10]}; commit {commit()}\n"
           f"- load average when it began: {load}. Where others use the machine, the CPU's time tells more than the "
           "wall's.\n\nMedians. \"The least\" is what the machine needs for what can't be left out: copying the bytes in "
           "question from memory to memory, or setting all pixels once.\n\n")
    yield from by_hand(folder)
    yield from for_values(folder)
    yield from without_stages(folder)
    for group in ORDER:
        members = {name.split("/", 1)[1]: values for name, values in runs.items() if name.split("/", 1)[0] == group}
        if members:
            yield f"## {group[0].upper()}{group[1:]}\n\n{ABOUT[group]}\n\n"
            yield from process_rows(members) if group == "process" else rows(members)
            yield "\n"


# What stands below this line was written by hand and stays.
BY_HAND = "<!-- by hand -->"


def kept(path):
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        _, mark, rest = file.read().partition(BY_HAND)
    return "\n" + mark + rest if mark else ""


if __name__ == "__main__":
    text = "".join(page(sys.argv[1])).rstrip() + "\n" + kept(sys.argv[2])
    with open(sys.argv[2], "w", encoding="utf-8") as target:
        target.write(text)
