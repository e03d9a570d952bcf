#!/usr/bin/env python3
"""What scripts end with. scripts/load and scripts/soak by what the test program says: rostest --text ends with 0 whatever that is."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))


def verdict(printed, status=0):
    """The exit status of run_rostest behind a rostest that prints this and ends with `status`."""
    with tempfile.TemporaryDirectory() as folder:
        fake = pathlib.Path(folder) / "rostest"
        fake.write_text(f"#!/bin/sh\ncat <<'END'\n{printed}\nEND\nexit {status}\n", encoding="utf-8")
        fake.chmod(0o755)
        return subprocess.run(["bash", "-c", 'source "$1/scripts/setup.sh"; run_rostest load', "bash", str(ROOT)],
                              env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "COBOT_BUILD_DIR": folder},
                              check=False, capture_output=True).returncode


class VerdictTest(unittest.TestCase):
    def test_is_0_when_the_test_program_succeeds(self):
        self.assertEqual(verdict(" * RESULT: SUCCESS"), 0)
        self.assertEqual(verdict("\x1b[32m * RESULT: SUCCESS\x1b[0m"), 0)

    def test_is_1_when_the_test_program_fails(self):
        self.assertEqual(verdict(" * RESULT: FAIL"), 1)
        self.assertEqual(verdict("\x1b[31m * RESULT: FAIL\x1b[0m"), 1)
        self.assertEqual(verdict(" * RESULT: SUCCESS\n * RESULT: FAIL"), 1)

    def test_is_1_when_the_test_program_says_nothing(self):
        self.assertEqual(verdict("process has died"), 1)
        self.assertEqual(verdict("process has died", 1), 1)


class ArgumentsTest(unittest.TestCase):
    """Refused before anything is installed or built."""

    def assert_refused(self, words, *command):
        done = subprocess.run([ROOT / "scripts" / command[0], *command[1:]], check=False, capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn(words, done.stderr)

    def test_demo_names_what_it_can_show(self):
        self.assert_refused("'dance' is not known. Allowed are: nothing (the pick-and-place), path, or cell NAME", "demo", "dance")
        self.assert_refused("'twice' is not an option of load_path.py", "demo", "path", "twice")

    def test_soak_load_tidy_figures_and_coverage_take_what_their_usage_says(self):
        self.assert_refused("usage: scripts/soak", "soak", "1", "10", "7", "more")
        self.assert_refused("usage: scripts/load", "load", "10", "7", "more")
        self.assert_refused("'src' is one argument too many", "tidy", "--changed", "src")
        self.assert_refused("'--all' is unknown", "tidy", "--all")
        self.assert_refused("usage: scripts/figures", "figures", "cell", "more")
        self.assert_refused("a room is a folder of src/", "coverage", "nowhere")

    def test_plot_profiles_takes_one_folder(self):
        self.assert_refused("usage: scripts/plot_profiles [folder]", "plot_profiles", "here", "there")


if __name__ == "__main__":
    unittest.main()
