#!/usr/bin/env python3
"""check_format.py takes the clang-format that decides, and no other."""
import pathlib
import tempfile
import unittest

import check_format


class CheckFormat(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def program(self, name, words):
        path = self.folder / name
        path.write_text(f"#!/bin/sh\necho '{words}'\n", encoding="utf-8")
        path.chmod(0o755)
        return str(path)

    def test_takes_the_first_of_the_version_that_decides(self):
        newer = self.program("newer", "Debian clang-format version 19.1.7 (3+b1)")
        fetched = self.program("fetched", "clang-format version 14.0.6")
        again = self.program("again", "Debian clang-format version 14.0.6")
        self.assertEqual(check_format.formatter("14", [newer, fetched, again]), fetched)

    def test_takes_no_other_version(self):
        newer = self.program("newer", "Ubuntu clang-format version 140.0.0")
        mute = self.program("mute", "")
        self.assertIsNone(check_format.formatter("14", [newer, mute, str(self.folder / "missing")]))

    def test_reads_the_version_from_the_list_of_what_is_fetched(self):
        (self.folder / "scripts").mkdir()
        (self.folder / "scripts/python-packages.txt").write_text("# two\nother==3.2\nclang-format==14.0.6 --hash=sha256:00\n", encoding="utf-8")
        self.assertEqual(check_format.wanted(self.folder), "14")

    def test_looks_at_all_sources_and_at_nothing_else(self):
        for name in ("include/a.h", "src/b/c.cpp", "test/unit/d.cpp", "src/CMakeLists.txt", "build/e.cpp"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).touch()
        found = [str(path.relative_to(self.folder)) for path in check_format.sources(self.folder)]
        self.assertEqual(found, ["include/a.h", "src/b/c.cpp", "test/unit/d.cpp"])


if __name__ == "__main__":
    unittest.main()
