"""How long commands were to take, and took."""
from flight.drawing import style

MOST = 16  # rows; the table of the page has all
NOTABLE = 0.05  # [s]; so much later is shown in another colour


def shown(commands):
    """Those that differ most, in their order, when there are too many."""
    if len(commands) <= MOST:
        return commands
    worst = sorted(range(len(commands)), key=lambda i: -abs(commands[i].later))[:MOST]
    return [commands[i] for i in sorted(worst)]


def draw(axes, analysis):
    rows = shown(analysis.commands)
    axes.set_title("Planned and actual time")
    axes.set_xlabel("[s]" if len(rows) == len(analysis.commands) else f"[s]; of {len(analysis.commands)} the {MOST} that differ most")
    if not rows:
        axes.text(0.5, 0.5, "no planned motion was executed", transform=axes.transAxes, ha="center")
        axes.set_yticks([])
        return
    longest = max(max(row.planned, row.actual) for row in rows)
    for place, row in enumerate(rows):
        axes.barh(place - 0.19, row.planned, height=0.36, color=style.PLANNED, label=None if place else "planned")
        axes.barh(place + 0.19, row.actual, height=0.36, color=style.ACTUAL, label=None if place else "actual")
        is_notable = abs(row.later) > max(NOTABLE, 0.05 * row.planned)
        axes.text(max(row.planned, row.actual) + 0.015 * longest, place, f"{row.actual:.2f} s  {later(row)}", va="center", fontsize=7.5,
                  color=style.BAD if is_notable else style.INK)
    axes.set_yticks(range(len(rows)))
    axes.set_yticklabels([style.shortened(label(row), 30) for row in rows], fontsize=7.5)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlim(0, 1.3 * longest)
    axes.grid(axis="y", visible=False)
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncol=2, borderaxespad=0.2)


def later(row):
    ms = round(row.later * 1000)
    return f"{ms:+d} ms" if ms else "±0 ms"


def label(row):
    tag = f"  (tag {row.tag})" if row.tag else ""
    return f"{row.label}{tag}"
