#!/usr/bin/env python3
"""Makes the report of a recorded run, report.png and report.html: what the robot did against its limits, what went over the wire, what
was planned and how it went, and what replays in the decoder and in the simulator say. No robot and no ROS master is needed.

Exit status: 0 when the recording is whole, the replays agree and the report was written; 1 when it was written and something is not as it
should be; 2 when the bag cannot be used or the report not be written; 3 when its output cannot be written."""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from flight import programs, report  # noqa: E402  its folder has to be known first
from flight.run import RunError  # noqa: E402
from flight.verdict import Difference, Verdict  # noqa: E402


def replays(run, arguments):
    """The verdicts of both; of one that cannot be made, why: the recording is drawn all the same."""
    verdicts = []
    for name in ("decoder", "simulator"):
        try:
            verdicts += programs.replays(run, arguments, of_decoder=name == "decoder", of_simulator=name == "simulator")
        except RunError as reason:
            why = f"{reason}; --no-replay draws without"
            verdicts.append(Verdict(name, differences=[Difference(0.0, "the replay as a whole", "a run", why)]))
    return verdicts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    programs.add_options(parser)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("report"), help="for the report (default: %(default)s)")
    parser.add_argument("--no-replay", action="store_true", help="draw only")
    arguments = parser.parse_args()
    run = programs.read(arguments)
    verdicts = [] if arguments.no_replay else replays(run, arguments)
    programs.tell(verdicts)
    analysis, files = report.write(run, verdicts, arguments.folder)
    for fault in analysis.faults:
        print(f"the recording is not whole: {fault}")
    for file in files:
        print(file)
    return programs.AGREES if analysis.is_good else programs.DIFFERS


if __name__ == "__main__":
    sys.exit(programs.ending(main, "flight_report.py"))
