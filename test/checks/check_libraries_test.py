#!/usr/bin/env python3
"""check_libraries.py finds the simulated controller where it is: in its own node."""
import pathlib
import sys
import unittest

import check_libraries

NODE = pathlib.Path(sys.argv.pop(1))


class CheckLibraries(unittest.TestCase):
    def test_finds_its_symbols(self):
        self.assertIn("cobot_command::runtime::SimulatorRuntime::start", "".join(check_libraries.faults(NODE)))

    def test_finds_its_libraries(self):
        libraries = check_libraries.own_libraries(NODE)
        if not libraries:
            self.skipTest("all rooms are linked into the program")
        found = [fault for fault in check_libraries.faults(NODE) if " loads " in fault]
        self.assertEqual([fault.split()[-1].split(".")[0] for fault in found],
                         ["libcobot_ros_simulation", "libcobot_runtime_simulation", "libcobot_simulator"])


if __name__ == "__main__":
    unittest.main()
