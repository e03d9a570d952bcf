"""Fact sheet 2.2: tags, waiting, pausing and stopping."""
from motions import BACK, LONG, SHORT, stands
from suite import CHOICE, DERIVED, check, equal, near, true


@check('TM-2.2.70', 'a tag completes when the motion queued before it has finished, and in order', 'M 8', since='1.80')
def tags_follow_motions(robot):
    robot.listen.script('1', 'QueueTag(1)', SHORT, 'QueueTag(2)', BACK, 'QueueTag(3)')
    seen = [f.text for f in robot.listen.until('TMSTA,01,03,true') if f.header == 'TMSTA']
    equal(seen, ['01,01,true', '01,02,true', '01,03,true'])
    near(robot.value('Joint_Angle')[0], 0, 0.001, 'J1')


@check('TM-2.2.71', 'a tag without a motion before it completes at once', 'I', DERIVED, since='1.76', time_scale=1)
def a_tag_without_motion_completes(robot):
    equal(robot.listen.run('1', 'QueueTag(1)'), 'OK')
    equal(robot.listen.ask('01,01'), '01,01,true')


@check('TM-2.2.72', 'WaitQueueTag returns 1 when the tag is complete', 'M 8', since='1.76')
def waiting_returns_1(robot):
    equal(robot.evaluate('WaitQueueTag(1,60000)', SHORT, 'QueueTag(1)'), '1')


@check('TM-2.2.73', 'WaitQueueTag returns 0 at the timeout', 'M 8', since='1.76')
def waiting_returns_0(robot):
    equal(robot.evaluate('WaitQueueTag(1,100)', LONG, 'QueueTag(1)'), '0')


@check('TM-2.2.74', 'WaitQueueTag returns -1 for an unknown tag', 'M 8', since='1.76')
def waiting_returns_minus_1(robot):
    equal(robot.evaluate('WaitQueueTag(9,100)'), '-1')


@check('TM-2.2.75', 'the script continues after a timeout of WaitQueueTag', 'M 8', since='1.76', time_scale=5)
def waiting_ends(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', 'WaitQueueTag(1,200)'), 'OK')
    equal(robot.listen.ask('01,01'), '01,01,false')


def waits_for_ever(robot, line):
    robot.listen.script('1', 'PTP("JPP",-40,0,90,0,90,0,10,200,0,false)', 'QueueTag(1)', line)
    equal([str(frame) for frame in robot.listen.until('TMSCT,1,OK')], ['TMSTA,01,01,true', 'TMSCT,1,OK'], line)


@check('TM-2.2.76', 'to 1.80: without a timeout, or with one of 0 or less, WaitQueueTag waits for ever', 'M 8',
       since='1.76', until='1.80')
def no_timeout_waits_for_ever(robot):
    for line in ('WaitQueueTag(1)', 'WaitQueueTag(1,0)', 'WaitQueueTag(1,-1)'):
        waits_for_ever(robot, line)
        robot.move(BACK)


@check('TM-2.2.77', 'from 1.82: without a timeout, or with a negative one, it waits for ever', 'M84 8', since='1.82')
def a_negative_timeout_waits_for_ever(robot):
    for line in ('WaitQueueTag(1)', 'WaitQueueTag(1,-1)'):
        waits_for_ever(robot, line)
        robot.move(BACK)


@check('TM-2.2.78', 'from 1.82: a timeout of 0 checks once', 'M84 8', since='1.82', time_scale=1)
def a_timeout_of_0_looks_once(robot):
    robot.listen.script('1', LONG, 'QueueTag(1)', 'WaitQueueTag(1,0)')
    equal(robot.listen.ask('01,01'), '01,01,false')  # at least behind the reply, if the script does not wait
    equal([str(frame) for frame in robot.listen.frames if frame.header == 'TMSCT'], ['TMSCT,1,OK'])


@check('TM-2.2.79', 'from 1.82: WaitQueueTag(0,ms) waits for that time', 'M84 8', since='1.82', time_scale=2)
def tag_0_waits(robot):
    before = robot.value('Joint_Angle')[0]
    equal(robot.listen.run('1', 'PTP("JPP",-90,0,90,0,90,0,10,200,0,false)', 'WaitQueueTag(0,2000)'), 'OK')
    turned = before - robot.value('Joint_Angle')[0]
    true(30 < turned < 89, 'J1 turned by %s deg at 18 deg/s in 2 s' % turned)


@check('TM-2.2.80', 'Pause stops the motion, and scripts continue', 'M 8', since='1.80', time_scale=5)
def pause_stops_the_motion(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', 'Pause()', 'ChangeLoad(1)'), 'OK')
    stands(robot)
    equal(robot.listen.run('2', 'ChangeLoad(2)'), 'OK')
    equal(robot.listen.ask('01,01'), '01,01,false')


@check('TM-2.2.81', 'Resume continues the motion to its target', 'M 8', since='1.80')
def resume_continues(robot):
    equal(robot.listen.run('1', 'PTP("JPP",-90,0,90,0,90,0,10,200,0,false)', 'QueueTag(1)', 'Pause()'), 'OK')
    stands(robot)
    equal(robot.listen.run('2', 'Resume()'), 'OK')
    robot.listen.until('TMSTA,01,01,true')
    near(robot.value('Joint_Angle')[0], -90, 0.001, 'J1')


@check('TM-2.2.82', 'a paused project is shown by Project_Pause', 'M 10: the item', since='1.80')
def the_pause_is_shown(robot):
    equal(robot.value('Project_Pause'), False, 'Project_Pause')
    equal(robot.listen.run('1', 'Pause()'), 'OK')
    robot.wait_for('Project_Pause', True, 1)
    equal(robot.listen.run('2', 'Resume()'), 'OK')
    robot.wait_for('Project_Pause', False, 1)


@check('TM-2.2.83', 'the Play button of the stick continues the motion, too', 'M 8', since='1.80')
def play_continues(robot):
    equal(robot.listen.run('1', 'PTP("JPP",-90,0,90,0,90,0,10,200,0,false)', 'QueueTag(1)', 'Pause()'), 'OK')
    stands(robot)
    robot.press('Stick_PlayPause')
    robot.listen.until('TMSTA,01,01,true')


@check('TM-2.2.84', 'StopAndClearBuffer stops the arm and empties the queue', 'M 8', since='1.80', time_scale=5)
def stop_empties_the_queue(robot):
    equal(robot.listen.run('1', LONG, 'PTP("JPP",0,0,90,0,90,0,1,200,0,false)'), 'OK')
    robot.listen.send_bytes(b'$TMSCT,22,2,StopAndClearBuffer(),*64\r\n')
    equal(robot.listen.reply('2'), 'OK')
    true(-89 < stands(robot)[0] < 1, 'the arm is at its target')


@check('TM-2.2.85', 'after StopAndClearBuffer the arm can be moved again', 'M 8', since='1.80')
def it_moves_after_a_stop(robot):
    equal(robot.listen.run('1', LONG, 'StopAndClearBuffer()'), 'OK')
    robot.move('PTP("JPP",10,0,90,0,90,0,100,100,0,false)')
    near(robot.value('Joint_Angle')[0], 10, 0.01, 'J1')


@check('TM-2.2.86', 'a tag dropped by StopAndClearBuffer is never reported, and is unknown afterwards', '?', CHOICE,
       since='1.76')
def dropped_tags_are_unknown(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', 'StopAndClearBuffer()'), 'OK')
    robot.move(SHORT)
    equal(robot.listen.ask('01,01'), '01,01,none')
    equal([f.text for f in robot.listen.frames if f.text == '01,01,true'], [], 'reports of the dropped tag')


@check('TM-2.2.87', 'StopAndClearBuffer does not end a pause', '?', CHOICE, since='1.80')
def a_stop_does_not_resume(robot):
    equal(robot.listen.run('1', LONG, 'Pause()', 'StopAndClearBuffer()', SHORT, 'QueueTag(2)'), 'OK')
    stands(robot)
    equal(robot.listen.ask('01,02'), '01,02,false')
    equal(robot.listen.run('2', 'Resume()'), 'OK')
    robot.listen.until('TMSTA,01,02,true')


@check('TM-2.2.88', 'if a tag number is queued again, a query returns the latest, and each is reported', '?',
       CHOICE, since='1.76', time_scale=20)
def tags_may_repeat(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1)', BACK, 'QueueTag(1)', 'QueueTag(2,1)')
    robot.listen.until('TMSCT,1,OK')
    equal(sum(f.text == '01,01,true' for f in robot.listen.frames), 2, 'reports of tag 1')


@check('TM-2.2.89', 'a script that is ended by a priority command is answered with OK', 'M84 8.7', since='1.82',
       time_scale=1)
def an_ended_script_is_ok(robot):
    robot.listen.script('1', LONG, 'QueueTag(1,1)')
    robot.listen.script('2', 'StopAndClearBuffer(1)')
    equal(robot.listen.reply('1'), 'OK')
