"""Angles and speeds of the joints against their limits, and the speed of the TCP."""
import numpy

from flight import motion
from flight.drawing import style

ROOM = 1.12  # beyond a limit, so that its line is seen


def draw_angles(axes, analysis, index):
    """One joint: its angle, and dashed what it may reach."""
    joints, use = analysis.run.joints, analysis.uses[index]
    strip(axes, joints.times, joints.angles[:, index], index)
    if use.axis:
        limits(axes, use.axis.lower, use.axis.upper)
        told = f"{use.margin:.0f}°\nleft" if use.margin >= 0 else f"{-use.margin:.1f}°\nbeyond"
        note(axes, told, use.margin < 0)
    axes.set_ylabel(f"J{index + 1}", rotation=0, ha="right", va="center", fontweight="bold", color=style.JOINTS[index % 6])


def draw_speeds(axes, analysis, index):
    """One joint: its speed, and dashed its rated speed."""
    joints, use = analysis.run.joints, analysis.uses[index]
    strip(axes, joints.times, joints.speeds[:, index], index)
    if use.axis:
        limits(axes, -use.axis.rated_speed, use.axis.rated_speed)
        note(axes, f"{use.share:.0f} %\nof rated", use.share > 100)


def strip(axes, times, values, index):
    axes.plot(*style.thinned(times, values), color=style.JOINTS[index % 6])
    axes.axhline(0, color=style.FAINT, linewidth=0.8, zorder=0)
    axes.tick_params(axis="y", labelsize=7)


def limits(axes, lower, upper):
    for value in (lower, upper):
        axes.axhline(value, color=style.LIMIT, linestyle=(0, (5, 3)), linewidth=0.9)
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    reach = max([half, *(abs(y - middle) for line in axes.lines[:1] for y in line.get_ydata() if numpy.isfinite(y))])
    axes.set_ylim(middle - ROOM * reach, middle + ROOM * reach)
    axes.set_yticks([lower, 0, upper] if lower < 0 < upper else [lower, upper])


def note(axes, text, is_bad):
    axes.text(1.008, 0.5, text, transform=axes.transAxes, ha="left", va="center", fontsize=7.5, color=style.BAD if is_bad else style.INK)


def draw_tool_speed(axes, analysis):
    """The speed of the TCP, as its recorded places tell it."""
    times, speeds = motion.tool_speed(analysis.run)
    axes.set_title("Speed of the TCP")
    axes.set_ylabel("mm/s")
    if not len(times):
        axes.text(0.5, 0.5, "tool_pose is not in the bag", transform=axes.transAxes, ha="center")
        return
    axes.fill_between(*style.thinned(times, speeds), color=style.ACTUAL, alpha=0.15, linewidth=0)
    axes.plot(*style.thinned(times, speeds), color=style.ACTUAL)
    fastest = int(numpy.argmax(speeds))
    axes.annotate(f"{speeds[fastest]:.0f} mm/s", (times[fastest], speeds[fastest]), xytext=(6, -3), textcoords="offset points", fontsize=8)
    axes.set_ylim(bottom=0, top=max(1.0, 1.15 * float(speeds[fastest])))
