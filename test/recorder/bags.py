"""Makes bags as the recorder writes them. Needs no master."""
import collections
import math
import pathlib
import sys

import genpy
import rosbag
from actionlib_msgs.msg import GoalID, GoalStatus
from geometry_msgs.msg import Point, PoseStamped
from sensor_msgs.msg import JointState
from visualization_msgs.msg import Marker

import cobot_command.msg as messages
from cobot_command.msg import CommandStatus, FrameTrace, RobotAxis, RobotData, RobotStatus

SOURCES = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCES / "recorder"))

BEGAN = 1_700_000_000.0  # [s]
NAMES = ["shoulder_1_joint", "shoulder_2_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"]
HOME = [0, 0, 90, 0, 90, 0]
LIMITS = [(-270, 270, 180), (-180, 180, 180), (-155, 155, 180), (-180, 180, 225), (-180, 180, 225), (-270, 270, 225)]
NODE = "/command_node"
QUESTION = (b"$TMSTA,2,00,*41\r\n", "in a Listen node?")
ANSWER = (b"$TMSTA,15,00,true,Listen1,*79\r\n", "in a Listen node: Listen1")


def encoded(header, data):
    body = f"{header},{len(data)},{data},".encode()
    check = 0
    for byte in body:
        check ^= byte
    return b"$" + body + b"*%02X\r\n" % check


class BagMaker:
    """Writes one bag, for a `with`. Times are in seconds since it begins."""

    def __init__(self, file, namespace=""):
        self.namespace = f"/{namespace}/" if namespace else ""
        self.bag = rosbag.Bag(str(file), "w")
        self.numbers = collections.Counter()
        self.clock = 0  # [s] by which the stamps are later than the recording
        self.sender = NODE  # of feedback and results; None: the bag does not say

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.bag.close()

    def write(self, topic, message, time, sender=None):
        stamp = genpy.Time.from_sec(BEGAN + time)
        if hasattr(message, "header"):
            message.header.stamp = genpy.Time.from_sec(BEGAN + time + self.clock)
            message.header.seq = self.numbers[topic]
            self.numbers[topic] += 1
        name = self.namespace + topic
        header = {"topic": name, "type": message._type, "md5sum": message._md5sum, "message_definition": message._full_text}
        self.bag.write(name, message, stamp, connection_header={**header, "callerid": sender} if sender else header)

    def lose(self, topic, count):
        """So many messages that were sent, and did not come."""
        self.numbers[topic] += count

    def frame(self, time, sent, data, meaning, text=None, topic="frames"):
        shown = data.decode("latin-1").replace("\r", "\\r").replace("\n", "\\n") if text is None else text
        channel = FrameTrace.SCRIPT if topic == "frames" else FrameTrace.STATUS
        self.write(topic, FrameTrace(channel=channel, sent=sent, bytes=data, text=shown, meaning=meaning), time)

    def send(self, time, data, meaning):
        self.frame(time, True, data, meaning)

    def receive(self, time, data, meaning):
        self.frame(time, False, data, meaning)

    def question(self, time):
        """The lifesign, and its answer."""
        self.send(time, *QUESTION)
        self.receive(time + 0.001, *ANSWER)

    def script(self, time, identity, lines, reply="OK"):
        """A script of one line or more, and its reply 1 ms later."""
        text = "\r\n".join(lines)
        more = len(lines) - 1
        behind = f" (and {more} more line{'s' if more > 1 else ''})" if more else ""
        self.send(time, encoded("TMSCT", f"{identity},{text}"), f"run script {identity}: {lines[0]}{behind}")
        wrong = reply.partition(";")[2].replace(";", ", ")
        self.receive(time + 0.001, encoded("TMSCT", f"{identity},{reply}"),
                     f"script {identity} accepted" if reply == "OK" else f"script {identity} refused, errors in line {wrong}")

    def tag(self, time, number, state="true"):
        self.receive(time, encoded("TMSTA", f"01,{number:02},{state}"), f"tag {number} {'complete' if state == 'true' else 'not complete'}")

    def joints(self, time, angles=HOME, speeds=(0,) * 6):
        self.write("joint_states", JointState(name=NAMES, position=[math.radians(a) for a in angles], velocity=[math.radians(s) for s in speeds]),
                   time)

    def tool(self, time, x, y, z):
        message = PoseStamped()
        message.pose.position = Point(x / 1000, y / 1000, z / 1000)
        self.write("tool_pose", message, time)

    def planned(self, time, *places):
        self.write("planned_path", Marker(type=Marker.LINE_STRIP, points=[Point(*(v / 1000 for v in place)) for place in places]), time)

    def data(self, time=0.0, limits=LIMITS, **changes):
        axes = [RobotAxis(name, *of_joint) for name, of_joint in zip(NAMES, limits)]
        self.write("robot_data", RobotData(model="tm5-900", tmflow_version="1.80", axes=axes, **changes), time)

    def link(self, time, state=CommandStatus.READY):
        self.write("command_status", CommandStatus(link_state=state), time)

    def state(self, time, **changes):
        self.write("robot_status", RobotStatus(**changes), time)

    def goal(self, time, action, identity="goal", **fields):
        kind = kind_of(action)
        message = getattr(messages, f"{kind}ActionGoal")(goal=getattr(messages, f"{kind}Goal")(**fields))
        message.goal_id = GoalID(genpy.Time.from_sec(BEGAN + time), identity)
        self.write(f"{action}/goal", message, time)

    def feedback(self, time, action, identity="goal", **fields):
        self.of_goal(time, action, identity, "Feedback", GoalStatus.ACTIVE, fields)

    def result(self, time, action, identity="goal", status=GoalStatus.SUCCEEDED, **fields):
        self.of_goal(time, action, identity, "Result", status, fields)

    def of_goal(self, time, action, identity, what, status, fields):
        """`given`, of the fields: when the server has got the goal."""
        given = fields.pop("given", None)
        stamp = genpy.Time() if given is None else genpy.Time.from_sec(BEGAN + given)
        kind = kind_of(action)
        content = getattr(messages, f"{kind}{what}")(**fields)
        message = getattr(messages, f"{kind}Action{what}")(**{what.lower(): content})
        message.status = GoalStatus(goal_id=GoalID(stamp, identity), status=status)
        self.write(f"{action}/{what.lower()}", message, time, self.sender)


def kind_of(action):
    return {"change_tcp": "ChangeTCP"}.get(action) or action.title().replace("_", "")


def duration(seconds):
    return genpy.Duration.from_sec(seconds)


def write_short_run(maker, reply="OK"):
    """A link, and one PTP of 45 deg of the first joint that its simulator makes as well; the bag ends when it is done."""
    maker.data()
    maker.joints(0.0)
    maker.link(0.1)
    maker.question(0.1)
    maker.goal(0.2, "move_absolute")
    maker.script(0.3, "1", ['PTP("JPP",45,0,90,0,90,0,50,200,0,false)', "QueueTag(3,0)"], reply)
    for step in range(21):
        time, share = 0.3 + 0.05 * step, step / 20
        maker.joints(time, [45 * share, *HOME[1:]], [45, 0, 0, 0, 0, 0])
        maker.tool(time, 500 * math.cos(share * math.pi / 4), 500 * math.sin(share * math.pi / 4), 300)
    maker.planned(0.3, *[(500 * math.cos(a / 20 * math.pi / 4), 500 * math.sin(a / 20 * math.pi / 4), 300) for a in range(21)])
    maker.tag(1.3, 3)
    maker.result(1.31, "move_absolute", planned_duration=duration(1.1), actual_duration=duration(1.0), command_id_ack=3)
