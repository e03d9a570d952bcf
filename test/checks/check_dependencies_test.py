#!/usr/bin/env python3
"""check_dependencies.py finds what it is for."""
import unittest

import check_dependencies

PACKAGE = "<package><name>a</name><depend>boost</depend><test_depend>gtest</test_depend><exec_depend>rostopic</exec_depend></package>"


class CheckDependencies(unittest.TestCase):
    def faults(self, package=PACKAGE, readme="rostopic echo", keys=frozenset({"boost", "gtest", "rostopic"})):
        return "\n".join(check_dependencies.faults(package, readme, set(keys)))

    def test_finds_nothing_where_all_is_known(self):
        self.assertEqual(self.faults(), "")

    def test_finds_a_key_that_rosdep_does_not_know(self):
        self.assertIn("orocos_kdl is no key", self.faults(PACKAGE.replace("boost", "orocos_kdl")))

    def test_finds_a_key_that_nothing_uses(self):
        self.assertIn("does not depend on fmt", self.faults(keys={"boost", "gtest", "rostopic", "fmt"}))

    def test_finds_a_program_of_the_readme_without_its_package(self):
        self.assertIn("<exec_depend>roslaunch</exec_depend>", self.faults(readme="roslaunch a b.launch"))

    def test_reads_the_keys_without_comments(self):
        self.assertEqual(check_dependencies.known_keys("# a\n\nboost  base.yaml\n"), {"boost"})


if __name__ == "__main__":
    unittest.main()
