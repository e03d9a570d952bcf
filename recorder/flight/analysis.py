"""All that a report shows, worked out of a run once."""
import dataclasses

from flight import commands, motion, tags, wholeness

# actionlib_msgs/GoalStatus
OUTCOMES = ("PENDING", "ACTIVE", "PREEMPTED", "SUCCEEDED", "ABORTED", "REJECTED", "PREEMPTING", "RECALLING", "RECALLED", "LOST")
OPEN = "still open"


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
