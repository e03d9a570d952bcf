"""Fact sheet 3.1 and 3.2: the items of the status port."""
import struct

import tm_items
from motions import OUT_OF_REACH, SHORT, stands
from suite import DERIVED, check, equal, near, true
from tm_client import pack_items, pack_text, unpack_items

GROUPS = {
    '01': ('the state of the robot',
           'Robot_Error Project_Run Project_Edit Project_Pause Get_Control Safeguard_A ESTOP Camera_Light '
           'Robot_Model Error_Code Error_Time'),
    '02': ('poses and joints', 'Coord_Base_Flange Coord_Base_Tool Coord_Robot_Flange Coord_Robot_Tool Joint_Angle'),
    '03': ('touch stop',
           'Touch_Coord_Base_Flange Touch_Joint_Angle_Stop Touch_Coord_Base_Tool Touch_Coord_Robot_Flange '
           'Touch_Coord_Robot_Tool'),
    '04': ('force and speed of the TCP', 'TCP_Force TCP_Force3D TCP_Speed TCP_Speed3D'),
    '05': ('speed, torque, current, temperature of the joints',
           'Joint_Speed Joint_Torque Joint_Current Joint_Temperature'),
    '06': ('tool and base', 'TCP_Name TCP_Value TCP_Mass TCP_MOI TCP_MCF Base_Name Base_Value HandCamera_Value'),
    '07': ('the project', 'Project_Name Project_Speed MA_Mode'),
    '08': ('the stick', 'Stick_Power Stick_MA Stick_PlayPause Stick_Plus Stick_Minus Stick_Stop End_FreeBot'),
    '09': ('limits of the safety functions',
           'Safety_TCP_Speed Safety_TCP_Speed_HandGuide Safety_TCP_Force Safety_Joint_Speed '
           'Safety_Joint_Torque Safety_Joint_Angle_Min Safety_Joint_Angle_Max Safety_GSensor'),
    '10': ('limits of collaborative operation',
           'Col_TCP_Speed Col_TCP_Speed_HandGuide Col_TCP_Force Col_Joint_Speed Col_Joint_Torque '
           'Col_Motion_Speed Col_PTP_Speed Col_Deceleration_Time Col_Contact_Area'),
    '11': ('automatic operation', 'Speed_Adjust_Enable Auto_Remote_Enable Auto_Remote_Active'),
    '12': ('the controller',
           'ControlBox_SN Controller_Temperature Manipulator_Voltage Manipulator_Consumption Manipulator_Current '
           'ControlBox_IO_Current End_IO_Current Current_Time Project_Run_Time System_Uptime TMflow_Version'),
    '13': ('DH tables and light', 'DHTable DeltaDH Robot_Light'),
    '14': ('safety I/O', ' '.join('SO%d SI%d' % (n, n) for n in range(5))),
    '15': ('digital I/O of the control box', ' '.join('Ctrl_DO%d Ctrl_DI%d' % (n, n) for n in range(16))),
    '16': ('analogue I/O of the control box', 'Ctrl_AO0 Ctrl_AI0 Ctrl_AI1'),
    '17': ('I/O of the end module', ' '.join('End_DO%d End_DI%d' % (n, n) for n in range(4)) + ' End_AI0'),
}


def can_be_read(robot, names):
    """All are there, and as long as their type is."""
    missing = []
    for name in names:
        mode, content = robot.svr.request(11, pack_text(name))
        if mode != 11:
            missing.append(name)
        elif name not in tm_items.UNSURE and tm_items.size(name) is not None:
            equal(len(unpack_items(content)[0][1]), tm_items.size(name), 'bytes of ' + name)
    true(not missing, 'cannot be read: ' + ' '.join(missing))


def _add(number, title, names):

    @check('TM-3.1.' + number, title + ': ' + ', '.join(_short(names)), 'C', since='1.84', safe=True)
    def group_can_be_read(robot):
        can_be_read(robot, names)


def _short(names):
    return names if len(names) <= 9 else [names[0], names[1], '…', names[-1]]


for _number, (_title, _names) in GROUPS.items():
    _add(_number, _title, _names.split())


@check('TM-3.1.20', 'the groups of the 1.84 table have 138 items, and Robot_Link', 'C', safe=True)
def the_table_is_complete(robot):
    grouped = {name for _, names in GROUPS.values() for name in names.split()}
    later = {'Joint_Torque_Average', 'Joint_Torque_Min', 'Joint_Torque_Max', 'Robot_Link'}
    equal(grouped | later, set(tm_items.TYPES), 'items of the sheet')
    equal(len(tm_items.TYPES), 139)


@check('TM-3.1.21', 'Joint_Torque_Average, _Min, _Max, from 1.84 on', 'C', since='1.84', safe=True)
def torques_of_1_84(robot):
    can_be_read(robot, ['Joint_Torque_Average', 'Joint_Torque_Min', 'Joint_Torque_Max'])


@check('TM-3.1.22', 'Joint_Torque_Average, _Min, _Max are not in 1.80', 'C', DERIVED, since='1.80', until='1.80',
       safe=True)
def torques_are_not_in_1_80(robot):
    for name in ('Joint_Torque_Average', 'Joint_Torque_Min', 'Joint_Torque_Max'):
        equal(robot.svr.refusal(11, pack_text(name)), '04,NotExist;' + name)


@check('TM-3.1.23', '1.76 and 1.80 have Ctrl_AO1, End_AO0, Ext0 to Ext7 and Robot_Mode', 'C', since='1.80',
       until='1.80', safe=True)
def extras_of_1_80(robot):
    can_be_there = [name for name in tm_items.OLDER if robot.svr.request(11, pack_text(name))[0] != 11]
    equal(can_be_there, [], 'cannot be read')


@check('TM-3.1.24', '1.82 and 1.84 have neither the items of TM-3.1.23 nor Error_Content', 'C', since='1.82', safe=True)
def extras_are_gone(robot):
    for name in ('Ctrl_AO1', 'End_AO0', 'Ext0_DO', 'Robot_Mode', 'Error_Content'):
        equal(robot.svr.refusal(11, pack_text(name)), '04,NotExist;' + name)


@check('TM-3.1.25', '1.76 has no Joint_Speed, TCP_Speed, DHTable', 'C', since='1.76', until='1.76', safe=True)
def items_that_1_76_lacks(robot):
    for name in ('Joint_Speed', 'TCP_Speed', 'DHTable'):
        equal(robot.svr.refusal(11, pack_text(name)), '04,NotExist;' + name)


@check('TM-3.1.26', '1.76 has Error_Content', 'C', since='1.76', until='1.76', safe=True)
def error_content_of_1_76(robot):
    equal(robot.svr.request(11, pack_text('Error_Content'))[0], 11, 'mode of the answer')


@check('TM-3.1.27', 'Error_Content is not in 1.80', 'C', DERIVED, since='1.80', until='1.80', safe=True)
def error_content_is_not_in_1_80(robot):
    equal(robot.svr.refusal(11, pack_text('Error_Content')), '04,NotExist;Error_Content')


# What they tell ---------------------------------------------------------------------------------


@check('TM-3.1.30', 'Joint_Angle in deg, poses in mm and deg', 'C', since='1.80')
def units_of_poses(robot):
    near(robot.value('Joint_Angle'), [0, 0, 90, 0, 90, 0], 0.01, 'Joint_Angle')
    near(robot.value('Coord_Robot_Flange')[:3], [517.5, -122.3, 461.05], 0.02, 'Coord_Robot_Flange')  # TM 4.4


@check('TM-3.1.31', 'Coord_*_Flange is the flange, Coord_*_Tool the TCP; Coord_Base_* in the current base', 'C',
       since='1.80')
def flange_tool_and_base(robot):
    flange = robot.value('Coord_Robot_Flange')
    robot.move('ChangeTCP(0,0,100,0,0,0)', 'ChangeBase(10,20,30,0,0,0)')
    near(robot.value('Coord_Robot_Flange')[:3], flange[:3], 0.01, 'Coord_Robot_Flange')
    near(robot.value('Coord_Robot_Tool')[:3], [flange[0], flange[1], flange[2] - 100], 0.01, 'Coord_Robot_Tool')
    near(
        robot.value('Coord_Base_Flange')[:3], [flange[0] - 10, flange[1] - 20, flange[2] - 30], 0.01,
        'Coord_Base_Flange')
    near(robot.value('Coord_Base_Tool')[:3], [flange[0] - 10, flange[1] - 20, flange[2] - 130], 0.01, 'Coord_Base_Tool')


@check('TM-3.1.32', 'Joint_Speed in deg/s and TCP_Speed in mm/s show the motion', 'C', since='1.80')
def units_of_speeds(robot):
    frames = robot.observe('PTP("JPP",-60,0,90,0,90,0,20,200,0,false)')
    near(max(abs(frame['Joint_Speed'][0]) for frame in frames), 36, 0.5, 'Joint_Speed')
    radius = (517.5**2 + 122.3**2)**0.5
    near(max(frame['TCP_Speed3D'] for frame in frames), radius * 0.6283, 5, 'TCP_Speed3D')
    for frame in frames:
        near(sum(speed**2 for speed in frame['TCP_Speed'][:3])**0.5, frame['TCP_Speed3D'], 0.5, 'length of TCP_Speed')


@check('TM-3.1.33', 'Project_Run is true while a project runs', 'C', since='1.80')
def a_project_runs(robot):
    equal(robot.value('Project_Run'), True, 'Project_Run')
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)


@check('TM-3.1.34', 'MA_Mode is 1 in automatic mode', 'C', since='1.80')
def automatic_mode(robot):
    equal(robot.value('MA_Mode'), 1, 'MA_Mode')


@check('TM-3.1.35', 'MA_Mode is 2 in manual mode', 'C', since='1.80', operator='manual')
def manual_mode(robot):
    equal(robot.value('MA_Mode'), 2, 'MA_Mode')


@check('TM-3.1.36', 'Robot_Light is 4 when a project runs in automatic mode, 3 when none does', 'C', since='1.80')
def the_light(robot):
    equal(robot.value('Robot_Light'), 4, 'Robot_Light')
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    equal(robot.value('Robot_Light'), 3, 'Robot_Light')


@check('TM-3.1.37', 'Robot_Light is 6 when a project runs in manual mode, 5 when none does', 'C', since='1.80',
       operator='manual')
def the_light_in_manual_mode(robot):
    equal(robot.value('Robot_Light'), 6, 'Robot_Light')
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    equal(robot.value('Robot_Light'), 5, 'Robot_Light')


def light_with_an_error(robot):
    equal(robot.listen.run('1', OUT_OF_REACH), 'OK')
    robot.wait_for('Robot_Error', True, 2)
    return robot.value('Robot_Light')


@check('TM-3.1.38', 'Robot_Light is 9 with an error in automatic mode', 'C', since='1.80')
def the_light_with_an_error(robot):
    equal(light_with_an_error(robot), 9, 'Robot_Light')


@check('TM-3.1.43', 'Robot_Light is 10 with an error in manual mode', 'C', since='1.80', operator='manual')
def the_light_with_an_error_in_manual_mode(robot):
    equal(light_with_an_error(robot), 10, 'Robot_Light')


@check('TM-3.1.44', 'ESTOP is true, and Robot_Light 0, while the emergency stop is pressed', 'C', since='1.80',
       operator='estop press')
def emergency_stop(robot):
    equal(robot.values('ESTOP', 'Robot_Light'), [True, 0])


@check('TM-3.1.45', 'Safeguard_A shows the open safeguard, and the arm is at standstill', 'C; I', DERIVED, since='1.80',
       operator='safeguard open')
def safeguard(robot):
    equal(robot.value('Safeguard_A'), True, 'Safeguard_A')
    equal(robot.listen.run('1', SHORT), 'OK')
    near(stands(robot)[0], 0, 0.001, 'J1')


@check('TM-3.1.46', 'Ctrl_DI and End_DI are the inputs', 'C', since='1.80', operator='input ControlBox 3 1')
def inputs(robot):
    equal(robot.values('Ctrl_DI2', 'Ctrl_DI3'), [0, 1])


@check('TM-3.1.39', 'TMflow_Version names the version', 'C', since='1.80', safe=True)
def the_version(robot):
    true(robot.value('TMflow_Version').startswith(tuple('12')), 'TMflow_Version is %r' % robot.value('TMflow_Version'))


@check('TM-3.1.40', 'TMflow_Version follows the version of the simulator', 'C', since='1.84')
def the_version_follows(robot):
    true('1.84' in robot.value('TMflow_Version'), 'TMflow_Version is %r' % robot.value('TMflow_Version'))


@check('TM-3.1.41', 'DHTable has six rows of offset, alpha, a, d, type, lower, upper', 'C; DS', since='1.80')
def the_dh_table(robot):
    rows = [robot.value('DHTable')[7 * n:7 * n + 7] for n in range(6)]
    near([row[:4] for row in rows][0], [0, -90, 0, 145.2], 0.01, 'row 1')
    near(rows[1][:4], [-90, 0, 429, 0], 0.01, 'row 2')
    near(rows[2][:4] + rows[2][5:], [0, 0, 411.5, 0, -155, 155], 0.01, 'row 3')
    near(rows[3][:4], [90, 90, 0, -122.3], 0.01, 'row 4')


@check('TM-3.1.42', 'Robot_Model names the model', 'C', DERIVED, since='1.80', model='tm12')
def the_model(robot):
    true('12' in robot.value('Robot_Model'), 'Robot_Model is %r' % robot.value('Robot_Model'))


# Writing them -----------------------------------------------------------------------------------


@check('TM-3.1.50', 'Project_Speed accepts multiples of 5 from 5 to 100', 'C')
def project_speeds(robot):
    for percent, answer in ((5, '00,OK'), (50, '00,OK'), (100, '00,OK'), (47, '07,ValueError;Project_Speed'),
                            (0, '07,ValueError;Project_Speed'), (105, '07,ValueError;Project_Speed')):
        equal(robot.svr.refusal(1, pack_items(('Project_Speed', struct.pack('<i', percent)))), answer,
              '%d %%' % percent)
    equal(robot.value('Project_Speed'), 100, 'Project_Speed')


@check('TM-3.1.51', 'Stick_Plus and Stick_Minus change the project speed', 'C', DERIVED)
def the_speed_buttons(robot):
    robot.press('Stick_Minus')
    robot.wait_for('Project_Speed', 95, 1)
    robot.press('Stick_Plus')
    robot.wait_for('Project_Speed', 100, 1)


@check('TM-3.1.52', 'outputs and Camera_Light can be written in both modes', 'C', operator='manual')
def outputs_in_manual_mode(robot):
    equal(robot.value('MA_Mode'), 2, 'MA_Mode')
    for name, value in (('Ctrl_DO15', b'\1'), ('End_DO3', b'\1'), ('Camera_Light', b'\1'), ('Ctrl_AO0',
                                                                                            struct.pack('<f', 2.5))):
        equal(robot.svr.refusal(1, pack_items((name, value))), '00,OK', name)
    equal(robot.values('Ctrl_DO15', 'End_DO3', 'Camera_Light', 'Ctrl_AO0'), [1, 1, 1, 2.5])


@check('TM-3.1.53', 'Project_Name, Project_Speed and the stick except Stop can only be written in automatic mode',
       'C', operator='manual')
def items_of_automatic_mode(robot):
    for name, value in (('Project_Name', b'x'), ('Project_Speed', struct.pack('<i', 50)), ('Stick_PlayPause', b'\1'),
                        ('Stick_Plus', b'\1'), ('Stick_Minus', b'\1')):
        equal(robot.svr.refusal(1, pack_items((name, value))), '06,ModeError;' + name)
    robot.press('Stick_Stop')


@check('TM-3.1.54', 'all other items are read-only', 'C')
def other_items_can_only_be_read(robot):
    for name in ('Robot_Error', 'Joint_Angle', 'MA_Mode', 'TCP_Value', 'Ctrl_DI0', 'Ctrl_AI0', 'End_DI0', 'Error_Code'):
        equal(robot.svr.refusal(1, pack_items((name, b'\0' * tm_items.size(name)))), '05,ReadOnly;' + name)


@check('TM-3.1.55', 'the frame `$TMSVR,20,local,2,Stick_Stop=1,*12` stops the project', 'C; W', since='1.80')
def stop_is_pressed(robot):
    robot.svr.send_bytes(b'$TMSVR,20,local,2,Stick_Stop=1,*12\r\n')
    answer = robot.svr.until(lambda frame: frame.data.startswith(b'local,'))[-1]
    equal(answer.text, 'local,0,00,OK')
    robot.wait_for('Project_Run', False, 1)


@check('TM-3.1.56', 'writing 1 to Stick_PlayPause runs a stopped project', 'C', since='1.80')
def play_is_pressed(robot):
    robot.stop_project()
    robot.wait_for('Project_Run', False, 1)
    robot.press('Stick_PlayPause')
    robot.wait_for('Project_Run', True, 1)


@check('TM-3.2.01', 'the stream can hold the 47 items of the vendor driver', 'D', safe=True)
def the_table_of_the_driver(robot):
    streamed = {name for name, _ in unpack_items(robot.svr.stream_frame()[2])}
    equal(sorted(set(tm_items.VENDOR_TABLE) - streamed), [], 'items that are not streamed')


@check('TM-3.2.02', 'they have the sizes that the driver expects', 'D', safe=True)
def sizes_of_the_table(robot):
    sizes = {
        name: len(value)
        for name, value in unpack_items(robot.svr.stream_frame()[2]) if name in tm_items.VENDOR_TABLE
    }
    equal(sizes, {name: tm_items.size(name) for name in tm_items.VENDOR_TABLE})
