"""What is recorded of a robot: names relative to the namespace of its command node."""
import re

FRAMES, STATUS_FRAMES = "frames", "status_frames"
JOINTS, TOOL = "joint_states", "tool_pose"
LINK, ROBOT, DATA = "command_status", "robot_status", "robot_data"
PLANNED, MESSAGES = "planned_path", "messages"
TOPICS = (FRAMES, JOINTS, TOOL, LINK, ROBOT, DATA, PLANNED, MESSAGES)
TYPES = {
    FRAMES: "cobot_command/FrameTrace", STATUS_FRAMES: "cobot_command/FrameTrace", JOINTS: "sensor_msgs/JointState",
    TOOL: "geometry_msgs/PoseStamped", LINK: "cobot_command/CommandStatus", ROBOT: "cobot_command/RobotStatus",
    DATA: "cobot_command/RobotData", PLANNED: "visualization_msgs/Marker", MESSAGES: "cobot_command/Message"}

GOAL, CANCEL, FEEDBACK, RESULT = "goal", "cancel", "feedback", "result"
OF_AN_ACTION = {GOAL: "ActionGoal", CANCEL: "actionlib_msgs/GoalID", FEEDBACK: "ActionFeedback", RESULT: "ActionResult"}  # ends of their types

# Its messages are another package's (doc/actions/follow_joint_trajectory.md).
FOREIGN_ACTION = "follow_joint_trajectory"


def is_own(name, kind):
    """Whether a topic of that name, relative to the namespace, is of the type that a command node gives it: others may have such names."""
    if name in TYPES:
        return kind == TYPES[name]
    action, _, what = name.rpartition("/")
    return bool(action) and what in OF_AN_ACTION and kind.endswith(OF_AN_ACTION[what])


def actions_in(message_names):
    """The names of actions, of those of messages: MoveAbsoluteActionGoal is one of move_absolute."""
    kinds = (re.fullmatch(r"([A-Z]\w+)ActionGoal", name) for name in message_names)
    return sorted(re.sub(r"(?<=[a-z])(?=[A-Z])", "_", kind[1]).lower() for kind in kinds if kind)


def recorded(actions, with_status_frames=False):
    """All names that are to be recorded."""
    wanted = [*TOPICS, *([STATUS_FRAMES] if with_status_frames else [])]
    return wanted + [f"{action}/{what}" for action in (*actions, FOREIGN_ACTION) for what in OF_AN_ACTION]
