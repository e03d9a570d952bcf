"""A bag into a Run. The messages are read as the bag itself describes them, so no workspace is needed."""
import math
import pathlib

import numpy
import rosbag

from flight import topics
from flight.goal_book import GoalBook
from flight.run import Axis, Event, Frame, Joints, Loss, Run, RunError, ToolTrack

MM = 1000.0
# Where a number is missing, something is missing of the run; the others say the same again and again.
COUNTED = {topics.FRAMES, topics.STATUS_FRAMES, topics.JOINTS, topics.TOOL, topics.FEEDBACK, topics.RESULT}
LINE_STRIP, LINE_LIST = 4, 5  # visualization_msgs/Marker
HELD = (("e_stopped", "emergency stop"), ("in_error", "error"), ("safeguard", "safeguard"), ("project_paused", "paused"))
IDENTITY = ("maker", "model", "controller_model", "control_box_sn", "tmflow_version", "layer_version")


def read(file, namespace=None):
    """The run that was recorded in the file, of the robot in the namespace; RunError says why there is none."""
    with opened(file) as bag:
        namespace = namespace_in(bag, namespace)
        reader = Reader(str(file), namespace, bag.get_start_time(), bag.get_end_time())
        for topic, message, received, header in bag.read_messages(return_connection_header=True):
            reader.take(topic, message, received.to_sec(), header)
    return reader.finish()


def opened(file):
    path = pathlib.Path(file)
    if not path.is_file():
        raise RunError(f"there is no bag {path}; give the file that flight_record.py has written")
    try:
        bag = rosbag.Bag(str(path))
    except rosbag.ROSBagUnindexedException:
        raise RunError(f"{path} was not closed, so its end may be missing; `rosbag reindex {path}` mends what is there") from None
    except (rosbag.ROSBagException, OSError) as error:
        raise RunError(f"{path} cannot be read as a bag: {error}") from None
    if bag.get_message_count() == 0:
        bag.close()
        raise RunError(f"{path} holds no messages; record while the command node runs")
    return bag


def namespace_in(bag, wanted):
    """Where the topic `frames` is, without slashes around it."""
    kinds = bag.get_type_and_topic_info().topics
    found = sorted({parts[0].strip("/") for parts in (split(name) for name in kinds) if parts[1] == topics.FRAMES})
    if wanted is not None and wanted.strip("/") in found:
        return wanted.strip("/")
    if wanted is None and len(found) == 1:
        return found[0]
    if not found:
        raise RunError(f"the bag has no topic {topics.FRAMES}; it has {', '.join(sorted(kinds))}. Record with flight_record.py")
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


def sender_of(header):
    """The node whose connection it is, or ""."""
    sender = header.get("callerid", "")
    return sender.decode("utf-8", "backslashreplace") if isinstance(sender, bytes) else sender


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

    def take(self, topic, message, received, header):
        name = topic.strip("/")
        if self.run.namespace:
            if not name.startswith(self.run.namespace + "/"):
                return
            name = name[len(self.run.namespace) + 1:]
        self.count(name, message, received, header)
        if name in self.takers:
            self.takers[name](message, self.time_of(message, received))
            return
        action, _, what = name.rpartition("/")
        if what in topics.OF_AN_ACTION:
            self.goals.take(action, what, message, self.time_of(message, received), sender_of(header))

    def time_of(self, message, received):
        """When it was; where nobody has written that, when it was recorded."""
        stamp = message.header.stamp.to_sec() if hasattr(message, "header") else 0
        return (stamp or received) - self.run.began

    def count(self, name, message, received, header):
        """roscpp and rospy number what they send: a number that is left out is a message that was lost."""
        if name.rpartition("/")[2] not in COUNTED:
            return
        key = (name, sender_of(header))
        number, before = message.header.seq, self.counts.get(key)
        if before is not None and number > before + 1:
            self.run.losses.append(Loss(name, received - self.run.began, number - before - 1))
        self.counts[key] = number

    def take_frame(self, message, time):
        self.run.frames.append(Frame(time, message.sent, message.channel == message.STATUS, bytes(message.bytes),
                                     message.text, message.meaning))

    def take_joints(self, message, time):
        self.names = self.names or list(message.name)
        if list(message.name) == self.names and len(message.position) == len(self.names):
            self.joints.append((time, message.position, message.velocity))

    def take_tool(self, message, time):
        place = message.pose.position
        self.places.append((time, place.x * MM, place.y * MM, place.z * MM))

    def take_link(self, message, time):
        self.run.links.append((time, message.link_state))

    def take_robot(self, message, time):
        held = ", ".join(word for field, word in HELD if getattr(message, field) == message.TRUE)
        if held != (self.run.states[-1][1] if self.run.states else None):
            self.run.states.append((time, held))

    def take_data(self, message, _):
        self.run.axes[:] = [Axis(a.name, a.lower_limit, a.upper_limit, a.rated_speed) for a in message.axes]
        self.run.identity.update({name: getattr(message, name) for name in IDENTITY if getattr(message, name)})

    def take_planned(self, message, time):
        if message.type not in (LINE_STRIP, LINE_LIST) or len(message.points) < 2:
            return
        points = numpy.array([(p.x, p.y, p.z) for p in message.points]) * MM
        self.run.planned.append((time, points if message.type == LINE_STRIP else chained(points)))

    def take_event(self, message, time):
        self.run.events.append(Event(time, message.severity, message.text))

    def finish(self):
        """The run; without joint states there is nothing to be shown of the robot."""
        if not self.joints:
            raise RunError(f"{self.run.file} has no {topics.JOINTS}: the status stream was not there (status_port 0, or the Ethernet Slave of"
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
