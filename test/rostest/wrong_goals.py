"""Goals with one thing wrong, and the error that it has to be refused with."""
import copy
import math

from cobot_command.msg import (ConnectGoal, MoveAbsoluteGoal, MoveCircleGoal, MoveRelativeGoal, OutputAction,
                               LoadPathGoal, PathPoint, PickAndPlaceGoal, RobotPose)
from cobot_goals import (HOME, POSE, base, circle, cycle, line_to, path, path_line, path_of_poses, path_to_joints, ptp_to, script, sequence, step,
                         tcp, to_joints, turn)
from tf_frames import pose_in

INT_MAX, INT_MIN = 2**31 - 1, -2**31
NOT_FINITE = (math.nan, math.inf, -math.inf)
TOO_FAR = (100000.1, -1e6, 1e308, -1.7976931348623157e308)
TINY_AND_HUGE = (-1, INT_MAX, INT_MIN)
# Names that want to be more than a name: of a frame, a base, a tool, a file, an output.
WILD_NAMES = ("a,b", "a*FF", "$TMSCT,4,1,OK,*5C", 'RobotBase")', '") ScriptExit() ("', "ü", "%s%n",
              "../../etc/passwd", " ")
WITH_CONTROLS = ("x\r\nScriptExit()", "a\x00b", "\n", "\x1b[2J")
FAR_TOO_LONG = "a" * 10000
UNREAL_TURNS = ((0, 0, 0, 0), (0, 0, 0, 0.9989), (1e300, 0, 0, 0), (1, 1, 1, 1))
FORMATS = (-1, 9, INT_MAX)


def draw(r, block, good):
    """(goal, its error ids); none: the layer cannot know, it is for the controller to refuse it. `r`: a random.Random."""
    rows = [row for row in _ROWS.get(block, ()) + _SHARED if row.fits(good)]
    row = r.choice(rows)
    return row.make(r, copy.deepcopy(good)), row.errors


class _Row:
    def __init__(self, error, make, fits=lambda good: True):
        self.errors = error if isinstance(error, tuple) else (error,)
        self.make = make
        self.fits = fits


def _field(error, name, *values, fits=lambda good: True):
    """A field of an otherwise good goal."""
    def make(r, good):
        setattr(good, name, r.choice(values))
        return good
    return _Row(error, make, lambda good: hasattr(good, name) and fits(good))


def _coordinate(error, name, values):
    def make(r, good):
        target = getattr(good, name)
        setattr(target, r.choice(target.__slots__), r.choice(values))
        return good
    return _Row(error, make, lambda good: _is_used(good, name))


def _is_used(good, name):
    """Numbers are not looked at where a pose in a frame or a name stands in place of them."""
    poses = [getattr(good, pose, None) for pose in ("target_pose", "base_pose", "arc_pose", "end_pose")]
    frames = [pose.header.frame_id for pose in poses if pose]
    names = [getattr(good, text, "") for text in ("base_name", "tcp_name")]
    return hasattr(good, name) and not any(frames + names)


def _of(error, *makers):
    """Goals that are made anew."""
    return _Row(error, lambda r, good: r.choice(makers)(r))


def _posed(error, makers, names, quaternions=((1, 0, 0, 0),)):
    return _Row(error, lambda r, good: r.choice(makers)(
        pose_in(r.choice(names), (0.4, 0.1, 0.4), r.choice(quaternions))))


def _with_pose(*bits):
    return lambda r: ptp_to(*POSE, robot_pose_enable=True, robot_pose=RobotPose(*bits))


_MOVE_TO = (lambda pose: ptp_to(target_pose=pose), lambda pose: line_to(target_pose=pose))
_CIRCLE_TO = (lambda pose: circle(POSE, POSE, arc_pose=pose), lambda pose: circle(POSE, POSE, end_pose=pose))
_BASE_TO = (lambda pose: base(base_pose=pose),)
_NO_FILES = ("/no/such/file", "package://none/a", "/", *WILD_NAMES, FAR_TOO_LONG, *WITH_CONTROLS)
_NO_FRAMES = ("nowhere", "no/where", FAR_TOO_LONG, *WILD_NAMES, *WITH_CONTROLS)


def _posed_rows(makers):
    return (_posed(0x217, makers, _NO_FRAMES), _posed(0x218, makers, ("base",), UNREAL_TURNS),
            _posed(0x200, makers, ("base",), ((math.nan, 0, 0, 1), (0, math.inf, 0, 1))))


def _with_output(module, number):
    return cycle(step(to_joints(*HOME), OutputAction(module, number, True)))


def _blended(radius, *values):
    changes = {"data_format": MoveAbsoluteGoal.CAR} if radius else {}
    return lambda r: line_to(*POSE, blending_enable=True, blending_value=r.choice(values), **changes)


def _point(error, **fields):
    """Behind a good one, a point with one wrong field."""
    return _of(error, lambda r: path(path_to_joints(*HOME), path_to_joints(*HOME, **{n: r.choice(v) for n, v in fields.items()})))


_SHARED = (_field(0x28, "command_id", -1, 1, 10, 16, INT_MAX, INT_MIN),
           _field(0x215, "buffer_mode", 3, *TINY_AND_HUGE, fits=lambda good: not getattr(good, "at_once", False)),
           _field(0x27, "accel_time", 149, 10000, 0, *TINY_AND_HUGE))

_ROWS = {
    "move_absolute": (
        _of(0x25, lambda r: line_to(*POSE, speed=r.choice((0, 4501, *TINY_AND_HUGE)))),
        _of(0x26, lambda r: to_joints(*HOME, speed=r.choice((0, 101, *TINY_AND_HUGE)))),
        _of(0x29, lambda r: line_to(*POSE, robot_pose_enable=True, robot_pose=RobotPose(0, 2, 4))),
        _of(0x30, _with_pose(2, 2, 4), _with_pose(-1, 2, 4)), _of(0x31, _with_pose(0, 4, 4), _with_pose(1, 0, 5)),
        _of(0x32, _with_pose(0, 2, 3), _with_pose(1, 3, INT_MAX)),
        _of(0x35, lambda r: ptp_to(*POSE, data_format=r.choice((2, 3, 4, *FORMATS)))),
        _of(0x36, lambda r: line_to(*POSE, speed=50, data_format=r.choice((0, 5, *FORMATS)))),
        _coordinate(0x200, "target_position", NOT_FINITE), _coordinate(0x213, "target_position", TOO_FAR),
        _of(0x210, _blended(False, 101, *TINY_AND_HUGE), _blended(True, 2001, *TINY_AND_HUGE)),
        _field(0x211, "movement_command", 2, *TINY_AND_HUGE),
        _of(0x212, lambda r: to_joints(*HOME, robot_pose_enable=True, robot_pose=RobotPose(0, 2, 4))),
        _of(0x219, lambda r: to_joints(*HOME, target_pose=pose_in("base", (0.4, 0.1, 0.5), (1, 0, 0, 0)))),
        *_posed_rows(_MOVE_TO)),
    "move_relative": (
        _of(0x26, lambda r: turn(1, speed=r.choice((0, 101, *TINY_AND_HUGE)))),
        _of(0x30, lambda r: turn(1, data_format=r.choice((2, 3, 4, 6, 7, 8, *FORMATS)))),
        _of(0x31, lambda r: turn(1, movement_command=MoveRelativeGoal.LINE, data_format=r.choice((0, *FORMATS)))),
        _coordinate(0x200, "target_position", NOT_FINITE), _coordinate(0x213, "target_position", TOO_FAR),
        _of(0x210, lambda r: turn(1, blending_enable=True, blending_value=r.choice((101, *TINY_AND_HUGE)))),
        _field(0x211, "movement_command", 2, *TINY_AND_HUGE)),
    "move_circle": (
        _field(0x25, "speed", 0, 4501, *TINY_AND_HUGE),
        _of(0x26, lambda r: circle(HOME, POSE, data_format=MoveCircleGoal.CPP,
                                   speed=r.choice((0, 101, *TINY_AND_HUGE)))),
        _coordinate(0x200, "arc_point", NOT_FINITE), _coordinate(0x213, "end_point", TOO_FAR),
        _field(0x21A, "arc_angle", -0.1, 360.1, 1e308, *NOT_FINITE),
        _of(0x21B, lambda r: circle(HOME, POSE, speed=50, data_format=r.choice((2, *FORMATS)))),
        *_posed_rows(_CIRCLE_TO)),
    "change_base": (
        _coordinate(0x200, "transformation", NOT_FINITE), _coordinate(0x213, "transformation", TOO_FAR),
        _field(0x21F, "base_name", "x" * 256, FAR_TOO_LONG, *WITH_CONTROLS), _field((), "base_name", *WILD_NAMES),
        *_posed_rows(_BASE_TO)),
    "change_tcp": (
        _of(0x25, lambda r: tcp(0, 0, 10, weight=r.choice((-0.1, 14.1, 1e308, *NOT_FINITE)))),
        _coordinate(0x200, "tcp_offset", NOT_FINITE), _coordinate(0x213, "tcp_offset", TOO_FAR),
        _coordinate(0x21D, "moment_of_inertia", (-0.1, 1e10, *NOT_FINITE)),
        _coordinate(0x200, "mass_center", NOT_FINITE),
        _field(0x21F, "tcp_name", "x" * 256, FAR_TOO_LONG, *WITH_CONTROLS), _field((), "tcp_name", *WILD_NAMES)),
    "change_load": (_field(0x261, "weight", -0.1, 14.1, 1e308, *NOT_FINITE),),
    "set_output": (
        _field(0x255, "module", "", *WILD_NAMES, FAR_TOO_LONG), _field(0x255, "output", 16, *TINY_AND_HUGE),
        _field(0x262, "value", 10.1, -10.1, *NOT_FINITE), _field(0x262, "kind", 2, *TINY_AND_HUGE)),
    "wait_for_input": (
        _field(0x263, "module", "", *WILD_NAMES, FAR_TOO_LONG), _field(0x263, "input", 16, *TINY_AND_HUGE),
        _field(0x264, "timeout", -0.1, 86400.1, 1e308, *NOT_FINITE)),
    "wait_time": (_field(0x8D34, "time", -0.1, 86400.1, 1e308, *NOT_FINITE),),
    "run_script": (
        _field(0x21E, "script", "", " \n\t", "x" * 4097, "QueueTag(1)", "x // waitqueuetag", "a\x07b",
               "ScriptExit()\nChangeLoad(1)"),
        _field(0x260, "reply_timeout", -1, 0.049, 3600.1, *NOT_FINITE)),
    "pick_and_place": (
        _of(0x250, lambda r: cycle(), lambda r: cycle(*[step(to_joints(*HOME))] * 51)),
        _of(0x251, lambda r: cycle(step(to_joints(*HOME, speed=0)))),
        # Not found before the cycle begins when nobody knows then where the robot is.
        _of((0x251, 0x252), lambda r: cycle(step(to_joints(*HOME)), step(to_joints(0, 0, 156, 0, 90, 0)))),
        _of(0x253, lambda r: cycle(step(to_joints(*HOME), dwell=r.choice((-0.1, 3600.1, *NOT_FINITE))))),
        _field(0x254, "cycles", 1000001, *TINY_AND_HUGE),
        _of(0x255, lambda r: _with_output(r.choice((*WILD_NAMES, FAR_TOO_LONG)), 0),
            lambda r: _with_output("EndModule", r.choice((4, *TINY_AND_HUGE)))),
        _of(0x256, lambda r: PickAndPlaceGoal(steps_file=r.choice(_NO_FILES), cycles=1)),
        _of(0x258, lambda r: cycle(step(to_joints(*HOME, blending_enable=True), dwell=0.1))),
        _of(0x259, lambda r: cycle(step(to_joints(*HOME, exit_node=True)), cycles=0))),
    "load_path": (
        _of(1010, lambda r: path(path_to_joints(*HOME), number_of_moves=r.choice((0, 2, *TINY_AND_HUGE))), lambda r: LoadPathGoal(),
            lambda r: path(*[PathPoint()] * 1001)),
        _of(1012, lambda r: path(path_to_joints(*HOME), start_index=r.choice((1, *TINY_AND_HUGE)))),
        _point(1013, speed=(-1, *NOT_FINITE)), _point(1014, acceleration_jerk=(-0.1, 100.1, *NOT_FINITE)),
        _point(1017, move_type=(2, 255)), _point(1018, target_point_type=(3, 255)), _point(1024, termination_type=(1, 255)),
        _point(1025, profile_type=(4, 255)), _point(1026, robot_configuration=(16, 255)),
        _of(1022, lambda r: path(path_to_joints(*HOME, termination_type=6, command_tolerance=r.choice((-0.1, *NOT_FINITE))))),
        _of(1023, lambda r: path(path_to_joints(*HOME, termination_type=6, command_tolerance=100.1))),
        _of(1015, lambda r: path(path_line(*POSE, orientation_speed=0))),
        _of((1033, 1037), lambda r: path(path_to_joints(*HOME), path_to_joints(r.choice((300, *NOT_FINITE, *TOO_FAR)), 0, 90, 0, 90, 0))),
        _field(0x275, "execution", 3, 255), _field(0x278, "max_deviation", -0.1, 1e308, *NOT_FINITE),
        _of(0x279, lambda r: LoadPathGoal(path_file=r.choice(_NO_FILES), number_of_moves=1)),
        _of(0x27A, lambda r: path(*[PathPoint()] * r.choice((0, 2)), poses=[pose_in("", (0.4, 0, 0.4), (1, 0, 0, 0))]),
            lambda r: path_of_poses(pose_in("", (0.4, 0, 0.4), (1, 0, 0, 0)), move_type=PathPoint.INCREMENTAL)),
        _of(1037, lambda r: path_of_poses(pose_in("", (0.4, 0, 0.4), r.choice(UNREAL_TURNS))),
            lambda r: path_of_poses(pose_in("", (r.choice(NOT_FINITE), 0, 0.4), (1, 0, 0, 0)))),
        _of(1040, lambda r: path_of_poses(pose_in(r.choice(_NO_FRAMES), (0.4, 0, 0.4), (1, 0, 0, 0))))),
    "check_sequence": (
        _of(0x208, lambda r: sequence(to_joints(*HOME), start_joints=r.choice(([0, 0, 90], [0] * 7, [math.nan] * 6)))),
        _of(0x250, lambda r: sequence(), lambda r: sequence(*[to_joints(*HOME)] * 201)),
        _of(0x251, lambda r: sequence(to_joints(*HOME), to_joints(*HOME, accel_time=0)),
            lambda r: sequence(ptp_to(*NOT_FINITE)))),
    "program_control": (_field(0x21C, "command", 2, *TINY_AND_HUGE),),
    "connect": (
        _of(0x15, lambda r: _connect(timeout=r.choice((0, 9.9, 300.1, -1, 1e308, *NOT_FINITE)))),
        _of(0x240, lambda r: _connect(host=r.choice(("", "a b", "ü", "x" * 256, *WITH_CONTROLS, FAR_TOO_LONG)))),
        _of(0x241, lambda r: _connect(port=r.choice((65536, *TINY_AND_HUGE))),
            lambda r: _connect(status_port=INT_MIN))),
}


def _connect(**changes):
    return ConnectGoal(**{"host": "127.0.0.1", "port": 1, "status_port": 1, "timeout": 10, **changes})
