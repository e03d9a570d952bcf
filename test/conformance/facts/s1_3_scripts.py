"""Fact sheet 1.3: scripts and their replies."""
from motions import LONG, OUT_OF_REACH, SHORT
from suite import CHOICE, DERIVED, check, equal, near, true

FAULTY = 'NoSuchFunction()'

# Ids and lines -----------------------------------------------------------------------------------


@check('TM-1.3.01', 'an id is one or more letters and digits, and is echoed', 'M 7.3', safe=True)
def an_id_is_echoed(robot):
    for identity in ('1', '007', 'a', 'Z', 'aZ9', 'PTPJ', 'SCTpy12', 'x' * 64):
        true(robot.listen.run(identity, FAULTY).startswith('ERROR'), 'no reply to id %s' % identity)


@check('TM-1.3.02', 'an id with any other byte is CPERR 04', 'M 7.3', safe=True)
def other_bytes_are_no_id(robot):
    for identity in ('_', 'a_b', '-1', ' 1', '1 ', 'a b', '1.0', 'ä', '$', '\r\n1', '\0'):
        robot.listen.script(identity, FAULTY)
        equal(str(robot.listen.receive()), 'CPERR,04', 'id %r' % identity)


@check('TM-1.3.03', 'an absent id is CPERR 04', 'M 7.3', safe=True)
def an_absent_id_is_an_error(robot):
    robot.listen.send('TMSCT', ',' + FAULTY)
    equal(str(robot.listen.receive()), 'CPERR,04')
    equal(robot.listen.exchange(b'$TMSCT,11,Hello World,*51\r\n'), 'CPERR,04')


@check('TM-1.3.04', 'ids need not be unique', 'M 7.3', safe=True)
def ids_may_repeat(robot):
    robot.listen.script('1', FAULTY)
    robot.listen.script('1', '', FAULTY)
    equal([robot.listen.reply('1'), robot.listen.reply('1')][0], 'ERROR;1')
    equal(str(robot.listen.frames[-1]), 'TMSCT,1,ERROR;2')


@check('TM-1.3.05', 'a script has one command in a line; lines end with CR LF', 'M 7.3', safe=True)
def lines_end_with_cr_lf(robot):
    equal(robot.listen.run('1', FAULTY, 'ChangeLoad(1)', FAULTY, 'ChangeLoad(2)', FAULTY), 'ERROR;1;3;5')


@check('TM-1.3.06', 'two commands in a line are an error', 'M 7.3', DERIVED, safe=True)
def a_line_has_one_command(robot):
    robot.refuses('ChangeLoad(1) ChangeLoad(2)')


@check('TM-1.3.07', 'a CR LF after the last line is accepted', 'M 7.3')
def the_last_line_may_end(robot):
    equal(robot.listen.run('1', 'ChangeBase("RobotBase")', ''), 'OK')


@check('TM-1.3.08', 'an empty first line is accepted', 'W')
def the_first_line_may_be_empty(robot):
    robot.listen.send_bytes(b'$TMSCT,24,1,\r\nStopAndClearBuffer(),*66\r\n')
    equal(robot.listen.reply('1'), 'OK')


@check('TM-1.3.09', 'empty lines count as lines', 'I', DERIVED, safe=True)
def empty_lines_count(robot):
    equal(robot.listen.run('1', '', FAULTY, '', '', FAULTY), 'ERROR;2;5')


@check('TM-1.3.10', 'a bare LF separates lines too', 'W, weak', CHOICE, safe=True)
def lf_separates_lines(robot):
    equal(robot.listen.run('1', 'ChangeLoad(1)\nNoSuchFunction()\nChangeLoad(1)'), 'ERROR;2')


@check('TM-1.3.11', '`//` begins a comment', '?', CHOICE, safe=True)
def line_comments_are_taken(robot):
    robot.accepts('// nothing', 'ChangeLoad(1) // and why')


@check('TM-1.3.12', '`/* */` is a comment', '?', CHOICE, safe=True)
def block_comments_are_taken(robot):
    robot.accepts('/* nothing */', 'ChangeLoad(/* kg */1)')


@check('TM-1.3.13', 'the frame with typographic quotes of a client test is refused', 'M chapters 1-2; I', DERIVED,
       safe=True)
def typographic_quotes_are_no_quotes(robot):
    robot.refuses('PTP(”JPP”,0,0,90,0,90,0,35,200,0,false)')


# Replies ----------------------------------------------------------------------------------------


@check('TM-1.3.14', 'without errors and warnings: `1,OK`', 'M 7.3')
def a_correct_script_is_ok(robot):
    equal(robot.listen.run('1', 'ChangeBase("RobotBase")', 'ChangeTCP("NOTOOL")', 'ChangeLoad(10.1)'), 'OK')


@check('TM-1.3.15', 'with warnings: `2,OK;2;3`, the lines counted from 1', 'M 7.3', safe=True)
def warnings_name_their_lines(robot):
    name = robot.name()
    reply = robot.listen.run('2', 'int %sa = 300' % name, 'int %sb = 1.5' % name, 'byte %sc = %sa' % (name, name))
    equal(reply, 'OK;2;3')


@check('TM-1.3.16', 'with errors: `3,ERROR;1;2;3`', 'M 7.3', safe=True)
def errors_name_their_lines(robot):
    equal(robot.listen.run('3', FAULTY, FAULTY, FAULTY), 'ERROR;1;2;3')


@check('TM-1.3.17', 'with both, only the lines with errors are listed', 'T', DERIVED, safe=True)
def errors_hide_warnings(robot):
    equal(robot.listen.run('1', 'int %s = 1.5' % robot.name(), FAULTY), 'ERROR;2')


@check('TM-1.3.18', 'the whole script is checked first: with an error nothing is executed', 'M 7.3', since='1.76',
       safe=True)
def with_an_error_nothing_is_executed(robot):
    before = robot.listen.ask('01,13')
    equal(robot.listen.run('1', 'QueueTag(13)', FAULTY), 'ERROR;2')
    equal(robot.listen.ask('01,13'), before, 'tag 13')


@check('TM-1.3.19', 'OK is sent at once for queued motions', 'M 7.3', since='1.76', time_scale=1)
def a_queued_motion_is_ok_at_once(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(1)'), 'OK')
    equal(robot.listen.ask('01,01'), '01,01,false', 'the tag behind the motion')


@check('TM-1.3.20', 'OK is sent after the wait of QueueTag(n,1), and the tag before OK', 'M 8.2', since='1.76')
def queue_tag_holds_the_ok(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1,1)')
    equal([str(frame) for frame in robot.listen.until('TMSCT,1,OK')], ['TMSTA,01,01,true', 'TMSCT,1,OK'])


@check('TM-1.3.21', 'OK is sent after the wait of WaitQueueTag, and the tag before OK', 'M 8.2', since='1.76')
def wait_queue_tag_holds_the_ok(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1)', 'WaitQueueTag(1)')
    equal([str(frame) for frame in robot.listen.until('TMSCT,1,OK')], ['TMSTA,01,01,true', 'TMSCT,1,OK'])


@check('TM-1.3.22', 'an unreachable target gets OK; Robot_Error and Error_Code report it later', 'T; FB', DERIVED,
       since='1.80')
def out_of_reach_is_ok(robot):
    equal(robot.listen.run('1', OUT_OF_REACH), 'OK')
    robot.wait_for('Robot_Error', True, 2)
    true(robot.value('Error_Code') != 0, 'Error_Code is 0')


@check('TM-1.3.23', 'a bad speed gets OK; Robot_Error and Error_Code report it later', 'T', DERIVED, since='1.80')
def a_bad_speed_is_ok(robot):
    equal(robot.listen.run('1', 'PTP("JPP",10,0,90,0,90,0,-10,200,0,false)'), 'OK')
    robot.wait_for('Robot_Error', True, 2)
    true(robot.value('Error_Code') != 0, 'Error_Code is 0')


@check('TM-1.3.24', 'frames after a script that blocks are buffered and run in order', 'M 7.3', since='1.76')
def scripts_run_in_order(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1,1)')
    robot.listen.script('2', 'QueueTag(2)')
    robot.listen.script('3', 'QueueTag(3)')
    seen = [str(frame) for frame in robot.listen.until('TMSCT,3,OK')]
    replies = [text for text in seen if text.startswith('TMSCT')]
    equal(replies, ['TMSCT,1,OK', 'TMSCT,2,OK', 'TMSCT,3,OK'])
    true(seen.index('TMSTA,01,01,true') < seen.index('TMSCT,2,OK'), 'the second script overtook: %s' % seen)


@check('TM-1.3.25', 'a buffered script is checked, and answered, when its turn comes', '?', CHOICE, since='1.76')
def a_buffered_script_is_answered_at_its_turn(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1,1)')
    robot.listen.script('2', FAULTY)
    replies = [str(f) for f in robot.listen.until('TMSCT,2,ERROR;1') if f.header == 'TMSCT']
    equal(replies, ['TMSCT,1,OK', 'TMSCT,2,ERROR;1'])


# Errors and warnings ----------------------------------------------------------------------------


@check('TM-1.3.26', 'a syntax error is an ERROR of its line', 'M 7.3', safe=True)
def syntax_errors(robot):
    robot.refuses('ChangeLoad(1', 'ChangeLoad 1)', 'ChangeLoad(1))', 'ChangeBase("RobotBase)', 'ChangeLoad(,)', '=')


@check('TM-1.3.27', 'an unknown function is an ERROR of its line', 'M 7.3', safe=True)
def unknown_functions(robot):
    robot.refuses('NoSuchFunction(1)', 'ptp("JPP",0,0,90,0,90,0,35,200,0,false)')


@check('TM-1.3.28', 'arguments of a wrong type are an ERROR of their line', 'M 7.3', safe=True)
def wrong_argument_types(robot):
    robot.refuses('ChangeLoad({1,2})', 'PTP(1,0,0,90,0,90,0,35,200,0,false)', 'PTP("JPP",{0,0,90,0,90},35,200,0,false)')


@check('TM-1.3.29', 'a wrong count of arguments is an ERROR of its line', 'M 7.3', safe=True)
def wrong_argument_counts(robot):
    robot.refuses('ChangeLoad()', 'ChangeLoad(1,2)', 'PTP("JPP",0,0,90,0,90,0,35,200,0)', 'Pause(1)',
                  'ChangeBase(1,2,3)')


@check('TM-1.3.30', 'declaring an existing local variable is an ERROR: `4,ERROR;1`', 'M 7.3', safe=True)
def a_variable_is_declared_once(robot):
    declaration = 'int %s = 100' % robot.name()
    equal(robot.listen.run('3', declaration), 'OK')
    equal(robot.listen.run('4', declaration), 'ERROR;1')


@check('TM-1.3.31', 'reading outside an IO array is an ERROR of its line', 'M 7.3', safe=True)
def io_arrays_have_ends(robot):
    name = robot.name()
    robot.accepts('byte %s = IO["ControlBox"].DI[15]' % name)
    robot.refuses('byte %s = IO["ControlBox"].DI[16]' % name, 'byte %s = IO["ControlBox"].DI[-1]' % name)


@check('TM-1.3.32', 'declaring and using a variable on one line is an ERROR of its line', 'M 7.3', safe=True)
def one_statement_in_a_line(robot):
    name = robot.name()
    robot.accepts('int %s = 1' % name)
    robot.refuses('int %s = 1 %s++' % (name, name), 'int %s = %s + 1' % (name, name))


@check('TM-1.3.33', 'float to int, and int to byte, are warnings', 'M chapter 1', safe=True)
def narrowing_warns(robot):
    name = robot.name()
    equal(robot.listen.run('1', 'int %sa = 1.5' % name), 'OK;1')
    equal(robot.listen.run('1', 'int %sb = 7' % name, 'byte %sc = %sb' % (name, name)), 'OK;2')


@check('TM-1.3.34', 'a string used as a number is a warning', 'M chapter 1', safe=True)
def a_string_as_a_number_warns(robot):
    equal(robot.listen.run('1', 'int %s = "12"' % robot.name()), 'OK;1')


@check('TM-1.3.35', 'an unquoted string is a warning', 'M chapter 1', safe=True)
def an_unquoted_string_warns(robot):
    equal(robot.listen.run('1', 'string %s = Hello' % robot.name()), 'OK;1')


# Variables and leaving --------------------------------------------------------------------------


@check('TM-1.3.36', 'a local variable exists in later scripts too', 'M 7.3', since='1.76', safe=True)
def local_variables_live_on(robot):
    name = robot.name()
    equal(robot.listen.run('1', 'int %s = 100' % name), 'OK')
    equal(robot.listen.run('2', '%s = 1000' % name, '%s++' % name), 'OK')
    equal(robot.evaluate(name), '1001')


@check('TM-1.3.37', 'local variables end when the node is left', 'M 7.3')
def local_variables_end_with_the_node(robot):
    equal(robot.listen.run('1', 'int var_i = 100'), 'OK')
    equal(robot.listen.run('2', 'ScriptExit()'), 'OK')
    robot.listen.until('TMSCT,0,Listen1')
    equal(robot.listen.run('3', 'var_i++'), 'ERROR;1')
    equal(robot.listen.run('4', 'int var_i = 100'), 'OK')


@check('TM-1.3.38', 'project variables can be read and written: `$TMSCT,15,1,var_counter++,*26`', 'M 7.3', since='1.76',
       variable='int var_counter=5')
def project_variables_are_there(robot):
    robot.listen.send_bytes(b'$TMSCT,15,1,var_counter++,*26\r\n')
    equal(robot.listen.reply('1'), 'OK')
    equal(robot.evaluate('var_counter'), '6')


@check('TM-1.3.39', 'project variables outlive the node', 'M 7.3', since='1.76', variable='int var_counter=5')
def project_variables_outlive_the_node(robot):
    equal(robot.listen.run('1', 'var_counter = 8', 'ScriptExit()'), 'OK')
    robot.listen.until('TMSCT,0,Listen1')
    equal(robot.evaluate('var_counter'), '8')


@check('TM-1.3.40', 'ScriptExit() is answered with OK', 'M 7.3')
def script_exit_is_ok(robot):
    robot.listen.send_bytes(b'$TMSCT,14,1,ScriptExit(),*67\r\n')
    equal(str(robot.listen.receive()), 'TMSCT,1,OK')


@check('TM-1.3.41', 'lines after ScriptExit() are not executed', 'M 7.3', since='1.76')
def script_exit_ends_the_script(robot):
    equal(robot.listen.run('2', 'QueueTag(6)', 'ScriptExit()', 'QueueTag(7)'), 'OK')
    robot.listen.until('TMSCT,0,Listen1')
    texts = [str(frame) for frame in robot.listen.frames]
    true('TMSTA,01,06,true' in texts, 'the line before it is not executed: %s' % texts)
    true('TMSTA,01,07,true' not in texts, 'the line behind it is executed')


@check('TM-1.3.42', 'from ScriptExit() until the node is left, scripts get CPERR F1', 'M 7.3', time_scale=1)
def after_script_exit_scripts_are_refused(robot):
    equal(robot.listen.run('1', LONG, 'ScriptExit()'), 'OK')
    robot.listen.script('2', 'ChangeLoad(1)')
    equal(str(robot.listen.receive()), 'CPERR,F1')


@check('TM-1.3.43', 'while the flow is elsewhere, a script is dropped: `$CPERR,2,F1,*3F`', 'M 7.3', time_scale=0.05)
def outside_the_node_scripts_are_refused(robot):
    equal(robot.listen.run('1', 'ScriptExit()'), 'OK')
    equal(robot.listen.ask('00').rstrip(','), '00,false')
    robot.listen.script('2', SHORT)
    equal(str(robot.listen.receive()), 'CPERR,F1')
    robot.listen.until('TMSCT,0,Listen1')
    near(robot.value('Joint_Angle')[0], 0, 0.001, 'J1')


@check('TM-1.3.44', 'scripts buffered after ScriptExit() get CPERR F1', '?', CHOICE, since='1.76')
def scripts_behind_script_exit_are_refused(robot):
    robot.listen.script('1', SHORT, 'QueueTag(1,1)', 'ScriptExit()')
    robot.listen.script('2', 'ChangeLoad(1)')
    robot.listen.until('TMSCT,1,OK')
    equal(str(robot.listen.receive()), 'CPERR,F1')


@check('TM-1.3.45', 'speed 0 and pose bits out of range get OK, then a robot error', '?', CHOICE, since='1.80')
def wrong_numbers_are_robot_errors(robot):
    equal(robot.listen.run('1', 'PTP("CPP",517,-122,461,180,0,90,10,200,0,false,9,9,9)'), 'OK')
    robot.wait_for('Robot_Error', True, 2)


@check('TM-1.3.46', 'a motion that fails reports the tags after it as false', '?', CHOICE, since='1.80')
def tags_of_a_failed_motion_are_false(robot):
    equal(robot.listen.run('1', OUT_OF_REACH, 'QueueTag(4)'), 'OK')
    robot.listen.until('TMSTA,01,04,false')


@check('TM-1.3.47', 'all lines with an error are listed, whatever the errors are', 'M 7.3', safe=True)
def all_faulty_lines_are_named(robot):
    equal(robot.listen.run('1', 'ChangeBase("NoSuchBase")', FAULTY, 'ChangeLoad(', 'ChangeLoad()'), 'ERROR;1;2;3;4')


@check('TM-1.3.48', 'more than 1000 waiting scripts are refused: `ERROR;1`', '?', CHOICE, since='1.76', time_scale=1)
def waiting_scripts_have_an_end(robot):
    robot.listen.script('first', LONG, 'QueueTag(1,1)')
    for number in range(1100):
        robot.listen.script('n%d' % number, 'ChangeLoad(1)')
    equal(robot.listen.in_listen_node(), True, 'in a Listen node')
    refused = [frame.text for frame in robot.listen.frames if frame.header == 'TMSCT']
    equal(set(text.split(',')[1] for text in refused), {'ERROR;1'})
    near(len(refused), 100, 2, 'refused scripts')


@check('TM-1.3.49', 'lines that do not fit in a queue of 1000 motions are an ERROR', '?', CHOICE, time_scale=1)
def the_queue_has_an_end(robot):
    reply = robot.listen.run('1', LONG, *['ChangeLoad(1)'] * 1100)
    true(reply.startswith('ERROR;') and reply.endswith(';1101'), 'answered with %s' % reply[:60])
