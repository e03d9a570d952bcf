"""How long each command was to take, and took: of the results of goals, of the steps of cycles and of the points of paths."""
import dataclasses
import typing

from flight.run import Goal
from flight.tags import DONE

CYCLE = "pick_and_place"
SUCCEEDED = 3  # actionlib_msgs/GoalStatus


@dataclasses.dataclass(frozen=True)
class Command:
    """One motion or one goal [s]. `part_of` is the identity of the goal that it is a part of; empty: it is the goal."""
    label: str
    planned: float
    actual: float
    tag: int = 0
    part_of: str = ""

    @property
    def later(self):
        return self.actual - self.planned


def commands_of(run, tags):
    """In the order of the goals; what a goal consists of stands before its whole."""
    found = []
    for goal in run.goals:
        found += steps_of(goal, tags) + points_of(goal)
        whole = whole_of(goal, tags)
        # What was stopped says nothing about its plan.
        found += [whole] if whole and goal.end.status == SUCCEEDED else []
    return found


def whole_of(goal, tags) -> typing.Optional[Command]:
    """What its result says. A blended one succeeds with its acceptance: its motion is told by its tag alone."""
    result = goal.end.result if goal.end else None
    planned, actual = seconds(result, "planned_duration"), seconds(result, "actual_duration")
    number = getattr(result, "command_id_ack", 0) or 0
    if getattr(goal.message, "blending_enable", False):
        tag = tag_of(number, goal.begun, tags)
        actual = time_of(tag) if tag else 0.0
    if planned <= 0 or actual <= 0:
        return None  # checked only, refused, or not planned
    cycles = max(1, getattr(result, "cycles_done", 1))
    of_all = "" if cycles == 1 else f", {cycles} cycles"
    return Command(f"{goal.action}{of_all}", planned * cycles, actual, number)


def steps_of(goal: Goal, tags):
    """The moves of a cycle, as its feedback names them; how long they took is told by their tags."""
    found, last = [], None
    if goal.action != CYCLE:
        return found
    for time, feedback in goal.feedback:
        key = (feedback.cycle, feedback.step, feedback.command_id_ack)
        planned = feedback.planned_duration.to_sec()
        if feedback.command_id_ack <= 0 or planned <= 0 or key == last:
            continue
        last = key
        tag = tag_of(feedback.command_id_ack, time, tags)
        if tag and tag.outcome == DONE:
            found.append(Command(f"cycle {feedback.cycle}, step {feedback.step + 1}: {tag.motion}", planned, time_of(tag),
                                 tag.number, goal.identity))
    return found


def points_of(goal):
    """Of a path: from the end of the point before to its own, as it was planned and as it was seen."""
    result = goal.end.result if goal.end else None
    if goal.action != "load_path" or result is None:
        return []
    found, planned_before, done_before = [], 0.0, 0.0
    for index, point in enumerate(result.points):
        ends, done = (point.start + point.duration).to_sec(), point.done.to_sec()
        if done <= 0 or ends <= planned_before:
            continue
        found.append(Command(f"path, point {index}", ends - planned_before, done - done_before, 0, goal.identity))
        planned_before, done_before = ends, done
    return found


def tag_of(number, time, tags):
    """The tag of that number whose script was sent next to the time: numbers are used again and again."""
    same = [tag for tag in tags if tag.number == number]
    return min(same, key=lambda tag: abs(tag.sent - time), default=None)


def time_of(tag):
    """From its acceptance, or from the end of the motion in front of it, to its own end [s]; 0: not known."""
    return 0.0 if tag.end is None else tag.end - tag.begun


def seconds(message, field):
    duration = getattr(message, field, None)
    return duration.to_sec() if duration is not None else 0.0


def error_of(goal):
    """(number, words) of what has gone wrong; ("", ...) when nothing has."""
    result = goal.end.result if goal.end else None
    identity = getattr(result, "error_id", 0)
    if not identity:
        return "", getattr(result, "error_description", "") or ""
    # The ids of load_path from 1000 on are its manual's, which are decimal (doc/errors.md).
    is_decimal = goal.action == "load_path" and identity >= 1000
    number = str(identity) if is_decimal else f"16#{identity:X}"
    return number, f"{result.error_description} → {result.remedy}" if result.remedy else result.error_description


def target_of(goal):
    """What the goal wanted, in few words."""
    message = goal.message
    if message is None:
        return "(not recorded)"
    words = ["check only"] if getattr(message, "check_only", False) else []
    kind = ("PTP " if message.movement_command == message.PTP else "Line ") if hasattr(message, "movement_command") else ""
    for name in ("target_position", "end_point", "tcp_offset", "transformation"):
        values = getattr(message, name, None)
        numbers = [getattr(values, axis, 0) for axis in ("x", "y", "z", "rx", "ry", "rz")]
        if any(numbers):
            words.append(kind + ", ".join(f"{number:g}" for number in numbers))
    for name in ("steps_file", "path_file", "host", "base_name", "tcp_name"):
        if getattr(message, name, ""):
            words.append(str(getattr(message, name)).replace("package://", ""))
    for name in ("cycles", "number_of_moves"):
        if getattr(message, name, 0):
            words.append(f"{name.replace('_', ' ')} {getattr(message, name)}")
    return "; ".join(words)
