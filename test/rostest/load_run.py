"""A load of random goals for one command node, in rounds, and all that has to hold meanwhile and behind each."""
import pathlib
import sys
import time

import rospkg
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus
from std_srvs.srv import Trigger

import plcopen_goals
import process_watch
import provoked_errors
from cobot_command.msg import CommandStatus
from load_clients import Client, Keeper, Publishers
from load_watch import Watch
from plcopen_status import StatusRules
from waiting import wait_until

sys.path.append(str(pathlib.Path(rospkg.RosPack().get_path("cobot_command")) / "test" / "checks"))
from check_error_coverage import rows  # noqa: E402  pylint: disable=wrong-import-position

CLIENTS = 4
CONTROLLER = "simulated_controller"
DEADLINE = 60.0  # [s] until the last goals of a round have ended, their patience and a loaded machine included
STATES = {getattr(GoalStatus, name): name for name in ("PREEMPTED", "SUCCEEDED", "ABORTED", "REJECTED", "RECALLED")}


def error_table():
    """(block, error id) of every error that can occur, of doc/errors.md."""
    page = pathlib.Path(rospkg.RosPack().get_path("cobot_command")) / "doc" / "errors.md"
    return {key for key, when in rows(page.read_text(encoding="utf-8")).items() if not when.startswith("cannot occur")}


def ports():
    """Of the simulated controller; None while it has none."""
    try:
        listening = rospy.get_param(f"{CONTROLLER}/listening")
        return listening["script_port"], listening["status_port"]
    except KeyError:
        return None


class Load:
    """Everything stands and is heard when it has been made."""

    def __init__(self, seed, where=ports, stream_breaks=False):
        """`where`: the ports that goals of connect are to use, or None. `stream_breaks`: the status stream does."""
        self.seed = seed
        self._stream_breaks = stream_breaks
        self._table = error_table()
        self._rules = StatusRules(self._table)
        self.watch = Watch(self._rules)
        self.publishers = Publishers()
        self.keeper = Keeper(seed, self.publishers, self.watch, where, resume_project)
        self.samples = []  # of the command node, between rounds
        self.compared = 0
        self.succeeded = set()  # blocks
        self._rounds = 0
        wait_until(lambda: self.watch.hears_all() and self.publishers.are_heard(), "all topics of the command node",
                   DEADLINE)
        self.pid = process_watch.pid_of("command_node")
        self.keeper.start()

    def run_round(self, goals):
        """That many goals by all clients together; returns what was against the rules."""
        self._rounds += 1
        self.keeper.resting = False
        clients = [Client(f"client_{k}_{self._rounds}", f"{self.seed} {self._rounds}",
                          goals * (k + 1) // CLIENTS - goals * k // CLIENTS, self.publishers, self.watch)
                   for k in range(CLIENTS)]
        for client in clients:
            client.start()
        for client in clients:
            client.has_sent_all.wait()
        deadline = time.monotonic() + DEADLINE
        for client in clients:
            client.join(max(0, deadline - time.monotonic()))
        self.settle()
        return self.judge()

    def send(self, name, drawn):
        """One goal; returns its id."""
        block = provoked_errors.block_of(drawn.goal)
        self.watch.expect(name, block, drawn)
        self.publishers.send(block, drawn.goal, GoalID(id=name, stamp=rospy.Time.now()))
        return name

    def settle(self):
        """Connected, nothing under way, and nobody has left the project paused."""
        self.keeper.resting = True
        self.watch.wait_for(self._is_ready, DEADLINE)
        resumed = self.keeper.resume()
        self.watch.wait_for(lambda: self.watch.has_ended(resumed), DEADLINE)
        # The status is another topic: the one that was made behind that end has to have come.
        end = self.watch.end_of(resumed)
        self.watch.wait_for(lambda: self._is_ready() and self.watch.last_status.header.stamp > end, DEADLINE)

    def _is_ready(self):
        status = self.watch.last_status
        return status.link_state == CommandStatus.READY and status.queue_depth == 0

    def judge(self, closed=False):
        """What all goals since the last time have to hold, now that they have ended; the link is ready, or `closed`."""
        missing = [m for m in self.watch.without_end() if not m.startswith("connect keeper")]
        faults = [f"without an end: {m}" for m in missing]
        if not closed and not self._is_ready():
            status = self.watch.last_status
            faults.append(f"not ready behind the round: link_state {status.link_state}, queue_depth {status.queue_depth}"
                          f", '{status.diagnosis}'")
        records, truth = self.watch.take_round()
        ended = [r for r in records if r.results]
        for record in ended:
            faults += plcopen_goals.faults_of(record, self._table, self._stream_breaks)
            if record.end[1] == GoalStatus.SUCCEEDED:
                self.succeeded.add(record.block)
        whole = plcopen_goals.Round(ended, truth)
        faults += whole.faults()
        self.compared += whole.compared
        faults += plcopen_goals.shown_faults(ended, self.watch.last_status)
        faults += self.watch.take_faults()
        self.samples.append(process_watch.counts_of(self.pid))
        return faults

    def finish(self):
        self.keeper.stop()
        self.watch.wait_for(lambda: not self.watch.without_end(), DEADLINE)

    def report(self):
        """In words, for people."""
        counts = self.watch.counts
        ends = ", ".join(f"{self.watch.ends[state]} {name}" for state, name in STATES.items())
        others = ", ".join(f"{value} {key}" for key, value in counts.items())
        found = sorted(self.watch.errors.items())
        errors = ", ".join(f"{block} 16#{error:X} {count}x" for (block, error), count in found if error)
        return (f"seed {self.seed}: {ends}\n  {others}, lists of up to {self.watch.longest_list} states\n  {errors}\n"
                f"  {self.compared} ends held against the simulator's own joints\n"
                f"  {self._rules.lost} command_status lost\n"
                f"  command_node: {self.samples[0]} at first, {self.samples[-1]} at last")


def resume_project():
    """By the operator. What hinders it is seen by what it does not help."""
    try:
        rospy.ServiceProxy(f"{CONTROLLER}/resume_project", Trigger)()
    except rospy.ServiceException:
        pass
