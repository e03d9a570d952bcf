"""Fact sheet 1.6: CPERR, and what is done with bytes that are no good frame."""
from suite import CHOICE, DERIVED, check, equal, true
from tm_client import checksum, encode

QUESTION = encode('TMSTA', '01,88')
ANSWER = 'TMSTA,01,88,none'


def with_length(length):
    return encode('TMSTA', '01,88', length=length)


@check('TM-1.6.01', 'packet error: `$CPERR,2,01,*49`', 'M 7.5', safe=True)
def packet_error(robot):
    robot.listen.send_bytes(b'$TMSCT,-100,1,ChangeBase("RobotBase"),*13\r\n')
    equal(encode('CPERR', robot.listen.receive().data), b'$CPERR,2,01,*49\r\n')


@check('TM-1.6.02', 'checksum error: `$CPERR,2,02,*4A`', 'M 7.5', safe=True)
def checksum_error(robot):
    robot.listen.send_bytes(b'$TMSTA,2,00,*42\r\n')
    equal(encode('CPERR', robot.listen.receive().data), b'$CPERR,2,02,*4A\r\n')


@check('TM-1.6.03', 'header error: `$CPERR,2,03,*4B`', 'M 7.5', safe=True)
def header_error(robot):
    for header in ('TMSXX', 'TMSCTX', 'TMSC', 'tmsct', 'X'):
        robot.listen.send(header, '00')
        equal(encode('CPERR', robot.listen.receive().data), b'$CPERR,2,03,*4B\r\n', header)


@check('TM-1.6.04', 'packet data error: `$CPERR,2,04,*4C`', 'M 7.5', safe=True)
def packet_data_error(robot):
    robot.listen.send_bytes(b'$TMSTA,4,XXXX,*47\r\n')
    equal(encode('CPERR', robot.listen.receive().data), b'$CPERR,2,04,*4C\r\n')


@check('TM-1.6.05', 'not in external script mode: `$CPERR,2,F1,*3F`', 'M 7.5', time_scale=0.05)
def mode_error(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    robot.listen.script('2', 'ChangeLoad(1)')
    equal(encode('CPERR', robot.listen.receive().data), b'$CPERR,2,F1,*3F\r\n')


@check('TM-1.6.06', 'on the status port a wrong checksum is CPERR 02, a wrong header CPERR 03', 'M 10.5', safe=True)
def the_status_port_has_them_too(robot):
    robot.svr.send('TMSVR', 'diag,12,Robot_Link', check='00')
    robot.svr.until('CPERR,02')
    robot.svr.send('TMsvr', 'diag,12,Robot_Link')
    robot.svr.until('CPERR,03')


@check('TM-1.6.07', 'on the status port a bad transaction id is CPERR 04', 'M 10.5', safe=True)
def the_status_port_checks_ids(robot):
    for identity in ('a_b', ' ', ''):
        robot.svr.send('TMSVR', identity + ',12,Robot_Link')
        robot.svr.until('CPERR,04')


@check('TM-1.6.08', 'each error is answered once, and the connection stays', 'I', DERIVED, safe=True)
def the_connection_survives_errors(robot):
    for damage in ({'length': '-1'}, {'check': '00'}):
        robot.listen.send('TMSTA', '01,88', **damage)
        robot.listen.send_bytes(QUESTION)
        robot.listen.until(ANSWER)
    equal([str(f) for f in robot.listen.frames], ['CPERR,01', ANSWER, 'CPERR,02', ANSWER])


@check('TM-1.6.09', 'a LENGTH that does not match DATA is CPERR 01', 'W', CHOICE, safe=True)
def a_wrong_length_is_a_packet_error(robot):
    for length in ('4', '1', '0'):
        equal(robot.listen.exchange(with_length(length)), 'CPERR,01', 'length ' + length)
        equal(robot.listen.exchange(QUESTION), ANSWER)


@check('TM-1.6.10', 'a LENGTH that is not a number is CPERR 01', '?', CHOICE, safe=True)
def a_length_is_a_number(robot):
    for length in ('x', '5x', '0xg', '0b2', '5.0', ' 5', '+5', '0x'):
        equal(robot.listen.exchange(with_length(length)), 'CPERR,01', 'length %r' % length)
        equal(robot.listen.exchange(QUESTION), ANSWER)


@check('TM-1.6.11', 'an empty LENGTH is CPERR 01', 'W', CHOICE, safe=True)
def an_empty_length_is_a_packet_error(robot):
    equal(robot.listen.exchange(with_length('')), 'CPERR,01')
    equal(robot.listen.exchange(QUESTION), ANSWER)


@check('TM-1.6.12', 'an empty LENGTH is accepted when the simulator is configured so', 'W', CHOICE,
       accept_empty_length=True)
def an_empty_length_may_be_taken(robot):
    equal(robot.listen.exchange(b'$TMSCT,,1,ScriptExit(),*62\r\n'), 'TMSCT,1,OK')


@check('TM-1.6.13', 'several frames in one segment are answered in order', 'I; all clients treat it as a byte stream',
       DERIVED, safe=True)
def a_segment_may_hold_several_frames(robot):
    robot.listen.send_bytes(QUESTION + encode('TMSTA', '01,99') + encode('TMSTA', 'XXXX') + QUESTION)
    answers = [str(robot.listen.receive()) for _ in range(4)]
    equal(answers, [ANSWER, 'TMSTA,01,99,none', 'CPERR,04', ANSWER])


@check('TM-1.6.14', 'a frame may arrive byte by byte', 'I; all clients treat it as a byte stream', DERIVED, safe=True)
def a_frame_may_come_in_pieces(robot):
    for byte in QUESTION:
        robot.listen.send_bytes(bytes([byte]))
    equal(str(robot.listen.receive()), ANSWER)


@check('TM-1.6.15', 'bytes before `$` are ignored without an answer', '?', CHOICE, safe=True)
def garbage_is_passed_over(robot):
    robot.listen.send_bytes(b'\r\n\0garbage,*00\r\n' + QUESTION + b'\r\n' + QUESTION)
    equal([str(robot.listen.receive()), str(robot.listen.receive())], [ANSWER, ANSWER])


@check('TM-1.6.16', 'a frame ends with CR LF: the robot waits until it arrives', '?', CHOICE, safe=True)
def the_end_is_waited_for(robot):
    other = robot.connect_script()
    robot.listen.send_bytes(QUESTION[:-2])
    true(other.ask('00').startswith('00,'), 'no answer')
    robot.listen.poll()
    equal(robot.listen.frames, [], 'answers before the end of the frame')
    robot.listen.send_bytes(b'\r\n')
    equal(str(robot.listen.receive()), ANSWER)


@check('TM-1.6.17', 'the checksum is checked before the header', '?', CHOICE, safe=True)
def checksum_before_header(robot):
    robot.listen.send('TMSXX', '00', check='00')
    equal(str(robot.listen.receive()), 'CPERR,02')


@check('TM-1.6.18', 'LENGTH is checked before the checksum', '?', CHOICE, safe=True)
def length_before_checksum(robot):
    robot.listen.send('TMSTA', '00', length='-2', check='00')
    equal(str(robot.listen.receive()), 'CPERR,01')


@check('TM-1.6.19', 'the header is checked before DATA', '?', CHOICE, safe=True)
def header_before_data(robot):
    robot.listen.send('TMSXX', '_,x')
    equal(str(robot.listen.receive()), 'CPERR,03')


@check('TM-1.6.20', 'DATA is checked before the mode', '?', CHOICE, time_scale=0.05)
def data_before_mode(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    robot.listen.script('_', 'ChangeLoad(1)')
    equal(str(robot.listen.receive()), 'CPERR,04')


@check('TM-1.6.21', 'a TMSVR frame on the script port is CPERR 03', '?', CHOICE, safe=True)
def each_port_has_its_headers(robot):
    robot.listen.send('TMSVR', 'Q1,12,Robot_Link')
    equal(str(robot.listen.receive()), 'CPERR,03')


@check('TM-1.6.22', 'a checksum that is not a hexadecimal number is CPERR 02', '?', CHOICE, safe=True)
def a_checksum_is_hexadecimal(robot):
    for text in ('4G', '0x', '  '):
        equal(robot.listen.exchange(encode('TMSTA', '00', check=text)), 'CPERR,02', text)


@check('TM-1.6.23', 'a frame with a negative LENGTH is skipped with all its bytes', '?', CHOICE, safe=True)
def a_refused_frame_leaves_nothing_behind(robot):
    body = b'TMSCT,-5,1,QueueTag(1),'
    robot.listen.send_bytes(b'$' + body + b'*%02X\r\n' % checksum(body) + QUESTION)
    robot.listen.until(ANSWER)
    equal([str(frame) for frame in robot.listen.frames], ['CPERR,01', ANSWER])
