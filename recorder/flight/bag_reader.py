"""A bag into a Run. The messages are read as the bag itself describes them, so no workspace is needed."""
import dataclasses
import math

import numpy

from flight import topics
from flight.bag_file import BagFile, version_told
from flight.goal_book import GoalBook
from flight.run import Axis, Event, Frame, Joints, Loss, Run, RunError, ToolTrack

MM = 1000.0
# Where a number is missing, something is missing of the run; the others say the same again and again.
COUNTED = {topics.FRAMES, topics.STATUS_FRAMES, topics.JOINTS, topics.TOOL, topics.FEEDBACK, topics.RESULT}
LINE_STRIP, LINE_LIST = 4, 5  # visualization_msgs/Marker
HELD = (("e_stopped", "emergency stop"), ("in_error", "error"), ("safeguard", "safeguard"), ("project_paused", "paused"))
FAR = 60.0  # [s] of a stamp from when its message was recorded: so long no message is under way
# Beyond all reason: turns of a joint [rad, rad/s], places of a TCP [m], limits and speeds of robot_data [deg, deg/s].
MOST_ANGLE, MOST_PLACE, MOST_LIMIT = 1e4, 1e3, 1e5
IDENTITY = ("maker", "model", "controller_model", "control_box_sn", "tmflow_version", "layer_version")


def read(file, namespace=None):
    """The run that was recorded in the file, of the robot in the namespace; RunError says why there is none."""
    with BagFile(file) as bag, version_told(file):
        namespace = namespace_in(bag.types, namespace)
        reader = Reader(str(file), namespace, bag.began, bag.ended)
        for received in bag.messages():
            reader.take(received)
    return reader.finish()


def namespace_in(types, wanted):
    """Where the topic `frames` is, without slashes around it."""
    named = {split(topic)[0].strip("/"): kind for topic, kind in types.items() if split(topic)[1] == topics.FRAMES}
    found = sorted(namespace for namespace, kind in named.items() if kind == topics.TYPES[topics.FRAMES])
    if wanted is not None and wanted.strip("/") in found:
        return wanted.strip("/")
    if wanted is None and len(found) == 1:
        return found[0]
    if not found:
        raise RunError(f"the bag has no topic {topics.FRAMES}; it has {', '.join(sorted(types))}. Record with flight_record.py")
    raise RunError(f"the bag has robots in the namespaces {', '.join('/' + name for name in found)}; choose one with --namespace")


def chained(points):
    """Pairs of points as one line, with a row of nan where the next pair does not go on where the last one has ended."""
    rows = [points[0], points[1]]
    for begin, end in zip(points[2::2], points[3::2]):
        rows += [end] if numpy.array_equal(begin, rows[-1]) else [numpy.full(3, math.nan), begin, end]
    return numpy.array(rows)


def split(topic):
    """The namespace, and the last part of the name."""
    namespace, _, name = ("/" + topic.lstrip("/")).rpartition("/")
    return namespace, name


def are_usable(values, most):
    """Whether all are numbers, and none is larger than any could be."""
    return all(abs(value) <= most for value in values)


class Reader:
    """Takes the messages of a bag, one after the other."""

    def __init__(self, file, namespace, began, ended):
        self.run = Run(file, namespace, began, ended - began, None, None)
        self.goals = GoalBook(self.run.goals, began)
        self.counts = {}  # (topic, who sent it): the number of the last message
        self.joints, self.places = [], []
        self.names = None
        self.takers = {
            topics.FRAMES: self.take_frame, topics.STATUS_FRAMES: self.take_frame, topics.JOINTS: self.take_joints,
            topics.TOOL: self.take_tool, topics.LINK: self.take_link, topics.ROBOT: self.take_robot,
            topics.DATA: self.take_data, topics.PLANNED: self.take_planned, topics.MESSAGES: self.take_event}

    def take(self, received):
        name = received.topic.strip("/")
        if self.run.namespace:
            if not name.startswith(self.run.namespace + "/"):
                return
            name = name[len(self.run.namespace) + 1:]
        message = received.message
        if not topics.is_own(name, message._type):
            return
        self.count(name, received)
        time = self.time_of(message, received.time)
        if name in self.takers:
            self.takers[name](message, time)
        else:
            action, _, what = name.rpartition("/")
            self.goals.take(action, what, message, time, received.sender)

    def time_of(self, message, received):
        """When it was; where nobody has written that, or by another clock, when it was recorded."""
        stamp = message.header.stamp.to_sec() if hasattr(message, "header") else 0
        if stamp and abs(stamp - received) > FAR:
            self.run.far_stamps += 1
            stamp = 0
        return (stamp or received) - self.run.began

    def count(self, name, received):
        """roscpp and rospy number what they send: a number that is left out is a message that was lost."""
        if name.rpartition("/")[2] not in COUNTED:
            return
        key = (name, received.sender)
        number, before = received.message.header.seq, self.counts.get(key)
        if before is not None and number > before + 1:
            self.run.losses.append(Loss(name, received.time - self.run.began, number - before - 1))
        self.counts[key] = number

    def cannot_use(self, topic):
        self.run.unusable[topic] = self.run.unusable.get(topic, 0) + 1

    def take_frame(self, message, time):
        self.run.frames.append(Frame(time, message.sent, message.channel == message.STATUS, bytes(message.bytes),
                                     message.text, message.meaning))

    def take_joints(self, message, time):
        self.names = self.names or list(message.name)
        if not are_usable([*message.position, *message.velocity], MOST_ANGLE):
            self.cannot_use(topics.JOINTS)
        elif list(message.name) == self.names and len(message.position) == len(self.names):
            self.joints.append((time, message.position, message.velocity))

    def take_tool(self, message, time):
        place = [message.pose.position.x, message.pose.position.y, message.pose.position.z]
        if not are_usable(place, MOST_PLACE):
            self.cannot_use(topics.TOOL)
            return
        self.places.append((time, *(value * MM for value in place)))

    def take_link(self, message, time):
        self.run.links.append((time, message.link_state))

    def take_robot(self, message, time):
        held = ", ".join(word for field, word in HELD if getattr(message, field) == message.TRUE)
        if held != (self.run.states[-1][1] if self.run.states else None):
            self.run.states.append((time, held))

    def take_data(self, message, _):
        axes = [Axis(a.name, a.lower_limit, a.upper_limit, a.rated_speed) for a in message.axes]
        if all(are_usable(dataclasses.astuple(axis)[1:], MOST_LIMIT) and axis.lower < axis.upper and axis.rated_speed > 0 for axis in axes):
            self.run.axes[:] = axes
        else:
            self.cannot_use(topics.DATA)
        self.run.identity.update({name: getattr(message, name) for name in IDENTITY if getattr(message, name)})

    def take_planned(self, message, time):
        if message.type not in (LINE_STRIP, LINE_LIST) or len(message.points) < 2:
            return
        places = [(p.x, p.y, p.z) for p in message.points]
        if not all(are_usable(place, MOST_PLACE) for place in places):
            self.cannot_use(topics.PLANNED)
            return
        points = numpy.array(places) * MM
        self.run.planned.append((time, points if message.type == LINE_STRIP else chained(points)))

    def take_event(self, message, time):
        self.run.events.append(Event(time, message.severity, message.text))

    def finish(self):
        """The run; without joint states there is nothing to be shown of the robot."""
        if not self.joints:
            raise RunError(f"{self.run.file} has no {topics.JOINTS}: the status stream was missing (status_port 0, or the Ethernet Slave of"
                           " the controller is off), or the topic was not recorded. Record with flight_record.py while status_stream"
                           " of command_status is true")
        self.run.joints = self.joint_track()
        places = numpy.array(self.places).reshape(-1, 4)
        self.run.tool = ToolTrack(places[:, 0], places[:, 1:])
        self.goals.finish()
        self.run.frames.sort(key=lambda frame: frame.time)
        self.run.goals.sort(key=lambda goal: goal.begun)
        return self.run

    def joint_track(self):
        times = numpy.array([time for time, _, _ in self.joints])
        angles = numpy.degrees([position for _, position, _ in self.joints])
        if all(len(velocity) == len(self.names) for _, _, velocity in self.joints):
            return Joints(self.names, times, angles, numpy.degrees([velocity for _, _, velocity in self.joints]))
        # The data table of the controller does not stream Joint_Speed.
        speeds = numpy.gradient(angles, times, axis=0) if len(times) > 1 else numpy.full(angles.shape, math.nan)
        return Joints(self.names, times, angles, speeds)
