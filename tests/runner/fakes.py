#!/usr/bin/env python3
"""run.py judges programs that end in every way that a program of GoogleTest can.

usage: fakes.py
"""
import os
import subprocess
import sys
import tempfile
import unittest

RUN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "run.py")

# A program of GoogleTest as it looks from outside: it writes a report, and ends.
FAKE = "#!" + sys.executable + """
import os, signal, sys, time
mode, folder = sys.argv[1], os.path.dirname(sys.argv[0])
chosen = [a[len("--gtest_filter="):].split(":") for a in sys.argv if a.startswith("--gtest_filter=")]
again = bool(chosen)
tests = ["Plain.Holds", "Rows/Table.Row/0", "Rows/Table.Row/1"]
failing = {"row": ["Rows/Table.Row/1"], "all": tests, "late": [] if again else ["Plain.Holds"],
           "late_row": [] if again else ["Rows/Table.Row/0"]}.get(mode, [])
if chosen:
    tests = [name for name in tests if name in chosen[0]]
if mode == "empty":
    tests = []
if mode == "crash":
    os.kill(os.getpid(), signal.SIGSEGV)
if mode == "ends":
    os._exit(0)
if mode in ("slow", "hangs"):
    print("[ RUN      ] Plain.Holds", flush=True)
    for _ in range(5 if mode == "slow" else 100):
        time.sleep(.4)
        if mode == "slow":
            print("[       OK ] Plain.Holds", flush=True)
def case(name):
    suite, test = name.split(".")
    inside = '<failure message="no"/>' if name in failing else ""
    if mode in ("blind", "skips"):
        why = "no graphics: none" if mode == "blind" else "no such file"
        inside = f'<skipped message="file.cpp:1&#x0A;{why}"/>'
    return f'<testcase name="{test}" classname="{suite}" status="run">{inside}</testcase>'
with open(os.environ["GTEST_OUTPUT"][len("xml:"):], "w") as report:
    report.write("<testsuites><testsuite>" + "".join(map(case, tests)) + "</testsuite></testsuites>")
for name in failing:
    print(f"[ RUN      ] {name}\\nthe reason\\n[  FAILED  ] {name} (1 ms)", flush=True)
if mode == "crash_behind":
    os.kill(os.getpid(), signal.SIGABRT)
sys.exit(66 if mode == "suite" else bool(set(failing) & set(tests)))
"""


class Verdicts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.fake = os.path.join(self.folder.name, "fake_tests")
        with open(self.fake, "w", encoding="utf-8") as file:
            file.write(FAKE)
        os.chmod(self.fake, 0o755)

    def tearDown(self):
        self.folder.cleanup()

    def run_fake(self, mode, *options, **environment):
        clean = {key: value for key, value in os.environ.items() if not key.startswith(("SNELL_", "GTEST_"))}
        return subprocess.run([sys.executable, RUN, *options, self.fake, mode], env={**clean, **environment}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    def sum(self, most):
        return subprocess.run([sys.executable, RUN, "--sum", self.folder.name + "/record"], text=True, stdout=subprocess.PIPE,
                              env={**os.environ, "SNELL_MOST_SKIPPED": most}, check=False)

    def test_passes_where_every_test_did(self):
        for options in ([], ["--again"], ["--side-by-side", "2"]):
            self.assertEqual(self.run_fake("holds", *options).returncode, 0)

    def test_fails_with_every_other_end(self):
        for mode in ("row", "all", "suite", "crash", "crash_behind", "ends", "empty", "blind"):
            for options in ([], ["--again", "--side-by-side", "2"]):
                with self.subTest(mode=mode, options=options):
                    self.assertEqual(self.run_fake(mode, *options).returncode, 1)

    def test_shows_what_failed(self):
        self.assertIn("the reason\n[  FAILED  ] Rows/Table.Row/1", self.run_fake("row").stdout)

    def test_only_the_second_time_is_a_remark(self):
        for mode, test in (("late", "Plain.Holds"), ("late_row", "Rows/Table.Row/0")):
            self.assertEqual(self.run_fake(mode).returncode, 1)
            outcome = self.run_fake(mode, "--again", SNELL_TEST_RECORD=self.folder.name + "/record")
            self.assertEqual(outcome.returncode, 0, outcome.stdout)
            self.assertIn("1 passed only the second time", outcome.stdout)
            self.assertIn("passed only the second time: " + test, self.sum("0").stdout)

    def test_a_test_that_hangs_ends(self):
        hung = self.run_fake("hangs", SNELL_TEST_SILENCE="1.5")
        self.assertEqual(hung.returncode, 1)
        self.assertIn("[ RUN      ] Plain.Holds", hung.stdout)
        self.assertIn("no test began or ended for 1.5 s", hung.stdout)
        self.assertEqual(self.run_fake("slow", SNELL_TEST_SILENCE="1.5").returncode, 0)

    def test_no_graphics_may_be_meant(self):
        self.assertIn("3 tests looked at nothing (no graphics: none)", self.run_fake("blind").stdout)
        self.assertEqual(self.run_fake("blind", SNELL_NO_GRAPHICS="1").returncode, 0)

    def test_skipped_tests_are_counted(self):
        self.assertEqual(self.run_fake("skips", SNELL_TEST_RECORD=self.folder.name + "/record").returncode, 0)
        self.assertEqual(self.sum("3").returncode, 0)
        too_many = self.sum("2")
        self.assertEqual(too_many.returncode, 1)
        self.assertIn("skipped: no such file: Plain.Holds and 2 more", too_many.stdout)


if __name__ == "__main__":
    sys.exit(unittest.main())
