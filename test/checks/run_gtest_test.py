#!/usr/bin/env python3
"""run_gtest.py reports each test of a program, whatever its tests do to the process."""
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import textwrap
import unittest
import xml.etree.ElementTree as ElementTree

RUNNER = pathlib.Path(__file__).resolve().parents[1] / "support" / "run_gtest.py"
# It speaks as GoogleTest does; what each test does is in its name.
PROGRAM = textwrap.dedent("""\
    #!/usr/bin/env python3
    import json, os, sys, time
    names = ["passes", "fails", "crashes", "hangs", "skips", "DISABLED_never", "passes/0"]
    argument = sys.argv[1]
    if argument == "--gtest_list_tests":
        tests = [dict(name=name, value_param="'\\n  Other.'" if "/" in name else "") for name in names]
        with open(sys.argv[2].partition("json:")[2], "w") as listing:
            json.dump(dict(testsuites=[dict(name="Suite", testsuite=tests)]), listing)
        sys.exit()
    wanted = open(argument.partition("=")[2]).readline().strip().partition("=")[2].split(":")
    failed = False
    for name in names:
        if "Suite." + name not in wanted:
            continue
        print("[ RUN      ] Suite." + name, flush=True)
        print("words of " + name, "in", os.getpid(), flush=True)
        if name == "crashes":
            os.abort()
        if name == "hangs":
            time.sleep(60)
        verdict = {"fails": "  FAILED  ", "skips": "  SKIPPED "}.get(name, "       OK ")
        failed |= name == "fails"
        print("[" + verdict + "] Suite." + name + " (5 ms)", flush=True)
    if "leaks" in os.environ.get("END", ""):
        print("a leak", flush=True)
        sys.exit(23)
    sys.exit(failed)
    """)


class RunGtest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)

    def run_it(self, *options, pattern="", **environment):
        report = self.folder / "report.xml"
        done = subprocess.run([sys.executable, RUNNER, "--timeout", "1", "--report", report, *options, "room", self.program],
                              env=dict(os.environ, COBOT_TEST_PATTERN=pattern, **environment), capture_output=True, text=True, check=False)
        self.cases = {}
        if report.exists():
            self.cases = {case.get("name"): case for case in ElementTree.parse(report).iter("testcase")}
        return done.returncode, done.stdout + done.stderr

    def faults(self):
        return {name: case.find("failure").get("message") for name, case in self.cases.items() if case.find("failure") is not None}

    def test_runs_what_passes_in_one_process_and_shows_nothing_of_it(self):
        status, output = self.run_it(pattern="passes")
        self.assertEqual((status, self.faults()), (0, {}))
        self.assertEqual(set(self.cases), {"room.Suite.passes", "room.Suite.passes/0"})
        self.assertEqual(self.cases["room.Suite.passes"].get("time"), "0.005")
        self.assertNotIn("words of", output)

    def test_names_each_that_failed_crashed_or_hung_and_runs_all_the_others(self):
        status, output = self.run_it()
        self.assertEqual(status, 1)
        self.assertEqual(self.faults(), {"room.Suite.fails": "it failed", "room.Suite.crashes": "its process ended with -6",
                                         "room.Suite.hangs": "took longer than 1.0 s"})
        self.assertEqual(len(self.cases), 6)
        self.assertIsNotNone(self.cases["room.Suite.skips"].find("skipped"))
        for words in ("words of fails", "words of crashes", "words of hangs", "2 passed, 3 failed, 1 skipped", "failed: room.Suite.hangs"):
            self.assertIn(words, output)
        self.assertNotIn("words of passes", output)

    def test_fails_when_a_process_ends_badly_after_its_tests(self):
        status, output = self.run_it(pattern="passes", END="leaks")
        self.assertEqual(status, 1)
        self.assertIn("The process ended with 23 after its tests:\na leak", output)

    def test_gives_each_test_a_process_of_its_own_when_told(self):
        self.program.write_text(PROGRAM.replace('"       OK "', '"  FAILED  "'), encoding="utf-8")
        output = self.run_it("--each", pattern="passes")[1]
        self.assertEqual(len(set(re.findall(r"in (\d+)", output))), 2)

    def test_runs_a_part_of_the_tests(self):
        for part, expected in (("1/2", {"room.Suite.passes", "room.Suite.skips"}), ("2/2", {"room.Suite.fails", "room.Suite.passes/0"})):
            self.run_it("--shard", part, pattern="passes|skips|fails")
            self.assertEqual(set(self.cases), expected)

    def test_says_when_no_test_matches(self):
        self.assertEqual(self.run_it(pattern="nothing of this name")[0], 77)


if __name__ == "__main__":
    unittest.main()
