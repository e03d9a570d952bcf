#!/usr/bin/env python3
"""Launches the robots and mechanisms that are listed in the artifact of a cell. cell.launch starts this program."""
import argparse
import os
import subprocess
import sys

import roslib.packages
import rospy


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("artifact", help="the artifact that tm_cell build has made of the cell's file")
    parser.add_argument("--time-scale", default="1.0", help="how many times faster than real time the controllers run")
    arguments = parser.parse_args(rospy.myargv()[1:])
    names = {what: ask(arguments.artifact, what) for what in ("robots", "mechanisms")}
    # Replaces this process, so that a signal that ends this program ends roslaunch.
    os.execvp("roslaunch", ["roslaunch", "--disable-title", "--no-summary", "cobot_command", "cell_movers.launch",
                            f"artifact:={arguments.artifact}", f"time_scale:={arguments.time_scale}",
                            *(f"{what}:={told}" for what, told in names.items() if told)])


def ask(artifact, what):
    """Finds tm_cell in the devel or install space, as roslaunch finds nodes."""
    programs = roslib.packages.find_node("cobot_command", "tm_cell")
    if not programs:
        sys.exit("cell_movers.py: tm_cell is missing: build the package")
    answer = subprocess.run([programs[0], "ask", artifact, what], stdout=subprocess.PIPE, text=True, check=False)
    if answer.returncode != 0:
        sys.exit(f"cell_movers.py: {programs[0]} ask {artifact} {what} ended with {answer.returncode}")
    return answer.stdout.strip()


if __name__ == "__main__":
    main()
