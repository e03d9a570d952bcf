"""Fact sheet 1.5: TMSTA, questions and what the robot tells by itself."""
import re

from motions import LONG, SHORT
from suite import CHOICE, DERIVED, check, equal, true
from tm_client import encode


@check('TM-1.5.01', 'in the Listen node, 00 is answered `00,true,Listen1`', 'M 7.4')
def the_flow_is_in_the_node(robot):
    equal(robot.listen.exchange(b'$TMSTA,2,00,*41\r\n'), 'TMSTA,00,true,Listen1')


@check('TM-1.5.02', 'elsewhere, 00 is answered `$TMSTA,9,00,false,,*37`', 'M 7.4', time_scale=0.05)
def the_flow_is_elsewhere(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    equal(robot.listen.exchange(b'$TMSTA,2,00,*41\r\n'), 'TMSTA,00,false,')


@check('TM-1.5.03', '`00,`, as the vendor driver sends it, gets the same answer', 'L', safe=True)
def the_drivers_form_is_taken(robot):
    plain = robot.listen.exchange(b'$TMSTA,2,00,*41\r\n')
    equal(robot.listen.exchange(b'$TMSTA,3,00,,*6c\r\n'), plain)


@check('TM-1.5.04', 'the message may hold commas', 'M 7.4', listen_node='UltrasonicFail,-12131')
def the_message_may_hold_commas(robot):
    equal(robot.listen.ask('00'), '00,true,UltrasonicFail,-12131')


@check('TM-1.5.05', 'a tag that was not set: `$TMSTA,5,01,15,*6F` is answered `01,15,none`', 'M 7.4', since='1.76')
def an_unknown_tag_is_none(robot):
    equal(robot.listen.exchange(b'$TMSTA,5,01,15,*6F\r\n'), 'TMSTA,01,15,none')


@check('TM-1.5.06', 'a tag whose motion is not finished is false', 'M 7.4', since='1.76', time_scale=1)
def a_pending_tag_is_false(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(8)'), 'OK')
    equal(robot.listen.ask('01,08'), '01,08,false')


@check('TM-1.5.07', 'a completed tag is true', 'M 7.4', since='1.76')
def a_completed_tag_is_true(robot):
    equal(robot.listen.run('1', SHORT, 'QueueTag(8,1)'), 'OK')
    equal(robot.listen.ask('01,08'), '01,08,true')


@check('TM-1.5.08', 'a tag that completes is reported: `$TMSTA,10,01,08,true,*6D`', 'M 7.4', since='1.76')
def a_tag_tells_when_it_completes(robot):
    equal(robot.listen.run('1', SHORT, 'QueueTag(8)'), 'OK')
    equal(encode('TMSTA', robot.listen.receive().data), b'$TMSTA,10,01,08,true,*6D\r\n')


@check('TM-1.5.09', 'tag numbers have two digits', 'M 7.4', since='1.76')
def tags_have_two_digits(robot):
    for tag in (1, 9, 10, 15):
        equal(robot.listen.run('1', 'QueueTag(%d,1)' % tag), 'OK')
        true('TMSTA,01,%02d,true' % tag in map(str, robot.listen.frames),
             'tag %d: %s' % (tag, robot.listen.frames[-2:]))


@check('TM-1.5.10', 'only the last four tags can be queried', 'M 7.4', since='1.76')
def four_tags_are_kept(robot):
    equal(robot.listen.run('1', *('QueueTag(%d,1)' % tag for tag in (1, 2, 3, 4, 5))), 'OK')
    equal([robot.listen.ask('01,%02d' % tag) for tag in (1, 2, 3, 4, 5)],
          ['01,01,none', '01,02,true', '01,03,true', '01,04,true', '01,05,true'])


@check('TM-1.5.11', 'an invalid tag is none: `$TMSTA,5,01,88,*6B` is answered `$TMSTA,10,01,88,none,*79`', 'M 7.4',
       since='1.76', safe=True)
def an_invalid_tag_is_none(robot):
    answer = robot.listen.exchange(b'$TMSTA,5,01,88,*6B\r\n')
    equal(answer, 'TMSTA,01,88,none')
    for tag in ('00', '16'):
        equal(robot.listen.ask('01,' + tag), '01,%s,none' % tag)


@check('TM-1.5.12', 'tags can be queried outside the Listen node', 'M 7.4', since='1.76', time_scale=0.05)
def tags_are_answered_outside_the_node(robot):
    equal(robot.listen.run('1', 'QueueTag(5,1)', 'ScriptExit()'), 'OK')
    equal(robot.listen.ask('00').rstrip(','), '00,false')
    equal(robot.listen.ask('01,05'), '01,05,true')


@check('TM-1.5.13', 'questions are answered while a script blocks', 'M 8.2', since='1.76', time_scale=1)
def questions_overtake_a_blocked_script(robot):
    robot.listen.script('1', LONG, 'QueueTag(1,1)')
    equal(robot.listen.ask('00'), '00,true,Listen1')
    equal(robot.listen.ask('01,01'), '01,01,false')
    equal([frame for frame in robot.listen.frames if frame.header == 'TMSCT'], [], 'replies')


@check('TM-1.5.14', 'an unknown sub command, `$TMSTA,4,XXXX,*47`, is CPERR 04', 'M 7.4', safe=True)
def an_unknown_question_is_an_error(robot):
    equal(robot.listen.exchange(b'$TMSTA,4,XXXX,*47\r\n'), 'CPERR,04')


@check('TM-1.5.15', 'there are no sub commands 02 and 03', 'M, M84: not in the texts', DERIVED, safe=True)
def there_is_no_02_and_03(robot):
    for sub in ('02', '03'):
        robot.listen.send('TMSTA', sub)
        equal(str(robot.listen.receive()), 'CPERR,04', sub)


@check('TM-1.5.16', '90 to 99 are not questions', 'M 7.4', DERIVED, safe=True)
def clients_cannot_ask_for_sent_data(robot):
    for sub in ('90', '99'):
        robot.listen.send('TMSTA', sub)
        equal(str(robot.listen.receive()), 'CPERR,04', sub)


@check('TM-1.5.17', 'a frame has one question', 'M 7.4', safe=True)
def a_frame_has_one_question(robot):
    robot.listen.send('TMSTA', '00\r\n00')
    robot.listen.receive()
    equal([str(frame) for frame in robot.listen.so_far()], [], 'further answers')


@check('TM-1.5.18', 'a tag with one digit, `01,1`, as users of the vendor drivers send it, is answered with two',
       'D, M 7.4', DERIVED, since='1.76', safe=True)
def one_digit_is_enough(robot):
    true(re.fullmatch(r'TMSTA,01,01,(none|true|false)', robot.listen.exchange(encode('TMSTA', '01,1'))),
         'another answer')


@check('TM-1.5.30', 'a tag with one digit is the tag of that number', 'D, M 7.4', DERIVED, since='1.76')
def one_digit_is_the_number(robot):
    equal(robot.listen.run('1', SHORT, 'QueueTag(3,1)'), 'OK')
    equal(robot.listen.ask('01,3'), '01,03,true')


@check('TM-1.5.19', 'a tag question without a number, or with more than one, is CPERR 04', '?', CHOICE, since='1.76',
       safe=True)
def a_tag_question_has_one_number(robot):
    for question in ('01', '01,', '01,x', '01,01,02', ''):
        robot.listen.send('TMSTA', question)
        equal(str(robot.listen.receive()), 'CPERR,04', question)


# ListenSend -------------------------------------------------------------------------------------


@check('TM-1.5.20', 'ListenSend of a string sends its UTF-8: `$TMSTA,14,90,Hello World,*73`', 'M 7.4', since='1.76',
       safe=True)
def a_string_is_sent(robot):
    equal(robot.sent_by('ListenSend(90,"Hello World")'), [b'Hello World'])
    equal(robot.sent_by('ListenSend(90,"達明")'), ['達明'.encode()])


@check('TM-1.5.21', 'ListenSend(91,float[]) sends four bytes each, little endian: the frame with `*60`', 'M 7.4',
       since='1.76', safe=True)
def floats_are_sent(robot):
    name = robot.name()
    equal(robot.listen.run('1', 'float[] %s = {1,2,3,4}' % name, 'ListenSend(91,%s)' % name), 'OK')
    frame = robot.listen.frames[-2]
    expected = b'$TMSTA,19,91,' + bytes.fromhex('0000803f000000400000404000008040') + b',*60\r\n'
    equal(encode(frame.header, frame.data), expected)


@check('TM-1.5.22', 'ListenSend of a byte sends one byte: `$TMSTA,4,90,d,*06`', 'M 7.4', since='1.76', safe=True)
def a_byte_is_sent(robot):
    name = robot.name()
    equal(robot.sent_by('byte %s = 100' % name, 'ListenSend(90,%s)' % name), [b'd'])


@check('TM-1.5.23', 'ListenSend of a byte[] sends its bytes: {100,200}', 'M 7.4', since='1.76', safe=True)
def bytes_are_sent(robot):
    name = robot.name()
    equal(robot.sent_by('byte[] %s = {100,200}' % name, 'ListenSend(90,%s)' % name), [b'd\xc8'])


@check('TM-1.5.24', 'ListenSend of int and double sends four and eight bytes, little endian', 'M 7.4', since='1.76',
       safe=True)
def numbers_are_sent(robot):
    name = robot.name()
    equal(robot.sent_by('int %s = -2' % name, 'ListenSend(90,%s)' % name), [b'\xfe\xff\xff\xff'])
    equal(robot.sent_by('double %sd = 0.5' % name, 'ListenSend(90,%sd)' % name), [bytes.fromhex('000000000000e03f')])


@check('TM-1.5.25', 'ListenSend of a string[] sends its elements one after the other', 'M 7.4', since='1.76',
       safe=True)
def strings_are_concatenated(robot):
    name = robot.name()
    equal(robot.sent_by('string[] %s = {"Hi","TM"}' % name, 'ListenSend(90,%s)' % name), [b'HiTM'])


@check('TM-1.5.26', 'GetString of a float[] is sent as `{…,…}` with the shortest digits', 'M 7.4', since='1.76',
       safe=True)
def get_string_has_the_shortest_digits(robot):
    text = '{-248.7316,-154.6399,-130.5106,-0.04263335,-0.6727331,0.8938164}'
    name = robot.name()
    equal(robot.sent_by('float[] %s = %s' % (name, text), 'ListenSend(90,GetString(%s))' % name), [text.encode()])


@check('TM-1.5.27', 'ListenSend sends under 90 to 99', 'M 7.4', since='1.76', safe=True)
def the_sub_commands_are_90_to_99(robot):
    lines = ['ListenSend(%d,"x")' % sub for sub in range(90, 100)]
    equal(robot.listen.run('1', *lines), 'OK')
    sent = [str(frame) for frame in robot.listen.frames if frame.header == 'TMSTA']
    equal(sent, ['TMSTA,%d,x' % sub for sub in range(90, 100)])


@check('TM-1.5.28', 'ListenSend returns 0, and -2 for a bad sub command, which sends nothing', 'M 7.4', since='1.76',
       safe=True)
def listen_send_returns_a_result(robot):
    name = robot.name()
    equal(robot.evaluate(name, 'int %s = ListenSend(91,"x")' % name), '0')
    for sub in (89, 100):
        before = len(robot.listen.frames)
        equal(robot.evaluate('%s%d' % (name, sub), 'int %s%d = ListenSend(%d,"x")' % (name, sub, sub)), '-2')
        equal([str(f) for f in robot.listen.frames[before:] if f.text.startswith('%d,' % sub)], [], 'messages')


@check('TM-1.5.29', 'a question is answered once', 'I', DERIVED, safe=True)
def questions_are_answered_once(robot):
    for question in ('00', '01,88', '00', '01,99'):
        robot.listen.ask(question)
    equal([frame.text[:5] for frame in robot.listen.frames][1::2], ['01,88', '01,99'])
    equal(len(robot.listen.frames), 4, 'frames')
