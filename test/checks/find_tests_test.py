#!/usr/bin/env python3
"""scripts/find_tests.py chooses the entries of CTest that have a test of a name, whether or not their programs are built."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNNER = str(ROOT / "test" / "support" / "run_gtest.py")
PROGRAM = """#!/usr/bin/env python3
import json, sys
json.dump({"testsuites": [{"name": "Suite", "testsuite": [{"name": "stops"}]}]}, open(sys.argv[2].partition("json:")[2], "w"))
"""


class FindTests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("program", PROGRAM)
        entries = [{"name": f"{name}.all", "command": [sys.executable, RUNNER, name, str(self.folder / program)]}
                   for name, program in (("built", "program"), ("missing", "no_program"))]
        entries.append({"name": "rostest.stop", "command": ["rostest"]})
        self.write("ctest", f"#!/bin/sh\ncat <<'END'\n{json.dumps({'tests': entries})}\nEND\n")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        (self.folder / name).chmod(0o755)

    def found(self, pattern, *within):
        done = subprocess.run([sys.executable, ROOT / "scripts" / "find_tests.py", self.folder, pattern, *within], capture_output=True, text=True,
                              env=dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"), check=False)
        names = ("built.all", "missing.all", "rostest.stop")
        return done.returncode, [name for name in names if done.stdout and re.match(done.stdout.strip(), name)]

    def test_finds_a_program_by_one_of_its_tests(self):
        self.assertEqual(self.found("Suite.stops"), (0, ["built.all"]))
        self.assertEqual(self.found(r"built\.Suite"), (0, ["built.all"]))

    def test_finds_other_entries_by_their_names(self):
        self.assertEqual(self.found("stop"), (0, ["built.all", "rostest.stop"]))

    def test_finds_a_program_that_is_not_built_by_its_name_alone(self):
        self.assertEqual(self.found("missing"), (0, ["missing.all"]))
        self.assertEqual(self.found("^(built|rostest)[.]"), (0, ["built.all", "rostest.stop"]))

    def test_looks_at_no_other_entries_than_those_that_are_named(self):
        self.assertEqual(self.found("stop", "^rostest[.]"), (0, ["rostest.stop"]))
        self.assertEqual(self.found("stop", "^missing[.]"), (4, []))

    def test_fails_when_no_test_matches(self):
        self.assertEqual(self.found("no such test"), (4, []))


if __name__ == "__main__":
    unittest.main()
