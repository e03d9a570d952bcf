"""The goals as a table in a picture, and the lines at its head."""
import datetime

from flight import commands
from flight.analysis import FAILED, OPEN, REFUSED, STOPPED, SUCCEEDED, count_of, kind_of, outcome_of
from flight.drawing import style

MOST = 14  # rows
URGENCY = (FAILED, REFUSED, OPEN, STOPPED, SUCCEEDED)  # what is shown first where not all have room
# Where the columns begin, as a share of the width.
COLUMNS = (("begun", 0.0), ("action", 0.055), ("goal", 0.18), ("outcome", 0.475), ("planned", 0.565), ("actual", 0.625),
           ("error, or message", 0.685))
LETTER = 0.0051  # the width of one of the verdicts, as a share of the line
ERROR_LETTERS, GOAL_LETTERS = 78, 58


def rows_of(analysis):
    """(values, kind) of each goal."""
    wholes = {}
    for goal in analysis.run.goals:
        wholes[goal.identity, goal.action] = commands.whole_of(goal, analysis.tags)
    for goal in analysis.run.goals:
        whole = wholes[goal.identity, goal.action]
        number, words = commands.error_of(goal)
        yield (f"{goal.begun:.2f} s", goal.action, commands.target_of(goal), outcome_of(goal),
               f"{whole.planned:.2f} s" if whole else "", f"{whole.actual:.2f} s" if whole else "",
               f"{number} {words}".strip()), kind_of(goal)


def shown(analysis):
    """The goals that failed come first where not all have room."""
    rows = list(rows_of(analysis))
    if len(rows) <= MOST:
        return rows, 0
    kept = sorted(sorted(range(len(rows)), key=lambda i: URGENCY.index(rows[i][1]))[:MOST])
    return [rows[i] for i in kept], len(rows) - MOST


def height(analysis):
    """Lines that the table takes."""
    return min(len(analysis.run.goals), MOST) + 2


def draw_goals(axes, analysis):
    axes.axis("off")
    rows, left_out = shown(analysis)
    lines = height(analysis)
    axes.set(xlim=(0, 1), ylim=(lines, 0))
    axes.set_title("Goals" + (f" ({left_out} more in the page)" if left_out else ""))
    for name, x in COLUMNS:
        axes.text(x, 0.6, name, fontsize=8, color="#6b7885", va="center")
    axes.axhline(1.05, color=style.FAINT, linewidth=0.8)
    for line, (values, kind) in enumerate(rows):
        for (name, x), value in zip(COLUMNS, values):
            most = {"error, or message": ERROR_LETTERS, "goal": GOAL_LETTERS}.get(name, 24)
            axes.text(x, line + 1.7, style.shortened(value, most), fontsize=8, va="center",
                      color=style.KINDS[kind] if name == "outcome" else style.INK,
                      fontweight="bold" if name == "outcome" else "normal")


def draw_head(axes, analysis):
    """What was recorded, and what the replays say."""
    axes.axis("off")
    axes.set(xlim=(0, 1), ylim=(3, 0))
    axes.text(0, 0.35, style.printable(f"Flight report of {analysis.title}"), fontsize=17, fontweight="bold", va="center")
    axes.text(0, 1.35, style.printable(" · ".join(facts(analysis))), fontsize=9, color="#6b7885", va="center")
    x = 0.0
    for words, colour in verdict_words(analysis):
        axes.text(x + 0.006, 2.3, words, fontsize=9, color="white", va="center", fontweight="bold",
                  bbox={"facecolor": colour, "edgecolor": "none", "boxstyle": "round,pad=0.4"})
        x += LETTER * len(words) + 0.024


def facts(analysis):
    run = analysis.run
    began = datetime.datetime.fromtimestamp(run.began).strftime("%Y-%m-%d %H:%M:%S")
    names = {"control_box_sn": "serial number", "tmflow_version": "TMflow", "layer_version": "cobot_command"}
    told = [f"{word} {run.identity[name]}" for name, word in names.items() if name in run.identity]
    return [began, f"{run.duration:.1f} s", *told, f"{len(run.frames)} frames", f"{len(run.goals)} goals", f"{len(run.joints.times)} joint states"]


def verdict_words(analysis):
    """(words, colour)"""
    faults = len(analysis.faults)
    yield (f"recording not whole: {faults} fault{'s' if faults > 1 else ''}", style.BAD) if faults else ("recording whole", style.GOOD)
    for verdict in analysis.verdicts:
        yield ((f"{verdict.name}: {verdict.compared} compared, all the same", style.GOOD) if verdict.agrees else
               (f"{verdict.name}: {len(verdict.differences)} differ", style.BAD))
    of_all = f"of {len(analysis.run.goals)} goals"
    counts = {kind: count_of(analysis.run, kind) for kind in (FAILED, REFUSED, STOPPED)}
    if not counts[FAILED]:
        yield "no goal failed", style.GOOD
    yield from ((f"{count} {of_all} {kind}", style.KINDS[kind]) for kind, count in counts.items() if count)
