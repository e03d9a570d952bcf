#!/usr/bin/env python3
"""What scripts/load and scripts/soak end with, by what the test program says: rostest --text ends with 0 whatever that is."""
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


if __name__ == "__main__":
    unittest.main()
