#!/usr/bin/env python3
"""messages.py in made repositories: what it refuses and accepts, in whole and shallow clones.

usage: clones.py
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import messages  # noqa: E402

REFUSED = ["Merge branch 'main' of /work/H1", "Merge remote-tracking branch '/srv/git/snell/main'", "it read /tmp/x, once",
           "a file (/home/u/x.glib)", "file:///home/u", "what `/root/x` is", "HOME=/data", "C:\\Users\\u", "/Users/u",
           "a fine subject\n\nand a body\n/var/tmp/x"]
ACCEPTED = ["Merge branch 'main' of ../H1", "and/or, n/a, 1 /2, (a)/b, x[1]/y", "/proc, /dev/null and /usr/share/mime",
            "https://www.example.org/path", "<b>x</b>", "src/app/x.cpp and ./dev test", "a comment: //line", "**/x, ~/x"]


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Clones(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = os.path.join(self.folder.name, "made")
        self.git("init", "-q", self.root, at=self.folder.name)
        self.commit("Merge branch 'main' of /work/old")
        self.base = self.commit("the base")

    def tearDown(self):
        self.folder.cleanup()

    def git(self, *words, at=None):
        settings = ["-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false"]
        return subprocess.run(["git", *settings, *words], cwd=at or self.root, check=True, capture_output=True,
                              text=True).stdout.strip()

    def commit(self, message):
        self.git("commit", "-q", "--allow-empty", "-m", message)
        return self.git("rev-parse", "HEAD")

    def clone(self, depth):
        clone = os.path.join(self.folder.name, f"depth{depth}")
        self.git("clone", "-q", "--depth", str(depth), "file://" + self.root, clone, at=self.folder.name)
        return clone

    def refuses(self, root=None):
        return messages.main(root or self.root, self.base)

    def test_every_message_since_the_base(self):
        self.assertFalse(self.refuses())  # the older one stays
        for message in ACCEPTED:
            self.commit(message)
            self.assertFalse(self.refuses(), message)
        for message in REFUSED:
            before = self.git("rev-parse", "HEAD")
            self.commit(message)
            self.commit("one more")
            self.assertTrue(self.refuses(), message)
            self.git("reset", "-q", "--hard", before)

    def test_both_sides_of_a_merge(self):
        self.git("checkout", "-q", "-b", "side")
        self.commit("it read /tmp/x")
        self.git("checkout", "-q", "-")
        self.commit("meanwhile")
        self.assertFalse(self.refuses())
        self.git("merge", "-q", "--no-ff", "-m", "what the side brings", "side")
        self.assertTrue(self.refuses())

    def test_shallow_clones(self):
        self.commit("after the base")
        self.assertFalse(self.refuses(self.clone(1)))
        self.assertFalse(self.refuses(self.clone(2)))
        self.commit("it read /tmp/x")
        self.commit("one more")
        self.assertTrue(self.refuses(self.clone(3)))

    def test_no_clone(self):
        self.assertFalse(self.refuses(self.folder.name))

    def test_a_base_that_is_not_there_hides_nothing(self):
        self.base = "0" * 40
        self.assertTrue(self.refuses())


if __name__ == "__main__":
    unittest.main(buffer=True)
