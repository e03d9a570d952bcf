"""Fact sheet 1.2: the life of connections, and of the Listen node behind them."""
import statistics
import time

from motions import LONG, SHORT, stands
from suite import CHOICE, DERIVED, check, equal, near, true


def refused(robot):
    try:
        robot.connect_script()
    except ConnectionRefusedError:
        return True
    return False


@check('TM-1.2.01', 'the script port is closed, and its clients are dropped, when the project stops', 'M 7.1',
       since='1.80')
def the_port_closes_with_the_project(robot):
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')
    robot.stop_project()
    robot.listen.until_closed()
    true(refused(robot), 'the port still takes connections')


@check('TM-1.2.02', 'the port opens when a project with a Listen node is run', 'M 7.1', since='1.80')
def the_port_opens_with_the_project(robot):
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    robot.run_project()
    robot.wait_for('Project_Run', True, 1)
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')


@check('TM-1.2.03', 'the port stays open while the flow is in another node', 'M 7.1', time_scale=0.05)
def the_port_stays_open_outside_the_node(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    equal(robot.listen.ask('00').rstrip(','), '00,false')
    equal(robot.connect_script().ask('00').rstrip(','), '00,false', 'a new client')


@check('TM-1.2.04', 'each time the node is entered, `$TMSCT,9,0,Listen1,*4C` is sent', 'M 7.3')
def the_node_says_when_it_is_entered(robot):
    for _ in range(3):
        equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
        robot.listen.until('TMSCT,0,Listen1')
        equal(robot.listen.ask('00'), '00,true,Listen1')


@check('TM-1.2.05', 'the entry message is the text of Send Message', 'M 7.1', listen_node='Cell, left')
def the_entry_message_is_free_text(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    robot.listen.until('TMSCT,0,Cell, left')


@check('TM-1.2.06', 'a client that connects later gets no entry message', 'M 7.3', safe=True)
def a_later_client_gets_no_entry_message(robot):
    true(robot.listen.ask('00').startswith('00,'), 'no answer')
    equal([str(frame) for frame in robot.listen.frames if str(frame).startswith('TMSCT,0,')], [], 'entry messages')


@check('TM-1.2.07', 'without timeouts the node is not left', 'M 7.1', time_scale=100)
def the_node_waits_for_ever(robot):
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')
    robot.later(30)
    equal(robot.listen.in_listen_node(), True, 'in a Listen node after 30 s')
    equal([str(frame) for frame in robot.listen.frames if frame.header == 'TMSCT'], [], 'entry messages')


def reentered(robot, seconds):
    """Whether the node is left and entered again within a time of the robot's clock."""
    robot.later(seconds)
    return any(str(frame) == 'TMSCT,0,Listen1' for frame in robot.listen.so_far())


@check('TM-1.2.08', 'a connection timeout leaves the node by Fail when no client connects', 'M 7.1',
       connection_timeout=500, reentry_delay=60000)
def the_connection_timeout_ends_the_node(robot):
    robot.later(2)
    equal(robot.listen.in_listen_node(), False, 'in a Listen node')


@check('TM-1.2.09', 'a data timeout leaves the node when a client sends nothing', 'M 7.1', data_timeout=500)
def the_data_timeout_ends_the_node(robot):
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')
    true(reentered(robot, 3), 'the node is not left within 3 s')


@check('TM-1.2.10', 'a data timeout in motion leaves the node when the motion ends', 'FB', data_timeout=500)
def the_data_timeout_waits_for_the_motion(robot):
    joints = robot.value('Joint_Angle')
    equal(robot.listen.run('1', 'PTP("JPP",-45,0,90,0,90,0,10,200,0,false)', 'QueueTag(3)'), 'OK')  # 2.7 s
    true(reentered(robot, 6), 'the node is not left after the motion')
    texts = [str(frame) for frame in robot.listen.frames]
    true('TMSTA,01,03,true' in texts, 'the node is left before the motion has ended: %s' % texts)
    near(robot.value('Joint_Angle')[0], joints[0] - 45, 0.01, 'J1')


@check('TM-1.2.11', 'ScriptExit leaves the node when the queued motion is finished', 'FB')
def script_exit_waits_for_the_motion(robot):
    equal(robot.listen.run('1', SHORT, 'QueueTag(3)', 'ScriptExit()'), 'OK')
    seen = [str(frame) for frame in robot.listen.until('TMSCT,0,Listen1')]
    true('TMSTA,01,03,true' in seen, 'the node was entered again before the motion had ended: %s' % seen)


@check('TM-1.2.12', 'several clients are served at once', 'M 7.4', safe=True)
def several_clients_are_served(robot):
    clients = [robot.connect_script() for _ in range(8)]
    for client in clients:
        client.send('TMSTA', '00')
    for client in clients:
        true(str(client.receive()).startswith('TMSTA,00,'), 'no answer')


@check('TM-1.2.13', 'the entry message goes to all clients', 'M 7.4')
def the_entry_message_goes_to_all(robot):
    other = robot.connect_script()
    equal(other.in_listen_node(), True, 'in a Listen node')
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    for client in (robot.listen, other):
        client.until('TMSCT,0,Listen1')


@check('TM-1.2.14', 'the completion of a tag goes to all clients', 'M 7.4', since='1.76')
def a_tag_goes_to_all(robot):
    other = robot.connect_script()
    equal(other.in_listen_node(), True, 'in a Listen node')
    equal(robot.listen.run('1', SHORT, 'QueueTag(3)'), 'OK')
    for client in (robot.listen, other):
        client.until('TMSTA,01,03,true')


@check('TM-1.2.15', 'what ListenSend sends goes to all clients', 'M 7.4', since='1.76', safe=True)
def listen_send_goes_to_all(robot):
    other = robot.connect_script()
    true(other.ask('00').startswith('00,'), 'no answer')
    equal(robot.listen.run('1', 'ListenSend(90,"Hello World")'), 'OK')
    other.until('TMSTA,90,Hello World')


@check('TM-1.2.16', 'the reply to a script goes to its sender alone', 'I', DERIVED, safe=True)
def the_reply_goes_to_the_sender(robot):
    other = robot.connect_script()
    true(other.ask('00').startswith('00,'), 'no answer')
    true(robot.listen.run('mine', 'NoSuchFunction()').startswith('ERROR'), 'no ERROR')
    equal([str(frame) for frame in other.so_far()], [], 'what the other client received')


@check('TM-1.2.17', 'scripts of several clients run in the order of their arrival', '?', CHOICE, since='1.76')
def clients_share_one_order(robot):
    other = robot.connect_script()
    equal(other.in_listen_node(), True, 'in a Listen node')
    robot.listen.script('first', SHORT, 'QueueTag(1)', 'WaitQueueTag(1)')
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')  # so that the first has arrived
    equal(other.run('second', 'QueueTag(2)'), 'OK')
    tags = [str(frame) for frame in other.frames + other.until('TMSTA,01,02,true') if frame.text.startswith('01,')]
    equal(tags[:2], ['TMSTA,01,01,true', 'TMSTA,01,02,true'])


@check('TM-1.2.18', 'a question is answered within some tens of milliseconds', 'L tmr_ros2 #20', time_scale=1,
       safe=True)
def answers_come_quickly(robot):
    times = []
    for _ in range(20):
        begin = time.monotonic()
        robot.listen.ask('00')
        times.append(time.monotonic() - begin)
    true(
        statistics.median(times) < 0.05,
        'half of the answers took more than %.0f ms' % (1e3 * statistics.median(times)))


@check('TM-1.2.19', 'a motion continues when its client disconnects', '?', CHOICE, since='1.80')
def a_motion_outlives_its_client(robot):
    watcher = robot.connect_script()
    equal(watcher.in_listen_node(), True, 'in a Listen node')
    equal(robot.listen.run('1', SHORT, 'QueueTag(3)'), 'OK')
    robot.listen.close()
    watcher.until('TMSTA,01,03,true')
    near(robot.value('Joint_Angle')[0], -20, 0.01, 'J1')


@check('TM-1.2.20', 'stopping the project stops the arm', 'M 7.1', since='1.80', time_scale=1)
def stopping_the_project_stops_the_arm(robot):
    equal(robot.listen.run('1', LONG), 'OK')
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    true(stands(robot)[0] > -80, 'the motion was made')
