"""Fact sheet 1.4: priority commands."""
from motions import LONG, SHORT, stands
from suite import CHOICE, DERIVED, check, equal, near, true

BLOCKING = (LONG, 'QueueTag(1)', 'WaitQueueTag(1)')


def script_replies(robot, last):
    """The replies up to and with the last."""
    return [frame.text for frame in robot.listen.until('TMSCT,' + last) if frame.header == 'TMSCT']


def stands_still_short_of_the_target(robot):
    turned = stands(robot)[0]
    true(-80 < turned <= 0, 'J1 stands at %s' % turned)


@check('TM-1.4.01', 'StopAndClearBuffer(0) stops the arm at once, even while a script blocks', 'M84 8.7', since='1.82',
       time_scale=1)
def stop_0_stops_the_arm(robot):
    robot.listen.script('1', LONG, 'WaitQueueTag(0,60000)')
    robot.listen.script('2', 'StopAndClearBuffer(0)')
    equal(robot.listen.reply('2'), 'OK')
    stands_still_short_of_the_target(robot)


@check('TM-1.4.02', 'StopAndClearBuffer(0) does not release a WaitQueueTag(0,…); the script continues after it',
       'M84 8.7', since='1.82')
def stop_0_does_not_end_the_script(robot):
    robot.listen.script('1', LONG, 'QueueTag(1)', 'WaitQueueTag(0,5000)', 'QueueTag(2)')
    robot.listen.script('2', 'StopAndClearBuffer(0)')
    equal(script_replies(robot, '1,OK'), ['2,OK', '1,OK'])
    robot.listen.until('TMSTA,01,02,true')


@check('TM-1.4.03', 'StopAndClearBuffer(1) also ends the running script; the next one starts', 'M84 8.7',
       since='1.82', time_scale=1)
def stop_1_ends_the_script(robot):
    robot.listen.script('1', *BLOCKING, 'QueueTag(2)')
    robot.listen.script('2', 'QueueTag(5)')
    robot.listen.script('3', 'StopAndClearBuffer(1)')
    robot.listen.until('TMSTA,01,05,true')
    equal(robot.listen.ask('01,02'), '01,02,none', 'the tag behind the wait of the ended script')


@check('TM-1.4.04', 'StopAndClearBuffer(2) also drops the buffered scripts: `1,OK`, `3,OK`, and nothing for 2',
       'M84 8.7', since='1.82', time_scale=1)
def stop_2_drops_the_scripts(robot):
    robot.listen.script('1', *BLOCKING)
    robot.listen.script('2', 'QueueTag(5)')
    robot.listen.script('3', 'StopAndClearBuffer(2)')
    equal(script_replies(robot, '3,OK'), ['1,OK', '3,OK'])
    equal(robot.listen.run('4', 'QueueTag(6)'), 'OK')
    equal([f.text for f in robot.listen.frames if f.text.startswith('2,')], [], 'replies to the dropped script')
    equal(robot.listen.ask('01,05'), '01,05,none', 'the tag of the dropped script')


@check('TM-1.4.05', 'ScriptExit(0) overtakes a blocked script: `1,OK`, `2,OK`', 'M84 8.7', since='1.82', time_scale=1)
def exit_0_overtakes(robot):
    robot.listen.script('1', *BLOCKING)
    robot.listen.send_bytes(b'$TMSCT,15,2,ScriptExit(0),*55\r\n')
    equal(script_replies(robot, '2,OK'), ['1,OK', '2,OK'])


@check('TM-1.4.06', 'ScriptExit(1) overtakes a blocked script', 'M84 8.7', since='1.82', time_scale=1)
def exit_1_overtakes(robot):
    robot.listen.script('1', *BLOCKING)
    robot.listen.script('2', 'ScriptExit(1)')
    equal(script_replies(robot, '2,OK'), ['1,OK', '2,OK'])


@check('TM-1.4.07', 'ScriptExit(0) and ScriptExit(1) stop the arm, clear everything, and leave the node', 'M84 8.7',
       since='1.82', time_scale=1)
def exits_stop_and_leave(robot):
    for code in (0, 1):
        robot.listen.script('1', *BLOCKING)
        robot.listen.script('2', 'ScriptExit(%d)' % code)
        robot.listen.until('TMSCT,0,Listen1')
        stands_still_short_of_the_target(robot)
        true(robot.listen.ask('01,01') != '01,01,true', 'the tag behind the stopped motion is true')


@check('TM-1.4.08', 'the argument of a priority command is a literal', 'M84 8.7', since='1.82')
def the_argument_is_a_literal(robot):
    name = robot.name()
    equal(robot.listen.run('1', 'int %s = 0' % name, 'StopAndClearBuffer(%s)' % name), 'ERROR;2')


@check('TM-1.4.09', 'of a script with other lines, only the priority command is executed', 'M84 8.7', since='1.82')
def only_the_priority_command_is_executed(robot):
    equal(robot.listen.run('1', 'QueueTag(3)', 'StopAndClearBuffer(0)', 'QueueTag(4)'), 'OK')
    equal([robot.listen.ask('01,03'), robot.listen.ask('01,04')], ['01,03,none', '01,04,none'])


@check('TM-1.4.10', 'ScriptExit has priority over StopAndClearBuffer in one script', 'M84 8.7', since='1.82')
def exit_beats_stop(robot):
    equal(robot.listen.run('1', 'StopAndClearBuffer(0)', 'ScriptExit(1)'), 'OK')
    robot.listen.until('TMSCT,0,Listen1')


@check('TM-1.4.11', 'of the same kind in one script, the first is executed', 'M84 8.7', since='1.82', time_scale=1)
def the_first_of_a_kind_wins(robot):
    robot.listen.script('1', *BLOCKING)
    robot.listen.script('2', 'QueueTag(5)')
    robot.listen.script('3', 'StopAndClearBuffer(1)', 'StopAndClearBuffer(2)')
    robot.listen.until('TMSTA,01,05,true')  # (1) drops no scripts, (2) would
    robot.listen.script('4', *BLOCKING)
    robot.listen.script('5', 'QueueTag(6)')
    robot.listen.script('6', 'StopAndClearBuffer(2)', 'StopAndClearBuffer(1)')
    equal(robot.listen.reply('6'), 'OK')
    equal(robot.listen.run('7', 'QueueTag(7)'), 'OK')
    equal(robot.listen.ask('01,06'), '01,06,none', 'the tag of the dropped script')


@check('TM-1.4.12', 'the forms without argument wait for their turn', 'I', DERIVED, since='1.76')
def without_argument_there_is_no_priority(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1)', 'WaitQueueTag(1)')
    robot.listen.script('2', 'StopAndClearBuffer()')
    equal(script_replies(robot, '2,OK'), ['1,OK', '2,OK'])
    near(robot.value('Joint_Angle')[0], -20, 0.001, 'J1')


@check('TM-1.4.13', 'before 1.82 there are no priority commands: an argument is an ERROR', 'M 8', DERIVED, until='1.80')
def older_versions_have_none(robot):
    robot.refuses('ScriptExit(0)', 'ScriptExit(1)', 'StopAndClearBuffer(0)', 'StopAndClearBuffer(1)',
                  'StopAndClearBuffer(2)')


@check('TM-1.4.14', 'codes that are not in the table are an ERROR', '?', CHOICE, since='1.82')
def there_are_no_other_codes(robot):
    robot.refuses('ScriptExit(2)', 'ScriptExit(-1)', 'StopAndClearBuffer(3)', 'StopAndClearBuffer(-1)')


@check('TM-1.4.15', 'in a script with an error a priority command has no priority', '?', CHOICE, since='1.82')
def a_faulty_script_has_no_priority(robot):
    equal(robot.listen.run('1', 'StopAndClearBuffer(0)', 'NoSuchFunction()'), 'ERROR;2')
