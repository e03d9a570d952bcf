"""Watches what a command node says of its goals and of itself while others send it goals: every message.

Messages of one topic come in their order. Between topics only their stamps tell it; the node stamps them as it publishes
them.
"""
import bisect
import collections
import threading
import time

import rospy
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from sensor_msgs.msg import JointState

import cobot_command.msg
from cobot_command.msg import CommandStatus
from load_clients import BLOCKS, action_kind

NAMED_BY_SERVER = "/command_node-"
TERMINAL = {GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.REJECTED, GoalStatus.RECALLED}
# What may follow a state in the status of an action, steps between may be missing; a terminal state is the last.
_FOLLOWERS = {GoalStatus.PENDING: TERMINAL | {GoalStatus.ACTIVE, GoalStatus.RECALLING, GoalStatus.PREEMPTING},
              GoalStatus.ACTIVE: (TERMINAL - {GoalStatus.REJECTED, GoalStatus.RECALLED}) | {GoalStatus.PREEMPTING},
              GoalStatus.RECALLING: TERMINAL | {GoalStatus.PREEMPTING},
              GoalStatus.PREEMPTING: {GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED}}


class Record:
    """One goal, with all that was said of it."""

    def __init__(self, goal_id, block, drawn):
        self.goal_id, self.block, self.drawn = goal_id, block, drawn
        self.sent = rospy.Time.now()
        self.waited_since = time.monotonic()
        self.state = None  # as the status topic told it last
        self.accepted = None  # the stamp of the first status that told so
        self.results = []  # (stamp, state, result)
        self.feedback = []  # (stamp, feedback)

    @property
    def goal(self):
        return self.drawn.goal if self.drawn else None

    @property
    def end(self):
        """(stamp, state, result) of its only result."""
        return self.results[0]

    def __str__(self):
        return f"{self.block} {self.goal_id}"


class Watch:
    def __init__(self, rules):
        """`rules`: what is to be held against each command_status, as status_rules.StatusRules."""
        self._changed = threading.Condition()
        self._rules = rules
        self._records, self._older = {}, {}  # of this round, and of the one before
        self._nameless = collections.Counter()
        self.faults, self.counts = [], collections.Counter()
        self.ends, self.errors = collections.Counter(), collections.Counter()  # by state; by block and error id
        self._listed = collections.defaultdict(list)
        self.longest_list = 0  # of states, in one message
        self.last_status = None
        self.truth = []  # (stamp, positions, fastest joint), of the simulator itself
        self._subscribers = [
            rospy.Subscriber("command_status", CommandStatus, self._take_status, queue_size=None),
            rospy.Subscriber("simulated_controller/joint_states", JointState, self._take_truth, queue_size=None)]
        for block in BLOCKS:
            self._subscribe(block, "status", GoalStatusArray, self._take_states)
            self._subscribe(block, "feedback", self._kind(block, "ActionFeedback"), self._take_feedback)
            self._subscribe(block, "result", self._kind(block, "ActionResult"), self._take_result)

    @staticmethod
    def _kind(block, part):
        return getattr(cobot_command.msg, action_kind(block) + part)

    def _subscribe(self, block, topic, kind, take):
        self._subscribers.append(rospy.Subscriber(f"{block}/{topic}", kind, take, callback_args=block, queue_size=None,
                                                  buff_size=2**22))

    def hears_all(self):
        return all(s.get_num_connections() for s in self._subscribers) and self.last_status and self.truth

    # --- For those who send goals.
    def expect(self, goal_id, block, drawn):
        with self._changed:
            self._records[goal_id] = Record(goal_id, block, drawn)
            self.counts["goals"] += 1

    def expect_nameless(self, block):
        with self._changed:
            self._nameless[block] += 1
            self.counts["goals without a name"] += 1

    def has_ended(self, goal_id):
        with self._changed:
            record = self._known(goal_id)
            return record is None or bool(record.results)

    def end_of(self, goal_id):
        """When that was; zero as long as it has none."""
        with self._changed:
            record = self._records.get(goal_id)
            return record.end[0] if record and record.results else rospy.Time()

    def state_of(self, goal_id):
        """Its end; None as long as it has none."""
        with self._changed:
            record = self._known(goal_id)
            return record.end[1] if record and record.results else None

    def listed(self, block):
        """The ids in the last status of the action."""
        with self._changed:
            return self._listed[block]

    def note(self, what):
        with self._changed:
            self.counts[what] += 1

    def complain(self, text):
        with self._changed:
            self.faults.append(text)

    def wait_for_change(self, seconds):
        with self._changed:
            self._changed.wait(seconds)

    def wait_for(self, condition, seconds):
        with self._changed:
            return self._changed.wait_for(condition, seconds)

    # --- Rounds.
    def without_end(self):
        with self._changed:
            named = [str(r) for r in self._records.values() if not r.results]
            nameless = self._nameless.items()
            return named + [f"{block}: {count} goals without a name" for block, count in nameless if count]

    def take_round(self):
        """(records, truth) of all goals since the last call; all of them have to have ended."""
        with self._changed:
            self._older, self._records = self._records, {}
            truth, self.truth = self.truth, self.truth[-1:]
            # A connect goal goes on as long as its link does.
            self._records = {r.goal_id: r for r in self._older.values() if r.block == "connect" and not r.results}
            self._nameless.clear()
            return list(self._older.values()), truth

    def take_faults(self):
        with self._changed:
            faults, self.faults = self.faults, []
            return faults

    # --- What the node says.
    def _take_status(self, message):
        with self._changed:
            self.faults += self._rules.check(message)
            self.counts["command_status"] += 1
            self.last_status = message
            self._changed.notify_all()

    def _take_truth(self, message):
        with self._changed:
            self.truth.append((message.header.stamp, message.position, max(abs(v) for v in message.velocity)))
            if len(self.truth) == 1:
                self._changed.notify_all()

    def _known(self, goal_id):
        return self._records.get(goal_id) or self._older.get(goal_id)

    def _record(self, goal_id, block):
        """None for a goal that nobody sent. One without a name is known as soon as something is said of the name it got."""
        record = self._known(goal_id)
        if record is None and goal_id.startswith(NAMED_BY_SERVER) and self._nameless[block] > 0:
            self._nameless[block] -= 1
            record = self._records[goal_id] = Record(goal_id, block, None)
        return record

    def _take_states(self, message, block):
        with self._changed:
            self.longest_list = max(self.longest_list, len(message.status_list))
            ids = [s.goal_id.id for s in message.status_list]
            self._listed[block] = ids
            self._changed.notify_all()
            if len(set(ids)) != len(ids):
                self.faults.append(f"{block}/status lists a goal twice: {ids}")
            for status in message.status_list:
                if record := self._known(status.goal_id.id):
                    self._take_state(record, status.status, message.header.stamp)

    def _take_state(self, record, state, stamp):
        before, record.state = record.state, state
        if record.accepted is None and state in (GoalStatus.ACTIVE, GoalStatus.PREEMPTING):
            record.accepted = stamp
        if before in (None, state) or state in _FOLLOWERS.get(before, ()):
            return
        # A cancel of a goal that actionlib has forgotten is kept for a while, in case that the goal comes.
        if not (state == GoalStatus.RECALLING and before in TERMINAL):
            self.faults.append(f"{record} went from state {before} to {state}")

    def _take_feedback(self, message, block):
        with self._changed:
            self.counts["feedback"] += 1
            record = self._record(message.status.goal_id.id, block)
            if record is None:
                self.faults.append(f"{block}/feedback of a goal that nobody sent: {message.status.goal_id.id}")
                return
            record.feedback.append((message.header.stamp, message.feedback))
            if record.results and message.header.stamp > record.end[0]:
                self.faults.append(f"{record} has feedback behind its result")

    def _take_result(self, message, block):
        with self._changed:
            self._changed.notify_all()
            state = message.status.status
            record = self._record(message.status.goal_id.id, block)
            self.ends[state] += 1
            self.errors[block, message.result.error_id] += 1
            if state not in TERMINAL:
                self.faults.append(f"{block}/result of {message.status.goal_id.id} in state {state}")
            if record is None:
                self.faults.append(f"{block}/result of a goal that nobody sent: {message.status.goal_id.id}")
                return
            record.results.append((message.header.stamp, state, message.result))
            if record.block != block or len(record.results) > 1:
                self.faults.append(f"{record} has result {len(record.results)}, on {block}: {message.result}")
            if any(stamp > message.header.stamp for stamp, _ in record.feedback):
                self.faults.append(f"{record} has feedback behind its result")


def first_at_or_after(samples, stamp):
    """The index in samples of (stamp, ...)."""
    return bisect.bisect_left(samples, stamp, key=lambda sample: sample[0])
