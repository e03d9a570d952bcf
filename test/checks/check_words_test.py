#!/usr/bin/env python3
"""check_words.py finds what it is for, and nothing else."""
import pathlib
import tempfile
import unittest

import check_words


class CheckWords(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def faults_of(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return list(check_words.faults(self.root))

    def test_finds_a_word_of_a_page_with_its_line_and_a_better_one(self):
        self.assertEqual(self.faults_of("doc/a.md", "# A\nThe goal waits\nbehind it.\n"), ['doc/a.md:3: "behind": write after'])

    def test_passes_over_code_and_quotations(self):
        self.assertEqual(self.faults_of("README.md", "`told` is a name.\n```\nbehind\n```\n    behind\n\"nobody\" is what it says.\n"), [])

    def test_reads_the_comments_of_interface_files_alone(self):
        self.assertEqual(len(self.faults_of("msg/A.msg", "bool told      # whether it was told\n")), 1)

    def test_reads_the_words_of_launch_files_alone(self):
        self.assertEqual(len(self.faults_of("launch/a.launch", '<launch><!-- anew --><arg name="behind" doc="what stands in the file" default="told" /></launch>')), 2)

    def test_passes_over_words_that_only_look_alike(self):
        self.assertEqual(self.faults_of("doc/a.md", "It stands for a robot. A renewed hearing.\n"), [])


if __name__ == "__main__":
    unittest.main()
