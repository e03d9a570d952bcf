"""Fact sheet 2.2: which motion and control functions there are, and what they take.

Nothing is executed: a last line with an unknown function makes the robot name all faulty lines, and do nothing (1.3).
Checks that name stopping functions so are not called safe all the same.
"""
from suite import CHOICE, DERIVED, check, equal

SIX = '417.50,-122.30,343.90,180.00,0.00,90.00'
ARRAY = '{%s}' % SIX
OTHER = '381.70,208.74,343.90,180.00,0.00,135.00'


def takes_both_forms(robot, function, formats, arguments, target=SIX):
    """Each format, with six numbers and with an array."""
    lines = []
    for text in formats:
        lines += [
            '%s("%s",%s,%s)' % (function, text, target, arguments),
            '%s("%s",{%s},%s)' % (function, text, target, arguments)
        ]
    robot.accepts(*lines)


def refuses_formats(robot, function, formats, arguments):
    robot.refuses(*('%s("%s",%s,%s)' % (function, text, SIX, arguments) for text in formats))


@check('TM-2.2.01', 'PTP: JPP, CPP; p6, speed %, ms, blend %, bool', 'M 8', safe=True)
def ptp(robot):
    takes_both_forms(robot, 'PTP', ('JPP', 'CPP'), '10,200,0,false')
    robot.refuses('PTP("CPP",%s,10,200,0)' % SIX, 'PTP("CPP",%s,10,200,0,false,0)' % SIX)


@check('TM-2.2.02', 'PTP CPP with the pose: three ints, or int[3]', 'M 8', safe=True)
def ptp_with_pose(robot):
    takes_both_forms(robot, 'PTP', ('CPP', ), '10,200,0,false,0,2,4')
    takes_both_forms(robot, 'PTP', ('CPP', ), '10,200,0,false,{0,2,4}')


@check('TM-2.2.03', 'PTP JPP takes no pose', 'M 8', DERIVED, safe=True)
def ptp_of_joints_has_no_pose(robot):
    robot.refuses('PTP("JPP",0,0,90,0,90,0,10,200,0,false,0,2,4)')


@check('TM-2.2.04', 'Line: CPP, CPR, CAP, CAR; p6, speed, ms, blend, bool', 'M 8', safe=True)
def line(robot):
    takes_both_forms(robot, 'Line', ('CPP', 'CPR', 'CAP', 'CAR'), '100,200,50,false')
    robot.refuses('Line("CAP",%s,100,200,50)' % SIX)


@check('TM-2.2.05', 'Circle: CPP, CAP; via and end p6, speed, ms, blend %, angle, bool', 'M 8', safe=True)
def circle(robot):
    robot.accepts(*('Circle("%s",%s,%s,100,200,50,270,false)' % (text, via, end) for text in ('CPP', 'CAP')
                    for via, end in ((SIX, OTHER), (ARRAY, '{%s}' % OTHER))))
    robot.refuses('Circle("CAP",%s,100,200,50,270,false)' % SIX)


@check('TM-2.2.06', 'PLine: JAP, CAP; p6, mm/s, ms, blend %, and no bool', 'M 8', safe=True)
def pline(robot):
    takes_both_forms(robot, 'PLine', ('JAP', 'CAP'), '100,200,50')
    robot.refuses('PLine("CAP",%s,100,200,50,false)' % SIX)


@check('TM-2.2.07', 'Move_PTP: CPP, TPP, JPP; relative p6, speed %, ms, blend %, bool', 'M 8', safe=True)
def move_ptp(robot):
    takes_both_forms(robot, 'Move_PTP', ('CPP', 'TPP', 'JPP'), '10,200,0,false', '0,0,10,45,0,0')


@check('TM-2.2.08', 'Move_Line: CPP, CPR, CAP, CAR, TPP, TPR, TAP, TAR; relative p6, speed, ms, blend, bool', 'M 8',
       safe=True)
def move_line(robot):
    formats = [target + speed + blend for target in 'CT' for speed in 'PA' for blend in 'PR']
    takes_both_forms(robot, 'Move_Line', formats, '10,200,0,false', '0,0,10,45,0,0')


@check('TM-2.2.09', 'Move_PLine: CAP, TAP, JAP; relative p6, mm/s, ms, blend %, and no bool', 'M 8', safe=True)
def move_pline(robot):
    takes_both_forms(robot, 'Move_PLine', ('CAP', 'TAP', 'JAP'), '125,200,0', '0,0,10,45,0,0')
    robot.refuses('Move_PLine("CAP",0,0,10,45,0,0,125,200,0,false)')


@check('TM-2.2.10', 'ChangeBase: a name, float[6], or six floats', 'M 8', safe=True)
def change_base(robot):
    robot.accepts('ChangeBase("RobotBase")', 'ChangeBase({20,30,10,0,0,90})', 'ChangeBase(20,30,10,0,0,90)')
    robot.refuses('ChangeBase(20,30,10,0,0)', 'ChangeBase()')


@check('TM-2.2.11', 'ChangeTCP: a name; a frame; with the mass; with inertia and mass centre; as array or numbers',
       'M 8', safe=True)
def change_tcp(robot):
    nine = '2,0.5,0.5,0,0,-80,0,0,0'
    robot.accepts('ChangeTCP("NOTOOL")', 'ChangeTCP({0,0,150,0,0,90})', 'ChangeTCP({0,0,150,0,0,90},2)',
                  'ChangeTCP({0,0,150,0,0,90},2,{%s})' % nine, 'ChangeTCP(0,0,150,0,0,90)',
                  'ChangeTCP(0,0,150,0,0,90,2)', 'ChangeTCP(0,0,150,0,0,90,2,%s)' % nine)
    robot.refuses('ChangeTCP(0,0,150,0,0)', 'ChangeTCP(0,0,150,0,0,90,2,3)', 'ChangeTCP()')


@check('TM-2.2.12', 'ChangeLoad: kg', 'M 8', safe=True)
def change_load(robot):
    robot.accepts('ChangeLoad(5.3)', 'ChangeLoad(0)')
    robot.refuses('ChangeLoad("5")')


@check('TM-2.2.13', 'PVTEnter: 0, 1, or nothing', 'M 8', since='1.72', safe=True)
def pvt_enter(robot):
    robot.accepts('PVTEnter(0)', 'PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)', 'PVTExit()')
    robot.accepts('PVTEnter(1)', 'PVTPoint(%s,0,0,0,0,0,0,2.0)' % SIX, 'PVTExit()')
    robot.accepts('PVTEnter()', 'PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)', 'PVTExit()')


@check('TM-2.2.14', 'PVTPoint: two float[6] and a duration, or thirteen floats', 'M 8', since='1.72', safe=True)
def pvt_point(robot):
    robot.accepts('PVTEnter(0)', 'PVTPoint({0,0,90,0,90,0},{0,0,0,0,0,0},2.0)',
                  'PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)', 'PVTExit()')
    robot.refuses('PVTPoint(0,0,90,0,90,0,2.0)')


@check('TM-2.2.15', 'PVTPause, PVTResume: nothing', 'M 8', since='1.72', safe=True)
def pvt_pause(robot):
    robot.accepts('PVTPause()', 'PVTResume()')
    robot.refuses('PVTPause(1)', 'PVTResume(1)')


@check('TM-2.2.16', 'QueueTag: the tag, and 0 or 1', 'M 8', since='1.76', safe=True)
def queue_tag(robot):
    robot.accepts('QueueTag(1)', 'QueueTag(15)', 'QueueTag(1,0)', 'QueueTag(1,1)')
    robot.refuses('QueueTag()', 'QueueTag(1,1,1)')


@check('TM-2.2.17', 'tags outside 1 to 15 are an ERROR', 'M 8: the range; ?: the ERROR', CHOICE, since='1.76',
       safe=True)
def tags_are_1_to_15(robot):
    robot.refuses('QueueTag(0)', 'QueueTag(16)', 'QueueTag(-1)')


@check('TM-2.2.18', 'WaitQueueTag: the tag, and a timeout', 'M 8', since='1.76', safe=True)
def wait_queue_tag(robot):
    robot.accepts('WaitQueueTag(1)', 'WaitQueueTag(1,5000)', 'WaitQueueTag(1,-1)', 'WaitQueueTag(1,0)')
    robot.refuses('WaitQueueTag()')


@check('TM-2.2.19', 'StopAndClearBuffer, Pause, Resume, ScriptExit: nothing', 'M 8', since='1.72')
def control(robot):
    robot.accepts('StopAndClearBuffer()', 'Pause()', 'Resume()', 'ScriptExit()')


@check('TM-2.2.20', 'motion functions return a bool, WaitQueueTag an int', 'M 8', since='1.76', safe=True)
def functions_return_values(robot):
    name = robot.name()
    robot.accepts('bool %sa = PTP("CPP",%s,10,200,0,false)' % (name, SIX), 'bool %sb = ChangeLoad(1)' % name,
                  'bool %sc = QueueTag(1)' % name, 'int %sd = WaitQueueTag(1,100)' % name)
    robot.refuses('float[] %se = PTP("CPP",%s,10,200,0,false)' % (name, SIX))


@check('TM-2.2.21', 'formats that a function does not have are an ERROR', 'M 8: the formats; ?: the ERROR', CHOICE,
       safe=True)
def formats_are_those_of_the_table(robot):
    refuses_formats(robot, 'PTP', ('TPP', 'CAP', 'JAP', 'CPR', '', 'cpp'), '10,200,0,false')
    refuses_formats(robot, 'Line', ('JPP', 'TPP'), '10,200,0,false')
    refuses_formats(robot, 'Move_PTP', ('CAP', ), '10,200,0,false')
    refuses_formats(robot, 'Move_Line', ('JPP', ), '10,200,0,false')


@check('TM-2.2.22', 'a base or tool with an unknown name is an ERROR', '?', CHOICE, safe=True)
def unknown_names(robot):
    for line in ('ChangeBase("NoSuchBase")', 'ChangeTCP("NoSuchTool")'):
        equal(robot.listen.run('1', line), 'ERROR;1', line)


@check('TM-2.2.23', 'the tools NOTOOL and HandCamera, and the base RobotBase, exist', 'M 8')
def special_names(robot):
    for line in ('ChangeTCP("NOTOOL")', 'ChangeTCP("HandCamera")', 'ChangeBase("RobotBase")'):
        equal(robot.listen.run('1', line), 'OK', line)


@check('TM-2.2.24', 'the velocity commands are an ERROR without a licence', 'L tmr_ros2 #19, #30', safe=True)
def velocity_needs_a_licence(robot):
    robot.refuses('ContinueVJog()', 'ContinueVLine(500,500)', 'SetContinueVJog(1,0,0,0,0,0)',
                  'SetContinueVLine(10,0,0,0,0,0)', 'StopContinueVmode()', 'SuspendContinueVmode()')


@check('TM-2.2.25', 'the velocity commands exist with a licence', 'D, W', DERIVED, licence=True)
def velocity_with_a_licence(robot):
    robot.accepts('ContinueVJog()', 'ContinueVLine(5000,10000)', 'SetContinueVJog(1,0,0,0,0,0)',
                  'SetContinueVLine(10,0,0,0,0,0)', 'StopContinueVmode()', 'SuspendContinueVmode()')


# Versions ---------------------------------------------------------------------------------------

BY_VERSION = {
    '1.68': [
        'ScriptExit()', 'PTP("JPP",0,0,90,0,90,0,35,200,0,false)',
        'Line("CAP",%s,100,200,0,false)' % SIX,
        'Circle("CAP",%s,%s,100,200,0,0,false)' % (SIX, OTHER),
        'PLine("CAP",%s,100,200,0)' % SIX, 'Move_PTP("TPP",0,0,1,0,0,0,10,200,0,false)',
        'Move_Line("TAP",0,0,1,0,0,0,10,200,0,false)', 'Move_PLine("TAP",0,0,1,0,0,0,10,200,0)',
        'ChangeBase("RobotBase")', 'ChangeTCP("NOTOOL")', 'ChangeLoad(1)'
    ],
    '1.72': [
        'StopAndClearBuffer()', 'Pause()', 'Resume()', 'PVTEnter(0)', 'PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)',
        'PVTExit()', 'PVTPause()', 'PVTResume()'
    ],
    '1.76': ['QueueTag(1)', 'WaitQueueTag(1,100)', 'ListenSend(90,"x")', 'int[] {0}a = Array_Append({{1}},2)'],
    '1.82': ['float[] {0}b = points2coord({{0,0,0,0,0,0}},{{1,0,0,0,0,0}},{{0,1,0,0,0,0}})'],
}
# Of other machines and of cameras: a simulator of an arm may do without.
SOCKET = ['socket_send("127.0.0.1",9,"x")']
VISION = [
    'Vision_DoJob("j")', 'Vision_DoJob_PTP("j",10,200,false)', 'Vision_DoJob_Line("j",10,200)',
    'Vision_IsJobAvailable("j")'
]


def lines_of(robot, version):
    name = robot.name()
    return [line.format(name) if '{0}' in line else line for line in BY_VERSION[version]]


def has_and_lacks(robot, has, lacks):
    for version in has:
        robot.accepts(*lines_of(robot, version))
    for version in lacks:
        robot.refuses(*lines_of(robot, version))


@check('TM-2.2.26', '1.68 has ScriptExit, PTP, Line, Circle, PLine, Move_*, Change*, and nothing else', 'M 8, FB',
       until='1.68')
def functions_of_1_68(robot):
    has_and_lacks(robot, ('1.68', ), ('1.72', '1.76', '1.82'))
    robot.refuses(*SOCKET, *VISION)


@check('TM-2.2.27', '1.72 adds StopAndClearBuffer, Pause, Resume and PVT*', 'M 8', since='1.72', until='1.72')
def functions_of_1_72(robot):
    has_and_lacks(robot, ('1.68', '1.72'), ('1.76', '1.82'))
    robot.refuses(*SOCKET, *VISION)


@check('TM-2.2.28', '1.76 adds tags, ListenSend and Array_*', 'M 8', since='1.76', until='1.76')
def functions_of_1_76(robot):
    has_and_lacks(robot, ('1.68', '1.72', '1.76'), ('1.82', ))
    robot.refuses(*VISION)


@check('TM-2.2.29', '1.80 has what 1.76 has', 'M 8', since='1.80', until='1.80')
def functions_of_1_80(robot):
    has_and_lacks(robot, ('1.68', '1.72', '1.76'), ('1.82', ))
    robot.refuses(*VISION)


@check('TM-2.2.30', '1.82 adds points2coord', 'M84 8', since='1.82', until='1.82')
def functions_of_1_82(robot):
    has_and_lacks(robot, ('1.68', '1.72', '1.76', '1.82'), ())


@check('TM-2.2.31', '1.84 has what 1.82 has', 'M84 8', since='1.84', until='1.84')
def functions_of_1_84(robot):
    has_and_lacks(robot, ('1.68', '1.72', '1.76', '1.82'), ())


@check('TM-2.2.90', 'socket_send exists from 1.76 on', 'M 8', since='1.76')
def a_socket_is_sent_to(robot):
    robot.accepts(*SOCKET)


@check('TM-2.2.91', 'Vision_* exists from 1.82 on', 'M84 8', since='1.82')
def there_are_cameras(robot):
    robot.accepts(*VISION)
