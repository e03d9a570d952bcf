"""Fact sheet 2.3: general functions.

The sheet names them; what the plain ones give follows from their names. Results of the geometric ones are those of the
manual. Not checked are functions whose name leaves open what they take (File_*, com_*, modbus_*, …).
"""
from suite import DERIVED, check, equal, near

P1 = '{-388.3831,-199.8061,367.0702,177.4319,1.717448,-46.02005}'
P2 = '{-436.9584,115.7343,371.4378,179.4419,-42.86601,-96.91867}'
P1_TO_P2 = '{-48.57532,315.5404,4.367615,-34.39363,-30.39285,-40.52448}'
SEEN = {'since': '1.76', 'safe': True}


@check('TM-2.3.01', 'trans(P1,P2), with the numbers of the manual', 'M', **SEEN)
def trans(robot):
    near(robot.numbers('trans(%s,%s)' % (P1, P2)), [float(n) for n in P1_TO_P2.strip('{}').split(',')], 1e-3)


@check('TM-2.3.02', 'inversetrans, with the numbers of the manual', 'M', **SEEN)
def inversetrans(robot):
    near(robot.numbers('inversetrans(%s)' % P1_TO_P2), [206.4934, -100.5999, -221.7758, 44.54835, -2.848977, 48.96799],
         1e-3)


@check('TM-2.3.03', 'changeref(p, base), with the numbers of the manual', 'M', **SEEN)
def changeref(robot):
    near(
        robot.numbers('changeref({-431.927,-140.6103,368.7306,-179.288,-0.6893783,-105.8449},'
                      '{-431.93,-140.61,368.73,-57.70,-44.98,33.62})'),
        [0.0020, 0, -0.0023, 113.9423, 14.9346, -123.1989], 2e-3)


@check('TM-2.3.04', 'applytrans(P1, trans(P1,P2)) is P2', 'M: trans; I', DERIVED, **SEEN)
def applytrans(robot):
    near(robot.numbers('applytrans(%s,trans(%s,%s))' % (P1, P1, P2)), [float(n) for n in P2.strip('{}').split(',')],
         2e-3)


@check('TM-2.3.05', 'interpoint between two points', 'M: the name; I', DERIVED, **SEEN)
def interpoint(robot):
    near(robot.numbers('interpoint({0,0,0,0,0,0},{100,40,-20,0,0,90},0.5)'), [50, 20, -10, 0, 0, 45], 1e-3)


@check('TM-2.3.06', 'dist of two points, norm2 of a vector', 'M: the names; I', DERIVED, **SEEN)
def lengths(robot):
    near(robot.numbers('dist({0,0,0,0,0,0},{3,4,12,0,0,0})'), [13], 1e-4)
    near(robot.numbers('norm2({3,4,12})'), [13], 1e-4)


@check('TM-2.3.07', 'abs, pow, sqrt, ceil, floor, round', 'M: the names', DERIVED, **SEEN)
def arithmetic(robot):
    for text, expected in (('abs(-3)', 3), ('pow(2,10)', 1024), ('sqrt(16)', 4), ('ceil(1.2)', 2), ('floor(1.8)', 1),
                           ('round(1.6)', 2)):
        near(robot.numbers(text), [expected], 1e-5, text)


@check('TM-2.3.08', 'sin, cos, tan, asin, acos, atan, atan2', 'M: the names; radians: I', DERIVED, **SEEN)
def trigonometry(robot):
    for text, expected in (('sin(d2r(30))', 0.5), ('cos(d2r(60))', 0.5), ('tan(d2r(45))', 1), ('r2d(asin(1))', 90),
                           ('r2d(acos(0))', 90), ('r2d(atan(1))', 45), ('r2d(atan2(1,-1))', 135)):
        near(robot.numbers(text), [expected], 1e-4, text)


@check('TM-2.3.09', 'd2r, r2d, log, log10', 'M: the names', DERIVED, **SEEN)
def conversions_of_numbers(robot):
    for text, expected in (('d2r(180)', 3.14159265), ('r2d(3.14159265)', 180), ('log10(1000)', 3), ('log(1)', 0)):
        near(robot.numbers(text), [expected], 1e-4, text)


@check('TM-2.3.10', 'random returns a number', 'M: the name', DERIVED, **SEEN)
def random_numbers(robot):
    equal(len(robot.numbers('random()')), 1, 'numbers of random()')


@check('TM-2.3.11', 'String_ToInteger, _ToFloat, _ToDouble', 'M: the names', DERIVED, **SEEN)
def strings_to_numbers(robot):
    for text, expected in (('String_ToInteger("12")', 12), ('String_ToFloat("1.5")', 1.5), ('String_ToDouble("-2.25")',
                                                                                            -2.25)):
        near(robot.numbers(text), [expected], 1e-6, text)


@check('TM-2.3.12', 'String_IndexOf, _LastIndexOf', 'M: the names', DERIVED, **SEEN)
def places_in_strings(robot):
    robot.evaluates(('String_IndexOf("banana","an")', '1'), ('String_LastIndexOf("banana","an")', '3'),
                    ('String_IndexOf("a","x")', '-1'))


@check('TM-2.3.13', 'String_Substring, _Replace, _Trim, _ToLower, _ToUpper', 'M: the names', DERIVED, **SEEN)
def parts_of_strings(robot):
    robot.evaluates(('String_Substring("robot",1,3)', 'obo'), ('String_Replace("banana","an","o")', 'booa'),
                    ('String_Trim("  a ")', 'a'), ('String_ToLower("aBc")', 'abc'), ('String_ToUpper("aBc")', 'ABC'))


@check('TM-2.3.14', 'String_Split', 'M: the name', DERIVED, **SEEN)
def strings_are_split(robot):
    equal(robot.evaluate('Length(String_Split("a,b,c",","))'), '3')


@check('TM-2.3.15', 'Array_Append, _Insert, _Remove', 'M: the names', DERIVED, **SEEN)
def arrays_are_changed(robot):
    name = robot.name()
    equal(robot.evaluate('Array_Append(%s,4)' % name, 'int[] %s = {1,2,3}' % name), '{1,2,3,4}')
    robot.evaluates(('Array_Insert(%s,1,9)' % name, '{1,9,2,3}'), ('Array_Remove(%s,0)' % name, '{2,3}'))


@check('TM-2.3.16', 'Array_Equals, _IndexOf, _LastIndexOf', 'M: the names', DERIVED, **SEEN)
def arrays_are_searched(robot):
    name = robot.name()
    equal(robot.evaluate('Array_IndexOf(%s,2)' % name, 'int[] %s = {2,1,2}' % name), '0')
    robot.evaluates(('Array_LastIndexOf(%s,2)' % name, '2'), ('Array_Equals(%s,%s) ? 1 : 0' % (name, name), '1'))


@check('TM-2.3.17', 'Array_Reverse, _Sort, _SubElements', 'M: the names', DERIVED, **SEEN)
def arrays_are_ordered(robot):
    name = robot.name()
    equal(robot.evaluate('Array_Reverse(%s)' % name, 'int[] %s = {3,1,2}' % name), '{2,1,3}')
    robot.evaluates(('Array_Sort(%s)' % name, '{1,2,3}'), ('Array_SubElements(%s,1,2)' % name, '{1,2}'))


@check('TM-2.3.18', 'Length of arrays and strings', 'M: the name', DERIVED, **SEEN)
def lengths_of_arrays(robot):
    name = robot.name()
    equal(robot.evaluate('Length(%s)' % name, 'int[] %s = {3,1,2}' % name), '3')


@check('TM-2.3.19', 'GetString of numbers, bools and arrays', 'M: the names; bools: as (string)True', DERIVED,
       **SEEN)
def texts(robot):
    robot.evaluates(('12', '12'), ('-0.5', '-0.5'), ('true', 'True'), ('false', 'False'))
    name = robot.name()
    equal(robot.evaluate(name, 'float[] %s = {1.5,-2}' % name), '{1.5,-2}')


@check('TM-2.3.20', 'GetBytes of an int: four bytes, little endian', 'M: the name; the order: as ListenSend', DERIVED,
       **SEEN)
def bytes_of_numbers(robot):
    name = robot.name()
    equal(robot.sent_by('int %s = 258' % name, 'ListenSend(90,GetBytes(%s))' % name), [b'\2\1\0\0'])


@check('TM-2.3.21', 'Byte_ToInt16, _ToInt32, _ToFloat, _ToDouble, _ToString', 'M: the names', DERIVED, **SEEN)
def numbers_of_bytes(robot):
    for function, data, expected in (('Byte_ToInt16', '{2,1}', '258'), ('Byte_ToInt32', '{2,1,0,0}', '258'),
                                     ('Byte_ToFloat', '{0,0,128,63}', '1'), ('Byte_ToDouble', '{0,0,0,0,0,0,240,63}',
                                                                             '1'), ('Byte_ToString', '{72,105}', 'Hi')):
        name = robot.name()
        equal(robot.evaluate('%s(%s)' % (function, name), 'byte[] %s = %s' % (name, data)), expected, function)


@check('TM-2.3.22', 'XOR8, SUM8', 'M: the names', DERIVED, **SEEN)
def sums(robot):
    name = robot.name()
    equal(robot.sent_by('byte[] %s = {1,2,4,8,255}' % name, 'ListenSend(90,XOR8(%s))' % name), [b'\xf0'])
    equal(robot.sent_by('ListenSend(90,SUM8(%s))' % name), [b'\x0e'])


@check('TM-2.3.23', 'ListenSend(90,GetString(Robot[0].CoordRobot)), as clients ask for the pose', 'W', DERIVED,
       since='1.80', safe=True)
def the_pose_is_asked_for(robot):
    found = robot.numbers('Robot[0].CoordRobot')
    near(found[:3], robot.value('Coord_Robot_Tool')[:3], 0.01, 'CoordRobot')


@check('TM-2.3.24', 'GetNow returns a text, Ctrl a control character', 'M: the names', DERIVED, **SEEN)
def time_and_control_characters(robot):
    robot.accepts('string %s = GetNow()' % robot.name())
    equal(robot.sent_by('ListenSend(90,"a" + Ctrl(10) + "b")'), [b'a\nb'])
