#!/usr/bin/env python3
"""check_headers.py finds what it is for."""
import pathlib
import tempfile
import unittest

import check_headers


def private_ones(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, included in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text("".join(f'#include "cobot_command/{header}"\n' for header in included), encoding="utf-8")
        return check_headers.private_ones(root)


HEADER = "include/cobot_command/link/ledger.h"


class CheckHeaders(unittest.TestCase):
    def test_finds_what_only_the_room_and_its_own_tests_include(self):
        users = {"src/link/link.cpp": ["link/ledger.h"], "test/unit/link/ledger_test.cpp": ["link/ledger.h"]}
        self.assertEqual(private_ones({HEADER: [], **users}), ["link/ledger.h"])

    def test_leaves_what_others_include(self):
        for user in ("src/blocks/run.cpp", "test/unit/blocks/run_test.cpp", "test/support/rig.h", "examples/tour.cpp"):
            self.assertEqual(private_ones({HEADER: [], user: ["link/ledger.h"]}), [], user)

    def test_leaves_what_a_public_header_includes(self):
        users = {"include/cobot_command/link/link.h": ["link/ledger.h"], "src/blocks/run.cpp": ["link/link.h"]}
        self.assertEqual(private_ones({HEADER: [], **users}), [])

    def test_takes_the_sub_rooms_of_a_cell_for_rooms(self):
        header = "include/cobot_command/cell/bodies/capsule.h"
        own = {"src/cell/bodies/capsule.cpp": ["cell/bodies/capsule.h"], "test/unit/cell/bodies/capsule_test.cpp": ["cell/bodies/capsule.h"]}
        self.assertEqual(private_ones({header: [], **own}), ["cell/bodies/capsule.h"])
        self.assertEqual(private_ones({header: [], "src/cell/sweep/claim.cpp": ["cell/bodies/capsule.h"]}), [])


if __name__ == "__main__":
    unittest.main()
