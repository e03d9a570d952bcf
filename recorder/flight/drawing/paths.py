"""The way of the TCP, from above and from the side: as it was planned, and as it was driven."""
from flight import motion
from flight.drawing import style

VIEWS = {"from above": (0, 1, "x [mm]", "y [mm]"), "from the side": (1, 2, "y [mm]", "z [mm]")}
LEAST = 60.0  # [mm]; what is smaller is shown with this much around it


def draw(axes, analysis, view):
    across, up, across_name, up_name = VIEWS[view]
    run = analysis.run
    axes.set_title(f"Path of the TCP, {view}")
    axes.set(xlabel=across_name, ylabel=up_name)
    for index, (_, line) in enumerate(run.planned):
        axes.plot(line[:, across], line[:, up], color=style.PLANNED, linewidth=5, alpha=0.55, solid_capstyle="round",
                  label="planned" if not index else None)
    places = motion.tool_path(run)
    if len(places):
        axes.plot(places[:, across], places[:, up], color=style.ACTUAL, linewidth=1.3, label="driven")
        for place, marker, name in ((places[0], "o", "begin"), (places[-1], "s", "end")):
            axes.plot(place[across], place[up], marker, color=style.ACTUAL, markerfacecolor=style.PAPER, markersize=6, label=name)
    frame(axes)
    if view == next(iter(VIEWS)) and axes.lines:
        axes.legend(loc="best")
    if analysis.deviation is not None and view != next(iter(VIEWS)):
        axes.text(0.03, 0.97, f"at most {analysis.deviation:.2f} mm off the plan", transform=axes.transAxes, fontsize=8, va="top",
                  bbox={"facecolor": style.PAPER, "edgecolor": "none", "alpha": 0.8, "pad": 1})


def frame(axes):
    """The same scale across and up, and something around what is drawn."""
    axes.set_aspect("equal", adjustable="datalim")
    for low, high, put in ((*axes.get_xlim(), axes.set_xlim), (*axes.get_ylim(), axes.set_ylim)):
        middle, half = (low + high) / 2, max((high - low) / 2, LEAST / 2)
        put(middle - 1.08 * half, middle + 1.08 * half)
