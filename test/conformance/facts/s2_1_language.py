"""Fact sheet 2.1: the language of scripts. Values are seen through ListenSend, which TMflow has from 1.76 on."""
import struct

from motions import LONG, text
from suite import CHOICE, DERIVED, check, equal, near, true

SEEN = {'since': '1.76'}


def sends(robot, kind, literal, expected):
    """A variable of a type, given a literal, is sent as these bytes."""
    name = robot.name()
    equal(robot.sent_by('%s %s = %s' % (kind, name, literal), 'ListenSend(90,%s)' % name), [expected],
          '%s %s' % (kind, literal))


@check('TM-2.1.01', 'byte: 0 to 255', 'M chapter 1', safe=True, **SEEN)
def the_type_byte(robot):
    sends(robot, 'byte', '0', b'\0')
    sends(robot, 'byte', '255', b'\xff')


@check('TM-2.1.02', 'int: 32 bits with sign', 'M chapter 1', safe=True, **SEEN)
def the_type_int(robot):
    sends(robot, 'int', '2147483647', struct.pack('<i', 2147483647))
    sends(robot, 'int', '-2147483648', struct.pack('<i', -2147483648))


@check('TM-2.1.03', 'float: 32 bits', 'M chapter 1', safe=True, **SEEN)
def the_type_float(robot):
    sends(robot, 'float', '0.1', struct.pack('<f', 0.1))


@check('TM-2.1.04', 'double: 64 bits', 'M chapter 1', safe=True, **SEEN)
def the_type_double(robot):
    sends(robot, 'double', '0.1', struct.pack('<d', 0.1))


@check('TM-2.1.05', 'bool: true and false', 'M chapter 1', safe=True, **SEEN)
def the_type_bool(robot):
    name = robot.name()
    equal(robot.evaluate('%s ? 1 : 2' % name, 'bool %s = true' % name), '1')
    equal(robot.evaluate('%sb ? 1 : 2' % name, 'bool %sb = false' % name), '2')


@check('TM-2.1.06', 'string: UTF-8', 'M chapter 1', safe=True, **SEEN)
def the_type_string(robot):
    sends(robot, 'string', '"達明 robot"', '達明 robot'.encode())


@check('TM-2.1.07', 'arrays `T[]` of each type, with `{…}` literals', 'M chapter 1', safe=True, **SEEN)
def arrays(robot):
    sends(robot, 'byte[]', '{1,2,255}', b'\1\2\xff')
    sends(robot, 'int[]', '{1,-1}', struct.pack('<2i', 1, -1))
    sends(robot, 'float[]', '{ 1.5 , 2 }', struct.pack('<2f', 1.5, 2))
    sends(robot, 'double[]', '{0.1}', struct.pack('<d', 0.1))
    sends(robot, 'string[]', '{"a","bc"}', b'abc')
    robot.accepts('bool[] %s = {true,false}' % robot.name())


@check('TM-2.1.08', 'an array has at most 2048 elements', 'M chapter 1', safe=True, **SEEN)
def arrays_have_an_end(robot):
    robot.accepts('byte[] %s = {%s}' % (robot.name(), ','.join(['1'] * 2048)))
    robot.refuses('byte[] %s = {%s}' % (robot.name(), ','.join(['1'] * 2049)))


@check('TM-2.1.09', 'elements are read and written as `a[i]`, counted from 0', 'M chapter 1', safe=True, **SEEN)
def elements(robot):
    name = robot.name()
    equal(robot.evaluate(name, 'int[] %s = {1,2,3}' % name, '%s[0] = %s[2] + 4' % (name, name)), '{7,2,3}')


@check('TM-2.1.10', 'numbers are decimal, `0x`, `0b`, or floating', 'M chapter 1', safe=True, **SEEN)
def numbers(robot):
    robot.evaluates(('100', '100'), ('0x100', '256'), ('0b100', '4'), ('1.5', '1.5'), ('-7', '-7'))


@check('TM-2.1.11', '`true` and `false` may begin with a capital', 'M chapter 1', safe=True, **SEEN)
def capital_booleans(robot):
    robot.evaluates(('True ? 1 : 2', '1'), ('False ? 1 : 2', '2'))
    robot.accepts('PTP("JPP",0,0,90,0,90,0,35,200,0,True)')


@check('TM-2.1.12', '`""` is a quote within a string', 'M chapter 1', safe=True, **SEEN)
def quotes_within_strings(robot):
    equal(robot.sent_by('ListenSend(90,"say ""hi""")'), [b'say "hi"'])


@check('TM-2.1.13', '+ - * / %', 'M chapter 2', safe=True, **SEEN)
def arithmetic(robot):
    robot.evaluates(('7 + 5', '12'), ('7 - 9', '-2'), ('7 * 5', '35'), ('8 / 2', '4'), ('17 % 5', '2'),
                    ('1.5 + 2', '3.5'), ('2 + 3 * 4', '14'), ('(2 + 3) * 4', '20'), ('10 - 4 - 3', '3'))


@check('TM-2.1.14', '++ and -- of a variable', 'M chapter 2', safe=True, **SEEN)
def increments(robot):
    name = robot.name()
    equal(robot.evaluate(name, 'int %s = 5' % name, '%s++' % name, '%s++' % name, '%s--' % name), '6')


@check('TM-2.1.15', '< > <= >= == !=', 'M chapter 2', safe=True, **SEEN)
def comparisons(robot):
    for condition, holds in (('1 < 2', 1), ('2 < 2', 0), ('2 > 1', 1), ('2 <= 2', 1), ('1 >= 2', 0), ('2 == 2', 1),
                             ('2 != 2', 0)):
        equal(robot.evaluate('%s ? 1 : 0' % condition), str(holds), condition)


@check('TM-2.1.16', '! && ||', 'M chapter 2', safe=True, **SEEN)
def logic(robot):
    robot.evaluates(('!false ? 1 : 0', '1'), ('true && false ? 1 : 0', '0'), ('false || true ? 1 : 0', '1'))


@check('TM-2.1.17', '~ & ^ | << >>', 'M chapter 2', safe=True, **SEEN)
def bits(robot):
    robot.evaluates(('~5', '-6'), ('12 & 10', '8'), ('12 ^ 10', '6'), ('12 | 10', '14'), ('1 << 4', '16'),
                    ('256 >> 4', '16'))


@check('TM-2.1.18', '?:', 'M chapter 2', safe=True, **SEEN)
def conditional(robot):
    robot.evaluates(('1 < 2 ? 10 : 20', '10'), ('1 > 2 ? 10 : 20', '20'))


@check('TM-2.1.19', '= and += -= *= /= %= <<= >>= &= ^= |=', 'M chapter 2', safe=True, **SEEN)
def assignments(robot):
    for operator, expected in (('=', 5), ('+=', 17), ('-=', 7), ('*=', 60), ('/=', 2), ('%=', 2), ('<<=', 384),
                               ('>>=', 0), ('&=', 4), ('^=', 9), ('|=', 13)):
        name = robot.name()
        equal(robot.evaluate(name, 'int %s = 12' % name, '%s %s 5' % (name, operator)), str(expected), operator)


@check('TM-2.1.20', 'a declaration may omit the value', 'M chapter 1', safe=True, **SEEN)
def declarations_without_a_value(robot):
    name = robot.name()
    equal(robot.evaluate(name, 'int %s' % name, '%s = 3' % name), '3')


@check('TM-2.1.21', 'strings are joined with +', 'M chapter 2', DERIVED, safe=True, **SEEN)
def strings_are_joined(robot):
    equal(robot.sent_by('ListenSend(90,"a" + "b")'), [b'ab'])


@check('TM-2.1.22', 'variables are arguments of motions', 'M 8', safe=True, **SEEN)
def variables_are_arguments(robot):
    name = robot.name()
    robot.accepts('float[] %s = {0,0,90,0,90,0}' % name, 'PTP("JPP",%s,10,200,0,false)' % name)


@check('TM-2.1.23', 'the two motions with tags of the manual run as printed', 'M 8.2', since='1.76')
def the_example_of_the_manual(robot):
    robot.listen.script('2', 'float[] targetP1={20,-35,125,0,90,0}', 'PTP("JPP",targetP1,100,200,0,false)',
                        'QueueTag(1)', 'float[] targetP2={0,-35,125,0,90,0}', 'PTP("JPP",targetP2,100,200,0,false)',
                        'QueueTag(2)')
    equal(robot.listen.reply('2'), 'OK')
    for tag in ('01', '02'):
        robot.listen.until('TMSTA,01,%s,true' % tag)
    near(robot.value('Joint_Angle'), [0, -35, 125, 0, 90, 0], 0.01, 'Joint_Angle')


@check('TM-2.1.24', 'variables are immediate: a value is read while the motion queued before is running', 'M 8',
       time_scale=1, **SEEN)
def expressions_are_immediate(robot):
    name = robot.name()
    equal(robot.listen.run('1', LONG, 'QueueTag(1)', 'int %s = 4' % name, 'ListenSend(90,GetString(%s))' % name), 'OK')
    texts = [frame.text for frame in robot.listen.frames]
    true('90,4' in texts and '01,01,true' not in texts, 'received %s' % texts)


@check('TM-2.1.25', 'changes of base, TCP and load are queued: they wait for the motion before', 'M 8', since='1.80',
       time_scale=1)
def changes_are_queued(robot):
    equal(robot.listen.run('1', LONG, 'ChangeTCP(0,0,150,0,0,90)', 'ChangeBase(1,2,3,0,0,0)', 'QueueTag(1)'), 'OK')
    equal(robot.listen.ask('01,01'), '01,01,false')
    equal(robot.values('TCP_Value', 'Base_Value'), [[0] * 6, [0] * 6], 'TCP and base during the motion')


@check('TM-2.1.26', 'queued changes apply to the motions after them', 'M 8', since='1.80')
def changes_count_for_later_motions(robot):
    pose = robot.value('Coord_Robot_Flange')
    robot.move('ChangeTCP(0,0,150,0,0,0)', 'Line("CAP",%s,200,200,0,false)' % text(pose))
    near(robot.value('Coord_Robot_Tool'), pose, 0.01, 'Coord_Robot_Tool')
    near(robot.value('Coord_Robot_Flange')[2], pose[2] + 150, 0.01, 'Z of the flange')  # the tool looks down


@check('TM-2.1.27', 'a float may have an exponent, as the robot itself writes them', '?', CHOICE, safe=True)
def floats_have_exponents(robot):
    robot.accepts('PTP("JPP",1e-05,-1.29178234E-05,9e1,0,9.0E+1,0,35,200,0,false)')
