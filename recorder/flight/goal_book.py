"""What belongs to the same goal, of the four topics of its action."""
from flight.pairing import pairs
from flight.run import End, Goal

# [s] from when the server had a goal without an id to when the recorder had it, or the other way round: `rostopic pub -1` offers its
# message for three seconds, and either may find it at their end.
NEAR = 5.0


class GoalBook:
    """Keeps the goals in a list, in the order in which they were heard of. Times of stamps are since `began`.

    A goal may be sent without an id, as `rostopic pub` does: then the server makes one, and the message of the goal does not have it."""

    def __init__(self, goals, began=0.0):
        self.goals = goals
        self.began = began
        self.known = {}  # (action, identity): the Goal that has it now
        self.nameless = []  # goals whose messages had no id
        self.again = {}  # (action, identity): (time, message) of a goal with the id of one that has ended
        self.servers = {}  # action: who sends its results, in front of the ids that it makes
        self.given = {}  # (action, identity): when the server had the goal

    def take(self, action, what, message, time, sender=""):
        """A message of one of the topics topics.OF_AN_ACTION; the sender is a node, or "" where the bag does not say."""
        if what == "goal":
            self.take_goal(action, message, time)
        elif what == "cancel":
            self.take_cancel(action, message, time)
        else:
            self.take_answer(action, what, message, time, sender)

    def goal(self, action, identity, time):
        """The recorder may hear of a goal late: a new client's topic is found a moment after its first message."""
        key = (action, identity)
        if key in self.again and self.known[key].end:
            begun, message = self.again.pop(key)
            return self.add(Goal(action, identity, begun, message))
        return self.known[key] if key in self.known else self.add(Goal(action, identity, time))

    def add(self, goal):
        self.known[goal.action, goal.identity] = goal
        self.goals.append(goal)
        return goal

    def take_goal(self, action, message, time):
        identity = message.goal_id.id
        known = self.known.get((action, identity))
        if not identity:
            self.nameless.append(Goal(action, "", time, message.goal))
            self.goals.append(self.nameless[-1])
        elif known and known.end and known.message is not None:
            # The server takes it once it has forgotten the first, and ignores it before: what it answers tells which.
            self.again[action, identity] = (time, message.goal)
        else:
            self.goal(action, identity, time).message = message.goal

    def take_cancel(self, action, message, time):
        """Of one goal; without an id of all that there are."""
        for goal in self.goals:
            if goal.action == action and goal.end is None and message.id in ("", goal.identity):
                goal.cancelled.append(time)

    def take_answer(self, action, what, message, time, sender):
        """Feedback or a result."""
        status = message.status
        goal = self.goal(action, status.goal_id.id, time)
        stamp = status.goal_id.stamp.to_sec()
        self.given.setdefault((action, goal.identity), stamp - self.began if stamp else goal.begun)
        if sender:
            self.servers[action] = sender
        if what == "feedback":
            goal.feedback.append((time, message.feedback))
        else:
            goal.end = End(time, status.status, status.text, message.result)

    def finish(self):
        """Joins the goals without an id with the ids that the servers have made for them."""
        for action in dict.fromkeys(goal.action for goal in self.nameless):
            sent = [goal for goal in self.nameless if goal.action == action]
            heard = [goal for goal in self.goals if goal.action == action and goal.message is None and self.is_made(action, goal.identity)]
            heard.sort(key=lambda goal: self.given[action, goal.identity])
            for i, j in pairs([goal.begun for goal in sent], [self.given[action, goal.identity] for goal in heard], NEAR):
                self.join(sent[i], heard[j])

    def is_made(self, action, identity):
        """Whether the server of the action has made it: such an id begins with the name of its node."""
        return identity.startswith(self.servers.get(action, "") + "-") if action in self.servers else True

    def join(self, sent, heard):
        heard.message = sent.message
        heard.begun = min(sent.begun, self.given[heard.action, heard.identity])
        cancelled = sorted({*sent.cancelled, *heard.cancelled})
        heard.cancelled = [time for time in cancelled if heard.end is None or time <= heard.end.time]
        self.goals[:] = [goal for goal in self.goals if goal is not sent]
