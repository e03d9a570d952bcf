"""All that a report shows, worked out of a run once."""
import dataclasses

from flight import commands, motion, tags, wholeness

# actionlib_msgs/GoalStatus
OUTCOMES = ("PENDING", "ACTIVE", "PREEMPTED", "SUCCEEDED", "ABORTED", "REJECTED", "PREEMPTING", "RECALLING", "RECALLED", "LOST")
OPEN = "still open"
SHORTEST = 1.0  # [s] of a picture
# How a goal can end, as doc/architecture.md has the words: what was refused has not begun, what was stopped somebody wanted to end.
SUCCEEDED, REFUSED, STOPPED, FAILED = "succeeded", "refused", "stopped", "failed"
KINDS = {"SUCCEEDED": SUCCEEDED, "REJECTED": REFUSED, "PREEMPTED": STOPPED, "RECALLED": STOPPED, "ABORTED": FAILED, "LOST": FAILED}


@dataclasses.dataclass
class Analysis:
    run: object
    tags: list
    commands: list
    uses: list  # of the joints
    deviation: object  # [mm] of the TCP from the planned paths; None: nothing was planned
    faults: list  # of the recording
    remarks: list
    verdicts: list = dataclasses.field(default_factory=list)  # of the replays

    @property
    def is_good(self):
        """The recording is whole, and each replay agrees."""
        return not self.faults and all(verdict.agrees for verdict in self.verdicts)

    @property
    def span(self):
        """(begin, end) of what the pictures show: all motion, when goals were sent and when one ended otherwise than by success, with a second
        around it; the whole run when nothing has moved."""
        moved = motion.motion_span(self.run)
        if not moved:
            return 0.0, max(self.run.duration, SHORTEST)
        ends = [goal.end.time for goal in self.run.goals if kind_of(goal) in (REFUSED, STOPPED, FAILED)]
        times = [*moved, *(goal.begun for goal in self.run.goals), *ends]
        return max(0.0, min(times) - 1), min(self.run.duration, max(times) + 1)

    @property
    def title(self):
        robot = self.run.identity.get("controller_model") or self.run.identity.get("model") or "a robot"
        return f"{robot}{' in /' + self.run.namespace if self.run.namespace else ''}"


def analyse(run, verdicts=()):
    """The Analysis of a run, with what its replays have found."""
    queued = tags.tags_in(run.script_frames)
    remarks = wholeness.remarks(run) + [remark for verdict in verdicts for remark in verdict.remarks]
    return Analysis(run, queued, commands.commands_of(run, queued), motion.joint_uses(run), motion.deviation(run),
                    wholeness.faults(run), remarks, list(verdicts))


def outcome_of(goal):
    """In a word."""
    if goal.end is None:
        return OPEN
    return OUTCOMES[goal.end.status] if goal.end.status < len(OUTCOMES) else str(goal.end.status)


def kind_of(goal):
    """SUCCEEDED, REFUSED, STOPPED or FAILED; OPEN where it has no end."""
    return KINDS.get(outcome_of(goal), OPEN)


def count_of(run, kind):
    """How many goals have ended so."""
    return sum(kind_of(goal) == kind for goal in run.goals)
