#!/usr/bin/env python3
"""run_gtest.py reports each test of a program, whatever its tests do to the process."""
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import textwrap
import time
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
        self.assertIn("The process ended with 23, and no test of it had failed:\na leak", output)

    def test_reads_the_end_of_a_test_with_a_parameter(self):
        for where in (", where GetParam() = 5", ", where GetParam() = (1, 2)", ", where GetParam() = 'a\\nb'", ", where TypeParam = int"):
            with self.subTest(where):
                ends = PROGRAM.replace('" (5 ms)"', f'"{where}" + " (5 ms)"').replace('"       OK "', '"  FAILED  " if name == "passes" else "       OK "')
                self.program.write_text(ends, encoding="utf-8")
                status, output = self.run_it(pattern="passes")
                self.assertEqual((status, self.faults()), (1, {"room.Suite.passes": "it failed"}), output)
                self.assertEqual(output.count("words of passes in"), 1, "it is not tried again")

    def test_fails_when_a_process_ends_badly_between_two_tests(self):
        self.program.write_text(PROGRAM.replace("    if name == \"crashes\":", "    if name == \"skips\":\n        pass\n    if name == \"crashes\":")
                                .replace('" (5 ms)", flush=True)', '" (5 ms)", flush=True)\n    if name == "passes" and "END" in os.environ:\n        os.abort()'),
                                encoding="utf-8")
        status, output = self.run_it(pattern="passes|skips", END="between")
        self.assertEqual((status, self.faults()), (1, {}), output)
        self.assertIn("The process ended with -6", output)
        self.assertEqual(len(self.cases), 3)

    def test_fails_when_a_process_does_not_end_after_its_tests(self):
        self.program.write_text(PROGRAM.replace("    sys.exit(23)", "    time.sleep(60)"), encoding="utf-8")
        status, output = self.run_it(pattern="passes", END="leaks")
        self.assertEqual((status, self.faults(), len(self.cases)), (1, {}, 2), output)
        self.assertIn("The process took longer than 1.0 s", output)
        self.assertIn("a leak", output)

    def test_does_not_wait_for_what_a_program_has_left_behind(self):
        self.program.write_text(PROGRAM.replace("    sys.exit(23)", "    if os.fork() == 0:\n        time.sleep(60)"), encoding="utf-8")
        self.assertEqual(self.run_it(pattern="passes", END="leaks")[0], 0)

    def test_fails_for_a_test_whose_end_is_not_printed(self):
        self.program.write_text(PROGRAM.replace('    print("[" + verdict', '    if name != "passes": print("[" + verdict'), encoding="utf-8")
        status, output = self.run_it(pattern="passes|skips")
        self.assertEqual((status, self.faults()["room.Suite.passes"]), (1, "another test began before its end"), output)

    def test_fails_for_a_program_without_tests(self):
        self.program.write_text(PROGRAM.replace("for name in names]", "for name in []]"), encoding="utf-8")
        self.assertEqual(self.run_it()[0], 1)

    def test_ends_the_program_when_it_is_ended(self):
        with subprocess.Popen([sys.executable, RUNNER, "room", self.program], env=dict(os.environ, COBOT_TEST_PATTERN="hangs"),
                              stdout=subprocess.PIPE) as runner:
            children = pathlib.Path(f"/proc/{runner.pid}/task/{runner.pid}/children")
            deadline = time.monotonic() + 60
            while not children.read_text() and time.monotonic() < deadline:
                time.sleep(0.05)
            runner.terminate()
            runner.communicate(timeout=60)
        self.assertEqual(runner.returncode, 1)

    def test_says_when_no_test_matches(self):
        self.assertEqual(self.run_it(pattern="nothing of this name")[0], 77)


if __name__ == "__main__":
    unittest.main()
