"""Fact sheet 1.1: the grammar of frames.

What the robot itself sends is held against the grammar by the client, in every check.
"""
import re

from suite import DERIVED, check, equal, true
from tm_client import checksum, encode

STATUS_QUESTION = b'$TMSTA,2,00,*41\r\n'


def answers_status(robot, raw):
    """The bytes are taken as the question whether the flow is in a Listen node."""
    answer = robot.listen.exchange(raw)
    true(re.fullmatch(r'TMSTA,00,(true,.*|false,?)', answer), '%r was answered with %s' % (raw, answer))


def damaged(text):
    """A frame of the text between `$` and `*`, with the right checksum."""
    body = text.encode()
    return b'$%s*%02X\r\n' % (body, checksum(body))


@check('TM-1.1.01', '`$TMSTA,2,00,*41` is a valid frame, and so is its answer', 'M 7.3, 10.5', safe=True)
def a_question_is_answered(robot):
    answers_status(robot, STATUS_QUESTION)


@check('TM-1.1.02', 'a script is answered in the same grammar, byte for byte: `$TMSCT,4,1,OK,*5C`', 'M 7.3')
def a_script_is_answered(robot):
    robot.listen.send_bytes(b'$TMSCT,25,1,ChangeBase("RobotBase"),*08\r\n')
    equal(str(robot.listen.receive()), 'TMSCT,1,OK')
    equal(encode('TMSCT', '1,OK'), b'$TMSCT,4,1,OK,*5C\r\n', 'the frame that the client reads as TMSCT,1,OK')


@check('TM-1.1.03', 'the status port uses the same grammar', 'M 10.5', since='1.80', safe=True)
def the_status_port_speaks_it_too(robot):
    mode, _ = robot.svr.request(11, b'\x0a\x00Robot_Link')
    equal(mode, 11, 'mode of the answer')


@check('TM-1.1.04', 'the header is case sensitive: `$TMsct,25,1,ChangeBase("RobotBase"),*28` is CPERR 03', 'M 7.3',
       safe=True)
def the_header_is_case_sensitive(robot):
    equal(robot.listen.exchange(b'$TMsct,25,1,ChangeBase("RobotBase"),*28\r\n'), 'CPERR,03')


@check('TM-1.1.05', 'LENGTH counts UTF-8 bytes: `$TMSCT,8,1,達明,*58` is a valid frame', 'M 7.3', safe=True)
def the_length_counts_bytes(robot):
    answer = robot.listen.exchange('$TMSCT,8,1,達明,*58\r\n'.encode())
    true(answer.startswith('TMSCT,1,'), 'answered with %s' % answer)


@check('TM-1.1.06', 'LENGTH may be hexadecimal, `0x2`', 'M 7.3', safe=True)
def the_length_may_be_hexadecimal(robot):
    answers_status(robot, encode('TMSTA', '00', length='0x2'))


@check('TM-1.1.07', 'LENGTH may be binary, `0b10`', 'M 7.3', safe=True)
def the_length_may_be_binary(robot):
    answers_status(robot, encode('TMSTA', '00', length='0b10'))


@check('TM-1.1.08', 'a negative LENGTH is CPERR 01', 'M 7.3', safe=True)
def a_negative_length_is_an_error(robot):
    equal(robot.listen.exchange(b'$TMSCT,-100,1,ChangeBase("RobotBase"),*13\r\n'), 'CPERR,01')


@check('TM-1.1.09', 'a LENGTH above the signed 32 bits is CPERR 01', 'M 7.3: the limit; I: the code', DERIVED,
       safe=True)
def the_length_has_32_bits(robot):
    equal(robot.listen.exchange(damaged('TMSTA,2147483648,00,')), 'CPERR,01')


@check('TM-1.1.10', 'DATA is cut by LENGTH: a whole frame inside a script is not taken for a frame', 'M 7.3', safe=True)
def a_frame_within_data_is_data(robot):
    robot.listen.script('1', 'NoSuchFunction()' + STATUS_QUESTION.decode(), ',*5C')
    true(robot.listen.reply('1').startswith('ERROR;'), 'the script is not answered as a faulty one')
    equal(robot.listen.so_far(), [], 'frames beside the reply')


@check('TM-1.1.11', 'DATA may hold any byte, 0x00 to 0xFF', 'M 7.3', safe=True)
def data_holds_any_byte(robot):
    robot.listen.send('TMSCT', b'1,NoSuchFunction("' + bytes(range(256)) + b'")')
    true(robot.listen.reply('1').startswith('ERROR;'), 'the script is not answered as a faulty one')
    answers_status(robot, STATUS_QUESTION)


@check('TM-1.1.12', 'the checksum is the XOR of all bytes between `$` and `*`: one wrong bit is CPERR 02', 'M 7.3',
       safe=True)
def each_bit_of_the_checksum_counts(robot):
    for bit in range(8):
        equal(robot.listen.exchange(encode('TMSTA', '00', check='%02X' % (0x41 ^ 1 << bit))), 'CPERR,02',
              'bit %d' % bit)


@check('TM-1.1.13', 'a checksum in lower case is accepted: `$TMSTA,3,00,,*6c`', 'L tm2_ros2 #7', safe=True)
def the_checksum_may_be_lower_case(robot):
    answers_status(robot, b'$TMSTA,3,00,,*6c\r\n')


@check('TM-1.1.14', 'a frame of 200 kB is read completely', 'D: trajectories are sent as one frame of many kB', DERIVED,
       safe=True)
def a_long_frame_is_read(robot):
    lines = ['PTP("JPP",0,0,90,0,90,0,35,200,0,false)'] * 4500
    equal(robot.listen.run('1', *lines, 'NoSuchFunction()'), 'ERROR;4501')


@check('TM-1.1.15', 'the script port is 5890, the status port 5891, unless others are requested', 'M 7.1, 10.1',
       safe=True)
def the_ports_have_their_numbers(robot):
    equal(robot.default_ports(), (5890, 5891))


@check('TM-1.1.16', 'frames of the robot have a decimal LENGTH and an upper-case checksum of two digits', 'M 7.3, L',
       safe=True)
def the_robot_writes_decimal_and_upper_case(robot):
    robot.listen.send('TMSTA', '01,88')
    robot.listen.until('TMSTA,01,88,none')  # the client refuses any other form
    robot.listen.send('TMSTA', 'XXXX')
    equal(str(robot.listen.receive()), 'CPERR,04')  # *4C: a digit and a letter
