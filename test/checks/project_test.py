#!/usr/bin/env python3
"""A check that is given a folder of something else fails: it would find no file, and so no fault."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKS = sorted(path for path in pathlib.Path(__file__).parent.glob("check_*.py")
                if "project_root(" in path.read_text(encoding="utf-8"))


class WrongFolder(unittest.TestCase):
    def test_is_refused(self):
        self.assertGreater(len(CHECKS), 0)
        with tempfile.TemporaryDirectory() as folder:
            for check in CHECKS:
                with self.subTest(check.name):
                    done = subprocess.run([sys.executable, check, folder], capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 2)
                    self.assertIn("is not the root of the project: it has no package.xml", done.stderr)


if __name__ == "__main__":
    unittest.main()
