"""Fact sheet 2.4: parameterised items."""
from motions import LONG
from suite import CHOICE, DERIVED, check, equal, near, true
from tm_client import pack_items

SEEN = {'since': '1.76', 'safe': True}
BOX = 'IO["ControlBox"]'
END = 'IO["EndModule"]'


@check('TM-2.4.01', 'the control box has 16 DI, 16 DO, 2 AI, 1 AO', 'M, DS', **SEEN)
def the_control_box(robot):
    robot.evaluates(('Length(%s.DI)' % BOX, '16'), ('Length(%s.DO)' % BOX, '16'), ('Length(%s.AI)' % BOX, '2'),
                    ('Length(%s.AO)' % BOX, '1'))


@check('TM-2.4.02', 'the end module has 4 DI, 4 DO, 1 AI', 'M, DS', **SEEN)
def the_end_module(robot):
    robot.evaluates(('Length(%s.DI)' % END, '4'), ('Length(%s.DO)' % END, '4'), ('Length(%s.AI)' % END, '1'))


@check('TM-2.4.03', 'DI are bytes, AI are floats', 'M', **SEEN)
def types_of_inputs(robot):
    equal([len(sent) for sent in robot.sent_by('ListenSend(90,%s.DI)' % BOX, 'ListenSend(90,%s.AI)' % BOX)], [16, 8])


@check('TM-2.4.04', 'an output is written: `$TMSCT,27,18,IO["ControlBox"].DO[2]=1,*5E`', 'M 2.4', since='1.80')
def an_output_is_written(robot):
    robot.listen.send_bytes(b'$TMSCT,27,18,IO["ControlBox"].DO[2]=1,*5E\r\n')
    equal(robot.listen.reply('18'), 'OK')
    robot.wait_for('Ctrl_DO2', 1, 1)


@check('TM-2.4.05', 'outputs of the end module are written', 'M', since='1.80')
def an_end_output_is_written(robot):
    equal(robot.listen.run('1', END + '.DO[1]=1'), 'OK')
    robot.wait_for('End_DO1', 1, 1)


@check('TM-2.4.06', 'DO is queued: it is set when the motion before it has ended', 'M', since='1.80')
def do_is_queued(robot):
    equal(robot.listen.run('1', LONG, BOX + '.DO[2]=1'), 'OK')
    equal(robot.value('Ctrl_DO2'), 0, 'Ctrl_DO2 during the motion')
    robot.wait_for('Ctrl_DO2', 1, 70)
    near(robot.value('Joint_Angle')[0], -90, 0.01, 'J1 when it is set')


@check('TM-2.4.07', 'InstantDO is immediate', 'M', since='1.80', time_scale=1)
def instant_do_is_immediate(robot):
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', BOX + '.InstantDO[3]=1'), 'OK')
    robot.wait_for('Ctrl_DO3', 1, 1)
    equal(robot.listen.ask('01,01'), '01,01,false')


@check('TM-2.4.08', 'AO is queued, InstantAO immediate', 'M', since='1.80', time_scale=1)
def analogue_outputs(robot):
    equal(robot.listen.run('1', BOX + '.AO[0]=2.5'), 'OK')
    robot.wait_for('Ctrl_AO0', 2.5, 1)
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', BOX + '.AO[0]=-3', BOX + '.InstantAO[0]=5'), 'OK')
    robot.wait_for('Ctrl_AO0', 5.0, 1)
    equal(robot.listen.ask('01,01'), '01,01,false')


@check('TM-2.4.09', 'a whole array is written with exactly its count of elements', 'M', since='1.80')
def whole_arrays_are_written(robot):
    robot.accepts(END + '.DO={1,0,1,0}')
    robot.refuses(END + '.DO={1,0,1}', END + '.DO={1,0,1,0,1}')
    equal(robot.listen.run('1', END + '.DO={1,0,1,0}'), 'OK')
    robot.wait_for('End_DO2', 1, 1)
    equal(robot.values('End_DO0', 'End_DO1', 'End_DO3'), [1, 0, 0])


@check('TM-2.4.10', 'an index outside an array is an ERROR', 'M', **SEEN)
def indices_have_ends(robot):
    robot.accepts(BOX + '.DO[15]=1', END + '.DO[3]=1')
    robot.refuses(BOX + '.DO[16]=1', END + '.DO[4]=1', BOX + '.DO[-1]=1')


@check('TM-2.4.11', 'writing a read-only attribute has no effect, and gives no error', 'M', since='1.80')
def read_only_attributes(robot):
    before = robot.value('Ctrl_DI0')
    true(robot.listen.run('1', BOX + '.DI[0]=%d' % (1 - before)).startswith('OK'), 'an ERROR')
    robot.later(0.1)
    equal(robot.value('Ctrl_DI0'), before, 'Ctrl_DI0')


@check('TM-2.4.12', 'IO["Safety"] has five SI and five SO', 'M', **SEEN)
def safety_io(robot):
    robot.evaluates(('Length(IO["Safety"].SI)', '5'), ('Length(IO["Safety"].SO)', '5'))


@check('TM-2.4.13', 'Robot[0].Joint, CoordRobot, CoordBase: the position of the arm', 'M', since='1.80', safe=True)
def where_the_robot_is(robot):
    joints, in_robot, in_base = robot.values('Joint_Angle', 'Coord_Robot_Tool', 'Coord_Base_Tool')
    near(robot.numbers('Robot[0].Joint'), joints, 0.01, 'Joint')
    near(robot.numbers('Robot[0].CoordRobot')[:3], in_robot[:3], 0.01, 'CoordRobot')
    near(robot.numbers('Robot[0].CoordBase')[:3], in_base[:3], 0.01, 'CoordBase')


@check('TM-2.4.14', 'Robot[0].BaseName and TCPName: the active base and tool', 'M', since='1.80', safe=True)
def what_the_robot_uses(robot):
    robot.evaluates(('Robot[0].BaseName', robot.value('Base_Name')), ('Robot[0].TCPName', robot.value('TCP_Name')))


@check('TM-2.4.15', 'Robot[0].TCPForce3D and TCPSpeed3D are floats', 'M', **SEEN)
def speed_and_force(robot):
    equal([len(robot.numbers('Robot[0].TCPForce3D')), len(robot.numbers('Robot[0].TCPSpeed3D'))], [1, 1])


@check('TM-2.4.16', 'Robot[0].CameraLight is read and written', 'M', since='1.80')
def camera_light(robot):
    equal(robot.listen.run('1', 'Robot[0].CameraLight=1'), 'OK')
    robot.wait_for('Camera_Light', 1, 1)
    equal(robot.evaluate('Robot[0].CameraLight'), '1')


@check('TM-2.4.17', 'Point["P1"]: Value, Pose, Flange, BaseName, TCPName, TeachValue, TeachPose', 'M', since='1.76',
       point='P1=0,0,90,0,90,0')
def points(robot):
    near(robot.numbers('Point["P1"].Value')[:3], robot.value('Coord_Robot_Tool')[:3], 0.01, 'Value of where the arm is')
    robot.evaluates(('Point["P1"].Pose', '{0,2,4}'), ('Point["P1"].BaseName', 'RobotBase'),
                    ('Point["P1"].TeachPose', '{0,2,4}'))
    equal([len(robot.numbers('Point["P1"].' + name)) for name in ('Flange', 'TeachValue')], [6, 6])


@check('TM-2.4.18', 'Point: Value and Pose are written, TeachValue stays', 'M', since='1.76', point='P1=0,0,90,0,90,0')
def points_are_written(robot):
    taught = robot.evaluate('Point["P1"].TeachValue')
    equal(robot.listen.run('1', 'Point["P1"].Value={1,2,3,4,5,6}', 'Point["P1"].Pose={1,3,5}'), 'OK')
    robot.evaluates(('Point["P1"].Value', '{1,2,3,4,5,6}'), ('Point["P1"].Pose', '{1,3,5}'),
                    ('Point["P1"].TeachValue', taught))


@check('TM-2.4.19', 'Base["RobotBase"] is of type R, and fixed', 'M', since='1.76')
def the_robot_base_is_fixed(robot):
    robot.evaluates(('Base["RobotBase"].Type', 'R'), ('Base["RobotBase"].Value', '{0,0,0,0,0,0}'))
    true(robot.listen.run('1', 'Base["RobotBase"].Value={1,2,3,0,0,0}').startswith('OK'), 'an ERROR')
    equal(robot.evaluate('Base["RobotBase"].Value'), '{0,0,0,0,0,0}')


@check('TM-2.4.20', 'a base of the project: Value is written, Type is C, TeachValue stays', 'M', since='1.76',
       base='table=1,2,3,0,0,0')
def bases(robot):
    robot.evaluates(('Base["table"].Value', '{1,2,3,0,0,0}'), ('Base["table"].Type', 'C'))
    equal(robot.listen.run('1', 'Base["table"].Value={4,5,6,0,0,90}'), 'OK')
    robot.evaluates(('Base["table"].Value', '{4,5,6,0,0,90}'), ('Base["table"].TeachValue', '{1,2,3,0,0,0}'))


@check('TM-2.4.21', 'a written base applies to ChangeBase by its name', 'M', DERIVED, since='1.80',
       base='table=1,2,3,0,0,0')
def a_base_is_used(robot):
    robot.move('ChangeBase("table")')
    equal(robot.values('Base_Name', 'Base_Value'), ['table', [1, 2, 3, 0, 0, 0]])
    robot.move('Base["table"].Value={4,5,6,0,0,90}', 'ChangeBase("table")')
    equal(robot.value('Base_Value'), [4, 5, 6, 0, 0, 90], 'Base_Value')


@check('TM-2.4.22', 'a tool of the project: Value, Mass, MOI, MCF are read and written', 'M', since='1.76',
       tcp='gripper=0,0,150,0,0,0')
def tools(robot):
    equal(robot.evaluate('TCP["gripper"].Value'), '{0,0,150,0,0,0}')
    equal(
        robot.listen.run('1', 'TCP["gripper"].Mass=2', 'TCP["gripper"].MOI={1,2,3}',
                         'TCP["gripper"].MCF={0,0,-80,0,0,0}'), 'OK')
    robot.evaluates(('TCP["gripper"].Mass', '2'), ('TCP["gripper"].MOI', '{1,2,3}'),
                    ('TCP["gripper"].MCF', '{0,0,-80,0,0,0}'), ('TCP["gripper"].TeachValue', '{0,0,150,0,0,0}'))


@check('TM-2.4.23', 'NOTOOL and HandCamera are read-only', 'M', since='1.76')
def fixed_tools(robot):
    for name in ('NOTOOL', 'HandCamera'):
        value = robot.evaluate('TCP["%s"].Value' % name)
        true(robot.listen.run('1', 'TCP["%s"].Value={1,2,3,0,0,0}' % name).startswith('OK'), 'an ERROR')
        equal(robot.evaluate('TCP["%s"].Value' % name), value, name)


@check('TM-2.4.24', 'an output written on the status port is read by scripts, and the other way round', 'M', DERIVED,
       since='1.80')
def both_ports_see_one_robot(robot):
    equal(robot.svr.refusal(1, pack_items(('Ctrl_DO5', b'\1'))), '00,OK')
    equal(robot.evaluate(BOX + '.DO[5]'), '1')
    equal(robot.listen.run('1', BOX + '.DO[5]=0'), 'OK')
    robot.wait_for('Ctrl_DO5', 0, 1)


@check('TM-2.4.25', 'an unknown item, module or attribute is an ERROR', 'M', DERIVED, **SEEN)
def unknown_items(robot):
    robot.accepts(BOX + '.DO[0]=1')
    robot.refuses('IO["NoBox"].DO[0]=1', BOX + '.NoSuch[0]=1', 'NoItem["x"].Value={1,2,3,4,5,6}')


@check('TM-2.4.26', 'outputs that StopAndClearBuffer drops keep their state', '?', CHOICE, since='1.80')
def dropped_outputs_stay(robot):
    equal(robot.listen.run('1', LONG, BOX + '.DO[4]=1', 'StopAndClearBuffer()', END + '.DO[0]=1'), 'OK')
    robot.wait_for('End_DO0', 1, 5)
    equal(robot.value('Ctrl_DO4'), 0, 'Ctrl_DO4')


@check('TM-2.4.27', 'outputs keep their state when the project stops', '?', CHOICE, since='1.80')
def outputs_outlive_the_project(robot):
    equal(robot.listen.run('1', BOX + '.DO[4]=1'), 'OK')
    robot.wait_for('Ctrl_DO4', 1, 1)
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    equal(robot.value('Ctrl_DO4'), 1, 'Ctrl_DO4')


@check('TM-2.4.28', 'outputs are written with `IO[ControlBox].DO[0]=1`, as the vendor drivers do: OK with a warning',
       'D, M chapter 1',
       since='1.80')
def the_drivers_write_outputs_without_quotes(robot):
    equal(robot.listen.run('io', 'IO[ControlBox].DO[0]=1'), 'OK;1')
    robot.wait_for('Ctrl_DO0', 1, 1)
    equal(robot.listen.run('io', 'IO[EndModule].InstantDO[1]=1'), 'OK;1')
    robot.wait_for('End_DO1', 1, 1)
    equal(robot.listen.run('io', 'IO[ControlBox].AO[0]=2.500000'), 'OK;1')
    robot.wait_for('Ctrl_AO0', 2.5, 1)


@check('TM-2.4.29', 'names without quotes in brackets are names: Base[table], TCP[grip], Point[P1], with a warning',
       'M chapter 1',
       DERIVED, since='1.80', base='table=1,2,3,0,0,0', tcp='grip=0,0,150,0,0,0', point='P1=0,0,90,0,90,0')
def names_need_no_quotes(robot):
    for name, attribute, count in (('Base[table]', 'Value', 6), ('TCP[grip]', 'Value', 6), ('Point[P1]', 'Pose', 3)):
        item = '%s.%s' % (name, attribute)
        equal(robot.listen.run('1', 'ListenSend(90,Length(%s))' % item), 'OK;1', item)
        equal(robot.listen.run('2', '%s=%s' % (item, '{0,2,4}' if count == 3 else '{4,5,6,0,0,0}')), 'OK;1', item)


@check('TM-2.4.30', 'a name without quotes that the robot does not have is an ERROR', 'M chapter 1', DERIVED,
       since='1.76', safe=True)
def unknown_names_without_quotes(robot):
    robot.refuses('IO[ControlBux].DO[0]=1', 'Base[nowhere_at_all].Value={1,2,3,0,0,0}', 'Robot[arm].CameraLight=1')
