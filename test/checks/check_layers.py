#!/usr/bin/env python3
"""Fails when a room includes what it may not: a room above it, or ROS inside the core. Rooms: doc/architecture.md."""
import re
import sys

from project import project_root

ALLOWED = {
    "common": set(),
    "capabilities": {"common"},
    "tm_script": {"common"},
    "rapid": {"common", "files"},
    "rapid/source": {"common"},
    "rapid/types": {"common"},
    "rapid/checks": {"common", "files"},
    "script": {"common", "tm_script"},
    "protocol": {"common"},
    "automata": {"common"},
    "arm": {"common"},
    "tables": {"common", "arm"},
    "kinematics": {"common", "arm", "tables"},
    "motion": {"common", "arm"},
    "planning": {"common", "script", "arm", "tables", "motion"},
    "path": {"common", "script", "arm", "tables", "motion", "planning"},
    "transport": {"common"},
    "link": {"common", "protocol", "arm"},
    "robot": {"common", "script", "protocol", "arm", "link"},
    "blocks": {"common", "tm_script", "script", "arm", "tables", "motion", "planning", "path", "robot"},
    "files": {"common"},
    "files/steps": {"common", "blocks"},
    "cell": {"common", "script", "automata", "arm", "tables", "motion", "planning", "link", "robot", "blocks", "files", "command"},
    "cell/agent": {"common", "arm", "motion", "link", "robot", "blocks", "command"},
    "cell/bodies": {"common", "arm"},
    "cell/program": {"common", "script", "arm", "blocks", "files"},
    "cell/artifact": {"common", "automata", "arm", "motion", "blocks"},
    "cell/claims": {"common", "arm", "motion"},
    "cell/covering": {"common"},
    "cell/zones": {"common"},
    "cell/splitting": {"common"},
    "cell/sweep": {"common", "script", "arm", "tables", "motion", "planning"},
    "cell/model": {"common", "automata"},
    "cell/monitor": {"common", "arm"},
    "cell/plan": {"common", "script", "arm", "motion", "planning", "blocks"},
    "cell/schedule": {"common", "automata"},
    "cell/supervision": {"common", "automata"},
    "command": {"common", "capabilities", "tm_script", "script", "protocol", "arm", "tables", "motion", "planning", "path", "link", "robot", "blocks"},
    "trial": {"common", "automata", "arm", "link", "blocks", "cell", "command", "simulator"},
    "simulator": {"common", "tm_script", "script", "protocol", "arm", "motion", "planning"},
    "runtime": {"common", "script", "protocol", "arm", "tables", "motion", "planning", "path", "transport", "link", "robot", "blocks", "cell", "command", "simulator"},
    "runtime/cell": {"common", "arm", "cell"},
    "runtime/shared": {"common"},
    "runtime/command": {"common", "arm", "tables", "transport", "link", "blocks", "command"},
    "runtime/simulation": {"common", "arm", "transport", "simulator"},
    "ros": {"common", "capabilities", "script", "arm", "tables", "kinematics", "path", "link", "robot", "blocks", "files", "cell", "command", "simulator", "runtime"},
    "ros/cell": {"common", "link", "cell", "command", "runtime/cell"},
    "ros/cell_watch": {"common", "arm", "cell", "runtime/cell"},
    "ros/pictures": {"common", "arm", "cell"},
    "ros/shared": {"common", "arm", "link", "runtime/shared"},
    "ros/tables": {"common", "arm", "tables", "command"},
    "ros/kinematics": {"common", "capabilities", "arm", "tables", "kinematics"},
    "ros/robot_data": {"common", "capabilities", "arm", "link"},
    "ros/files": {"common", "arm", "path", "blocks", "files"},
    "ros/interruption": {"common", "command"},
    "ros/dynamics": {"common", "capabilities", "arm", "blocks", "command"},
    "ros/exchange": {"common", "blocks", "command"},
    "ros/messages": {"common", "command"},
    "ros/paths": {"common", "arm", "path", "blocks", "command"},
    "ros/command": {"common", "script", "arm", "tables", "path", "link", "robot", "blocks", "command", "runtime/command"},
    "ros/action_parts": {"common", "script", "arm", "blocks"},
    "ros/actions": {"common", "script", "arm", "path", "blocks"},
    "ros/simulation": {"common", "script", "arm", "link", "simulator", "runtime/simulation"},
    "rviz": {"arm", "ros/shared"},
    "rviz/forms": set(),
    "rviz/widgets": set(),
    "rviz/pages": set(),
    "rviz/panel": set(),
}
# The wings of a room, and what each may use of it besides itself, wings and headers; what stands in the room's own folder may use
# them all; "*.h": each header of the room itself. Above is what a wing may use of other rooms, where it is less than what its room may.
WINGS = {
    "automata/formats": {"*.h"},
    "arm/urdf": {"arm_model.h", "collision_shapes.h", "urdf_prefix.h"},
    "blocks/jog": {"jog.h", "list", "shared"},
    "blocks/list": {"*.h", "programs", "shared", "waits", "ways_back"},
    "blocks/chain": {"list", "shared"},
    "blocks/paths": {"chain", "list", "shared"},
    "blocks/programs": {"list", "run_program.h", "set_output.h", "shared", "waits"},
    "blocks/runs": {"list", "shared"},
    "blocks/shared": set(),
    "blocks/trajectory": {"follow_joint_trajectory.h", "list", "shared"},
    "blocks/waits": {"list", "shared"},
    "blocks/ways_back": {"list", "shared"},
    "cell/agent": {"artifact", "bodies", "model", "supervision", "sweep"},
    "cell/artifact": {"bodies", "claims", "model", "plan", "program", "schedule", "splitting", "sweep", "zones"},
    "cell/bodies": set(),
    "cell/checks": {"bodies", "program"},
    "cell/claims": {"bodies", "plan", "program", "sweep"},
    "cell/covering": {"bodies"},
    "cell/program": {"bodies"},
    "cell/model": set(),
    "cell/monitor": {"bodies"},
    "cell/plan": {"program"},
    "cell/schedule": set(),
    "cell/reading": {"bodies", "checks", "program"},
    "cell/splitting": {"claims", "model", "plan", "program", "sweep", "zones"},
    "cell/supervision": {"model"},
    "cell/sweep": {"bodies"},
    "cell/zones": {"bodies", "claims", "model", "plan", "sweep"},
    "command/arbiter": {"actions.h", "board", "connecting", "core_ports.h", "dynamics", "exchange", "finish.h", "forecast", "interruption.h", "path_requests.h", "paths", "planning_job.h", "queue", "runs",
                        "sending", "speed_override.h", "stops", "sync", "waiting_goals.h"},
    "command/board": {"actions.h"},
    "command/connecting": {"board", "links"},
    "command/dynamics": {"actions.h", "dynamics.h", "forecast", "paths", "runs", "speed_override.h"},
    "command/exchange": {"board", "connecting", "exchange_answer.h", "links", "messages", "sync", "waiting_goals.h"},
    "command/forecast": {"actions.h", "planning_job.h", "speed_override.h"},
    "command/links": {"actions.h"},
    "command/messages": {"actions.h", "message.h", "waiting_goals.h"},
    "command/paths": {"actions.h", "forecast", "path_requests.h", "planning_job.h", "runs", "speed_override.h"},
    "command/queue": {"actions.h", "board", "exchange", "forecast", "waiting_goals.h"},
    "command/runs": {"forecast", "gate.h", "stops"},
    "command/sending": {"actions.h", "board", "forecast", "interruption.h", "planning_job.h", "queue", "runs"},
    "command/stops": {"board"},
    "command/sync": {"actions.h", "dynamics", "exchange_rules.h", "messages", "table_write.h", "tables"},
    "command/tables": {"actions.h", "table_write.h"},
    "files/steps": {"*.h"},
    "motion/curves": {"command.h", "refusal.h"},
    "motion/kinds": {"blend.h", "command.h", "curves", "paths", "planner.h", "profiles", "pvt.h", "velocity.h"},
    "motion/paths": {"command.h", "curves", "joint_range.h", "planner.h", "profiles", "refusal.h"},
    "motion/profiles": {"command.h", "trajectory.h"},
    "path/points": {"motion_refusal.h", "path_plan.h", "path_point.h", "path_refusal.h", "path_scene.h"},
    "path/pvt": {"motion_refusal.h", "path_pieces.h", "path_plan.h", "path_refusal.h", "path_scene.h", "pvt_block.h"},
    "rapid/source": {"lexer", "parser", "printer"},
    "rapid/lexer": {"reporting.h", "source"},
    "rapid/parser": {"lexer", "reporting.h", "source"},
    "rapid/printer": {"source"},
    "rapid/types": {"source"},
    "rapid/checks": {"expressions", "linking", "reporting.h", "routines", "source", "types"},
    "rapid/expressions": {"checks", "draft.h", "names.h", "source", "type_reference.h", "types"},
    "rapid/linking": {"checks", "data_declaration.h", "draft.h", "expressions", "names.h", "source", "type_reference.h", "types"},
    "rapid/routines": {"checks", "data_declaration.h", "draft.h", "expressions", "names.h", "source", "type_reference.h", "types"},
    "tm_script/execution": {"checker.h", "environment.h", "functions.h", "interpreter.h", "script.h", "values", "variables.h"},
    "tm_script/grammar": {"open_end.h", "parser.h", "script.h", "values"},
    "tm_script/library": {"functions.h", "values"},
    "tm_script/values": {"script.h", "value.h"},
    "runtime/cell": set(),
    "runtime/shared": set(),
    "runtime/cell": {"shared"},
    "runtime/command": {"shared"},
    "runtime/simulation": {"shared"},
    "ros/shared": set(),
    "ros/tables": {"shared"},
    "ros/files": {"shared"},
    "ros/kinematics": {"shared"},
    "ros/robot_data": {"shared"},
    "ros/messages": {"shared"},
    "ros/paths": {"shared"},
    "ros/dynamics": {"shared"},
    "ros/exchange": {"action_parts", "shared"},
    "ros/interruption": {"shared"},
    "ros/cell": {"shared"},
    "ros/cell_watch": {"cell_watch/pictures", "shared"},
    "ros/pictures": {"cell_watch/pictures", "shared"},
    "ros/command": {"cell", "dynamics", "exchange", "files", "interruption", "kinematics", "messages", "paths", "robot_data", "shared", "tables"},
    "ros/action_parts": {"command", "shared"},
    "ros/actions": {"action_parts", "command", "shared"},
    "ros/simulation": {"shared"},
    "rviz/forms": set(),
    "rviz/goals": {"forms"},
    "rviz/clients": {"forms", "goals"},
    "rviz/widgets": {"clients", "forms"},
    "rviz/displays": {"own_topics.h"},
    "rviz/preview": {"clients", "goals", "own_topics.h"},
    "rviz/pages": {"clients", "forms", "goals", "preview", "widgets"},
    "rviz/panel": {"clients", "pages", "preview", "widgets"},
    "simulator/wire": {"simulated_controller.h", "fault_switches.h"},
    "simulator/drive": set(),
    "simulator/queue": {"drive", "fault_switches.h"},
    "simulator/robot": {"wire", "settings.h", "robot_state.h"},
    "simulator/script_port": {"wire", "queue", "robot", "settings.h", "robot_state.h"},
    "simulator/status_port": {"wire", "robot", "settings.h", "robot_state.h", "operator_action.h"},
}
# The rooms that may include ROS.
OF_ROS = {"ros", "rviz"}
# Folders of headers that the core may include. What is not here is refused: nobody can list all packages of ROS.
LIBRARIES = {"Eigen", "arpa", "boost", "console_bridge", "fmt", "gmock", "gtest", "kdl", "netinet", "nlohmann", "openssl", "rapidcheck", "sys",
             "tl", "urdf_model", "urdf_parser", "yaml-cpp"}
FOLDER = re.compile(r'\s*#\s*include\s*[<"](?!cobot_command/)([^/>"]+)/')
MESSAGE = re.compile(r'\s*#\s*include\s*[<"]cobot_command/[A-Z]')
OWN = re.compile(r'\s*#\s*include\s*[<"]cobot_command/(([a-z_]+)/(?:[a-z_]+(?=/))?)')
INSIDE = re.compile(r'\s*#\s*include\s*"(?:cobot_command/([a-z_]+)/)?((?:[a-z_]+/)*)([a-z_0-9]+\.h)"')


def faults(root):
    for room in [room for room in ALLOWED if "/" not in room]:
        for folder in (root / "include/cobot_command" / room, root / "src" / room, root / "test/unit" / room):
            for file in sorted(folder.rglob("*")):
                if file.suffix in (".h", ".cpp"):
                    yield from faults_in(file, room)


def faults_in(file, room):
    place = f"{room}/{file.parent.name}" if f"{room}/{file.parent.name}" in ALLOWED else room
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        if room not in OF_ROS:
            yield from faults_of_core(file, number, room, line)
        yield from faults_of_wing(file, number, room, line)
        own = OWN.match(line)
        if own and not {own.group(1).rstrip("/"), own.group(2)} & (ALLOWED[place] | {room}):
            yield f"{file}:{number}: {place}/ may not use {own.group(1).rstrip('/')}/ (allowed: {', '.join(sorted(ALLOWED[place]))})"


def faults_of_core(file, number, room, line):
    folder = FOLDER.match(line)
    if MESSAGE.match(line) or (folder and folder.group(1) not in LIBRARIES | wings_of(room)):
        yield (f"{file}:{number}: {room}/ is core and must not include ROS, only the libraries "
               f"{', '.join(sorted(LIBRARIES))}: {line}")


def wings_of(room):
    return {wing.split("/")[1] for wing in WINGS if wing.split("/")[0] == room}


def faults_of_wing(file, number, room, line):
    wing, included = file.parent.name, INSIDE.match(line)
    in_a_wing = f"{room}/{wing}" in WINGS and "test" not in file.parts
    if not in_a_wing or not included or included.group(1) not in (None, room):
        return
    used = included.group(2).rstrip("/") or ("" if included.group(1) or not (file.parent / included.group(3)).exists() else wing)
    if not used and "*.h" in WINGS[f"{room}/{wing}"]:
        return
    if not {used or included.group(3)} & (WINGS[f"{room}/{wing}"] | {wing}):
        yield f"{file}:{number}: the wing {room}/{wing} may not use {room}/{used or 'its own folder'}: {line}"


def main():
    found = list(faults(project_root(sys.argv[1])))
    print("\n".join(found) or "every room uses only the rooms below it, and the core is free of ROS")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
