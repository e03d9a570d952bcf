"""What happened when: goals, queue tags, and the frames on the wire."""
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.transforms import ScaledTranslation

from flight import commands, tags
from flight.analysis import OPEN, kind_of, outcome_of
from flight.drawing import style

TAGS = {tags.DONE: style.ACTUAL, tags.DROPPED: style.STOPPED, tags.REFUSED: style.REFUSED, tags.FAILED: style.BAD, tags.OPEN: style.OPEN}
SENT, RECEIVED, QUESTION, FAULT = "#0072b2", "#2e8b57", "#a9b4be", style.BAD
MOST_LABELS = 60
MOST_LETTERS = 30  # of the name of a lane
LEGEND = -0.5  # [inches] below the axes
HEIGHT = 0.62  # of a bar, of a lane of 1
MARK = 6.5  # [points]
LETTER = 0.0048  # the width of one in a label, as a share of the time line
BESIDE_MARK = "  "
WIDEST, NARROWEST = 0.05, 0.012  # of the time line: so wide is a bar with words in it, and with a number


def lanes_of(analysis):
    """The names of the lanes, from the top down."""
    actions = list(dict.fromkeys(goal.action for goal in analysis.run.goals))
    return [*actions, "robot", "queue tags", "sent", "received"]


def draw(axes, analysis, span):
    lanes = lanes_of(analysis)
    axes.set_title("Goals, queue tags and frames")
    axes.set_xlim(*span)
    axes.set_ylim(len(lanes) - 0.45, -0.55)
    axes.set_yticks(range(len(lanes)))
    axes.set_yticklabels([style.shortened(lane, MOST_LETTERS) for lane in lanes])
    axes.grid(axis="y", visible=False)
    for lane in range(len(lanes)):
        axes.axhspan(lane - 0.5, lane + 0.5, color="#f5f7f9" if lane % 2 else style.PAPER, zorder=0, linewidth=0)
    width = span[1] - span[0]
    for lane, action in enumerate(lanes):
        goals = [goal for goal in analysis.run.goals if goal.action == action]
        for goal, following in zip(goals, [*(goal.begun for goal in goals[1:]), span[1]]):
            draw_goal(axes, lane, goal, following, span)
    draw_states(axes, lanes.index("robot"), analysis.run)
    draw_tags(axes, lanes.index("queue tags"), analysis, width)
    draw_frames(axes, lanes.index("sent"), analysis.run)
    axes.set_xlabel("time since the recording began [s]")
    below = axes.transAxes + ScaledTranslation(0, LEGEND, axes.figure.dpi_scale_trans)
    axes.legend(handles=legend(), loc="upper left", bbox_to_anchor=(0, 0), bbox_transform=below, ncol=11, handlelength=1.2, columnspacing=1.2,
                borderaxespad=0)


def bar(axes, lane, begin, end, colour, **how):
    axes.barh(lane, max(end - begin, 1e-3), left=begin, height=how.pop("height", HEIGHT), color=colour, **{"linewidth": 0, "zorder": 2, **how})


def draw_goal(axes, lane, goal, following, span):
    """`following`: where the next one of the lane begins, which has to be left free."""
    outcome = outcome_of(goal)
    end = goal.end.time if goal.end else span[1]
    colour = style.KINDS[kind_of(goal)]
    width = span[1] - span[0]
    bar(axes, lane, goal.begun, end, colour, alpha=0.3, edgecolor=colour)
    axes.plot([goal.begun, goal.begun], [lane - HEIGHT / 2, lane + HEIGHT / 2], color=colour, linewidth=1.6, zorder=3)
    if end - goal.begun < NARROWEST * width:
        # A bar without a length, as of a goal that was refused, would not be seen.
        axes.plot(goal.begun, lane, "D", color=colour, markeredgecolor=style.PAPER, markeredgewidth=0.8, markersize=MARK, zorder=5)
    number, _ = commands.error_of(goal)
    words = f"{outcome} {number}".strip()
    if end - goal.begun > WIDEST * width:
        place, align = (max(goal.begun, span[0]) + min(end, span[1])) / 2, "center"
    else:
        place, align = end, "left"
        room = (following - end) / (LETTER * width) - len(BESIDE_MARK)
        fitting = [said for said in (words, number) if len(said) <= room] if number or outcome == OPEN else []
        words = BESIDE_MARK + fitting[0] if fitting else ""
    axes.text(place, lane, words, ha=align, va="center", fontsize=7.5, color=style.INK, clip_on=True, zorder=4)


def draw_states(axes, lane, run):
    """When something has held the robot."""
    for (begin, held), following in zip(run.states, [*run.states[1:], (run.duration, "")]):
        colour = style.BAD if "stop" in held or "error" in held else style.STOPPED if held else style.GOOD
        bar(axes, lane, begin, following[0], colour, alpha=0.5 if held else 0.18, height=0.4)
        if held:
            axes.text(begin, lane, f" {held}", va="center", fontsize=7.5, clip_on=True, zorder=4)


def draw_tags(axes, lane, analysis, width):
    """From where its motion could begin to where the tag came back."""
    for tag in analysis.tags:
        end = analysis.run.duration if tag.end is None else tag.end
        bar(axes, lane, tag.begun, end, TAGS[tag.outcome], alpha=0.85, edgecolor=style.PAPER, linewidth=0.5)
        share = (end - tag.begun) / width
        if len(analysis.tags) <= MOST_LABELS and share > NARROWEST:
            words = f"{tag.number} {tag.motion}" if share > WIDEST else str(tag.number)
            axes.text((tag.begun + end) / 2, lane, words, ha="center", va="center", fontsize=7.5, color="white", fontweight="bold",
                      clip_on=True, zorder=4)


def draw_frames(axes, lane, run):
    """A stroke for each frame of the script port; received ones a lane further down."""
    for frame in run.script_frames:
        at = lane if frame.sent else lane + 1
        is_script = bool(tags.SCRIPT.match(frame.data)) if frame.sent else b"TMSTA" not in frame.data or b",01," in frame.data
        colour = FAULT if frame.refused or b"CPERR" in frame.data or b",ERROR" in frame.data else (
            (SENT if frame.sent else RECEIVED) if is_script else QUESTION)
        half = 0.34 if is_script else 0.18
        axes.plot([frame.time, frame.time], [at - half, at + half], color=colour, linewidth=1.5 if is_script else 1, zorder=3,
                  solid_capstyle="butt")


def legend():
    bars = (("succeeded", style.GOOD), ("refused", style.REFUSED), ("stopped, paused", style.STOPPED), ("failed", style.BAD))
    ends = (("tag done", tags.DONE), ("tag dropped by a stop", tags.DROPPED), ("tag failed", tags.FAILED))
    frames = (("script", SENT), ("reply, tag", RECEIVED), ("heartbeat", QUESTION), ("error, faulty", FAULT))
    return [*(Patch(color=colour, alpha=0.4, label=label) for label, colour in bars), *(Patch(color=TAGS[end], label=label) for label, end in ends),
            *(Line2D([], [], color=colour, label=label) for label, colour in frames)]
