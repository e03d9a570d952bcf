#!/usr/bin/env python3
"""check_waits.py finds calls that can wait and are not in the table, and rows without calls."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).with_name("check_waits.py")


class CheckWaits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("src/ros", "src/runtime", "include/cobot_command/ros", "include/cobot_command/runtime", "doc"):
            (self.root / name).mkdir(parents=True)

    def check(self, source, rows):
        (self.root / "src/ros/desk.cpp").write_text(source)
        table = "\n".join(f"| `{name}` | {kind} | {calls} | main | a while |" for name, kind, calls in rows)
        (self.root / "doc/ros.md").write_text(f"## What may wait, and where\n{table}\n\n## More\n| `ros/x.cpp` | disk | 1 | | |\n")
        return subprocess.run([sys.executable, str(CHECK), str(self.root)], capture_output=True, text=True, check=False)

    def test_takes_what_has_its_row(self):
        self.assertEqual(self.check("::fsync(file);", [("ros/desk.cpp", "disk", 1)]).returncode, 0)

    def test_finds_a_call_without_a_row(self):
        for call, kind in (("::fsync(file);", "disk"), ("answer.wait_for(patience);", "condition"), ("thread.join();", "thread"), ("topic_.shutdown();", "master"),
                           ('node.advertise<M>("x", 1);', "master"), ("buffer.lookupTransform(a, b, t);", "tf")):
            with self.subTest(call=call):
                found = self.check(call, [])
                self.assertEqual(found.returncode, 1)
                self.assertIn(f"ros/desk.cpp: it has 1 calls that can wait for the {kind}, doc/ros.md lists 0", found.stdout)

    def test_finds_one_more_call_in_a_source_that_has_its_row(self):
        found = self.check("answer.wait_for(patience); other.wait();", [("ros/desk.cpp", "condition", 1)])
        self.assertEqual(found.returncode, 1)
        self.assertIn("it has 2 calls that can wait for the condition, doc/ros.md lists 1", found.stdout)

    def test_finds_a_row_without_a_call(self):
        found = self.check("// fsync(file)", [("ros/desk.cpp", "disk", 1)])
        self.assertEqual(found.returncode, 1)
        self.assertIn("it has 0 calls that can wait for the disk, doc/ros.md lists 1", found.stdout)


if __name__ == "__main__":
    unittest.main()
