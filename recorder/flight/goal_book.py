"""What belongs to the same goal, of the four topics of its action."""
from flight.run import End, Goal


class GoalBook:
    """Keeps the goals in a list, in the order in which they were heard of."""

    def __init__(self, goals):
        self.goals = goals
        self.known = {}  # (action, identity): Goal

    def take(self, action, what, message, time):
        """A message of one of the topics topics.OF_AN_ACTION."""
        getattr(self, f"take_{what}")(action, message, time)

    def goal(self, action, identity, time):
        """The recorder may hear of a goal late: a new client's topic is found a moment after its first message."""
        key = (action, identity)
        if key not in self.known:
            self.known[key] = Goal(action, identity, time)
            self.goals.append(self.known[key])
        return self.known[key]

    def take_goal(self, action, message, time):
        self.goal(action, message.goal_id.id, time).message = message.goal

    def take_cancel(self, action, message, time):
        """Of one goal; without an id of all that there are."""
        for goal in self.goals:
            if goal.action == action and goal.end is None and message.id in ("", goal.identity):
                goal.cancelled.append(time)

    def take_feedback(self, action, message, time):
        self.goal(action, message.status.goal_id.id, time).feedback.append((time, message.feedback))

    def take_result(self, action, message, time):
        status = message.status
        self.goal(action, status.goal_id.id, time).end = End(time, status.status, status.text, message.result)
