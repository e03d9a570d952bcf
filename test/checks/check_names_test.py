#!/usr/bin/env python3
"""check_names.py finds what it is for."""
import pathlib
import tempfile
import unittest

import check_names


def faults_of(**files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "include").mkdir()
        (root / "src").mkdir()
        for name, text in files.items():
            (root / "src" / f"{name}.h").write_text(f"namespace cobot_command::cell {{\n{text}\n}}  // namespace\n", encoding="utf-8")
        return list(check_names.faults(root))


class Names(unittest.TestCase):
    def test_two_types_of_one_name_are_found(self):
        self.assertEqual(len(faults_of(one="struct Hold {\n};", other="struct Hold {\n  int zone;\n};")), 1)
        self.assertEqual(len(faults_of(one="class Hold final : public Base {\n};", other="enum class Hold { A };")), 1)

    def test_declarations_and_types_inside_of_others_are_none(self):
        self.assertEqual(faults_of(one="struct Hold {\n};", other="struct Hold;\nstruct Part::Hold {\n};\nclass ActionOf<Hold> {\n};"), [])

    def test_what_a_file_keeps_to_itself_is_none(self):
        self.assertEqual(faults_of(one="struct Hold {\n};", other="namespace {\nstruct Hold {\n};\n}  // namespace"), [])


if __name__ == "__main__":
    unittest.main()
