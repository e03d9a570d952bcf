"""Colours and settings that all pictures share. The colours can be told apart by people who do not see all of them."""
import matplotlib
import numpy

from flight import analysis

matplotlib.use("Agg")  # without a display

JOINTS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9")
ACTUAL, PLANNED, LIMIT = "#0072b2", "#8fa3b5", "#c0392b"
INK, FAINT, PAPER = "#22303c", "#d9e0e6", "#ffffff"
GOOD, BAD, REFUSED, STOPPED, OPEN = "#2e8b57", "#c0392b", "#d9902f", "#7a62b0", "#8fa3b5"
KINDS = {analysis.SUCCEEDED: GOOD, analysis.REFUSED: REFUSED, analysis.STOPPED: STOPPED, analysis.FAILED: BAD, analysis.OPEN: OPEN}
SETTINGS = {
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": 9, "axes.titlesize": 10, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.edgecolor": "#a9b4be", "axes.labelcolor": INK, "text.color": INK, "axes.titlecolor": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.grid": True, "grid.color": FAINT, "grid.linewidth": 0.6, "axes.axisbelow": True,
    "axes.spines.top": False, "axes.spines.right": False, "figure.facecolor": PAPER, "axes.facecolor": PAPER, "legend.frameon": False,
    "text.parse_math": False, "legend.fontsize": 8, "lines.linewidth": 1.3, "svg.hashsalt": "cobot_command", "xtick.labelsize": 8,
    "ytick.labelsize": 8}
MOST_POINTS = 3000  # of a line: more than a picture has columns


def thinned(times, values):
    """A line with as few points as a picture needs; what is least and most in each piece stays."""
    count = len(times)
    if count <= MOST_POINTS:
        return times, values
    size = -(-2 * count // MOST_POINTS)
    kept = set()
    for begin in range(0, count, size):
        piece = values[begin:begin + size]
        kept |= {begin + int(numpy.argmin(piece)), begin + int(numpy.argmax(piece))}
    kept = sorted(kept)
    return times[kept], values[kept]


def printable(text):
    """What a picture can show: other characters than letters and signs are written as escapes."""
    return "".join(letter if letter.isprintable() else letter.encode("unicode_escape").decode() for letter in text)


def shortened(text, most):
    text = printable(text)
    return text if len(text) <= most else text[:most - 1].rstrip() + "…"
