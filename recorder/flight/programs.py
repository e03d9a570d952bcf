"""What the programs of the flight recorder share: their common options, where their helpers are, and how they end."""
import os
import pathlib
import sys

from flight import bag_reader, decoder_replay, simulator_replay
from flight.run import RunError

AGREES, DIFFERS, UNUSABLE, UNWRITTEN = 0, 1, 2, 3


def add_options(parser):
    """The options of a program that reads a bag."""
    parser.add_argument("bag", help="bag that flight_record.py has written")
    parser.add_argument("--namespace", help="namespace of the robot, if the bag has several")
    parser.add_argument("--programs", type=pathlib.Path, help="folder with tm_frame and tm_simulator (default: those of this package)")
    parser.add_argument("--time-scale", type=float, default=simulator_replay.TIME_SCALE, metavar="X",
                        help="speed of the replay in the simulator, as a multiple of the recording, 0.01 to 100 (default: %(default)g)")
    parser.add_argument("--simulator", action="append", default=[], metavar="OPTION",
                        help="an option of tm_simulator, to set it up like the project of the robot: --simulator=--tcp=gripper=0,0,100,0,0,0")


def program(name, folder):
    """Its path, or RunError."""
    if folder is not None:
        path = folder / name
        if not path.is_file():
            raise RunError(f"{path} does not exist; build it, or give another folder with --programs")
        return path
    # ROS is needed for this alone.
    import roslib.packages
    found = roslib.packages.find_node("cobot_command", name)
    if not found:
        raise RunError(f"{name} is not built; build the package, or give the folder with --programs")
    return pathlib.Path(found[0])


def read(arguments):
    return bag_reader.read(arguments.bag, arguments.namespace)


def replays(run, arguments, of_decoder=True, of_simulator=True):
    """The verdicts of the replays that are wanted."""
    found = []
    if of_decoder:
        found.append(decoder_replay.replay(run, program("tm_frame", arguments.programs)))
    if of_simulator:
        found.append(simulator_replay.replay(run, program("tm_simulator", arguments.programs), arguments.time_scale, arguments.simulator))
    return found


def tell(verdicts):
    """Each verdict, and below it what is otherwise."""
    for verdict in verdicts:
        print(verdict)
        for line in [*verdict.differences, *(f"  {remark}" for remark in verdict.remarks)]:
            print(line)


def ending(main, name):
    """The exit status of main(), which may raise RunError, and whose standard output may be closed or full."""
    try:
        status = main()
        sys.stdout.flush()
        return status
    except RunError as reason:
        print(f"{name}: {reason}", file=sys.stderr)
        return UNUSABLE
    except OSError as fault:
        if fault.filename is not None:
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # else Python tries again at its end
        print(f"{name}: the output cannot be written: {fault.strerror}", file=sys.stderr)
        return UNWRITTEN
