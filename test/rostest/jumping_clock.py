"""A ROS time that jumps, or stands still, as a test wants it."""
import contextlib
import threading

import rospy
from rosgraph_msgs.msg import Clock

AN_HOUR = 3600.0  # [s]
STEP = 0.02  # [s]


class JumpingClock(threading.Thread):
    """Publishes /clock, as fast as the time of the machine, from where it was last set to."""

    def __init__(self):
        super().__init__(daemon=True)
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=10)
        self._changed = threading.Condition()
        self._time, self._runs = 10 * AN_HOUR, True

    def run(self):
        with contextlib.suppress(rospy.ROSException):  # at the end nobody can publish any more
            while not rospy.is_shutdown():
                with self._changed:
                    self._changed.wait(STEP)
                    self._time += STEP if self._runs else 0.0
                    self._publisher.publish(Clock(rospy.Time.from_sec(self._time)))

    def jump(self, seconds):
        with self._changed:
            self._time += seconds

    def set_running(self, runs):
        with self._changed:
            self._runs = runs
