"""The predefined items of the status port (TM 3.1, table of TMflow 1.84), their types, who may write them."""
import struct

# A type and its items, a line each. `*` marks what may be written in automatic mode, `+` in both modes.
_TABLE = """
byte Robot_Link Camera_Light+
bool Robot_Error Project_Run Project_Edit Project_Pause Get_Control Safeguard_A ESTOP
string Robot_Model Error_Time
int Error_Code
float[6] Coord_Base_Flange Coord_Base_Tool Coord_Robot_Flange Coord_Robot_Tool Joint_Angle
float[6] Touch_Coord_Base_Flange Touch_Joint_Angle_Stop Touch_Coord_Base_Tool Touch_Coord_Robot_Flange
float[6] Touch_Coord_Robot_Tool
float[3] TCP_Force
float TCP_Force3D TCP_Speed3D
float[6] TCP_Speed Joint_Speed Joint_Torque Joint_Torque_Average Joint_Torque_Min Joint_Torque_Max
float[6] Joint_Current Joint_Temperature
string TCP_Name Base_Name
float[6] TCP_Value TCP_MCF Base_Value HandCamera_Value
float TCP_Mass
float[3] TCP_MOI
string Project_Name*
int Project_Speed* MA_Mode
bool Stick_Power Stick_MA Stick_PlayPause* Stick_Plus* Stick_Minus* Stick_Stop+ End_FreeBot
float Safety_TCP_Speed Safety_TCP_Speed_HandGuide Safety_TCP_Force
float[6] Safety_Joint_Speed Safety_Joint_Torque Safety_Joint_Angle_Min Safety_Joint_Angle_Max
float Col_TCP_Speed Col_TCP_Speed_HandGuide Col_TCP_Force Col_Motion_Speed Col_PTP_Speed Col_Contact_Area
float[6] Col_Joint_Speed Col_Joint_Torque
int Col_Deceleration_Time
bool Safety_GSensor Speed_Adjust_Enable Auto_Remote_Enable Auto_Remote_Active*
string ControlBox_SN Current_Time Project_Run_Time System_Uptime TMflow_Version
float Controller_Temperature Manipulator_Voltage Manipulator_Consumption Manipulator_Current
float ControlBox_IO_Current End_IO_Current
float[42] DHTable
float[30] DeltaDH
int Robot_Light
byte SO0 SO1 SO2 SO3 SO4 SI0 SI1 SI2 SI3 SI4
byte Ctrl_DO0+ Ctrl_DO1+ Ctrl_DO2+ Ctrl_DO3+ Ctrl_DO4+ Ctrl_DO5+ Ctrl_DO6+ Ctrl_DO7+
byte Ctrl_DO8+ Ctrl_DO9+ Ctrl_DO10+ Ctrl_DO11+ Ctrl_DO12+ Ctrl_DO13+ Ctrl_DO14+ Ctrl_DO15+
byte Ctrl_DI0 Ctrl_DI1 Ctrl_DI2 Ctrl_DI3 Ctrl_DI4 Ctrl_DI5 Ctrl_DI6 Ctrl_DI7
byte Ctrl_DI8 Ctrl_DI9 Ctrl_DI10 Ctrl_DI11 Ctrl_DI12 Ctrl_DI13 Ctrl_DI14 Ctrl_DI15
float Ctrl_AO0+ Ctrl_AI0 Ctrl_AI1
byte End_DO0+ End_DO1+ End_DO2+ End_DO3+ End_DI0 End_DI1 End_DI2 End_DI3
float End_AI0
"""

# What the sheet groups as "strings/floats" or names without a type: their size is not checked.
UNSURE = {
    'Col_Contact_Area', 'Col_PTP_Speed', 'Col_Motion_Speed', 'Controller_Temperature', 'Manipulator_Voltage',
    'Manipulator_Consumption', 'Manipulator_Current', 'ControlBox_IO_Current', 'End_IO_Current', 'Current_Time',
    'Project_Run_Time', 'System_Uptime'
}

# In TMflow 1.76 and 1.80 only.
OLDER = ['Ctrl_AO1', 'End_AO0', 'Ext0_DO', 'Ext0_DI', 'Ext0_AO', 'Ext0_AI', 'Ext7_DO', 'Ext7_DI', 'Robot_Mode']

# The table that the vendor's ROS driver needs (TM 3.2).
VENDOR_TABLE = (
    'Robot_Link Robot_Error Project_Run Project_Pause Safeguard_A ESTOP Camera_Light Error_Code Joint_Angle '
    'Coord_Robot_Flange Coord_Robot_Tool TCP_Force TCP_Force3D TCP_Speed TCP_Speed3D Joint_Speed Joint_Torque '
    'Project_Speed MA_Mode Robot_Light').split()
VENDOR_TABLE += ['Ctrl_DO%d' % n for n in range(8)] + ['Ctrl_DI%d' % n for n in range(8)]
VENDOR_TABLE += ['Ctrl_AO0', 'Ctrl_AI0', 'Ctrl_AI1'] + ['End_DO%d' % n for n in range(4)]
VENDOR_TABLE += ['End_DI0', 'End_DI1', 'End_DI2', 'End_AI0']

TYPES = {}  # name -> 'float[6]'
WRITABLE = {}  # name -> 'A' or 'M/A'
for _line in _TABLE.split('\n'):
    for _word in _line.split()[1:]:
        TYPES[_word.rstrip('*+')] = _line.split()[0]
        if _word[-1] in '*+':
            WRITABLE[_word[:-1]] = 'A' if _word[-1] == '*' else 'M/A'

_SCALARS = {'byte': 'B', 'bool': '?', 'int': 'i', 'float': 'f'}


def size(name):
    """Bytes of an item's value, or None when it has no fixed size."""
    scalar, count = _split(TYPES[name])
    return None if scalar == 'string' else struct.calcsize(_SCALARS[scalar]) * count


def _split(kind):
    scalar, _, count = kind.partition('[')
    return scalar, int(count.rstrip(']')) if count else 1


def decode(name, data):
    """The value of an item: a number, a bool, a text, or a list of floats."""
    scalar, count = _split(TYPES[name])
    if scalar == 'string':
        return data.decode()
    if len(data) != size(name):
        raise AssertionError('%s has %d bytes, its type %s has %d' % (name, len(data), TYPES[name], size(name)))
    numbers = struct.unpack('<%d%s' % (count, _SCALARS[scalar]), data)
    return list(numbers) if count > 1 else numbers[0]
