"""techmanpy 1.2, a client of TM robots by others, unmodified against tm_simulator.

Usage: techmanpy_test.py PROGRAM [unittest options]. Exit status 77 when techmanpy cannot be imported (skipped);
scripts/test installs it where CTest looks for it.

techmanpy knows the robot's ports by heart. So each test has an address of its own on the loopback network.
"""
import asyncio
import inspect
import random
import sys
import unittest

import robot
import suite

try:
    import techmanpy
except ImportError:
    print('techmanpy is not installed: skipped')
    sys.exit(77)

PROGRAM = ''
POSTURE = [0, 0, 90, 0, 90, 0]
POINT = [500, -120, 450, 180, 0, 90]  # some cm from where the TM5-900 stands in that posture


class Addressed(robot.Simulator):
    """tm_simulator on the robot's own ports."""

    def __init__(self, program, *wanted):
        super().__init__(program)
        self.address = '127.%d.%d.%d' % tuple(random.randint(1, 254) for _ in range(3))
        options = {option: value for option, value in wanted if option in self.options}
        arguments = [text for pair in options.items() for text in pair]
        self.robot = robot.SimulatedRobot(
            [program, '--bind', self.address, '--script-port', '5890', '--status-port', '5891', *arguments],
            suite.DEFAULT_VERSION, self.help, self.address)


class Case(unittest.TestCase):

    def setUp(self):
        self.simulator = Addressed(PROGRAM, ('--time-scale', '20'), ('--stream-format', 'string'))
        self.addCleanup(self.simulator.robot.close)
        self.robot = self.simulator.robot

    def script(self, *calls):
        """Calls of a script connection, `(name, arguments…)`, one after the other."""

        async def run():
            async with techmanpy.connect_sct(robot_ip=self.simulator.address) as connection:
                for name, *arguments in calls:
                    await getattr(connection, name)(*arguments)

        asyncio.run(asyncio.wait_for(run(), 30))

    def question(self, name, *arguments):

        async def run():
            async with techmanpy.connect_sta(robot_ip=self.simulator.address) as connection:
                return await getattr(connection, name)(*arguments)

        return asyncio.run(asyncio.wait_for(run(), 30))

    def item(self, name, *arguments):

        async def run():
            async with techmanpy.connect_svr(robot_ip=self.simulator.address) as connection:
                return await getattr(connection, name)(*arguments)

        return asyncio.run(asyncio.wait_for(run(), 30))

    def assert_at(self, item, expected, tolerance=0.02):
        suite.near(self.robot.value(item), expected, tolerance, item)


class ListenNode(Case):

    def test_the_node_is_active(self):
        self.assertIs(self.question('is_listen_node_active'), True)

    def test_a_tag_is_unknown_and_then_complete(self):
        self.assertIsNone(self.question('get_queue_tag_status', 5))
        self.script(('set_queue_tag', 5, True))
        self.assertIs(self.question('get_queue_tag_status', 5), True)

    def test_a_tag_is_waited_for(self):
        self.script(('move_to_joint_angles_ptp', [10] + POSTURE[1:], 1.0, 200), ('set_queue_tag', 1),
                    ('wait_for_queue_tag', 1, 60000))
        self.assert_at('Joint_Angle', [10] + POSTURE[1:])

    def test_the_node_is_left(self):
        self.script(('exit_listen', ))

    def test_an_error_is_told_with_its_command(self):
        with self.assertRaisesRegex(techmanpy.TMSCTError, 'ChangeBase'):
            self.script(('set_base', 'NoSuchBase'))


class Settings(Case):

    def test_base_tool_and_load(self):
        self.script(('set_base', [10, 20, 30, 0, 0, 90]), ('set_tcp', [0, 0, 150, 0, 0, 0]),
                    ('set_tcp', [0, 0, 150, 0, 0, 0], 2), ('set_load_weight', 1.5), ('set_queue_tag', 1, True))
        self.assert_at('Base_Value', [10, 20, 30, 0, 0, 90])
        self.assert_at('TCP_Value', [0, 0, 150, 0, 0, 0])
        self.assert_at('TCP_Mass', 2)

    def test_inertia(self):
        self.script(('set_tcp', [0, 0, 150, 0, 0, 0], 2, [2, 0.5, 0.5, 0, 0, -80, 0, 0, 0]))

    def test_base_and_tool_by_name(self):
        self.script(('set_base', 'RobotBase'), ('set_tcp', 'NOTOOL'))


class Motion(Case):

    def reaches(self, item, expected, *calls):
        self.script(*calls, ('set_queue_tag', 1, True))
        self.assert_at(item, expected)

    def test_ptp_to_joints(self):
        self.reaches('Joint_Angle', [10, -5, 80, 5, 85, 20],
                     ('move_to_joint_angles_ptp', [10, -5, 80, 5, 85, 20], 1.0, 200))

    def test_ptp_by_joints(self):
        self.reaches('Joint_Angle', [10, 0, 85, 0, 90, 0],
                     ('move_to_relative_joint_angles_ptp', [10, 0, -5, 0, 0, 0], 1.0, 200))

    def test_ptp_to_a_point(self):
        self.reaches('Coord_Robot_Tool', POINT, ('move_to_point_ptp', POINT, 1.0, 200))

    def test_ptp_to_a_point_with_a_pose(self):
        self.reaches('Coord_Robot_Tool', POINT, ('move_to_point_ptp', POINT, 1.0, 200, 0.0, True, [0, 2, 4]))

    def test_ptp_by_an_offset(self):
        x, y, z, *_ = self.robot.value('Coord_Robot_Tool')
        self.script(('move_to_relative_point_ptp', [-20, 0, 0, 0, 0, 0], 1.0, 200),
                    ('move_to_relative_point_ptp', [0, 0, 30, 0, 0, 0], 1.0, 200, 0.0, True),
                    ('set_queue_tag', 1, True))
        suite.near(self.robot.value('Coord_Robot_Tool')[:3], [x - 20, y, z - 30], 0.02)

    def test_line(self):
        self.reaches('Coord_Robot_Tool', POINT, ('move_to_point_line', POINT, 0.1, 200),
                     ('move_to_point_line', [480] + POINT[1:], 200, 200, 0, True),
                     ('move_to_point_line', POINT, 0.1, 200, 10, False, True),
                     ('move_to_point_line', POINT, 200, 200, 10, True, True))

    def test_line_by_an_offset(self):
        x, y, z, *_ = self.robot.value('Coord_Robot_Tool')
        self.script(('move_to_relative_point_line', [-20, 0, 0, 0, 0, 0], 0.1, 200),
                    ('move_to_relative_point_line', [0, 0, 30, 0, 0, 0], 200, 200, 0, True, True),
                    ('set_queue_tag', 1, True))
        suite.near(self.robot.value('Coord_Robot_Tool')[:3], [x - 20, y, z - 30], 0.02)

    def test_circle(self):
        x, y, *rest = [round(number, 3) for number in self.robot.value('Coord_Robot_Tool')]
        self.reaches('Coord_Robot_Tool', [x - 50, y - 50, *rest],
                     ('move_on_circle', [x - 50, y + 50, *rest], [x - 100, y, *rest], 200, 200, 270, 0.0, True))

    def test_path(self):
        self.reaches('Coord_Robot_Tool', POINT, ('move_to_joint_angles_path', [5] + POSTURE[1:], 200, 200),
                     ('move_to_point_path', POINT, 200, 200))

    def test_path_by_an_offset(self):
        self.reaches('Joint_Angle', [5] + POSTURE[1:],
                     ('move_to_relative_joint_angles_path', [5, 0, 0, 0, 0, 0], 200, 200),
                     ('move_to_relative_point_path', [-20, 0, 0, 0, 0, 0], 200, 200),
                     ('move_to_relative_point_path', [20, 0, 0, 0, 0, 0], 200, 200))

    def test_numbers_are_sent_as_python_writes_them(self):
        self.reaches('Joint_Angle', POSTURE, ('move_to_joint_angles_ptp', [1e-5] + POSTURE[1:], 1.0, 200))

    def test_pvt_of_joints(self):

        async def run():
            async with techmanpy.connect_sct(robot_ip=self.simulator.address) as connection:
                trajectory = connection.start_transaction()
                trajectory.enter_joint_pvt_mode()
                trajectory.add_pvt_joint_angles([5] + POSTURE[1:], [5, 0, 0, 0, 0, 0], 1000)
                trajectory.add_pvt_joint_angles([10] + POSTURE[1:], [0] * 6, 1000)
                trajectory.exit_pvt_mode()
                trajectory.set_queue_tag(1, True)
                await trajectory.submit()

        asyncio.run(asyncio.wait_for(run(), 30))
        self.assert_at('Joint_Angle', [10] + POSTURE[1:])

    def test_pvt_of_points(self):
        self.script(('enter_point_pvt_mode', ), ('add_pvt_point', POINT, [0] * 6, 1000), ('exit_pvt_mode', ))

    def test_pvt_pauses(self):
        self.script(('pause_pvt_mode', ), ('resume_pvt_mode', ))

    def test_a_transaction_is_one_script(self):

        async def run():
            async with techmanpy.connect_sct(robot_ip=self.simulator.address) as connection:
                script = connection.start_transaction()
                script.move_to_joint_angles_ptp([20] + POSTURE[1:], 1.0, 200)
                script.set_queue_tag(1)
                script.move_to_joint_angles_ptp(POSTURE, 1.0, 200)
                script.set_queue_tag(2)
                script.wait_for_queue_tag(2)
                await script.submit()

        asyncio.run(asyncio.wait_for(run(), 30))
        self.assert_at('Joint_Angle', POSTURE)

    def test_pause_and_resume(self):
        self.reaches('Joint_Angle', [20] + POSTURE[1:], ('move_to_joint_angles_ptp', [20] + POSTURE[1:], 0.5, 200),
                     ('pause_project', ), ('resume_project', ))

    def test_stop(self):
        self.reaches('Joint_Angle', POSTURE, ('move_to_joint_angles_ptp', [90] + POSTURE[1:], 0.01, 200),
                     ('stop_motion', ), ('move_to_joint_angles_ptp', POSTURE, 1.0, 200))


class Status(Case):
    """techmanpy reads the stream as text: it needs the stream in STRING."""

    def test_an_item_is_read(self):
        suite.near(self.item('get_value', 'Joint_Angle'), POSTURE, 0.01)

    def test_items_are_read(self):
        values = self.item('get_values', ['Robot_Link', 'TCP_Name', 'Robot_Error'])
        self.assertEqual(values, {'Robot_Link': 1, 'TCP_Name': 'NOTOOL', 'Robot_Error': False})

    def test_an_item_is_written(self):
        self.item('set_value', 'Ctrl_DO0', 1)
        self.item('set_values', {'Ctrl_DO1': 1, 'Project_Speed': 50})
        self.assertEqual(self.robot.values('Ctrl_DO0', 'Ctrl_DO1', 'Project_Speed'), [1, 1, 50])

    def test_an_unknown_item_is_told(self):
        with self.assertRaisesRegex(techmanpy.TMSVRError, 'TCP_MaXX'):
            self.item('get_value', 'TCP_MaXX')

    def test_the_stream_is_read(self):
        received = []

        async def run():
            async with techmanpy.connect_svr(robot_ip=self.simulator.address) as connection:
                connection.add_broadcast_callback(received.append)
                await connection.keep_alive(quit=lambda: len(received) >= 5)

        asyncio.run(asyncio.wait_for(run(), 30))
        suite.near(received[0]['Joint_Angle'], POSTURE, 0.01)


class Completeness(unittest.TestCase):

    def test_every_call_of_techmanpy_is_made_here(self):
        source = inspect.getsource(sys.modules[__name__])
        connections = (techmanpy.clients.tmsct_client.TMSCT_commands, techmanpy.clients.tmsta_client.TMSTA_connection,
                       techmanpy.clients.tmsvr_client.TMSVR_connection)
        calls = {name for kind in connections for name in vars(kind) if not name.startswith('_')}
        self.assertGreater(len(calls), 25)
        self.assertEqual(sorted(name for name in calls if name not in source), [])


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
