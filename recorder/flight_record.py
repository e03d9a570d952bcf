#!/usr/bin/env python3
"""Records what the flight recorder needs of one robot, and nothing else, until it is ended: rosbag record with its topics.

Run it in the namespace of the command node. Ctrl-C, SIGTERM, and the end of its launch close the bag; one that was not closed is called
FILE.active. Exit status: that of rosbag record; 2 if the file cannot be written."""
import argparse
import os
import pathlib
import sys

import roslib.packages
import rospy

import cobot_command.msg

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from flight import topics  # noqa: E402  its folder has to be known first


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=pathlib.Path, help="bag to write; an existing file is replaced")
    parser.add_argument("--status-frames", action="store_true", help="record the frames of the status port as well: 67 per second")
    return parser.parse_args(rospy.myargv()[1:])


def main():
    arguments = parse_arguments()
    # A launch starts its nodes in a folder of ROS.
    file = pathlib.Path(arguments.file.expanduser().absolute())
    if not os.access(file.parent, os.W_OK | os.X_OK):
        print(f"flight_record.py: nothing can be written into {file.parent}; make the folder, or give another file", file=sys.stderr)
        return 2
    found = roslib.packages.find_node("rosbag", "record")
    if not found:
        print("flight_record.py: rosbag is not installed (Debian: python3-rosbag, ROS: rosbag)", file=sys.stderr)
        return 2
    names = topics.recorded(topics.actions_in(dir(cobot_command.msg)), arguments.status_frames)
    # In its place: signals and the name that a launch gives are for the recorder itself.
    os.execv(found[0], [found[0], "--quiet", "-O", str(file), *names, *(word for word in sys.argv[1:] if ":=" in word)])


if __name__ == "__main__":
    sys.exit(main())
