#!/usr/bin/env python3
"""Runs tests so that they cannot pass without having looked.

usage: run.py [--name NAME] [--side-by-side N] [--again] COMMAND...
       run.py --sum FOLDER

COMMAND is a program of GoogleTest. It fails if a test fails, if the program ends in any other way than by its last
test, if it has no test at all, and if there are no graphics, unless SNELL_NO_GRAPHICS=1 says that this is meant.
--side-by-side  N processes share the tests: tests of windows wait most of the time
--again         those that fail are run once more, alone: another process may have taken the processor, or a display may
                have been late; what is wrong fails both times
A program in which no test begins or ends for SNELL_TEST_SILENCE seconds (900) is ended.
With SNELL_TEST_RECORD, a folder, what was skipped and what passed only the second time is written there; --sum prints
it, and fails if more than SNELL_MOST_SKIPPED tests were skipped.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml


class Run:
    """What one process did: the names of its tests, of those that failed, and what others were skipped for."""

    def __init__(self, command, folder, name, environment=None):
        self.report, self.log = os.path.join(folder, name + ".xml"), os.path.join(folder, name + ".log")
        with open(self.log, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(command, env={**os.environ, **(environment or {}),
                                                          "GTEST_OUTPUT": "xml:" + self.report},
                                            stdout=log, stderr=subprocess.STDOUT)
        self.tests, self.failed, self.skipped, self.wrong = [], [], {}, ""

    def wait(self):
        """Ends it if no test begins or ends for long: however many tests it has, and however busy the machine is."""
        longest = float(os.environ.get("SNELL_TEST_SILENCE", 900))
        length, since = 0, time.monotonic()
        while (status := self.ended(longest / 100)) is None:
            now = os.stat(self.log).st_size
            if now != length:
                length, since = now, time.monotonic()
            elif time.monotonic() - since > longest:
                self.process.kill()
                self.process.wait()
                self.wrong = f"no test began or ended for {longest:g} s"
                return self
        try:
            cases = xml.parse(self.report).getroot().iter("testcase")
        except (OSError, xml.ParseError):
            self.wrong = f"it ended with status {status} before its last test"
            return self
        for case in cases:
            if case.get("status") != "run":
                continue
            name = f"{case.get('classname')}.{case.get('name')}"
            self.tests.append(name)
            if case.find("failure") is not None:
                self.failed.append(name)
            elif case.find("skipped") is not None:
                self.skipped[name] = case.find("skipped").get("message", "").split("\n", 1)[-1].strip()
        if status != 0 and not self.failed:
            self.wrong = f"it ended with status {status} although no test failed"
        return self

    def ended(self, seconds):
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None

    def print(self):
        """The output of what failed comes last: where it is cut, it is cut before that."""
        with open(self.log, encoding="utf-8", errors="replace") as log:
            text = log.read()
        if self.wrong:
            print(text[-8000:])
        one = ""
        for line in text.splitlines(keepends=True):
            one = line if line.startswith("[ RUN ") else one + line
            if line.startswith("[  FAILED  ]") and line.rstrip().endswith("ms)"):
                print(one, end="")
                one = ""


def run(command, name, processes, again, folder):
    runs = [Run(command, folder, str(i), {"GTEST_TOTAL_SHARDS": str(processes), "GTEST_SHARD_INDEX": str(i)}
                if processes > 1 else None) for i in range(processes)]
    for one in runs:
        one.wait().print()
    wrong = [one.wrong for one in runs if one.wrong]
    tests = sum(len(one.tests) for one in runs)
    failed = [test for one in runs for test in one.failed]
    skipped = {test: why for one in runs for test, why in one.skipped.items()}
    if not tests and not wrong:
        wrong.append("it has no such test")
    blind = [test for test, why in skipped.items() if "no graphics" in why]
    if blind and os.environ.get("SNELL_NO_GRAPHICS") != "1":
        wrong.append(f"there are no graphics, so {len(blind)} tests looked at nothing ({skipped[blind[0]]}); "
                     "SNELL_NO_GRAPHICS=1 says that this is meant")
    second = []
    if failed and again and not wrong:
        print("once more:", " ".join(failed), flush=True)
        other = Run([word for word in command if not word.startswith("--gtest_filter=")] +
                    ["--gtest_filter=" + ":".join(failed)], folder, "again",
                    {"GTEST_TOTAL_SHARDS": "1", "GTEST_SHARD_INDEX": "0"}).wait()
        other.print()
        if other.wrong or other.failed or sorted(other.tests) != sorted(failed):
            wrong.append(other.wrong or "they fail the second time, too")
        else:
            second, failed = failed, []
    for why in wrong:
        print(f"{os.path.basename(command[0])}: {why}")
    print(f"{tests} tests, {len(failed)} failed, {len(skipped)} skipped, {len(second)} passed only the second time")
    if record := os.environ.get("SNELL_TEST_RECORD"):
        os.makedirs(record, exist_ok=True)
        with open(os.path.join(record, (name or os.path.basename(command[0])) + ".json"), "w", encoding="utf-8") as file:
            json.dump({"tests": tests, "skipped": skipped, "second": second}, file)
    return 1 if wrong or failed else 0


def total(folder):
    tests, skipped, second = 0, {}, []
    for name in sorted(os.listdir(folder) if os.path.isdir(folder) else []):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            one = json.load(file)
        tests += one["tests"]
        skipped.update(one["skipped"])
        second += one["second"]
    reasons = {}
    for test, why in skipped.items():
        reasons.setdefault(why, []).append(test)
    print(f"{tests} tests, {len(skipped)} of them skipped")
    for why, those in sorted(reasons.items(), key=lambda reason: -len(reason[1])):
        print(f"  skipped: {why or 'no reason'}: {those[0]}" + (f" and {len(those) - 1} more" if len(those) > 1 else ""))
    for test in second:
        print("  passed only the second time:", test)
    most = os.environ.get("SNELL_MOST_SKIPPED")
    if most and len(skipped) > int(most):
        print(f"more than SNELL_MOST_SKIPPED={most} tests were skipped")
        return 1
    return 0


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--sum")
    parser.add_argument("--name")
    parser.add_argument("--side-by-side", type=int, default=1)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    if options.sum:
        return total(options.sum)
    with tempfile.TemporaryDirectory() as folder:
        return run(options.command, options.name, options.side_by_side, options.again, folder)


if __name__ == "__main__":
    sys.exit(main())
