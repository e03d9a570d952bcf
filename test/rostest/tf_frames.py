"""Frames of tf that a test publishes or looks up."""
import math

import rospy
import tf2_ros
from geometry_msgs.msg import PoseStamped, TransformStamped
from waiting import wait_until



def pose_in(frame, position, quaternion):
    """Metres; (x, y, z, w)."""
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position.x, pose.pose.position.y, pose.pose.position.z = position
    orientation = pose.pose.orientation
    orientation.x, orientation.y, orientation.z, orientation.w = quaternion
    return pose


class Frames:
    """To be made before a test listens to tf itself: the command node is to be the listener that is waited for."""

    def __init__(self):
        self._broadcaster = tf2_ros.StaticTransformBroadcaster()

    def publish(self, parent, child, position, turn):
        """A frame that stands at the position [m], turned about Z [rad]."""
        transform = TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = parent
        transform.child_frame_id = child
        transform.transform.translation.x, transform.transform.translation.y = position[:2]
        transform.transform.translation.z = position[2]
        transform.transform.rotation.z = math.sin(turn / 2)
        transform.transform.rotation.w = math.cos(turn / 2)
        self._broadcaster.sendTransform(transform)
        wait_until(self._broadcaster.pub_tf.get_num_connections, "a listener to tf")


class Lookup:
    def __init__(self):
        self._buffer = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._buffer)

    def position(self, parent, child):
        """(x, y, z) [m] of the child, or None."""
        try:
            found = self._buffer.lookup_transform(parent, child, rospy.Time(0)).transform.translation
        except tf2_ros.TransformException:
            return None
        return found.x, found.y, found.z
