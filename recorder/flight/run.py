"""A recorded run as values. Times are in seconds since the bag begins; mm, degrees, as on the actions."""
import dataclasses
import typing

import numpy


class RunError(Exception):
    """A bag that cannot be used: what was found, what is needed, and what to do."""


@dataclasses.dataclass(frozen=True)
class Frame:
    """One frame on the wire, or what came in place of one."""
    time: float
    sent: bool
    of_status_port: bool
    data: bytes
    text: str
    meaning: str

    @property
    def refused(self):
        """It came and could not be read."""
        return self.meaning.startswith(("not understood: ", "not a frame: "))


@dataclasses.dataclass
class Joints:
    """Angles and speeds of N moments: arrays of N, and of N x joints."""
    names: list
    times: numpy.ndarray
    angles: numpy.ndarray  # [deg]
    speeds: numpy.ndarray  # [deg/s]


@dataclasses.dataclass
class ToolTrack:
    """The place of the TCP in the robot base."""
    times: numpy.ndarray
    places: numpy.ndarray  # N x 3 [mm]


@dataclasses.dataclass(frozen=True)
class Axis:
    """What a joint may do [deg, deg/s]."""
    name: str
    lower: float
    upper: float
    rated_speed: float


@dataclasses.dataclass(frozen=True)
class End:
    """How a goal has ended. `status` is a number of actionlib_msgs/GoalStatus."""
    time: float
    status: int
    text: str
    result: typing.Any


@dataclasses.dataclass
class Goal:
    """All that was recorded of one goal of an action. `message` is None where nobody heard it."""
    action: str
    identity: str
    begun: float
    message: typing.Any = None
    feedback: list = dataclasses.field(default_factory=list)  # (time, message)
    cancelled: list = dataclasses.field(default_factory=list)  # times
    end: typing.Optional[End] = None


@dataclasses.dataclass(frozen=True)
class Loss:
    """Messages of a topic that were sent, as their numbers say, and are not in the bag."""
    topic: str
    time: float
    count: int


@dataclasses.dataclass(frozen=True)
class Event:
    """A message for people (msg/Message.msg)."""
    time: float
    severity: int
    text: str


@dataclasses.dataclass
class Run:
    """A bag that was read."""
    file: str
    namespace: str
    began: float  # [s] since 1970
    duration: float
    joints: Joints
    tool: ToolTrack
    frames: list = dataclasses.field(default_factory=list)
    goals: list = dataclasses.field(default_factory=list)
    axes: list = dataclasses.field(default_factory=list)
    identity: dict = dataclasses.field(default_factory=dict)  # what the robot is: model, serial number ...
    planned: list = dataclasses.field(default_factory=list)  # (time, N x 3 [mm]; a row of nan: the line ends, and another begins)
    states: list = dataclasses.field(default_factory=list)  # (time, why the robot is held or failed, or "")
    links: list = dataclasses.field(default_factory=list)  # (time, link_state of command_status)
    events: list = dataclasses.field(default_factory=list)
    losses: list = dataclasses.field(default_factory=list)
    unusable: dict = dataclasses.field(default_factory=dict)  # topic: messages whose numbers are none, or beyond all reason
    far_stamps: int = 0  # messages whose stamps are of another time than that of their recording

    @property
    def script_frames(self):
        return [frame for frame in self.frames if not frame.of_status_port]
