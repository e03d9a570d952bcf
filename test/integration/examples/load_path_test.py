#!/usr/bin/env python3
"""The example of a path by the core alone does what it says.

Usage: load_path_test.py load_path
"""
import signal
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=90, check=False)


class LoadPath(unittest.TestCase):
    def test_drives_what_it_has_planned(self):
        done = run()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count("sent as a PVT of"), 1)
        for point in range(4):
            for words in (f"  point {point} from ", f"  point {point} is active, ", f"  point {point} was done after "):
                self.assertIn(words, done.stdout)
        self.assertIn("0 blends lost", done.stdout)
        self.assertIn("The path is done", done.stdout)

    def test_ends_when_it_is_told_to(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number.name), subprocess.Popen([PROGRAM], stdout=subprocess.PIPE, text=True) as program:
                self.assertTrue(any("is active" in line for line in program.stdout))
                program.send_signal(number)
                self.assertIn("interrupted", program.communicate(timeout=30)[0])
                self.assertEqual(program.returncode, 1)

    def test_refuses_what_is_no_address(self):
        for words, found in ((["a", "b"], "usage: load_path"), (["localhost", "0", "5891"], "'0' is not a port"),
                             (["localhost", "5890", "5891x"], "'5891x' is not a port"), (["localhost", "5890", "65536"], "1 to 65535")):
            with self.subTest(words=words):
                done = run(*words)
                self.assertEqual(done.returncode, 2)
                self.assertIn(found, done.stdout)


if __name__ == "__main__":
    unittest.main()
