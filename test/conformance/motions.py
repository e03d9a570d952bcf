"""Motions that many checks use, and how they look at poses. The arm starts in the posture 0,0,90,0,90,0 deg."""
from suite import equal, near

LONG = 'PTP("JPP",-90,0,90,0,90,0,1,200,0,false)'  # 50 s
SHORT = 'PTP("JPP",-20,0,90,0,90,0,100,100,0,false)'
BACK = 'PTP("JPP",0,0,90,0,90,0,100,100,0,false)'
OUT_OF_REACH = 'PTP("CPP",9000,0,300,180,0,90,10,200,0,false)'

REST = 0.5  # s, in which an arm that is stopped comes to rest


def text(pose):
    """Numbers as arguments of a script."""
    return ','.join('%.5f' % number for number in pose)


def shifted(pose, *offset):
    return [one + other for one, other in zip(pose, offset + (0, ) * (6 - len(offset)))]


def distance(one, other):
    """Between the positions of two poses."""
    return sum((a - b)**2 for a, b in zip(one[:3], other[:3]))**0.5


def same_pose(found, expected, what):
    """Positions to 0.02 mm; angles to 0.02 deg, of which 180 and -180 are one."""
    near(found[:3], expected[:3], 0.02, what)
    same_angles(found[3:], expected[3:], 0.02, what)


def same_angles(found, expected, tolerance, what):
    turns = [(one - other + 180) % 360 - 180 for one, other in zip(found, expected)]
    near(turns, [0] * len(turns), tolerance, '%s %s, deviation' % (what, found))


def stands(robot):
    """The arm comes to rest, and stays at rest: its joints."""
    robot.later(REST)
    joints = robot.value('Joint_Angle')
    robot.later(REST)
    equal(robot.value('Joint_Angle'), joints, 'Joint_Angle')
    return joints
