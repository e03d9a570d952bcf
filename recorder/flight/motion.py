"""What the robot did, of what was recorded of its joints and its tool."""
import dataclasses

import numpy

STANDS = 0.01  # [deg/s]; slower is no motion
LEAST_STEP = 1e-3  # [mm]
JUMP, LEVER = 5.0, 30.0  # [mm], and [mm] for each degree that joints turn: the TCP goes no farther by itself
FITTED = 7  # samples, a tenth of a second: the stream is not evenly spaced as it is recorded


@dataclasses.dataclass(frozen=True)
class JointUse:
    """How far and how fast a joint went. Limits are None where they are not known."""
    name: str
    least: float
    most: float
    fastest: float
    axis: object = None

    @property
    def margin(self):
        """To the nearer limit [deg]; below 0: beyond it."""
        return min(self.least - self.axis.lower, self.axis.upper - self.most) if self.axis else None

    @property
    def share(self):
        """Of the rated speed [%]."""
        return 100 * self.fastest / self.axis.rated_speed if self.axis else None


def axis_of(run, name):
    return next((axis for axis in run.axes if axis.name == name), None)


def joint_uses(run):
    """A JointUse for each joint."""
    joints = run.joints
    return [JointUse(name, float(numpy.nanmin(joints.angles[:, i])), float(numpy.nanmax(joints.angles[:, i])),
                     float(numpy.nanmax(numpy.abs(joints.speeds[:, i]))), axis_of(run, name))
            for i, name in enumerate(joints.names)]


def pieces(run):
    """Slices of the places of the tool; between them its TCP was changed, which moves it and not the arm."""
    times, places = run.tool.times, run.tool.places
    if len(times) < 2:
        return [slice(0, len(times))]
    turned = [numpy.abs(numpy.diff(numpy.interp(times, run.joints.times, angles))) for angles in run.joints.angles.T]
    steps = numpy.linalg.norm(numpy.diff(places, axis=0), axis=1)
    cuts = [0, *(numpy.flatnonzero(steps > JUMP + LEVER * numpy.sum(turned, axis=0)) + 1), len(times)]
    return [slice(begin, end) for begin, end in zip(cuts, cuts[1:])]


def tool_speed(run):
    """(times, speeds [mm/s]) of the TCP."""
    times, places = run.tool.times, run.tool.places
    speeds = numpy.zeros(len(times))
    for piece in pieces(run):
        if piece.stop - piece.start >= FITTED:
            speeds[piece] = numpy.linalg.norm(slopes(times[piece], places[piece]), axis=1)
    return times, speeds


def tool_path(run):
    """The places of the TCP while it moved, with a row of nan where it was changed."""
    rows = []
    for piece in pieces(run):
        places = run.tool.places[piece]
        steps = numpy.linalg.norm(numpy.diff(places, axis=0), axis=1)
        rows += [places[numpy.concatenate(([True], steps > LEAST_STEP))[:len(places)]], numpy.full((1, 3), numpy.nan)]
    return numpy.concatenate(rows[:-1])


def slopes(times, places):
    """Of the straight line through each sample and its neighbours: what the network and the system are late by would be
    seen in the difference of two as a jump of the speed."""
    side = FITTED // 2
    windows = numpy.lib.stride_tricks.sliding_window_view
    t = windows(numpy.pad(times, side, mode="reflect", reflect_type="odd"), FITTED)
    p = windows(numpy.pad(places, ((side, side), (0, 0)), mode="reflect", reflect_type="odd"), FITTED, axis=0)
    t = t - t.mean(axis=1, keepdims=True)
    p = p - p.mean(axis=2, keepdims=True)
    return numpy.einsum("ij,ikj->ik", t, p) / numpy.maximum(numpy.einsum("ij,ij->i", t, t), 1e-12)[:, None]


def deviation(run):
    """The farthest that the TCP was from all planned paths while something was planned [mm]; None without any."""
    if not run.planned or not len(run.tool.times):
        return None
    lines = [line for _, line in run.planned]
    begins, ends = numpy.concatenate([l[:-1] for l in lines]), numpy.concatenate([l[1:] for l in lines])
    are_there = ~numpy.isnan(begins - ends).any(axis=1)
    begins, ends = begins[are_there], ends[are_there]
    moved = run.tool.places[run.tool.times >= run.planned[0][0]]
    return max((nearest(place, begins, ends) for place in moved[::4]), default=None)


def nearest(place, begins, ends):
    """From a place to the nearest of the straight pieces."""
    along = ends - begins
    lengths = numpy.maximum(numpy.einsum("ij,ij->i", along, along), 1e-12)
    share = numpy.clip(numpy.einsum("ij,ij->i", place - begins, along) / lengths, 0, 1)
    return float(numpy.min(numpy.linalg.norm(begins + share[:, None] * along - place, axis=1)))


def motion_span(run):
    """(begin, end) of all motion; None when nothing has moved."""
    moving = run.joints.times[numpy.any(numpy.abs(run.joints.speeds) > STANDS, axis=1)]
    return (float(moving[0]), float(moving[-1])) if len(moving) else None
