#!/usr/bin/env python3
"""Simulates the PLC of a mechanism of a cell: moves the mechanism to the `target` that `cell_mechanism` publishes, and publishes its
`position` fifty times a second. Both are in m, or in rad if it rotates. Private parameters: ~start (m or rad), ~speed (m/s or rad/s).
"""
import argparse
import sys

import rospy
from std_msgs.msg import Float64

PERIOD = 0.02  # [s]


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args(rospy.myargv()[1:])
    rospy.init_node("simulated_mechanism")
    position = rospy.get_param("~start", 0.0)
    step = PERIOD * rospy.get_param("~speed", 0.25)
    targets = [position]
    rospy.Subscriber("target", Float64, lambda message: targets.append(message.data))
    positions = rospy.Publisher("position", Float64, queue_size=1)
    rate = rospy.Rate(1.0 / PERIOD)
    while not rospy.is_shutdown():
        position += max(-step, min(step, targets[-1] - position))
        positions.publish(position)
        try:
            rate.sleep()
        except rospy.ROSInterruptException:
            break
    return 0


if __name__ == "__main__":
    sys.exit(main())
