#!/usr/bin/env python3
"""Replays a recorded run, and prints the differences: each frame is decoded again, and what was sent is sent to a new simulator.
No robot and no ROS master is needed; doc/flight-recorder.md says what is compared.

Exit status: 0 when all is the same, 1 when something differs, 2 when the bag cannot be used, 3 when its output
cannot be written."""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from flight import programs  # noqa: E402  its folder has to be known first


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    programs.add_options(parser)
    parser.add_argument("--only", choices=("decoder", "simulator"), help="one of the two replays")
    arguments = parser.parse_args()
    verdicts = programs.replays(programs.read(arguments), arguments, arguments.only != "simulator", arguments.only != "decoder")
    programs.tell(verdicts)
    return programs.AGREES if all(verdict.agrees for verdict in verdicts) else programs.DIFFERS


if __name__ == "__main__":
    sys.exit(programs.ending(main, "flight_replay.py"))
