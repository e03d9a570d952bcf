"""Fact sheet 2.6: failure codes in Error_Code. Which cause has which code is told by their names alone.

Not checked are 0x05, 0x11, 0x22 and the codes of hardware: no frame of a client brings them about for sure.
"""
from motions import OUT_OF_REACH, shifted, text
from suite import CHOICE, DERIVED, check, equal, near, true


def fails_with(robot, code, *lines):
    equal(robot.listen.run('1', *lines), 'OK')
    robot.wait_for('Robot_Error', True, 30)
    found = robot.value('Error_Code')
    equal('0x%X' % found, '0x%X' % code, 'Error_Code')


@check('TM-2.6.01', '0x00: no error', 'C', since='1.80', safe=True)
def no_error(robot):
    if not robot.value('Robot_Error'):
        equal(robot.value('Error_Code'), 0, 'Error_Code')


@check('TM-2.6.02', '0x01: out of the working range', 'C', CHOICE, since='1.80')
def out_of_range(robot):
    fails_with(robot, 0x01, OUT_OF_REACH)


@check('TM-2.6.03', '0x12, 0x14 or, as singular, 0x14064: a line that cannot be followed between its reachable ends',
       'C: the names', DERIVED, since='1.80')
def unreachable_between(robot):
    start = robot.value('Coord_Robot_Tool')
    robot.move('PTP("CPP",%s,100,200,0,false)' % text(shifted(start, 0, 62)))  # 60 mm beside axis 1; 122.3 are reached
    equal(robot.listen.run('1', 'Line("CAP",%s,500,200,0,false)' % text(shifted(start, -900, 62))), 'OK')
    robot.wait_for('Robot_Error', True, 30)
    true(robot.value('Error_Code') in (0x12, 0x14, 0x14064), 'Error_Code 0x%X' % robot.value('Error_Code'))


@check('TM-2.6.04', '0x15: no circle through three points on a line', 'C', CHOICE, since='1.80')
def no_circle(robot):
    start = robot.value('Coord_Robot_Tool')
    fails_with(robot, 0x15,
               'Circle("CAP",%s,%s,100,200,0,0,false)' % (text(shifted(start, -20)), text(shifted(start, -40))))


@check('TM-2.6.05', '0x21: speed over its range', 'C', CHOICE, since='1.80')
def speed_over_range(robot):
    fails_with(robot, 0x21, 'PTP("JPP",10,0,90,0,90,0,500,200,0,false)')


@check('TM-2.6.06', '0x1405A: a joint outside its range', 'C', CHOICE, since='1.80')
def joint_out_of_range(robot):
    fails_with(robot, 0x1405A, 'PTP("JPP",0,0,170,0,90,0,10,200,0,false)')


@check('TM-2.6.07', '0x14064: a line through the shoulder singularity', 'C', CHOICE, since='1.80')
def singular(robot):
    start = robot.value('Coord_Robot_Tool')  # its wrist is 122.3 mm beside axis 1, and comes over it
    fails_with(robot, 0x14064, 'Line("CAP",%s,200,200,0,false)' % text(shifted(start, -600)))


@check('TM-2.6.08', 'an error ends when the next motion is made', '?', CHOICE, since='1.80')
def the_next_motion_clears(robot):
    fails_with(robot, 0x01, OUT_OF_REACH)
    robot.move('PTP("JPP",10,0,90,0,90,0,100,200,0,false)')
    near(robot.value('Joint_Angle')[0], 10, 0.01, 'J1')
    equal(robot.values('Robot_Error', 'Error_Code'), [False, 0])


@check('TM-2.6.09', 'entries queued after a motion that fails are dropped', '?', CHOICE, since='1.80')
def the_queue_is_dropped(robot):
    fails_with(robot, 0x01, OUT_OF_REACH, 'PTP("JPP",10,0,90,0,90,0,100,200,0,false)')
    robot.later(2)
    near(robot.value('Joint_Angle')[0], 0, 0.01, 'J1')


@check('TM-2.6.10', 'Error_Time gives the time of the error', 'C: the item', DERIVED, since='1.80')
def the_error_has_a_time(robot):
    fails_with(robot, 0x01, OUT_OF_REACH)
    true(robot.value('Error_Time'), 'Error_Time is empty')
