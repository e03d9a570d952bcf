"""Fact sheet 3: the status port."""
import json
import statistics
import struct

from suite import CHOICE, DERIVED, check, equal, near, true
from tm_client import pack_items, pack_text, unpack_items

READ = {'since': '1.80', 'safe': True}

# The stream --------------------------------------------------------------------------------------


@check('TM-3.0.01', 'the stream is sent without a request', 'M 10', safe=True)
def the_stream_comes_by_itself(robot):
    true(len(robot.svr.stream_frame()) == 3, 'no frame')


@check('TM-3.0.02', 'its ids cycle from 0 to 9', 'M 10', safe=True)
def ids_go_round(robot):
    ids = [int(robot.svr.stream_frame()[0]) for _ in range(25)]
    equal(ids, [(ids[0] + step) % 10 for step in range(25)])


@check('TM-3.0.03', 'a frame is sent every 15 to 16 ms', 'L tmr_ros2 #46', time_scale=1, safe=True)
def the_period(robot):
    robot.svr.stream_frame()
    begin = robot.svr.frames[-1].time
    for _ in range(64):
        robot.svr.stream_frame()
    near(1e3 * (robot.svr.frames[-1].time - begin) / 64, 15.5, 5, 'ms')


@check('TM-3.0.04', 'it is served without a running project', 'M 10', since='1.80')
def no_project_is_needed(robot):
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    other = robot.connect_status()
    equal(len(other.stream_frame()), 3)


@check('TM-3.0.05', 'several clients get the same stream', 'M 10', safe=True)
def clients_get_the_same(robot):
    clients = [robot.connect_status() for _ in range(4)]
    names = [sorted(name for name, _ in unpack_items(client.stream_frame()[2])) for client in clients]
    equal(names[1:], names[:1] * 3, 'items')


@check('TM-3.0.06', 'the first item is Robot_Link, and it is 1', 'M 10', safe=True)
def robot_link_is_first(robot):
    equal(unpack_items(robot.svr.stream_frame()[2])[0], ('Robot_Link', b'\1'))


@check('TM-3.0.07', 'BINARY is mode 1: name length, name, value length, value, little endian', 'M 10', safe=True)
def the_binary_stream(robot):
    _, mode, content = robot.svr.stream_frame()
    equal(mode, 1, 'mode')
    true(len(unpack_items(content)) > 1, 'no items')


def streamed_text(robot, expected):
    """The content of a frame of the stream, which must be of this mode."""
    _, mode, content = robot.svr.stream_frame()
    equal(mode, expected, 'mode')
    return content.decode()


@check('TM-3.0.08', 'STRING is mode 2: lines `Item=Value`, arrays as {a,b}', 'M 10', stream_format='string')
def the_string_stream(robot):
    lines = streamed_text(robot, 2).split('\r\n')
    equal(lines[0], 'Robot_Link=1')
    values = dict(line.split('=', 1) for line in lines)
    equal(values['Joint_Angle'], '{0,0,90,0,90,0}', 'Joint_Angle')
    equal(values['TCP_Name'], '"NOTOOL"', 'TCP_Name')


@check('TM-3.0.09', 'JSON is mode 3: `[{"Item":"x","Value":v},…]`', 'M 10', stream_format='json')
def the_json_stream(robot):
    items = json.loads(streamed_text(robot, 3))
    equal(items[0], {'Item': 'Robot_Link', 'Value': 1})
    values = {item['Item']: item['Value'] for item in items}
    equal(values['Joint_Angle'], [0, 0, 90, 0, 90, 0], 'Joint_Angle')


@check('TM-3.0.10', 'in JSON, bools are true and false, and whole floats have `.0`', 'L', stream_format='json')
def json_values(robot):
    text = streamed_text(robot, 3)
    true('{"Item":"Robot_Error","Value":false}' in text, 'Robot_Error is not false')
    true('90.0' in text, 'no 90.0')


@check('TM-3.0.11', 'in STRING, bools are true and false', 'I', DERIVED, stream_format='string')
def string_bools(robot):
    true('\r\nRobot_Error=false\r\n' in streamed_text(robot, 2), 'Robot_Error is not false')


@check('TM-3.0.12', 'the streamed items are set at the robot', 'M 10', stream_items='Robot_Error,Joint_Angle')
def the_table_is_set(robot):
    names = [name for name, _ in unpack_items(robot.svr.stream_frame()[2])]
    equal(names, ['Robot_Link', 'Robot_Error', 'Joint_Angle'])


# Reading ----------------------------------------------------------------------------------------


@check('TM-3.0.20', 'mode 11 reads in BINARY, and is answered with mode 11', 'M 10', **READ)
def binary_reading(robot):
    mode, content = robot.svr.request(11, pack_text('Robot_Link') + pack_text('Error_Code'))
    equal(mode, 11, 'mode')
    equal([(name, len(value)) for name, value in unpack_items(content)], [('Robot_Link', 1), ('Error_Code', 4)])


@check('TM-3.0.21', 'mode 12 reads in STRING, and is answered with mode 12', 'M 10', **READ)
def string_reading(robot):
    mode, content = robot.svr.request(12, 'Robot_Link\r\nError_Code')
    equal(mode, 12, 'mode: %r' % content)
    equal([line.split('=')[0] for line in content.decode().split('\r\n')], ['Robot_Link', 'Error_Code'])


@check('TM-3.0.22', 'mode 13 reads in JSON, and is answered with mode 13', 'M 10, L', **READ)
def json_reading(robot):
    mode, content = robot.svr.request(13, '[{"Item":"Robot_Link"},{"Item":"Joint_Angle"}]')
    equal(mode, 13, 'mode: %r' % content)
    items = json.loads(content.decode())
    equal([item['Item'] for item in items], ['Robot_Link', 'Joint_Angle'])
    equal(len(items[1]['Value']), 6, 'joints')


@check('TM-3.0.23', 'the answer has the id of the request', 'M 10', **READ)
def ids_are_echoed(robot):
    for identity in ('Q', 'dh', 'SVRpy0', 'x' * 40):
        equal(robot.svr.request(11, pack_text('Robot_Link'), identity)[0], 11, identity)


@check('TM-3.0.24', 'an item that does not exist: `04,NotExist;TCP_MaXX`, and the whole request is refused', 'M 10',
       **READ)
def unknown_items(robot):
    equal(robot.svr.refusal(11,
                            pack_text('TCP_Mass') + pack_text('TCP_MaXX') + pack_text('Other')), '04,NotExist;TCP_MaXX')


@check('TM-3.0.25', 'a failed read in STRING or JSON is mode 0, too', 'M 10', **READ)
def failed_reads(robot):
    equal(robot.svr.refusal(12, 'TCP_MaXX'), '04,NotExist;TCP_MaXX')
    equal(robot.svr.refusal(13, '[{"Item":"TCP_MaXX"}]'), '04,NotExist;TCP_MaXX')


@check('TM-3.0.26', 'an unknown mode: `01,NotSupport`', 'M 10', **READ)
def unknown_modes(robot):
    for mode in (99, 4, 14, 5):
        equal(robot.svr.refusal(mode, 'Robot_Link'), '01,NotSupport', 'mode %d' % mode)


@check('TM-3.0.27', 'a request whose content does not fit its mode: `03,InvalidData`', 'M 10', **READ)
def content_does_not_fit(robot):
    equal(robot.svr.refusal(11, '[{}]'), '03,InvalidData')
    equal(robot.svr.refusal(13, 'Ctrl_DO0'), '03,InvalidData')


@check('TM-3.0.28', 'a bad id is CPERR 04', 'M 10', **READ)
def bad_ids(robot):
    for identity in ('a_b', ' a', ''):
        equal(robot.svr.request(11, pack_text('Robot_Link'), identity), (None, 'CPERR,04'), 'id %r' % identity)


@check('TM-3.0.29', 'predefined items can be read though they are not streamed', 'M 10', stream_items='Robot_Error',
       since='1.80')
def items_need_not_be_streamed(robot):
    near(robot.value('Joint_Angle'), [0, 0, 90, 0, 90, 0], 0.01, 'Joint_Angle')


@check('TM-3.0.30', 'globals can be read only when they are streamed', 'M 10', since='1.80', variable='int g_count=7',
       stream_items='Robot_Error,g_count')
def globals_are_read(robot):
    equal(robot.svr.read_bytes('g_count')['g_count'], struct.pack('<i', 7))


@check('TM-3.0.31', 'globals that are not streamed do not exist', 'M 10', since='1.80', variable='int g_count=7',
       stream_items='Robot_Error')
def other_globals_are_not(robot):
    equal(robot.svr.refusal(11, pack_text('g_count')), '04,NotExist;g_count')


@check('TM-3.0.32', 'a script variable of the stream follows the script', 'M 10', DERIVED, since='1.80',
       variable='int g_count=7', stream_items='g_count')
def globals_follow(robot):
    equal(robot.listen.run('1', 'g_count = 9'), 'OK')
    equal(robot.svr.read_bytes('g_count')['g_count'], struct.pack('<i', 9))


# Writing ----------------------------------------------------------------------------------------


@check('TM-3.0.40', 'mode 1 writes in BINARY: `00,OK`', 'M 10')
def binary_writing(robot):
    equal(robot.svr.refusal(1, pack_items(('Ctrl_DO0', b'\1'))), '00,OK')
    robot.wait_for('Ctrl_DO0', 1, 1)


@check('TM-3.0.41', 'mode 2 writes in STRING: `$TMSVR,15,S0,2,Ctrl_DO0=1,*76`', 'M 10')
def string_writing(robot):
    robot.svr.send_bytes(b'$TMSVR,15,S0,2,Ctrl_DO0=1,*76\r\n')
    answer = robot.svr.until(lambda frame: frame.data.startswith(b'S0,'))[-1]
    equal(answer.text, 'S0,0,00,OK')
    robot.wait_for('Ctrl_DO0', 1, 1)


@check('TM-3.0.42', 'mode 3 writes in JSON', 'M 10')
def json_writing(robot):
    equal(robot.svr.refusal(3, '[{"Item":"Ctrl_DO0","Value":1},{"Item":"Ctrl_AO0","Value":2.5}]'), '00,OK')
    robot.wait_for('Ctrl_DO0', 1, 1)
    near(robot.value('Ctrl_AO0'), 2.5, 1e-6, 'Ctrl_AO0')


@check('TM-3.0.43', 'a client without permission: `02,WritePermission`', 'M 10', write_clients='none')
def without_permission(robot):
    equal(robot.svr.refusal(2, 'Ctrl_DO0=1'), '02,WritePermission')
    equal(robot.value('Ctrl_DO0'), 0, 'Ctrl_DO0')


@check('TM-3.0.44', 'an item that does not exist: `04,NotExist;Ctrl_DO32`', 'M 10')
def writing_unknown_items(robot):
    equal(robot.svr.refusal(2, 'Ctrl_DO32=1'), '04,NotExist;Ctrl_DO32')


@check('TM-3.0.45', 'a read-only item: `05,ReadOnly;Robot_Link`', 'M 10')
def writing_read_only_items(robot):
    equal(robot.svr.refusal(2, 'Robot_Link=1'), '05,ReadOnly;Robot_Link')


@check('TM-3.0.46', 'an item of the other mode: `06,ModeError;Project_Speed` in manual mode', 'M 10', operator='manual')
def writing_in_the_other_mode(robot):
    equal(robot.svr.refusal(2, 'Project_Speed=50'), '06,ModeError;Project_Speed')


@check('TM-3.0.47', 'a value of a wrong type or size: `07,ValueError`', 'M 10')
def writing_wrong_values(robot):
    equal(robot.svr.refusal(2, 'Ctrl_DO0={1,2}'), '07,ValueError;Ctrl_DO0')
    equal(robot.svr.refusal(2, 'Ctrl_DO0="on"'), '07,ValueError;Ctrl_DO0')
    equal(robot.svr.refusal(1, pack_items(('Ctrl_DO0', b'\1\0\0\0'))), '07,ValueError;Ctrl_DO0')


@check('TM-3.0.48', 'a write whose content does not fit its mode: `03,InvalidData`', 'M 10')
def writing_invalid_data(robot):
    robot.svr.send_bytes(b'$TMSVR,15,S3,3,Ctrl_DO0=1,*74\r\n')
    answer = robot.svr.until(lambda frame: frame.data.startswith(b'S3,'))[-1]
    equal(answer.text, 'S3,0,03,InvalidData')
    equal(robot.svr.refusal(1, '[{}]'), '03,InvalidData')
    equal(robot.svr.refusal(2, 'Ctrl_DO0'), '03,InvalidData')


@check('TM-3.0.49', 'the mode is checked before the permission', 'M 10', write_clients='none')
def mode_before_permission(robot):
    equal(robot.svr.refusal(99, 'Ctrl_DO0=1'), '01,NotSupport')


@check('TM-3.0.50', 'the permission is checked before the content, the content before the items', 'M 10',
       write_clients='none')
def permission_before_content(robot):
    equal(robot.svr.refusal(3, 'Ctrl_DO32=1'), '02,WritePermission')


@check('TM-3.0.51', 'existence is checked before read-only, read-only before the mode, the mode before the value',
       'M 10', operator='manual')
def order_of_checks(robot):
    equal(robot.svr.refusal(3, 'Ctrl_DO32=1'), '03,InvalidData')
    equal(robot.svr.refusal(2, 'Robot_Link="x"'), '05,ReadOnly;Robot_Link')
    equal(robot.svr.refusal(2, 'Project_Speed="x"'), '06,ModeError;Project_Speed')


@check('TM-3.0.52', 'a write of several items is all or nothing', 'M 10')
def all_or_nothing(robot):
    equal(robot.svr.refusal(2, 'Ctrl_DO0=1\r\nCtrl_DO1=1\r\nRobot_Link=1'), '05,ReadOnly;Robot_Link')
    equal(robot.values('Ctrl_DO0', 'Ctrl_DO1'), [0, 0])


@check('TM-3.0.53', 'the first refused item is named', 'M 10')
def the_first_offender_is_named(robot):
    equal(robot.svr.refusal(2, 'Ctrl_DO0=1\r\nCtrl_DO33=1\r\nCtrl_DO32=1'), '04,NotExist;Ctrl_DO33')


@check('TM-3.0.54', 'string[] in BINARY: elements are separated by two NUL', 'M 10', variable='string[] g_ss={"a","b"}',
       stream_items='g_ss')
def arrays_of_strings(robot):
    robot.svr.send_bytes(b'$TMSVR,25,T2,1,\x04\x00g_ss\x0C\x00Hello\x00\x00World,*02\r\n')
    answer = robot.svr.until(lambda frame: frame.data.startswith(b'T2,'))[-1]
    equal(answer.text, 'T2,0,00,OK')
    equal(robot.svr.read_bytes('g_ss')['g_ss'], b'Hello\0\0World')


@check('TM-3.0.55', 'globals are written with exactly their count of elements: `07,ValueError;adata`', 'M 10',
       variable='int[] adata={0,0,0,0}', stream_items='adata')
def arrays_keep_their_size(robot):
    robot.svr.send_bytes(b'$TMSVR,18,S7,2,adata={1,2,3},*47\r\n')
    answer = robot.svr.until(lambda frame: frame.data.startswith(b'S7,'))[-1]
    equal(answer.text, 'S7,0,07,ValueError;adata')


# Values -----------------------------------------------------------------------------------------


@check('TM-3.0.60', 'a read in each format gives the same values', 'M 10', **READ)
def formats_agree(robot):
    binary = robot.value('Joint_Angle')
    text = robot.svr.request(12, 'Joint_Angle')[1].decode()
    true(text.startswith('Joint_Angle={'), 'STRING: %s' % text)
    near([float(n) for n in text.split('=')[1].strip('{}').split(',')], binary, 1e-4, 'STRING')
    near(json.loads(robot.svr.request(13, '[{"Item":"Joint_Angle"}]')[1].decode())[0]['Value'], binary, 1e-4, 'JSON')


@check('TM-3.0.61', 'strings are quoted in STRING', 'M 10', **READ)
def strings_are_quoted(robot):
    equal(robot.svr.request(12, 'TCP_Name')[1].decode(), 'TCP_Name="%s"' % robot.value('TCP_Name'))


@check('TM-3.0.62', 'a read is answered between the frames of the stream, which continues', 'M 10', **READ)
def the_stream_goes_on(robot):
    periods = []
    for _ in range(12):
        robot.value('Robot_Link')
        periods.append(int(robot.svr.stream_frame()[0]))
    true(len(set(periods)) > 1, 'ids %s' % periods)


@check('TM-3.0.63', 'a float has 7 digits where these make the same float, else 9', 'L', **READ)
def seven_digits_or_nine(robot):
    mode, content = robot.svr.request(12, 'Joint_Angle')
    equal(mode, 12, 'mode')
    for digits in content.decode().split('=')[-1].strip('{}').split(','):
        seven, nine = ('%.*g' % (count, float(digits)) for count in (7, 9))
        is_the_same = struct.pack('<f', float(seven)) == struct.pack('<f', float(digits))
        equal(digits.upper(), (seven if is_the_same else nine).upper())


@check('TM-3.0.64', 'malformed BINARY names: `03,InvalidData`', 'M 10', **READ)
def malformed_names(robot):
    equal(robot.svr.refusal(11, b'\x0a\x00Robot'), '03,InvalidData')
    equal(robot.svr.refusal(11, b'\x0a'), '03,InvalidData')


@check('TM-3.0.65', 'a request for nothing: `03,InvalidData`', '?', CHOICE, since='1.80', safe=True)
def requests_for_nothing(robot):
    equal(robot.svr.refusal(11, b''), '03,InvalidData')


@check('TM-3.0.66', 'a busy client does not slow the stream of others', 'I', DERIVED, since='1.80', time_scale=1,
       safe=True)
def clients_do_not_disturb_each_other(robot):
    watcher = robot.connect_status()
    watcher.stream_frame()
    begin = watcher.frames[-1].time
    for _ in range(100):
        robot.svr.request(11, pack_text('DHTable'))
    times = [begin]
    for _ in range(32):
        watcher.stream_frame()
        times.append(watcher.frames[-1].time)
    true(statistics.mean(other - one for one, other in zip(times, times[1:])) < 0.03, 'the stream slows down')


@check('TM-3.0.67', 'a request is answered once', 'I', DERIVED, **READ)
def requests_are_answered_once(robot):
    for identity in ('one', 'two', 'three'):
        equal(robot.svr.request(11, pack_text('Robot_Link'), identity)[0], 11, 'mode')
    answers = [frame.text.split(',')[0] for frame in robot.svr.frames if not frame.text.split(',')[0].isdigit()]
    equal(answers, ['one', 'two', 'three'])
