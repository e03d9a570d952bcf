#!/usr/bin/env python3
"""check_pages.py finds what it is for."""
import pathlib
import shutil
import tempfile
import unittest

import check_pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What check_pages.py reads.
PAGES = ("README.md", "doc/architecture.md", "doc/ros.md", "doc/actions/load_path.md", "src/ros/files/pick_and_place_file.cpp",
         "src/ros/files/path_file.cpp", "action/MoveAbsolute.action")


class CheckPages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for page in PAGES:
            (self.root / page).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / page, self.root / page)

    def faults_with(self, page, old, new):
        """What is found where the page says the new in place of the old."""
        text = (self.root / page).read_text(encoding="utf-8")
        self.assertIn(old, text)
        (self.root / page).write_text(text.replace(old, new), encoding="utf-8")
        return "\n".join(check_pages.faults(self.root))

    def test_finds_nothing_where_nothing_is_wrong(self):
        self.assertEqual(list(check_pages.faults(self.root)), [])

    def test_finds_a_room_that_is_left_out_of_a_row(self):
        self.assertIn("link/ may use protocol/ (check_layers.py), and its row does not say so",
                      self.faults_with("doc/architecture.md", "| `protocol`, `arm` |", "| `arm` |"))

    def test_finds_a_room_that_a_row_has_too_many(self):
        self.assertIn("link/ may not use motion/ (check_layers.py), and its row says so",
                      self.faults_with("doc/architecture.md", "| `protocol`, `arm` |", "| `protocol`, `arm`, `motion` |"))

    def test_finds_a_room_without_a_row(self):
        self.assertIn("trial/ has no row", self.faults_with("doc/architecture.md", "| `trial/` |", "| trial |"))

    def test_finds_another_size_of_a_file(self):
        self.assertIn("the size of a path_file is 4 MiB", self.faults_with("src/ros/files/path_file.cpp", "kMaxFileSize = 4 << 20", "kMaxFileSize = 8 << 20"))
        self.assertIn("doc/actions/load_path.md: the size of a path_file is 5 MiB",
                      self.faults_with("doc/actions/load_path.md", "up to 4 MiB", "up to 5 MiB"))

    def test_finds_a_message_that_shows_no_units(self):
        self.assertIn("README.md: rosmsg shows no unit of MoveAbsoluteActionGoal",
                      self.faults_with("README.md", "rosmsg show -r cobot_command/MoveAbsoluteGoal", "rosmsg show -r cobot_command/MoveAbsoluteActionGoal"))


if __name__ == "__main__":
    unittest.main()
