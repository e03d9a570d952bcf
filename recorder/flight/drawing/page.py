"""The parts put together: one large picture, and each part as a picture of its own."""
import contextlib
import io

import matplotlib
from matplotlib.figure import Figure

from flight.drawing import joints, paths, style, tables, timeline, times

WIDTH = 15.0  # [inches]
DPI = 110
LANE, LINE, SPEED = 0.3, 0.24, 1.6  # [inches] of the time line, of a table, and of the speed of the TCP


@contextlib.contextmanager
def styled():
    with matplotlib.rc_context(style.SETTINGS):
        yield


def write_picture(analysis, file):
    """All parts in one PNG."""
    with styled():
        whole(analysis).savefig(file, dpi=DPI, metadata={"Software": None})


def whole(analysis):
    count = len(analysis.run.joints.names)
    lanes = lanes_height(analysis)
    rows = max(len(times.shown(analysis.commands)), 6)
    heights = [1.1, 0.8 * count + 0.7, SPEED + lanes, max(3.6, 0.34 * rows + 0.7), LINE * tables.height(analysis) + 0.3]
    figure = Figure(figsize=(WIDTH, sum(heights) + 0.4), layout="constrained")
    figure.get_layout_engine().set(hspace=0.01, h_pad=0.06, w_pad=0.06, rect=(0.008, 0.004, 0.984, 0.992))
    parts = figure.subfigures(len(heights), 1, height_ratios=heights)
    tables.draw_head(parts[0].subplots(), analysis)
    draw_joints(parts[1], analysis)
    draw_times(parts[2], analysis, lanes)
    draw_paths_and_times(parts[3], analysis)
    tables.draw_goals(parts[4].subplots(), analysis)
    return figure


def lanes_height(analysis):
    return LANE * len(timeline.lanes_of(analysis)) + 0.9


def draw_times(figure, analysis, lanes):
    """The speed of the TCP above what happened meanwhile."""
    speed, line = figure.subplots(2, 1, sharex=True, height_ratios=(SPEED, lanes))
    joints.draw_tool_speed(speed, analysis)
    timeline.draw(line, analysis, analysis.span)


def draw_joints(figure, analysis):
    """Two columns of strips with one time axis."""
    count = len(analysis.run.joints.names)
    grid = figure.subplots(count, 2, sharex=True, squeeze=False)
    for index in range(count):
        joints.draw_angles(grid[index][0], analysis, index)
        joints.draw_speeds(grid[index][1], analysis, index)
    grid[0][0].set_xlim(*analysis.span)
    limits, rated = (", limits in the corner", ", rated speed in the corner") if analysis.run.axes else ("", "")
    grid[0][0].set_title(f"Angles of the joints [deg]{limits}")
    grid[0][1].set_title(f"Speeds of the joints [deg/s]{rated}")
    for axes in grid[-1]:
        axes.set_xlabel("time since the recording began [s]")


def draw_paths_and_times(figure, analysis):
    grid = figure.subplots(1, 3, width_ratios=(1, 1, 1.25))
    for axes, view in zip(grid, paths.VIEWS):
        paths.draw(axes, analysis, view)
    times.draw(grid[2], analysis)


def single_pictures(analysis):
    """(title, SVG) of each part, for the page."""
    count = len(analysis.run.joints.names)
    lanes = lanes_height(analysis)
    rows = max(len(times.shown(analysis.commands)), 6)
    parts = (("Joints", 0.8 * count + 0.8, lambda figure: draw_joints(figure, analysis)),
             ("Speed and time line", SPEED + lanes, lambda figure: draw_times(figure, analysis, lanes)),
             ("Path and times", max(4.2, 0.34 * rows + 0.7), lambda figure: draw_paths_and_times(figure, analysis)))
    with styled():
        for title, height, draw in parts:
            figure = Figure(figsize=(WIDTH, height), layout="constrained")
            draw(figure)
            drawn = io.StringIO()
            figure.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
            yield title, drawn.getvalue()
