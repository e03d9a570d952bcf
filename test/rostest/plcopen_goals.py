"""The PLCopen rules that goals have to hold, each by itself and all of a round together, and the truth of what succeeded;
doc/plcopen.md numbers them. Times are the stamps of the node's own messages."""
import bisect
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import (LoadPathGoal, MoveAbsoluteGoal, MoveCircleGoal, MoveRelativeGoal, PickAndPlaceGoal, RunScriptGoal,
                               StopGoal)
from load_watch import first_at_or_after
from motion_checks import AS_REPORTED
from plcopen_status import QUEUED_BLOCKS

LOOKED_UP = " while a frame or a file was looked up for this goal, or for one that was received earlier"
CANCELLED_EARLY = ("cancelled by its id before the goal was received", "cancelled before the goal was received",  # the action server says so
                   "cancelled before it was started")  # on its way to the core's thread
TOO_MANY = {0x216, 1000}  # wait, for their turn or for frames and files
MOVES = (MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal)
# For the state of the layer or the robot, not for what the goal says.
NOT_READY = {0x10, 0x11, 0x208, 0x216, 0x220, 0x221, 0x222, 0x225, 0x227, 0x231, 0x242, 1000, 1001, 1002, 1003, 1005, 1006}
FAILED = (GoalStatus.REJECTED, GoalStatus.ABORTED)
WITHDRAWN = (GoalStatus.RECALLED, GoalStatus.PREEMPTED)
QUEUED = 1  # phase
STANDING = 1e-6  # [rad/s]
AROUND = rospy.Duration(0.1)
AT_TARGET = 1e-4  # [rad]


def faults_of(record, table, stream_breaks=False):
    """Of one goal that has ended: (words). `stream_breaks`: the status stream does, so that an end may not know its place."""
    _, state, result = record.end
    faults = list(_end_faults(record, state, result, table)) + list(_verdict_faults(record, state, result))
    faults += _feedback_faults(record)
    if state == GoalStatus.SUCCEEDED:
        faults += _success_faults(record, result, stream_breaks)
    goal = " ".join(str(record.goal).split())
    end = f"{record}, state {state}, 16#{result.error_id:X} '{result.error_description}'"
    return [f"{end}: {fault}; goal: {goal[:3000]}" for fault in faults]


def _end_faults(record, state, result, table):
    if (state in FAILED) != bool(result.error_id):
        yield f"error_id {result.error_id} in state {state}"
    if result.error_id and (record.block, result.error_id) not in table:
        yield "an error that the table of its block does not have"
    if result.error_id and not (result.remedy and result.error_description):
        yield "an error without words or remedy"
    step = getattr(result, "step_error_id", 0)
    if step and ("move_absolute", step) not in table:
        yield f"step_error_id 16#{step:X} is not of move_absolute"


def _verdict_faults(record, state, result):
    """Of goals that are wrong by themselves."""
    if not record.drawn or record.drawn.errors is None:
        return
    if state == GoalStatus.SUCCEEDED:
        yield "succeeded, though it cannot"
    allowed = record.drawn.errors
    if allowed and result.error_id and result.error_id not in allowed | NOT_READY:
        yield f"not the error that it has: {[hex(e) for e in sorted(allowed)]}"
    if allowed and state == GoalStatus.ABORTED and record.block != "pick_and_place":
        yield "was sent to the robot, though it is wrong by itself"


def _feedback_faults(record):
    goal, turn_has_come = record.goal, False
    for _, feedback in record.feedback:
        place = getattr(feedback, "place_in_queue", 0)
        if turn_has_come and place > 0:
            yield "waits again after its turn had come"
        turn_has_come = turn_has_come or place == 0
        if place < 0 or (place > 0 and feedback.phase != QUEUED):
            yield f"place {place} in phase {feedback.phase}"
        if not 0 <= getattr(feedback, "progress", 0) <= 1:
            yield f"progress {feedback.progress}"
        if getattr(goal, "check_only", False) and record.block != "check_sequence":
            yield "is told of as if it ran, though it is only to be checked"
    # Behind another one of its kind a path joins, or waits to: that is no refusal.
    refuses = record.block != "load_path" and getattr(goal, "buffer_mode", None) == 0
    if refuses and any(f.place_in_queue > 1 for _, f in record.feedback):
        yield "REFUSE, and it waits behind another goal"


def _success_faults(record, result, stream_breaks):
    goal = record.goal
    command_id = getattr(goal, "command_id", 0)
    if command_id and not getattr(goal, "check_only", False) and result.command_id_ack != command_id:
        yield f"command_id {command_id} is acknowledged as {result.command_id_ack}"
    if not isinstance(goal, MOVES):
        return
    if goal.check_only:
        if not result.joint_path.points or result.planned_duration.to_sec() < 0:
            yield "checked, and no path is told"
    elif not goal.blending_enable and not (stream_breaks and _place_is_unknown(result)):
        yield from _place_faults(goal, result)


def _place_is_unknown(result):
    return not result.final_joints and not any(_six(result.final_pose))


def _place_faults(goal, result):
    """What the result itself tells of where the robot is."""
    if isinstance(goal, MoveRelativeGoal):
        return
    if isinstance(goal, MoveAbsoluteGoal) and goal.data_format == MoveAbsoluteGoal.JPP:
        wanted, found = _six(goal.target_position), result.final_joints
        if len(found) != 6 or max(abs(a - b) for a, b in zip(wanted, found)) > AS_REPORTED:
            yield f"succeeded at {list(found)}"
        return
    whole = isinstance(goal, MoveAbsoluteGoal) or goal.arc_angle == 0
    target = goal.target_position if isinstance(goal, MoveAbsoluteGoal) else goal.end_point
    framed = (goal.target_pose if isinstance(goal, MoveAbsoluteGoal) else goal.end_pose).header.frame_id
    if whole and not framed and math.dist(_six(target)[:3], _six(result.final_pose)[:3]) > AS_REPORTED:
        yield f"succeeded at {_six(result.final_pose)}"


def _six(t):
    return (t.x, t.y, t.z, t.rx, t.ry, t.rz)


def shown_faults(records, status):
    """R3, R4: each block shows the end of its last goal until it is executed again. To be asked when nothing is under way."""
    last = {}
    for record in sorted(records, key=lambda r: r.end[0]):
        result = record.end[2]
        description = result.error_description
        if description.endswith(LOOKED_UP) or description.startswith(CANCELLED_EARLY) or result.error_id in TOO_MANY:
            continue  # it has not come to its block, or perhaps not
        last[record.block] = record
    for outputs in status.blocks:
        if outputs.block not in last or outputs.busy:
            continue
        _, state, result = last[outputs.block].end
        shown = (outputs.done, outputs.error, outputs.command_aborted, outputs.error_id)
        if shown != (state == GoalStatus.SUCCEEDED, state in FAILED, state in WITHDRAWN, result.error_id):
            yield (f"R4: {outputs.block} shows {shown} behind {last[outputs.block]}, state {state}, 16#{result.error_id:X} "
                   f"'{result.error_description}'")


class Round:
    """All goals of a round, when the last has ended."""

    def __init__(self, records, truth):
        self._records, self._truth = records, truth
        # A set_output that is at_once has no turn; of one that came without an id nobody knows here.
        self._queued = [r for r in records if r.block in QUEUED_BLOCKS and r.results
                        and not (r.block == "set_output" and getattr(r.goal, "at_once", True))]
        self._ends = sorted(r.end[0] for r in self._queued if _begin(r))
        self.compared = 0  # ends that the truth of the simulator could be asked about

    def faults(self):
        return [*self._overlaps(), *self._survivors(), *self._lies()]

    def _overlaps(self):
        """R9: one command at a time is with the controller; but paths that follow each other are one."""
        spans = sorted(((began, r.end[0], r) for r in self._queued if (began := _begin(r))), key=lambda span: span[0])
        for (_, ended, first), (began, _, second) in zip(spans, spans[1:]):
            is_one_path = first.block == second.block == "load_path"
            if began < ended and not is_one_path:
                yield f"R9: {second} began before the end of {first}"

    def _survivors(self):
        """R10: what waits behind a command that fails ends with it."""
        waiting = [(r.feedback[0][0], r) for r in self._queued if r.feedback and r.feedback[0][1].place_in_queue > 0]
        for failed in self._queued:
            stamp, state, _ = failed.end
            if state != GoalStatus.ABORTED:
                continue
            for since, r in waiting:
                if since < stamp < r.end[0]:
                    yield f"R10: {r} waited when {failed} failed, and ended later"

    def _lies(self):
        """Ends that say that the robot stands, or where, against what the simulator itself says."""
        spans = [(self._may_move_from(r), r.end[0]) for r in self._queued if r.end[1] != GoalStatus.REJECTED]
        for record in self._records:
            stamp, state, _ = record.end
            if not _stands(record.goal, state):
                continue
            # The first one behind the end may have been looked up before it, and published late.
            place = first_at_or_after(self._truth, stamp) + 1
            if place >= len(self._truth):
                continue
            seen, joints, fastest = self._truth[place]
            if any(began <= seen and ended > stamp for began, ended in spans):
                continue  # it moves on for another goal
            self.compared += 1
            if fastest > STANDING:
                yield (f"{record} ended in state {state}, and {(seen - stamp).to_sec():.4f} s later the robot moves with "
                       f"{fastest}; {self._around(stamp)}")
            target = _joint_target(record.goal) if state == GoalStatus.SUCCEEDED else None
            if target and max(abs(math.radians(a) - b) for a, b in zip(target, joints)) > AT_TARGET:
                found = [math.degrees(j) for j in joints]
                yield f"{record} succeeded, and the robot is at {found}, not at {target}; {self._around(stamp)}"

    def _may_move_from(self, record):
        """A command is told of behind its script: the robot may move for it as soon as the one in front of it has ended."""
        told = _begin(record)
        if told is None:
            return record.sent
        place = bisect.bisect_right(self._ends, told)
        return max(record.sent, self._ends[place - 1]) if place else record.sent

    def _around(self, stamp):
        """What went on about then, for whoever has to understand a fault."""
        told = []
        for record in self._records:
            begin, end = _begin(record) or record.sent, record.end[0]
            if end > stamp - AROUND and begin < stamp + AROUND:
                span = f"{(begin - stamp).to_sec():.4f}..{(end - stamp).to_sec():.4f} s"
                goal = " ".join(str(record.goal).split())[:300]
                told.append((begin, f"{record}: {span}, state {record.end[1]}, {goal}, "
                                    f"'{record.end[2].error_description}'"))
        return "about then:\n    " + "\n    ".join(text for _, text in sorted(told))


def _begin(record):
    """When it was its turn; None if that never came."""
    if getattr(record.goal, "check_only", False):
        return None
    told = [stamp for stamp, f in record.feedback if getattr(f, "place_in_queue", 0) == 0]
    return min([*told[:1], *([record.accepted] if record.accepted else [])], default=None)


def _stands(goal, state):
    """Whether this end promises that the robot stands."""
    if isinstance(goal, StopGoal):
        return state == GoalStatus.SUCCEEDED
    if getattr(goal, "check_only", False):
        return False
    if isinstance(goal, MOVES):
        return state == GoalStatus.PREEMPTED or (state == GoalStatus.SUCCEEDED and not goal.blending_enable)
    if isinstance(goal, (LoadPathGoal, PickAndPlaceGoal)):
        return state in (GoalStatus.SUCCEEDED, GoalStatus.PREEMPTED)
    return isinstance(goal, RunScriptGoal) and goal.await_motion and state == GoalStatus.SUCCEEDED


def _joint_target(goal):
    if isinstance(goal, MoveAbsoluteGoal) and goal.data_format == MoveAbsoluteGoal.JPP:
        return _six(goal.target_position)
    if isinstance(goal, LoadPathGoal) and goal.path and not goal.path[-1].interpolation_type:
        return list(goal.path[-1].joints[:6])
    if isinstance(goal, PickAndPlaceGoal) and goal.steps:
        return _joint_target(goal.steps[-1].move)
    return None
