"""Angles and speeds of the joints with their limits, and the speed of the TCP."""
import numpy
from matplotlib.ticker import MaxNLocator

from flight import motion
from flight.drawing import style

ROOM = 0.12  # of what is shown, above and below the curve
LEAST_ANGLES, LEAST_SPEEDS = 1.0, 2.0  # [deg, deg/s]; so much is shown at least, or a joint that stands would show its noise


def draw_angles(axes, analysis, index):
    """One joint: its angle, as large as it fits, and what it may reach."""
    joints, use = analysis.run.joints, analysis.uses[index]
    strip(axes, joints.times, joints.angles[:, index], index, LEAST_ANGLES)
    if use.axis:
        limits(axes, use.axis.lower, use.axis.upper)
        corner(axes, f"{use.axis.lower:g}° to {use.axis.upper:g}°")
        told = f"{use.margin:.0f}°\nleft" if use.margin >= 0 else f"{-use.margin:.1f}°\nbeyond"
        note(axes, told, use.margin < 0)
    axes.set_ylabel(f"J{index + 1}", rotation=0, ha="right", va="center", fontweight="bold", color=style.JOINTS[index % 6])


def draw_speeds(axes, analysis, index):
    """One joint: its speed, as large as it fits, and its rated speed."""
    joints, use = analysis.run.joints, analysis.uses[index]
    strip(axes, joints.times, joints.speeds[:, index], index, LEAST_SPEEDS)
    if use.axis:
        limits(axes, -use.axis.rated_speed, use.axis.rated_speed)
        corner(axes, f"±{use.axis.rated_speed:g}°/s")
        note(axes, f"{use.share:.0f} %\nof rated", use.share > 100)


def strip(axes, times, values, index, least):
    """The scale is that of the curve: against the limits the curve of a small path is flat."""
    axes.plot(*style.thinned(times, values), color=style.JOINTS[index % 6], zorder=3)
    axes.axhline(0, color=style.FAINT, linewidth=0.8, zorder=0)
    low, high = (float(of(values)) for of in (numpy.nanmin, numpy.nanmax)) if numpy.isfinite(values).any() else (0.0, 0.0)
    middle, half = (low + high) / 2, max(high - low, least) / 2
    axes.set_ylim(middle - (1 + 2 * ROOM) * half, middle + (1 + 2 * ROOM) * half)
    axes.yaxis.set_major_locator(MaxNLocator(3))
    axes.tick_params(axis="y", labelsize=7)


def limits(axes, lower, upper):
    """Dashed where the curve comes near enough that they are in the picture."""
    low, high = axes.get_ylim()
    for value in (lower, upper):
        if low <= value <= high:
            axes.axhline(value, color=style.LIMIT, linestyle=(0, (5, 3)), linewidth=0.9)


def corner(axes, words):
    axes.text(0.995, 0.97, words, transform=axes.transAxes, ha="right", va="top", fontsize=7, color=style.LIMIT, zorder=4,
              bbox={"facecolor": style.PAPER, "edgecolor": "none", "alpha": 0.75, "pad": 0.8})


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
