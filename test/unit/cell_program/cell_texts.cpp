#include "cell_texts.h"

#include <fstream>
#include <sstream>

#include "source_tree.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {

const char* const kExample =
    R"(cell: handover                     # demo A1; complete
parameters: {voxel: 20, step_bound: 10, margin: 20}                                         # mm
robots:
  RA: {model: tm5-900, namespace: RA, base: [-720, 122.3, 0, 0, 0, 0], home: HOME, tool: &gripper [{capsule: {from: [0,0,0], to: [0,0,120], radius: 50}}]}
  RB: {model: tm5-900, namespace: RB, base: [720, -122.3, 0, 0, 0, 180], home: HOME, tool: *gripper}
stations:
  RA: &stations {HOME: [0, -30, 120, 0, 90, 0], T1: [0, 45, 60, -15, 90, 0]}                 # joints, degrees
  RB: *stations
programs:
  RA: &program
    - {path: T1,   from: HOME, to: T1,   steps: [{movement_command: PTP, data_format: JPP, target_position: T1, speed: 30, accel_time: 300}]}
    - {path: BACK, from: T1,   to: HOME, steps: [{movement_command: PTP, data_format: JPP, target_position: HOME, speed: 30, accel_time: 300}]}
  RB: *program
)";

const char* const kFull = R"(cell: full
parameters:
  voxel: 10
  step_bound: 5
  margin: 30
  tracking: 0.2
  body_tolerance: 6
  body_cell: 40
  speed_override: 0.5
  zone_size: 600
  zone_overlap: 0.25
  split: never
  max_zones: 100
  max_states: 1000
  lease: 1
  report_period: 0.1
  lookahead: 0.25
  wait_timeout: 30
  aging: 5
robots:
  RA:
    model: tm5-900
    namespace: line/RA
    base: {position: [-720, 122.3, 0], quaternion: [0, 0, 1, 0]}
    home: HOME
    holds: true
    tcp: [0, 0, 120, 0, 0, 0]
    tool:
      - capsule: {from: [0, 0, 0], to: [0, 0, 120], radius: 50}
      - sphere: {radius: 30}
        at: [0, 0, 120, 0, 0, 0]
stations:
  RA: {HOME: [0, -30, 120, 0, 90, 0], T1: [0, 45, 60, -15, 90, 0]}
parts:
  sheet:
    shapes:
      - box: {size: [400, 300, 5]}
    on: flange
    at: [0, 0, 125, 0, 0, 90]
  clip:
    shapes:
      - cylinder: {radius: 10, length: 40}
    on: sheet
obstacles:
  fence:
    - box: {size: [20, 2000, 1500]}
      at: {position: [-1300, 0, 750], rotation: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}
mechanisms:
  PALLET:
    at: [0, -900, 150, 0, 0, 0]
    axis:
      kind: prismatic
      along: [0, 2, 0]
    shapes:
      - box: {size: [400, 400, 150]}
    positions: {OUT: 0, IN: 900}
    home: OUT
    holds: false
    program:
      - path: FEED
        from: OUT
        to: IN
        duration: 4
        uncontrollable: [book]
      - {path: CLEAR, from: IN, to: OUT}
programs:
  RA:
    - path: WORK
      from: HOME
      to: T1
      dwell: 1.5
      steps:
        - block: change_base
          name: world
          base: [1, 2, 3, 0, 0, 90]
        - block: change_tcp
          tcp: [0, 0, 100, 0, 0, 0]
          weight: 1.5
          moment_of_inertia: [1, 2, 3]
          mass_center: [0, 0, 10, 0, 0, 0]
        - block: move_relative
          movement_command: LINE
          data_format: TAR
          target_position: [0, 0, 10, 0, 0, 0]
          speed: 100
          accel_time: 300
          blending_enable: true
          blending_value: 20
        - block: move_circle
          command_id: 3
          data_format: CAP
          arc_point: [400, 0, 300, 180, 0, 0]
          end_point: [400, 100, 300, 180, 0, 0]
          arc_angle: 90
          speed: 100
          accel_time: 300
          disable_precise_positioning: true
        - movement_command: PTP
          data_format: CPP
          target_position: [400, 0, 300, 180, 0, 0]
          robot_pose: [RIGHTY, ABOVE, NOFLIP]
          exit_node: false
          speed: 20
          accel_time: 200
          attach: sheet
          output: {module: EndModule, output: 1, value: true}
          input: {module: ControlBox, input: 2, value: false, timeout: 3}
          dwell: true
        - block: script
          script: |
            PTP("JPP",0,45,60,-15,90,0,30,300,0,true)
          attach: clip
          dwell: 0.5
        - {movement_command: PTP, data_format: JPP, target_position: T1, speed: 30, accel_time: 300, detach: clip}
    - path: AGAIN
      from: T1
      to: T1
      steps_file: pick.yaml
    - path: BACK
      from: T1
      to: HOME
      steps:
        - {movement_command: PTP, data_format: JPP, target_position: HOME, speed: 30, accel_time: 300, detach: sheet}
        - block: script
          script: |
            ChangeBase(0,0,0,0,0,0)
            ChangeTCP(0,0,120,0,0,0)
)";

Result<std::string, std::string> readTestFile(const std::string& name) {
  if (name != "pick.yaml") return refuse(std::string("there is no such file"));
  return std::string(
      "steps:\n"
      "  - {name: to T1, movement_command: PTP, data_format: JPP, target_position: [0, 45, 60, -15, 90, 0], "
      "speed: 30, accel_time: 300}\n");
}

Result<Cell, std::vector<Fault>> parsed(const std::string& text) {
  return parseCell(text, "cell.yaml", readTestFile);
}

Cell cellOf(const std::string& text) {
  auto cell = parsed(text);
  if (cell) return *std::move(cell);
  ADD_FAILURE() << faultsOf(text);
  return {};
}

std::string faultsOf(const std::string& text) {
  const auto cell = parsed(text);
  if (cell) return "none";
  std::string all;
  for (const Fault& fault : cell.error()) all += describe(fault) + '\n';
  return all;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << "there is no " << from;
    return text;
  }
  return text.replace(at, from.size(), to);
}

std::string inFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(test_support::inSourceTree(path)).rdbuf();
  return text.str();
}

}  // namespace cobot_command::cell
