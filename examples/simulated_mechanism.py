#!/usr/bin/env python3
"""What a PLC does for a mechanism of a cell: moves it to the `target` that `cell_mechanism` gives, and tells its `position` fifty times a
second. Both in m, or rad of one that turns. Private parameters: ~start, and ~speed in m/s or rad/s.
"""
import sys

import rospy
from std_msgs.msg import Float64

PERIOD = 0.02  # [s]


def main():
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
