#!/usr/bin/env python3
"""check_waits.py finds what waits and has no row, and rows of what does not wait."""
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
        table = "\n".join(f"| `{name}` | {kind} | main | a while |" for name, kind in rows)
        (self.root / "doc/ros.md").write_text(f"## What may wait, and where\n{table}\n\n## More\n| `ros/x.cpp` | disk | | |\n")
        return subprocess.run([sys.executable, str(CHECK), str(self.root)], capture_output=True, text=True, check=False)

    def test_takes_what_has_its_row(self):
        self.assertEqual(self.check("::fsync(file);", [("ros/desk.cpp", "disk")]).returncode, 0)

    def test_finds_a_call_without_a_row(self):
        for call, kind in (("::fsync(file);", "disk"), ("answer.wait_for(patience);", "condition"), ("thread.join();", "thread"),
                           ('node.advertise<M>("x", 1);', "master"), ("buffer.lookupTransform(a, b, t);", "tf")):
            with self.subTest(call=call):
                found = self.check(call, [])
                self.assertEqual(found.returncode, 1)
                self.assertIn(f"ros/desk.cpp: waits for the {kind}", found.stdout)

    def test_finds_a_row_without_a_call(self):
        found = self.check("// fsync(file)", [("ros/desk.cpp", "disk")])
        self.assertEqual(found.returncode, 1)
        self.assertIn("ros/desk.cpp does not wait for the disk", found.stdout)


if __name__ == "__main__":
    unittest.main()
