"""Random goals of all actions: good ones, those at the ends of their ranges, and wrong ones. A seed makes the same goals
again."""
import collections
import random

from cobot_command.msg import (ChangeLoadGoal, ConnectGoal, ExitListenNodeGoal, MoveAbsoluteGoal, MoveRelativeGoal,
                               OutputAction, PickAndPlaceGoal, ProgramControlGoal, RobotPose, SetOutputGoal, StopGoal,
                               WaitForInputGoal, WaitTimeGoal)
from cobot_goals import (HOME, base, circle, cycle, line_to, path, path_line, path_to_joints, ptp_to, relative, script, sequence, step, tcp, to_joints,
                         turn, with_changes)
from tf_frames import pose_in
import wrong_goals

Drawn = collections.namedtuple("Drawn", "goal errors endless follow_up")
Drawn.__doc__ = """errors: None: a good goal, as far as a goal alone can tell. Else it must fail: for one of these, or for
the state of the layer or the robot; empty: for whatever the controller says. endless: it is for a cancel to end it.
follow_up: a goal that its sender owes the others, as the resume behind a pause."""

# How often a goal is of this action.
WEIGHTS = {"move_absolute": 26, "move_relative": 14, "move_circle": 8, "change_base": 7, "change_tcp": 6,
           "change_load": 3, "set_output": 5, "wait_for_input": 4, "wait_time": 3,
           "run_script": 12, "pick_and_place": 8, "load_path": 8, "check_sequence": 5, "program_control": 6, "exit_listen_node": 3,
           "stop": 3, "connect": 2}
WRONG = 0.2  # of the goals
WAITED_FOR = (1, 2)  # cycles that end by themselves before anybody's patience does
DOWNWARDS = (180, 0)


class RandomGoals:
    def __init__(self, seed):
        self._random = random.Random(seed)

    def draw(self):
        r = self._random
        block = r.choices(list(WEIGHTS), WEIGHTS.values())[0]
        if r.random() < WRONG and block != "stop":
            goal, errors = wrong_goals.draw(r, block, self._good(block))
            return Drawn(goal, frozenset(errors), False, None)
        goal = self._good(block)
        endless = block == "connect" or getattr(goal, "cycles", 1) not in WAITED_FOR
        paused = block == "program_control" and goal.command == ProgramControlGoal.PAUSE
        return Drawn(goal, None, endless, ProgramControlGoal(command=ProgramControlGoal.RESUME) if paused else None)

    def _good(self, block):
        return getattr(self, block)()

    # --- What motions have in common.
    def _common(self, radius=False):
        r = self._random
        changes = {"buffer_mode": r.choices((0, 1, 2), (30, 60, 10))[0], "accel_time": r.choice((150, 200, 400)),
                   "command_id": r.choices((0, r.randint(2, 9)), (3, 1))[0],
                   "disable_precise_positioning": r.random() < 0.5}
        kind = r.random()
        if kind < 0.12:
            changes.update(blending_enable=True, blending_value=r.choice((0, 1, 50, 100, 2000 if radius else 100)))
        elif kind < 0.2:
            changes["check_only"] = True
        elif kind < 0.23:
            changes["exit_node"] = True
        if r.random() < 0.03:
            changes["accel_time"] = 9999
        return changes

    def _percent(self):
        return {"speed": self._random.choice((5, 30, 60, 80, 100))}

    def _millimetres(self):
        return {"speed": self._random.choice((100, 250, 400, 1000, 4500))}

    def _joints(self):
        r = self._random
        return (r.uniform(-120, 120), r.uniform(-40, 30), r.uniform(60, 110), r.uniform(-30, 30), r.uniform(60, 100),
                r.uniform(-90, 90))

    def _pose(self):
        r = self._random
        return (r.uniform(350, 500), r.uniform(-200, 200), r.uniform(250, 450), *DOWNWARDS, r.uniform(0, 90))

    # --- One for each action.
    def move_absolute(self):
        r, kind = self._random, self._random.random()
        if kind < 0.5:
            return to_joints(*r.choice((HOME, self._joints())), **{**self._common(), **self._percent()})
        if kind < 0.7:
            bits = RobotPose(r.randint(0, 1), r.randint(2, 3), r.randint(4, 5))
            return ptp_to(*self._pose(), robot_pose_enable=r.random() < 0.4, robot_pose=bits,
                          **{**self._common(), **self._percent()})
        if kind < 0.8:
            frame = r.choice(("base", "base", "active_base"))
            where = pose_in(frame, (r.uniform(0.35, 0.5), r.uniform(-0.2, 0.2), r.uniform(0.25, 0.45)), (1, 0, 0, 0))
            return ptp_to(target_pose=where, **{**self._common(), **self._percent()})
        form = r.choice((MoveAbsoluteGoal.CPP, MoveAbsoluteGoal.CPR, MoveAbsoluteGoal.CAP, MoveAbsoluteGoal.CAR))
        speed = self._percent() if form in (MoveAbsoluteGoal.CPP, MoveAbsoluteGoal.CPR) else self._millimetres()
        radius = form in (MoveAbsoluteGoal.CPR, MoveAbsoluteGoal.CAR)
        return line_to(*self._pose(), data_format=form, **{**self._common(radius), **speed})

    def move_relative(self):
        r = self._random
        if r.random() < 0.5:
            return turn(*(r.uniform(-20, 20) for _ in range(6)), **{**self._common(), **self._percent()})
        form = r.choice((MoveRelativeGoal.CPP, MoveRelativeGoal.CAP, MoveRelativeGoal.CAR, MoveRelativeGoal.TPP,
                         MoveRelativeGoal.TPR, MoveRelativeGoal.TAP))
        percent = form in (MoveRelativeGoal.CPP, MoveRelativeGoal.TPP, MoveRelativeGoal.TPR)
        radius = form in (MoveRelativeGoal.CAR, MoveRelativeGoal.TPR)
        offset = [r.uniform(-60, 60) for _ in range(3)] + [r.uniform(-10, 10) for _ in range(3)]
        return relative(*offset, data_format=form,
                        **{**self._common(radius), **(self._percent() if percent else self._millimetres())})

    def move_circle(self):
        r = self._random
        changes = {**self._common(), **self._millimetres()}
        changes["arc_angle"] = r.choice((0, 0, 0, 1, 30, 90, 360))
        return circle(self._pose(), self._pose(), **changes)

    def change_base(self):
        r, kind = self._random, self._random.random()
        if kind < 0.6:
            return base(base_name="RobotBase", **self._change())
        if kind < 0.7:
            return base(base_pose=pose_in("base", (0.02, 0.01, 0), (0, 0, 0, 1)), **self._change())
        return base(r.uniform(-40, 40), r.uniform(-40, 40), r.uniform(0, 40), 0, 0, r.uniform(-20, 20),
                    **self._change())

    def change_tcp(self):
        r = self._random
        if r.random() < 0.6:
            return tcp(tcp_name="NOTOOL", **self._change())
        return tcp(0, 0, r.uniform(0, 60), 0, 0, r.uniform(-90, 90), weight=r.choice((0, 1.5, 14)), **self._change())

    def change_load(self):
        return ChangeLoadGoal(weight=self._random.choice((0, 0.5, 1, 14)), buffer_mode=self._common()["buffer_mode"])

    def set_output(self):
        r = self._random
        mode = {"buffer_mode": self._common()["buffer_mode"], "at_once": r.random() < 0.4}
        if r.random() < 0.2:
            return SetOutputGoal(kind=SetOutputGoal.ANALOG, module="ControlBox", value=r.uniform(-10, 10), **mode)
        module, number = r.choice((("EndModule", 0), ("EndModule", 3), ("ControlBox", 0), ("ControlBox", 15)))
        return SetOutputGoal(module=module, output=number, value=r.choice((0, 1)), **mode)

    def wait_for_input(self):
        """All inputs are off."""
        r = self._random
        return WaitForInputGoal(module=r.choice(("EndModule", "ControlBox")), input=r.randint(0, 2), value=r.random() < 0.2,
                                timeout=r.choice((0.05, 0.5)), buffer_mode=self._common()["buffer_mode"])

    def wait_time(self):
        r = self._random
        return WaitTimeGoal(time=r.choice((0, 0.05, 0.5)), buffer_mode=self._common()["buffer_mode"])

    def _change(self):
        common = self._common()
        return {name: common[name] for name in ("buffer_mode", "command_id", "exit_node") if name in common}

    def run_script(self):
        r, kind = self._random, self._random.random()
        mode = {"buffer_mode": self._common()["buffer_mode"]}
        if kind < 0.5:
            joints = ",".join(f"{angle:.4f}" for angle in self._joints())
            lines = (f'PTP("JPP",{joints},{r.choice((30, 60, 100))},200,0,false)',)
            return script(*lines, await_motion=r.random() < 0.8, reply_timeout=r.choice((0, 0, 0.5, 3600)), **mode)
        if kind < 0.55:
            return script("ScriptExit()", **mode)
        lines = r.choice((("ChangeLoad(1)",), ("int i = 1", "i = i + 1", "ChangeLoad(i)"), ("x = ",), ("Dance()",),
                          ('string s = "a,b*c$d"', "ChangeLoad(0.5)"), ("// " + "x" * 4093,)))
        return script(*lines, **mode)

    def pick_and_place(self):
        r = self._random
        changes = {"cycles": r.choices((*WAITED_FOR, 0, 1000000), (70, 20, 5, 5))[0],
                   "buffer_mode": self._common()["buffer_mode"], "check_only": r.random() < 0.1}
        if r.random() < 0.1:
            return PickAndPlaceGoal(steps_file="package://cobot_command/config/pick_and_place.yaml", **changes)
        count = r.choice((1, 2, 3) if changes["cycles"] == 1 else (2, 3, 6))
        return cycle(*(self._step() for _ in range(count)), **changes)

    def _step(self):
        r = self._random
        output = OutputAction(*r.choice((("EndModule", 0), ("EndModule", 3), ("ControlBox", 15))), r.random() < 0.5)
        return step(to_joints(*self._joints(), **self._percent()), output if r.random() < 0.3 else None,
                    r.choice((0, 0, 0, 0.05)))

    def load_path(self):
        """Lines may not be possible from where the arm is then."""
        r = self._random
        points = [path_to_joints(*r.choice((HOME, self._joints())), **self._end_of_point(percent=True))
                  for _ in range(r.choice((1, 1, 2, 4)))]
        if r.random() < 0.3:
            points += [path_line(*self._pose(), **self._end_of_point(percent=False)) for _ in range(r.choice((1, 2)))]
        start = r.choice((0, 0, len(points) - 1))
        return path(*points, start_index=start, number_of_moves=len(points) - start, execution=r.choice((0, 0, 2)),
                    buffer_mode=self._common()["buffer_mode"], check_only=r.random() < 0.1, max_deviation=r.choice((0, 100)))

    def _end_of_point(self, percent):
        r = self._random
        ramps = {"profile_type": r.randint(0, 3), "acceleration_jerk": r.choice((0, 50, 100)), "move_id": r.randint(0, 99)}
        if r.random() < 0.5:
            return ramps
        return {**ramps, "termination_type": 6, "command_tolerance": r.choice((0, 10, 100 if percent else 1e4))}

    def check_sequence(self):
        r = self._random
        goals = [r.choice((self.move_absolute, self.move_relative, self.change_base, self.change_tcp))()
                 for _ in range(r.choice((1, 2, 3, 8)))]
        return sequence(*goals, start_joints=list(r.choice((HOME, self._joints(), ()))))

    def program_control(self):
        r = self._random
        return ProgramControlGoal(command=r.choice((ProgramControlGoal.PAUSE, ProgramControlGoal.RESUME)),
                                  command_id=r.choice((0, 0, 2, 9)))

    def exit_listen_node(self):
        return ExitListenNodeGoal(buffer_mode=self._common()["buffer_mode"])

    @staticmethod
    def stop():
        return StopGoal()

    def connect(self):
        """To a port where nobody listens: it ends by itself as soon as somebody has cancelled it."""
        return with_changes(ConnectGoal(host="127.0.0.1", port=1, status_port=1),
                            {"timeout": self._random.choice((10, 300))})
