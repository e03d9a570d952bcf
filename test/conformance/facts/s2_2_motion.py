"""Fact sheet 2.2: what the motion and control functions do. Seen on the status port."""
from motions import distance, same_angles, same_pose, shifted, stands, text
from suite import CHOICE, DERIVED, check, equal, near, true


def tool(robot):
    return robot.value('Coord_Robot_Tool')


# PTP, Line, Circle, PLine -----------------------------------------------------------------------


@check('TM-2.2.40', 'PTP JPP ends at the joints', 'M 8', since='1.80')
def ptp_reaches_joints(robot):
    robot.move('PTP("JPP",10,5,80,10,85,-20,100,200,0,false)')
    near(robot.value('Joint_Angle'), [10, 5, 80, 10, 85, -20], 0.01, 'Joint_Angle')


@check('TM-2.2.41', 'PTP CPP ends at the pose of the TCP, mm and deg', 'M 8', since='1.80')
def ptp_reaches_a_pose(robot):
    target = shifted(tool(robot), -30, 20, -10)
    robot.move('PTP("CPP",%s,100,200,0,false)' % text(target))
    same_pose(tool(robot), target, 'Coord_Robot_Tool')


EIGHT = {  # TM 5.1
    (0, 2, 4): (0, 0, 90, 0, 90, 0),
    (0, 2, 5): (0, 43.1401, 30.2710, -163.4111, -90, -180),
    (0, 3, 4): (0, 86.8699, -90, 93.1301, 90, 0),
    (0, 3, 5): (0, 72.5642, -30.2710, -132.2933, -90, -180),
    (1, 2, 4): (147.3458, 0, -90, 0, -90, -32.6542),
    (1, 2, 5): (147.3458, -43.1401, -30.2710, 163.4111, 90, 147.3458),
    (1, 3, 4): (147.3458, -86.8699, 90, -93.1301, -90, -32.6542),
    (1, 3, 5): (147.3458, -72.5642, 30.2710, 132.2933, 90, 147.3458),
}


@check('TM-2.2.42', 'PTP CPP with a pose ends in that one of the eight configurations', 'M appendix; I: the numbers',
       DERIVED, since='1.80', model='tm5-700')
def ptp_chooses_the_configuration(robot):
    for configuration, joints in EIGHT.items():
        robot.move('PTP("CPP",417.5,-122.3,361.05,180,0,90,100,200,0,false,%d,%d,%d)' % configuration)
        same_angles(robot.value('Joint_Angle'), joints, 0.01, 'configuration %s: joints' % (configuration, ))


@check('TM-2.2.43', 'PTP CPP without a pose keeps the configuration that the arm has', 'FB', since='1.80',
       model='tm5-700')
def ptp_keeps_the_configuration(robot):
    robot.move('PTP("JPP",0,86.8699,-90,93.1301,90,0,100,200,0,false)')
    robot.move('PTP("CPP",437.5,-122.3,361.05,180,0,90,100,200,0,false)')
    joints = robot.value('Joint_Angle')
    true(joints[2] < 0 < joints[4], 'another configuration: %s' % joints)


@check('TM-2.2.44', 'Line moves the TCP on a straight line', 'M 8', since='1.80')
def line_is_straight(robot):
    start = tool(robot)
    target = shifted(start, -80, 60, 0)
    frames = robot.observe('Line("CAP",%s,200,200,0,false)' % text(target))
    for frame in frames:
        at = frame['Coord_Robot_Tool']
        aside = 0.6 * (at[0] - start[0]) + 0.8 * (at[1] - start[1])
        near([aside, at[2] - start[2]], [0, 0], 0.02, 'mm from the line')
    same_pose(tool(robot), target, 'Coord_Robot_Tool')


@check('TM-2.2.45', 'Circle with angle 0 goes from the pose through via to the end', 'M 8', since='1.80')
def circle_passes_via(robot):
    start = tool(robot)
    centre, via, end = shifted(start, -50), shifted(start, -50, 50), shifted(start, -100)
    frames = robot.observe('Circle("CAP",%s,%s,200,200,0,0,false)' % (text(via), text(end)))
    near([distance(frame['Coord_Robot_Tool'], centre) for frame in frames], [50] * len(frames), 0.02, 'radius')
    true(min(distance(frame['Coord_Robot_Tool'], via) for frame in frames) < 5, 'via is not passed')
    same_pose(tool(robot), end, 'Coord_Robot_Tool')


@check('TM-2.2.46', 'Circle with angle 0 turns the TCP towards the pose of the end', 'M 8', since='1.80')
def circle_turns_towards_the_end(robot):
    start = tool(robot)
    end = shifted(start, -100, 0, 0, 0, 0, 20)
    robot.move('Circle("CAP",%s,%s,200,200,0,0,false)' % (text(shifted(start, -50, 50)), text(end)))
    same_pose(tool(robot), end, 'Coord_Robot_Tool')


@check('TM-2.2.47', 'Circle with an angle travels that angle, and keeps the orientation', 'M 8', since='1.80')
def circle_travels_an_angle(robot):
    start = tool(robot)
    end = shifted(start, -100, 0, 0, 0, 0, 20)
    robot.move('Circle("CAP",%s,%s,200,200,0,270,false)' % (text(shifted(start, -50, 50)), text(end)))
    same_pose(tool(robot), shifted(start, -50, -50), 'Coord_Robot_Tool')


@check('TM-2.2.48', 'PLine CAP ends at the pose, PLine JAP at the joints', 'M 8', since='1.80')
def pline_reaches_its_targets(robot):
    target = shifted(tool(robot), -40, 30)
    robot.move('PLine("CAP",%s,200,200,0)' % text(target))
    same_pose(tool(robot), target, 'Coord_Robot_Tool')
    robot.move('PLine("JAP",3,2,88,1,90,0,200,200,0)')
    near(robot.value('Joint_Angle'), [3, 2, 88, 1, 90, 0], 0.01, 'Joint_Angle')


@check('TM-2.2.49', 'PLine passes close points with constant speed when it blends', 'M 8', since='1.80')
def pline_keeps_its_speed(robot):
    start = tool(robot)
    points = [shifted(start, -10.0 * n, 0.02 * n * n) for n in range(1, 16)]
    frames = robot.observe(*('PLine("CAP",%s,100,100,50)' % text(point) for point in points))
    inner = [frame['TCP_Speed3D'] for frame in frames if -130 < frame['Coord_Robot_Tool'][0] - start[0] < -20]
    true(inner, 'nothing was seen between the ends')
    near(inner, [100] * len(inner), 10, 'TCP_Speed3D')


# Relative motion --------------------------------------------------------------------------------


@check('TM-2.2.50', 'Move_PTP JPP turns the joints by the given angles', 'M 8', since='1.80')
def move_ptp_of_joints(robot):
    joints = robot.value('Joint_Angle')
    robot.move('Move_PTP("JPP",5,-4,3,-2,1,10,100,200,0,false)')
    near(robot.value('Joint_Angle'), shifted(joints, 5, -4, 3, -2, 1, 10), 0.01, 'Joint_Angle')


@check('TM-2.2.51', 'Move_PTP CPP and Move_Line C** shift the TCP along the axes of the base', 'M 8', since='1.80')
def moves_in_the_base(robot):
    start = tool(robot)
    robot.move('Move_PTP("CPP",-30,20,10,0,0,0,100,200,0,false)')
    same_pose(tool(robot), shifted(start, -30, 20, 10), 'after Move_PTP')
    for form in ('CPP', 'CPR', 'CAP', 'CAR'):
        robot.move('Move_Line("%s",0,-5,-2,0,0,0,100,200,0,false)' % form)
    same_pose(tool(robot), shifted(start, -30, 0, 2), 'after four Move_Line')


@check('TM-2.2.52', 'Move_* in C uses the active base', 'M 8', since='1.80')
def moves_in_another_base(robot):
    start = tool(robot)
    robot.move('ChangeBase(0,0,0,0,0,90)', 'Move_Line("CAP",20,0,0,0,0,0,100,200,0,false)')
    same_pose(tool(robot), shifted(start, 0, 20), 'Coord_Robot_Tool')


@check('TM-2.2.53', 'Move_PTP TPP and Move_Line T** shift it along the axes of the tool at the start', 'M 8',
       since='1.80')
def moves_in_the_tool(robot):
    start = tool(robot)
    near(start[3:5], [180, 0], 0.01, 'the tool must look down')
    robot.move('Move_PTP("TPP",0,0,40,0,0,0,100,200,0,false)')
    same_pose(tool(robot), shifted(start, 0, 0, -40), 'after Move_PTP')
    for form in ('TPP', 'TPR', 'TAP', 'TAR'):
        robot.move('Move_Line("%s",0,0,-10,0,0,0,100,200,0,false)' % form)
    same_pose(tool(robot), start, 'after four Move_Line')


@check('TM-2.2.54', 'Move_PLine CAP, TAP and JAP', 'M 8', since='1.80')
def move_pline(robot):
    start, joints = tool(robot), robot.value('Joint_Angle')
    robot.move('Move_PLine("CAP",-30,0,0,0,0,0,100,200,0)', 'Move_PLine("TAP",0,0,40,0,0,0,100,200,0)')
    same_pose(tool(robot), shifted(start, -30, 0, -40), 'Coord_Robot_Tool')
    robot.move('PTP("JPP",%s,100,200,0,false)' % text(joints), 'Move_PLine("JAP",5,0,0,0,0,-5,100,200,0)')
    near(robot.value('Joint_Angle'), shifted(joints, 5, 0, 0, 0, 0, -5), 0.01, 'Joint_Angle')


@check('TM-2.2.55',
       'a turn in the base is about axes of the base through the TCP; one in the tool about those of the tool', '?',
       CHOICE, since='1.80')
def moves_turn(robot):
    start = tool(robot)  # 180, 0, 90: a turn about the tool's Z is one about -Z of the base
    robot.move('Move_Line("CAP",0,0,0,0,0,15,100,200,0,false)')
    same_pose(tool(robot), shifted(start, 0, 0, 0, 0, 0, 15), 'in the base')
    robot.move('Move_Line("TAP",0,0,0,0,0,15,100,200,0,false)')
    same_pose(tool(robot), start, 'in the tool')


# Base, tool, load -------------------------------------------------------------------------------


@check('TM-2.2.56', 'poses are in the current base', 'M 8', since='1.80')
def poses_are_in_the_base(robot):
    start = tool(robot)
    robot.move('ChangeBase(100,50,0,0,0,0)', 'PTP("CPP",%s,100,200,0,false)' % text(shifted(start, -120, -50)))
    same_pose(tool(robot), shifted(start, -20), 'Coord_Robot_Tool')
    same_pose(robot.value('Coord_Base_Tool'), shifted(start, -120, -50), 'Coord_Base_Tool')
    equal(robot.value('Base_Value'), [100, 50, 0, 0, 0, 0], 'Base_Value')


@check('TM-2.2.57', 'ChangeTCP sets frame, mass, inertia and mass centre', 'M 8', since='1.80')
def change_tcp_sets_all(robot):
    robot.move('ChangeTCP({0,0,150,0,0,90},2,{2,0.5,0.25,0,0,-80,0,0,0})')
    equal(robot.values('TCP_Value', 'TCP_Mass', 'TCP_MOI', 'TCP_MCF'),
          [[0, 0, 150, 0, 0, 90], 2, [2, 0.5, 0.25], [0, 0, -80, 0, 0, 0]])


@check('TM-2.2.58', 'ChangeTCP and ChangeBase by name set the name', 'M 8', since='1.80')
def names_are_set(robot):
    robot.move('ChangeTCP(0,0,150,0,0,90)', 'ChangeBase(1,2,3,0,0,0)')
    robot.move('ChangeTCP("NOTOOL")', 'ChangeBase("RobotBase")')
    equal(robot.values('TCP_Name', 'TCP_Value', 'Base_Name', 'Base_Value'), ['NOTOOL', [0] * 6, 'RobotBase', [0] * 6])


@check('TM-2.2.59', 'the names are empty when frames are given by value', '?', CHOICE, since='1.80')
def values_have_no_name(robot):
    robot.move('ChangeTCP(0,0,150,0,0,90)', 'ChangeBase(1,2,3,0,0,0)')
    equal(robot.values('TCP_Name', 'Base_Name'), ['', ''])


# PVT --------------------------------------------------------------------------------------------


@check('TM-2.2.60', 'PVT of joints: one script with the whole trajectory, which ends at its last point', 'M 8, D',
       since='1.80')
def pvt_of_joints(robot):
    robot.move('PVTEnter(0)', 'PVTPoint(5,0,90,0,90,0,10,0,0,0,0,0,0.5)', 'PVTPoint(10,0,90,0,90,5,0,0,0,0,0,0,1.0)',
               'PVTExit()')
    near(robot.value('Joint_Angle'), [10, 0, 90, 0, 90, 5], 0.01, 'Joint_Angle')


@check('TM-2.2.61', 'PVT of poses', 'M 8', since='1.80')
def pvt_of_poses(robot):
    target = shifted(tool(robot), -50)
    robot.move('PVTEnter(1)', 'PVTPoint(%s,0,0,0,0,0,0,2)' % text(target), 'PVTExit()')
    same_pose(tool(robot), target, 'Coord_Robot_Tool')


@check('TM-2.2.62', 'the duration of a PVT point is in seconds, from the point before', 'M84 8, D, P', since='1.80')
def pvt_durations_are_seconds(robot):
    frames = robot.observe('PVTEnter(0)', 'PVTPoint(5,0,90,0,90,0,10,0,0,0,0,0,1)',
                           'PVTPoint(10,0,90,0,90,0,0,0,0,0,0,0,1)', 'PVTExit()')
    moving = sum(any(frame['Joint_Speed']) for frame in frames) * 0.015
    near(moving, 2, 0.1, 'seconds of motion')


@check('TM-2.2.63', 'PVT interpolates with cubics: rest to rest, the speed in the middle is 1.5 times the mean', 'I',
       DERIVED, since='1.80')
def pvt_is_cubic(robot):
    frames = robot.observe('PVTEnter(0)', 'PVTPoint(20,0,90,0,90,0,0,0,0,0,0,0,2)', 'PVTExit()')
    near(max(abs(frame['Joint_Speed'][0]) for frame in frames), 15, 0.2, 'highest speed of J1')


@check('TM-2.2.64', 'QueueTag may be used within PVT', 'W', DERIVED, since='1.80')
def tags_within_pvt(robot):
    robot.move('PVTEnter(0)', 'PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,0.5)', 'QueueTag(2)',
               'PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,0.5)', 'PVTExit()', tag=3)
    seen = [frame.text for frame in robot.listen.frames if frame.header == 'TMSTA']
    equal(seen[:2], ['01,02,true', '01,03,true'])


@check('TM-2.2.65', 'PVTPause pauses a PVT motion, PVTResume continues it', 'M 8', since='1.80', time_scale=5)
def pvt_pauses(robot):
    robot.later(0)
    equal(robot.listen.run('1', 'PVTEnter(0)', 'PVTPoint(30,0,90,0,90,0,0,0,0,0,0,0,10)', 'PVTExit()', 'QueueTag(1)'),
          'OK')
    equal(robot.listen.run('2', 'PVTPause()'), 'OK')
    stands(robot)
    equal(robot.listen.run('3', 'PVTResume()'), 'OK')
    robot.listen.until('TMSTA,01,01,true')
    near(robot.value('Joint_Angle')[0], 30, 0.01, 'J1')


@check('TM-2.2.66', 'a tool given by value without its mass keeps the mass; NOTOOL has none', '?', CHOICE, since='1.80')
def the_mass_is_kept(robot):
    robot.move('ChangeTCP({0,0,150,0,0,90},2)', 'ChangeTCP({0,0,100,0,0,0})')
    equal(robot.value('TCP_Mass'), 2, 'TCP_Mass')
    robot.move('ChangeTCP("NOTOOL")')
    equal(robot.value('TCP_Mass'), 0, 'TCP_Mass')
