#!/usr/bin/env python3
"""check_pages.py finds what it is for."""
import pathlib
import shutil
import tempfile
import unittest

import check_pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What check_pages.py reads, and what links lead to.
FILES = ("README.md", "CONTRIBUTING.md", "CHANGELOG.rst", "LICENSE", "src/ros/files/pick_and_place_file.cpp", "src/ros/files/path_file.cpp")
FOLDERS = ("doc", "action", "msg", "examples", "scripts", "config")


class CheckPages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in (*FILES, *(str(page.relative_to(ROOT)) for page in ROOT.glob("test/**/*.md"))):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)
        for name in FOLDERS:
            shutil.copytree(ROOT / name, self.root / name)

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

    def test_finds_a_link_that_leads_nowhere(self):
        self.assertIn("doc/README.md: the link tables.rst leads to no file", self.faults_with("doc/README.md", "(tables.md)", "(tables.rst)"))
        self.assertIn("the link ros.md#moveit leads to no heading", self.faults_with("doc/ros.md", "## MoveIt", "## Moving"))

    def test_knows_the_anchors_of_headings(self):
        self.assertEqual(check_pages.anchors_of("# `a_b`: The end, of it\n## Two [words](x.md)\n```\n# none\n```\n## Two words\n"),
                         {"a_b-the-end-of-it", "two-words", "two-words-1"})

    def test_finds_a_readme_that_is_too_long(self):
        with open(self.root / "README.md", "a", encoding="utf-8") as page:
            page.write("\n" * 150)
        self.assertIn("allowed are 150", "\n".join(check_pages.faults(self.root)))


if __name__ == "__main__":
    unittest.main()
