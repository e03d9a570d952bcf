"""Clients of all actions that speak actionlib by its bare topics, so that nothing is hidden by a client library: several
at once, each with random goals of its own, random cancels at random times, and resumes that they owe. One more keeps the
link, and now and then does not."""
import heapq
import itertools
import random
import threading
import time
import warnings

import rospy
from actionlib_msgs.msg import GoalID

import cobot_command.msg
import provoked_errors
from cobot_command.msg import CommandStatus, ConnectGoal, ProgramControlGoal
from random_goals import RandomGoals

BLOCKS = ("connect", "move_absolute", "move_relative", "move_circle", "change_base", "change_tcp", "change_load",
          "set_output", "wait_for_input", "wait_time", "program_control", "stop", "exit_listen_node", "run_script", "check_sequence", "pick_and_place",
          "load_path")
PATIENCE = 8.0  # [s], then a goal is cancelled whatever it does
OPERATOR_COMES = 1.0  # [s] after the flow has left the Listen node
AN_HOUR = rospy.Duration(3600)


def action_kind(block):
    return {"change_tcp": "ChangeTCP"}.get(block) or block.title().replace("_", "")


class Publishers:
    """Of goals and cancels; shared, as the node at the other end cannot tell. What they have sent is in its socket."""

    def __init__(self):
        with warnings.catch_warnings():
            # rospy wants another size, for senders that a slow subscriber must not hold up.
            warnings.simplefilter("ignore", SyntaxWarning)
            self.goal = {b: rospy.Publisher(f"{b}/goal", self._kind(b), queue_size=None) for b in BLOCKS}
            self.cancel = {b: rospy.Publisher(f"{b}/cancel", GoalID, queue_size=None) for b in BLOCKS}

    @staticmethod
    def _kind(block):
        return getattr(cobot_command.msg, f"{action_kind(block)}ActionGoal")

    def are_heard(self):
        return all(p.get_num_connections() for p in (*self.goal.values(), *self.cancel.values()))

    def send(self, block, goal, goal_id):
        message = self._kind(block)(goal=goal, goal_id=goal_id)
        message.header.stamp = rospy.Time.now()
        self.goal[block].publish(message)


def _is_lull(now):
    """All clients are quiet together for a moment, again and again: the truth can be asked where nothing follows at once."""
    return now % 0.6 < 0.25


class Client(threading.Thread):
    """Sends `share` random goals, and comes to its end when all of them have. What it does depends on its seed alone, when it
    does so on the layer too."""

    def __init__(self, name, seed, share, publishers, watch):
        super().__init__(name=name, daemon=True)
        self._goals = RandomGoals(f"{seed} {name} goals")
        self._random = random.Random(f"{seed} {name} manners")
        self._share, self._publishers, self._watch = share, publishers, watch
        self._numbers = itertools.count(1)
        self._due = []  # heap of (time, number, what to do then, whether it is owed)
        self._open = {}  # goal id: block
        self.has_sent_all = threading.Event()  # or ended

    def run(self):
        try:
            self._live()
        finally:
            self.has_sent_all.set()

    def _live(self):
        sent, next_time, most_open = 0, time.monotonic(), 1
        while sent < self._share or self._open or any(owed for *_, owed in self._due):
            self._forget_ended()
            now = time.monotonic()
            while self._due and self._due[0][0] <= now:
                heapq.heappop(self._due)[2]()
            if sent < self._share and now >= next_time and len(self._open) < most_open and not _is_lull(now):
                self._send_next()
                sent += 1
                most_open = self._random.choice((1, 1, 2, 4, 8))
                next_time = now + self._random.choice((0, 0, 0.005, 0.05))
                if sent == self._share:
                    self.has_sent_all.set()
            else:
                self._watch.wait_for_change(self._pause(sent, now, next_time))

    def _pause(self, sent, now, next_time):
        """Until something is due; ends of goals end it too."""
        times = [0.2, *(self._due[0][0] - now for _ in self._due[:1])]
        if sent < self._share and next_time > now:
            times.append(next_time - now)
        return max(min(times), 0.001)

    def _forget_ended(self):
        for goal_id in [i for i in self._open if self._watch.has_ended(i)]:
            del self._open[goal_id]

    def _later(self, seconds, action, owed=False):
        heapq.heappush(self._due, (time.monotonic() + seconds, next(self._numbers), action, owed))

    # --- Goals.
    def _send_next(self):
        drawn = self._goals.draw()
        goal_id = self._send(drawn)
        block = provoked_errors.block_of(drawn.goal)
        if drawn.follow_up:
            # A plain goal, with nothing that could keep it from its end.
            self._later(self._random.uniform(0, 0.3), lambda: self._send_plainly(drawn.follow_up), owed=True)
        self._plan_cancels(block, goal_id, drawn.endless)

    def _send(self, drawn):
        r, block = self._random, provoked_errors.block_of(drawn.goal)
        goal_id = GoalID(id=f"{self.name}-{next(self._numbers)}", stamp=self._stamp())
        kind = r.random()
        # Of a goal without a name nobody knows later what was in it: whether it runs has to be plain.
        if kind < 0.01 and not drawn.endless and not getattr(drawn.goal, "check_only", False):
            self._watch.expect_nameless(block)
            self._publishers.send(block, drawn.goal, GoalID(stamp=goal_id.stamp))  # the server names it
            return None
        self._watch.expect(goal_id.id, block, drawn)
        self._open[goal_id.id] = block
        if kind < 0.03:
            self._cancel(block, goal_id)  # overtakes its goal
        self._publishers.send(block, drawn.goal, goal_id)
        if kind > 0.98:
            self._publishers.send(block, drawn.goal, goal_id)  # twice the same is one
        return goal_id

    def _send_plainly(self, goal):
        block = provoked_errors.block_of(goal)
        goal_id = GoalID(id=f"{self.name}-{next(self._numbers)}")
        self._watch.expect(goal_id.id, block, None)
        self._open[goal_id.id] = block
        self._publishers.send(block, goal, goal_id)

    def _stamp(self):
        now = rospy.Time.now()
        return self._random.choices((now, rospy.Time(0), now - AN_HOUR, now + AN_HOUR), (80, 10, 5, 5))[0]

    # --- Cancels.
    def _plan_cancels(self, block, goal_id, endless):
        r = self._random
        if goal_id is None:
            return
        if endless or r.random() < 0.2:
            self._later(r.choice((0, 0, r.uniform(0, 0.1), r.uniform(0, 1))), lambda: self._cancel(block, goal_id))
        elif r.random() < 0.03:
            self._later(r.uniform(0, 0.5), lambda: self._cancel_many(block))
        if r.random() < 0.02:
            self._later(r.uniform(6, 7), lambda: self._cancel(block, goal_id))  # long forgotten
        self._later(PATIENCE, lambda: self._give_up(block, goal_id))

    def _give_up(self, block, goal_id):
        if not self._watch.has_ended(goal_id.id):
            self._watch.note("given up")
            self._cancel(block, goal_id)

    def _cancel(self, block, goal_id):
        self._publishers.cancel[block].publish(GoalID(id=goal_id.id))

    def _cancel_many(self, block):
        """All of the action, or all that came before now."""
        self._publishers.cancel[block].publish(GoalID(stamp=self._random.choice((rospy.Time(0), rospy.Time.now()))))


class Keeper(threading.Thread):
    """Keeps the link, and every now and then closes it for a moment. Where the layer can do nothing any more, as with a
    project that was paused on its way out of the Listen node, it calls the operator."""

    def __init__(self, seed, publishers, watch, ports, operator):
        super().__init__(name="keeper", daemon=True)
        self._random = random.Random(f"{seed} keeper")
        self._publishers, self._watch, self._ports, self._operator = publishers, watch, ports, operator
        self._numbers = itertools.count(1)
        self._out_since = None
        self._goal_id, self._stopping = None, threading.Event()
        self._close_at = 0.0
        self.resting = False  # nothing is closed

    def run(self):
        while not self._stopping.is_set():
            if self._goal_id is None or self._watch.has_ended(self._goal_id.id):
                self._connect()
            elif not self.resting and time.monotonic() > self._close_at:
                self._publishers.cancel["connect"].publish(GoalID(id=self._goal_id.id))
                self._close_at = time.monotonic() + 2.0  # asked again if it was not heard
            self._look_after_the_flow()
            self._stopping.wait(0.1)

    def _look_after_the_flow(self):
        out = self._watch.last_status.link_state == CommandStatus.NOT_LISTENING
        self._out_since = (self._out_since or time.monotonic()) if out else None
        if out and time.monotonic() > self._out_since + OPERATOR_COMES:
            self._watch.note("calls of the operator")
            self._operator()
            self._out_since = None

    def _connect(self):
        ports = self._ports()
        if ports is None:
            return
        self._goal_id = GoalID(id=f"{self.name}-{next(self._numbers)}", stamp=rospy.Time.now())
        self._watch.expect(self._goal_id.id, "connect", None)
        goal = ConnectGoal(host="127.0.0.1", port=ports[0], status_port=ports[1], timeout=10)
        self._publishers.send("connect", goal, self._goal_id)
        self._close_at = time.monotonic() + self._random.uniform(3, 10)

    def resume(self):
        goal_id = GoalID(id=f"{self.name}-{next(self._numbers)}")
        self._watch.expect(goal_id.id, "program_control", None)
        self._publishers.send("program_control", ProgramControlGoal(command=ProgramControlGoal.RESUME), goal_id)
        return goal_id.id

    def stop(self):
        """The link is closed at the end."""
        self._stopping.set()
        self.join()
        if self._goal_id is not None and not self._watch.has_ended(self._goal_id.id):
            self._publishers.cancel["connect"].publish(GoalID(id=self._goal_id.id))
