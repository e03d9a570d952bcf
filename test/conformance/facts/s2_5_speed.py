"""Fact sheet 2.5: speeds, times to top speed, blending. Seen in the status stream, a frame each 15 ms of its time."""
from motions import BACK, distance, shifted, text
from robot import STREAM_PERIOD
from suite import CHOICE, DERIVED, check, near, true

HALF_TURN = 'PTP("JPP",-90,0,90,0,90,0,%s,%s,0,false)'


def speeds(frames, joint):
    return [abs(frame['Joint_Speed'][joint]) for frame in frames]


def corner(robot, blend, form='CAP'):
    """Two lines at a right angle, with ramps of 20 mm: the frames, and the corner."""
    start = robot.value('Coord_Robot_Tool')
    middle, end = shifted(start, -100), shifted(start, -100, 100)
    line = 'Line("%s",%s,100,400,%s,true)'
    frames = robot.observe(line % (form, text(middle), blend), line % (form, text(end), 0))
    near(robot.value('Coord_Robot_Tool')[:3], end[:3], 0.02, 'end')
    return frames, middle


def gap(frames, point):
    """How near the TCP comes to a point."""
    return min(distance(frame['Coord_Robot_Tool'], point) for frame in frames)


@check('TM-2.5.01', 'the speed of PTP is a percentage of the rated speed of the joint (180 deg/s)', 'M, DS',
       since='1.80')
def percent_of_the_joint_speed(robot):
    for percent in (10, 50):
        top = max(speeds(robot.observe(HALF_TURN % (percent, 100)), 0))
        near(top, 1.8 * percent, 0.5, 'deg/s of J1 at %d %%' % percent)
        robot.move(BACK)


@check('TM-2.5.02', 'the joint with the longest travel determines the time: its rated speed applies', 'DS', DERIVED,
       since='1.80')
def rated_speeds_differ(robot):
    top = max(speeds(robot.observe('PTP("JPP",0,0,90,0,90,90,20,100,0,false)'), 5))
    near(top, 45, 0.7, 'deg/s of J6, rated 225, at 20 %')


@check('TM-2.5.03', 'all joints of a PTP move in step', 'M', since='1.80')
def joints_move_in_step(robot):
    frames = robot.observe('PTP("JPP",-60,10,80,0,90,30,50,200,0,false)')
    for frame in frames:
        joints = frame['Joint_Angle']
        done = joints[0] / -60
        near([joints[1], joints[2] - 90, joints[5]], [10 * done, -10 * done, 30 * done], 0.02, 'J2, J3, J6')


@check('TM-2.5.04', 'the project speed scales all motions', 'L tmr_ros2 #20, #41', since='1.80')
def the_project_speed_scales(robot):
    robot.set_project_speed(50)
    near(max(speeds(robot.observe(HALF_TURN % (40, 100)), 0)), 36, 0.5, 'deg/s of J1 at 40 % of 50 %')


@check('TM-2.5.05', 'the speed of Line CA* is in mm/s', 'M', since='1.80')
def millimetres_per_second(robot):
    start = robot.value('Coord_Robot_Tool')
    frames = robot.observe('Line("CAP",%s,120,100,0,false)' % text(shifted(start, -100)))
    near(max(frame['TCP_Speed3D'] for frame in frames), 120, 1, 'TCP_Speed3D')


@check('TM-2.5.06', 'the speed of Line CP* is a percentage of the typical speed of the model (TM5-900: 1.4 m/s)', 'I',
       CHOICE, since='1.80')
def percent_of_the_tcp_speed(robot):
    start = robot.value('Coord_Robot_Tool')
    frames = robot.observe('Line("CPP",%s,10,100,0,false)' % text(shifted(start, -100)))
    near(max(frame['TCP_Speed3D'] for frame in frames), 140, 2, 'TCP_Speed3D')


@check('TM-2.5.07', 'the time to top speed is in ms, from rest', 'M', since='1.80')
def the_time_to_top_speed(robot):
    for milliseconds in (300, 900):
        found = speeds(robot.observe(HALF_TURN % (20, milliseconds)), 0)
        rising = sum(0.3 < speed < 35.7 for speed in found[:found.index(max(found)) + 1]) * STREAM_PERIOD
        near(rising, milliseconds / 1000, 0.06, 's to rise')
        robot.move(BACK)


@check('TM-2.5.08', 'slowing down takes as long as speeding up', 'I', DERIVED, since='1.80')
def slowing_down_takes_as_long(robot):
    found = speeds(robot.observe(HALF_TURN % (20, 600)), 0)
    top = max(found) - 0.3
    first = next(place for place, speed in enumerate(found) if speed >= top)
    last = max(place for place, speed in enumerate(found) if speed >= top)
    rise, fall = sum(0.3 < speed for speed in found[:first]), sum(0.3 < speed for speed in found[last + 1:])
    near(rise, fall, 3, 'frames')


@check('TM-2.5.09', 'a short motion does not reach its speed', 'I', DERIVED, since='1.80')
def short_motions_are_triangular(robot):
    top = max(speeds(robot.observe('PTP("JPP",-5,0,90,0,90,0,100,1000,0,false)'), 0))
    near(top, 30, 2, 'deg/s of J1: 5 deg at 180 deg/s2')


@check('TM-2.5.10', 'blend 0: the arm stops in the corner', 'M', since='1.80')
def without_blending_it_stops(robot):
    frames, point = corner(robot, 0)
    near(gap(frames, point), 0, 1, 'mm from the corner')
    inner = [frame for frame in frames if gap([frame], point) < 1]
    near(min(frame['TCP_Speed3D'] for frame in inner), 0, 10, 'mm/s in the corner')


@check('TM-2.5.11', 'blend %: the next motion starts before the corner is reached, and the arm does not stop', 'M',
       since='1.80')
def blending_by_percent(robot):
    frames, point = corner(robot, 50)
    true(gap(frames, point) > 1, 'the corner is met')
    near_corner = [frame['TCP_Speed3D'] for frame in frames if gap([frame], point) < 30]
    true(near_corner and min(near_corner) > 20, 'the arm slows down to %s mm/s' % min(near_corner, default=0))


@check('TM-2.5.12', 'a higher blend % leaves earlier', 'M', DERIVED, since='1.80')
def more_blending_is_further(robot):
    frames, point = corner(robot, 20)
    robot.move(BACK)
    more, point_again = corner(robot, 80)
    near(point_again[:3], point[:3], 0.05, 'corner')
    true(
        gap(more, point) > gap(frames, point) + 1,
        '%s mm at 80 %%, %s mm at 20 %%' % (gap(more, point), gap(frames, point)))


@check('TM-2.5.13', 'blend R: within the radius, in mm, around the corner', 'M', since='1.80')
def blending_by_radius(robot):
    frames, point = corner(robot, 20, 'CAR')
    near_corner = gap(frames, point)
    true(1 < near_corner < 20, '%s mm from the corner' % near_corner)
    start = frames[0]['Coord_Robot_Tool']
    for frame in frames:  # on the first line, on the second, or within the radius
        at = frame['Coord_Robot_Tool']
        aside = min(abs(at[1] - start[1]), abs(at[0] - point[0]))
        true(aside < 0.05 or gap([frame], point) < 20.05, '%s is neither on a line nor within the radius' % at)


@check('TM-2.5.14', 'blended PTPs pass the middle without stopping', 'M', since='1.80')
def ptp_blends(robot):
    frames = robot.observe('PTP("JPP",-30,0,90,0,90,0,20,200,60,true)', 'PTP("JPP",-60,0,90,0,90,0,20,200,0,true)')
    middle = [frame['Joint_Speed'][0] for frame in frames if -35 < frame['Joint_Angle'][0] < -25]
    true(middle and max(middle) < -20, 'J1 slows down to %s deg/s' % max(middle, default=0))


@check('TM-2.5.15', 'with disablePrecise true or false the target is reached', 'M', since='1.80')
def both_ways_reach_the_target(robot):
    for target, precise in ((-10, 'true'), (-20, 'false')):
        robot.move('PTP("JPP",%d,0,90,0,90,0,50,200,0,%s)' % (target, precise))
        near(robot.value('Joint_Angle')[0], target, 0.01, 'J1')


@check('TM-2.5.16', 'position and speed are continuous', 'I', DERIVED, since='1.80')
def motion_is_continuous(robot):
    frames = robot.observe(HALF_TURN % (30, 300), 'PTP("JPP",0,0,90,0,90,0,30,300,0,false)')
    for one, other in zip(frames, frames[1:]):
        mean = (one['Joint_Speed'][0] + other['Joint_Speed'][0]) / 2
        near(other['Joint_Angle'][0] - one['Joint_Angle'][0], mean * STREAM_PERIOD, 0.05,
             'deg of J1 between two frames')


@check('TM-2.5.17', 'a time to top speed of 0, as off-line programming tools send it, is accepted', '?', CHOICE,
       since='1.80')
def no_time_to_top_speed(robot):
    found = speeds(robot.observe('PTP("JPP",5,0,90,0,90,0,10,0,0,false)'), 0)
    near(max(found), 18, 0.5, 'deg/s of J1')
    true(robot.value('Robot_Error') in (0, False), 'a robot error')
