#!/usr/bin/env python3
"""Shows the robots of fleet.launch in one RViz: what cobot.rviz shows of one robot, for each of them."""
import argparse
import copy
import math
import os
import sys
import tempfile

import rospkg
import rospy
import yaml


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int, help="number of robots")
    parser.add_argument("--spacing", type=float, default=2.0, help="distance between the bases on their grid [m]")
    parser.add_argument("--columns", type=int, help="columns of the grid; default: as many as there are rows, or one more")
    arguments = parser.parse_args(rospy.myargv()[1:])
    folder = os.path.join(rospkg.RosPack().get_path("cobot_command"), "rviz")
    with open(os.path.join(folder, "cobot.rviz"), encoding="utf-8") as file:
        config = yaml.safe_load(file)
    for_all(config["Visualization Manager"], arguments.count)
    look_at_all(config["Visualization Manager"], *size_of(arguments.count, arguments.columns, arguments.spacing))
    for panel in config["Panels"]:
        if panel["Class"] == "cobot_command/Cobot":
            panel["Robot"] = "/robot_1"
    with tempfile.NamedTemporaryFile("w", suffix=".rviz", delete=False) as file:  # RViz reads it after this has ended
        yaml.safe_dump(config, file)
    os.execvp("rviz", ["rviz", "-d", file.name] + [a for a in sys.argv if ":=" in a])


def for_all(manager, count):
    """Turns the displays of one robot into a group of them for each, in the frame world."""
    shared = [d for d in manager["Displays"] if d["Class"] in ("rviz/Grid", "cobot_command/Preview")]
    own = [d for d in manager["Displays"] if d not in shared]
    robots = [group_of(f"robot_{k}", own) for k in range(1, count + 1)]
    manager["Displays"] = shared + robots
    manager["Global Options"]["Fixed Frame"] = "world"


def size_of(count, columns, spacing):
    """Of the grid of fleet.launch, from its first base to its last, along x and y [m]."""
    columns = columns or math.ceil(math.sqrt(count))
    return (min(count, columns) - 1) * spacing, (math.ceil(count / columns) - 1) * spacing


def look_at_all(manager, width, depth):
    """As one robot is looked at, from as much farther away as all of them are larger."""
    view = manager["Views"]["Current"]
    view["Focal Point"]["X"] += width / 2
    view["Focal Point"]["Y"] += depth / 2
    view["Distance"] += 1.3 * math.hypot(width, depth)
    for display in manager["Displays"]:
        if display["Class"] == "rviz/Grid":
            display["Plane Cell Count"] += math.ceil(2 * max(width, depth) / display["Cell Size"])


def group_of(robot, displays):
    displays = copy.deepcopy(displays)
    for display in displays:
        for key in ("Robot Description", "Topic", "Marker Topic", "Update Topic", "Joints"):
            if key in display:
                display[key] = f"{robot}/{display[key]}"
        if display["Class"] == "rviz/TF":
            display["Frames"] = {key if key == "All Enabled" else f"{robot}_{key}": value
                                 for key, value in display["Frames"].items()}
    return {"Class": "rviz/Group", "Name": robot, "Enabled": True, "Displays": displays}


if __name__ == "__main__":
    main()
