"""A good goal of each block, and how to change it. The arm starts at HOME; none of these leaves its reach."""
from cobot_command.msg import (ChangeBaseGoal, ChangeLoadGoal, ChangeTCPGoal, CheckSequenceGoal, ExitListenNodeGoal, JogGoal, LoadPathGoal,
                               MomentOfInertia, MoveAbsoluteGoal, MoveCircleGoal, MoveRelativeGoal, OutputAction, PathPoint,
                               PickAndPlaceGoal, PickAndPlaceStep, ProgramControlGoal, RetraceGoal, RunScriptGoal, SequenceStep,
                               SetOutputGoal, StopGoal, Transformation, WaitForInputGoal, WaitTimeGoal)

HOME = (0, 0, 90, 0, 90, 0)
ELSEWHERE = (60, -20, 100, 10, 80, -45)
POSE = (400, 100, 500, 180, 0, 60)  # of the tool, in reach by a line from anywhere near HOME
SLOWLY = {"speed": 2, "accel_time": 1000}  # long enough to be interrupted
MODERATELY = {"speed": 3, "accel_time": 300}  # the same, and to be waited for
BUFFERED = MoveAbsoluteGoal.BUFFERED
ABORTING = MoveAbsoluteGoal.ABORTING


def six(values):
    """Missing ones are 0."""
    return Transformation(*values, *[0] * (6 - len(values)))


def with_changes(goal, changes):
    for name, value in changes.items():
        if not hasattr(goal, name):
            raise AttributeError(name)
        setattr(goal, name, value)
    return goal


def to_joints(*degrees, **changes):
    return with_changes(
        MoveAbsoluteGoal(movement_command=MoveAbsoluteGoal.PTP, data_format=MoveAbsoluteGoal.JPP,
                         target_position=six(degrees), speed=80, accel_time=200),
        changes)


def ptp_to(*pose, **changes):
    return with_changes(to_joints(*pose), {"data_format": MoveAbsoluteGoal.CPP, **changes})


def line_to(*pose, **changes):
    return with_changes(
        to_joints(*pose), {"movement_command": MoveAbsoluteGoal.LINE, "data_format": MoveAbsoluteGoal.CAP,
                           "speed": 250, **changes})


def relative(*offset, **changes):
    """A straight line along the base."""
    return with_changes(
        MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
                         target_position=six(offset), speed=250, accel_time=200),
        changes)


def turn(*degrees, **changes):
    """A relative motion of the joints."""
    return with_changes(relative(*degrees), {"movement_command": MoveRelativeGoal.PTP, "speed": 80,
                                             "data_format": MoveRelativeGoal.JPP, **changes})


def step_of_joint(degrees, **changes):
    """A jog by an increment of joint 1, which nobody has to hold."""
    return with_changes(JogGoal(mode=JogGoal.AXES, directions=[1, 0, 0, 0, 0, 0], speed=50, increment_deg=degrees), changes)


def circle(arc, end, **changes):
    return with_changes(
        MoveCircleGoal(data_format=MoveCircleGoal.CAP, arc_point=six(arc), end_point=six(end),
                       speed=250, accel_time=200), changes)


def base(*pose, **changes):
    return with_changes(ChangeBaseGoal(transformation=six(pose)), changes)


def tcp(*pose, **changes):
    return with_changes(ChangeTCPGoal(tcp_offset=six(pose), weight=1.5,
                                      moment_of_inertia=MomentOfInertia(2, 3, 4)), changes)


def script(*lines, **changes):
    return with_changes(RunScriptGoal(script="\n".join(lines)), changes)


def cycle(*steps, **changes):
    return with_changes(PickAndPlaceGoal(steps=list(steps), cycles=1), changes)


def step(move, output=None, dwell=0.0, awaited=None):
    return PickAndPlaceStep(move=move, output=output or OutputAction(), input=awaited or WaitForInputGoal(), dwell=dwell)


def path(*points, **changes):
    """Loads them all."""
    return with_changes(LoadPathGoal(path=list(points), number_of_moves=len(points)), changes)


def path_to_joints(*degrees, **changes):
    """A PTP to a point of a path; quick, so that it takes long only where `changes` say so."""
    return with_changes(PathPoint(joints=[*degrees, 0, 0, 0], speed=90, acceleration=400, deceleration=400), changes)


def path_line(*pose, **changes):
    """A straight way of the flange."""
    return with_changes(
        PathPoint(interpolation_type=PathPoint.CP_LINEAR, target_point_type=PathPoint.CARTESIAN, pose=six(pose),
                  pose_type=PathPoint.FLANGE, ref_frame_type=PathPoint.ROBOT, speed=200, acceleration=1000, deceleration=1000,
                  orientation_speed=90, orientation_acceleration=400, orientation_deceleration=400),
        changes)


def path_of_poses(*poses, **changes):
    """All poses, each reached straight; `changes`: of their template."""
    template = PathPoint(interpolation_type=PathPoint.CP_LINEAR, pose_type=PathPoint.FLANGE, speed=200, acceleration=1000, deceleration=1000,
                         orientation_speed=90, orientation_acceleration=400, orientation_deceleration=400)
    return LoadPathGoal(path=[with_changes(template, changes)], poses=list(poses), number_of_moves=len(poses))


def output(number=0, value=1, **changes):
    return with_changes(SetOutputGoal(module="EndModule", output=number, value=value), changes)


def wait_for(number=0, value=True, timeout=10.0, **changes):
    return with_changes(WaitForInputGoal(module="ControlBox", input=number, value=value, timeout=timeout), changes)


def pause(seconds=0.1, **changes):
    """A time that is waited for."""
    return with_changes(WaitTimeGoal(time=seconds), changes)


def sequence(*goals, **changes):
    """To be checked from HOME; each step is the goal of its block."""
    kinds = {MoveAbsoluteGoal: ("MOVE_ABSOLUTE", "move_absolute"), MoveRelativeGoal: ("MOVE_RELATIVE", "move_relative"),
             MoveCircleGoal: ("MOVE_CIRCLE", "move_circle"), ChangeBaseGoal: ("CHANGE_BASE", "change_base"),
             ChangeTCPGoal: ("CHANGE_TCP", "change_tcp")}
    steps = []
    for goal in goals:
        kind, field = kinds[type(goal)]
        steps.append(SequenceStep(kind=getattr(SequenceStep, kind), **{field: goal}))
    return with_changes(CheckSequenceGoal(steps=steps, start_joints=list(HOME)), changes)


def move_script(speed=80, angle=60, **changes):
    """One motion of all joints as lines of script, waited for."""
    return script(f'PTP("JPP",{angle},-20,100,10,80,-45,{speed},200,0,false)',
                  **{"await_motion": True, **changes})


def motions(**changes):
    """One motion of each block that waits for its end."""
    return [to_joints(*ELSEWHERE, **changes), turn(60, 0, 0, 0, 0, 0, **changes),
            circle((450, 0, 500, 180, 0, 90), POSE, **{**changes, **({"speed": 40} if "speed" in changes else {})}),
            move_script(**{k: v for k, v in changes.items() if k in ("speed", "buffer_mode")})]


def queued(**changes):
    """One goal of each block that may have to wait for its turn."""
    return [to_joints(*HOME, **changes), relative(0, 0, 20, 0, 0, 0, **changes),
            circle((450, 0, 500, 180, 0, 90), POSE, **changes), base(20, 30, 10, 0, 0, 90, **changes),
            tcp(0, 0, 150, 0, 0, 90, **changes), ChangeLoadGoal(weight=1, **changes), output(**changes),
            wait_for(value=False, **changes), pause(**changes), ExitListenNodeGoal(**changes), script("ChangeLoad(1)", **changes),
            cycle(step(to_joints(*HOME)), **changes), path(path_to_joints(*HOME), **changes), RetraceGoal(**changes)]


def commands():
    """One goal of each block that needs a link."""
    return [*queued(), ProgramControlGoal(command=ProgramControlGoal.RESUME), StopGoal()]
