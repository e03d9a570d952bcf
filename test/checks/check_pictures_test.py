#!/usr/bin/env python3
"""check_pictures.py finds what it is for."""
import pathlib
import tempfile
import unittest

import check_pictures


def faults_of(page, pictures, made):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "doc" / "images").mkdir(parents=True)
        (root / "README.md").write_text("", encoding="utf-8")
        (root / "doc" / "page.md").write_text(page, encoding="utf-8")
        for name, size in pictures.items():
            (root / "doc" / "images" / name).write_bytes(b"x" * size)
        return list(check_pictures.faults(root, set(made)))


class Pictures(unittest.TestCase):
    def test_those_that_are_made_and_shown_are_fine(self):
        self.assertEqual(faults_of("![A](images/a.png)", {"a.png": 10}, ["a.png"]), [])

    def test_one_that_nobody_makes_is_found(self):
        self.assertEqual(len(faults_of("![A](images/a.png)", {"a.png": 10}, [])), 1)

    def test_one_that_nobody_shows_is_found(self):
        self.assertEqual(len(faults_of("", {"a.png": 10}, ["a.png"])), 1)

    def test_one_that_is_shown_or_made_and_not_there_is_found(self):
        self.assertEqual(len(faults_of("![A](images/a.png)", {}, [])), 1)
        self.assertEqual(len(faults_of("", {}, ["a.png"])), 1)

    def test_one_that_is_too_large_is_found(self):
        self.assertEqual(len(faults_of("![A](images/a.png)", {"a.png": 2 << 20}, ["a.png"])), 1)


if __name__ == "__main__":
    unittest.main()
