// What a cell file is refused for (M4), with file, line and field.
#include <string>

#include "cell_texts.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string faultsWith(const std::string& from, const std::string& to) {
  return faultsOf(with(kExample, from, to));
}
/// Of kFull, which has what the example has not.
std::string fullWith(const std::string& from, const std::string& to) {
  return faultsOf(with(kFull, from, to));
}

struct Case {
  const char* from;
  const char* to;
  const char* told;
};
void expectRefused(const std::vector<Case>& cases, const char* text) {
  for (const Case& row : cases) {
    EXPECT_THAT(faultsOf(with(text, row.from, row.to)), HasSubstr(row.told)) << row.to;
  }
}

TEST(CellFaults, haveFileLineColumnFieldAndWhatToDo) {
  const auto cell = parsed(with(kExample, "speed: 30", "speed: fast"));
  ASSERT_FALSE(cell);
  ASSERT_EQ(cell.error().size(), 1U) << "told once, though both robots have the step";
  const Fault& fault = cell.error().front();
  EXPECT_EQ(fault.file, "cell.yaml");
  EXPECT_EQ(fault.line, 11);
  EXPECT_EQ(fault.column, 120);
  EXPECT_EQ(fault.field, "programs.RA[0].steps[0].speed");
  EXPECT_EQ(fault.found, "is \"fast\"");
  EXPECT_EQ(fault.allowed, "a whole number");
  EXPECT_FALSE(fault.advice.empty());
  EXPECT_EQ(describe(fault),
            "cell.yaml:11:120: programs.RA[0].steps[0].speed is \"fast\"; allowed: a whole number; "
            "write what is allowed");
}

TEST(CellFaults, tellOfKeysAndNamesThatAreMissing) {
  expectRefused({{"cell: handover", "", "cell is missing; add it"},
                 {"model: tm5-900, namespace: RA", "namespace: RA", "robots.RA.model is missing"},
                 {"base: [-720, 122.3, 0, 0, 0, 0], ", "", "robots.RA.base is missing"},
                 {"home: HOME, ", "", "robots.RA.home is missing"},
                 {"  RB: *stations\n", "", "cell.yaml:7:3: stations.RB is missing"},
                 {"  RB: *program\n", "", "programs.RB is missing"},
                 {"path: T1,   ", "", "programs.RA[0].path is missing"},
                 {"from: HOME, ", "", "programs.RA[0].from is missing"},
                 {"speed: 30, ", "", "programs.RA[0].steps[0].speed is missing"},
                 {"{path: BACK, from: T1,   to: HOME, steps: [{movement_command: PTP, data_format: JPP, "
                  "target_position: HOME, speed: 30, accel_time: 300}]}",
                  "{path: BACK, from: T1, to: HOME}", "programs.RA[1].steps is missing"}},
                kExample);
}

TEST(CellFaults, tellOfNamesThatAreUnknownWithTheNearest) {
  expectRefused(
      {{"model: tm5-900", "model: tm5_900", "robots.RA.model is \"tm5_900\", which is not a model"},
       {"model: tm5-900", "model: tm5_900", "write tm5-900"},
       {"home: HOME", "home: HOMME",
        "robots.RA.home is \"HOMME\", which is not a station of the robot; allowed: HOME, T1; write HOME"},
       {"to: T1,", "to: T2,",
        "programs.RA[0].to is \"T2\", which is not a station of the robot; allowed: HOME, T1"},
       {"target_position: T1", "target_position: T2", "steps[0].target_position is \"T2\""},
       {"  RB: *stations", "  RBB: *stations",
        "stations.RBB is \"RBB\", which is not a robot; allowed: RA, RB; write RB"},
       {"  RB: *program", "  RC: *program", "programs.RC is \"RC\", which is not a robot"},
       {"movement_command: PTP", "movement_command: PTB", "allowed: LINE, PTP; write PTP"}},
      kExample);
}

TEST(CellFaults, tellOfNamesThatCanBeNone) {
  for (const char* name : {"R-A", "1", "\"\"", "\xC3\x84", "~", "R A", "[R]"}) {
    EXPECT_THAT(faultsWith("\n  RA: {", fmt::format("\n  {}: {{", name)), HasSubstr("ASCII letters")) << name;
  }
  EXPECT_THAT(faultsWith("cell: handover", "cell: " + std::string(65, 'x')), HasSubstr("cell is \"xxx"));
  EXPECT_THAT(faultsWith("namespace: RA", "namespace: RA//b"), HasSubstr("robots.RA.namespace is \"RA//b\""));
  EXPECT_THAT(faultsWith("namespace: RB", "namespace: RA"),
              HasSubstr("robots.RB.namespace is RA, the same as that of RA in line 4"));
}

TEST(CellFaults, tellOfValuesOfAnotherType) {
  expectRefused(
      {{"robots:\n", "robots: 5\nrobot:\n", "is no key of the file"},
       {"[0, -30, 120, 0, 90, 0]", "[0, -30, 120, 0, 90]",
        "stations.RA.HOME is a list of 5; allowed: a list of 6"},
       {"[0, -30, 120, 0, 90, 0]", "[0, -30, x, 0, 90, 0]", "stations.RA.HOME[2] is \"x\""},
       {"[0, -30, 120, 0, 90, 0]", "[0, -30, .nan, 0, 90, 0]", "stations.RA.HOME[2] is \".nan\""},
       {"[0, -30, 120, 0, 90, 0]", "[0, -30, 1e999, 0, 90, 0]", "stations.RA.HOME[2]"},
       {"[0, -30, 120, 0, 90, 0]", "[0, -30, 300, 0, 90, 0]",
        "stations.RA.HOME[2] is 300 deg for J3 of a tm5-900"},
       {"base: [-720, 122.3, 0, 0, 0, 0]", "base: origin", "robots.RA.base is \"origin\""},
       {"steps: [{", "steps: {", "not YAML"},
       {"target_position: T1, speed: 30", "target_position: {T1: 1}, speed: 30",
        "steps[0].target_position is a map"},
       {"tool: *gripper", "tool: 5", "robots.RB.tool is \"5\"; allowed: a list of at most 200 shapes"}},
      kExample);
}

TEST(CellFaults, tellWhatTheBlockOfAStepRefuses) {
  expectRefused(
      {{"speed: 30", "speed: 101", "steps[0] is refused by move_absolute: speed is 101 %"},
       {"speed: 30", "speed: -1", "there is no default for it"},
       {"accel_time: 300", "accel_time: 100", "accel_time is 100"},
       {"movement_command: PTP", "movement_command: LINE", "is refused by move_absolute: data_format is 0"},
       {"accel_time: 300", "accel_time: 300, command_id: 1", "is refused by move_absolute: command_id is 1"}},
      kExample);
  expectRefused({{"weight: 1.5", "weight: 15", "steps[1] is refused by change_tcp: weight is 15"},
                 {"output: 1,", "output: 4,", "steps[4].output is refused by set_output"},
                 {"input: 2,", "input: 16,", "steps[4].input is refused by wait_for_input"},
                 {"arc_angle: 90", "arc_angle: 361", "is refused by move_circle"},
                 {"dwell: 0.5", "dwell: 3601", "steps[5].dwell is 3601 s; allowed: 0 to 3600 s"}},
                kFull);
}

TEST(CellFaults, adviseAFormatThatTheMovementTakes) {
  const auto fault_of = [](const std::string& movement, const std::string& format) {
    return faultsWith("movement_command: PTP, data_format: JPP",
                      "movement_command: " + movement + ", data_format: " + format);
  };
  const std::string of_tool = fault_of("LINE", "TPP");
  EXPECT_THAT(of_tool, HasSubstr("data_format is TPP, which is relative to the tool"));
  EXPECT_THAT(of_tool, HasSubstr("add block: move_relative"));
  EXPECT_THAT(of_tool, Not(HasSubstr("write JPP")));
  const std::string of_line = fault_of("LINE", "JPR");
  EXPECT_THAT(of_line, HasSubstr("allowed: CPP, CPR, CAP, CAR; write CPR")) << "no JPP, which no line takes";
  EXPECT_THAT(fault_of("PTP", "JPX"), HasSubstr("allowed: JPP, CPP; write JPP"));
}

TEST(CellFaults, tellOfAPathThatDoesNotEndAtItsStation) {
  EXPECT_THAT(faultsWith("target_position: HOME", "target_position: [0, -30, 120, 0, 90, 0.0001]"),
              HasSubstr("programs.RA[1].steps[0].target_position is 0.0001 deg of J6 away from station HOME, "
                        "where the path "
                        "ends"));
  EXPECT_EQ(faultsWith("target_position: HOME", "target_position: [0, -30, 120, 0, 90, 0.00005]"), "none")
      << "below 1e-6 rad";
  EXPECT_THAT(faultsWith("target_position: HOME", "target_position: T1"),
              HasSubstr("write target_position: HOME"));
  EXPECT_THAT(faultsWith("steps: [{movement_command: PTP, data_format: JPP, target_position: T1, speed: 30, "
                         "accel_time: 300}]",
                         "steps: [{block: change_base, base: [0, 0, 0, 0, 0, 0]}]"),
              HasSubstr("programs.RA[0].steps do not move the robot to T1"));
  EXPECT_THAT(faultsWith("steps: [{movement_command: PTP, data_format: JPP, target_position: T1, speed: 30, "
                         "accel_time: 300}]",
                         "steps: []"),
              HasSubstr("programs.RA[0].steps has no entries"));
}

TEST(CellFaults, tellOfAProgramThatDoesNotComeHome) {
  const std::string back = std::string(kExample).substr(std::string(kExample).find("    - {path: BACK"));
  const std::string line = back.substr(0, back.find('\n') + 1);
  EXPECT_THAT(faultsWith(line, ""),
              HasSubstr("cell.yaml:11:7: programs.RA[0] has T1, from where no paths lead home, to HOME"));
  EXPECT_THAT(faultsWith("home: HOME, tool: &", "home: T1, tool: &"), "none") << "T1 is as good a home";
  EXPECT_THAT(
      faultsWith("T1: [0, 45, 60, -15, 90, 0]}", "T1: [0, 45, 60, -15, 90, 0], U: [0, 0, 0, 0, 0, 0]}"),
      "none")
      << "a station that no path needs";
  std::string lost =
      with(kExample, "T1: [0, 45, 60, -15, 90, 0]}", "T1: [0, 45, 60, -15, 90, 0], U: [0, 0, 0, 0, 0, 0]}");
  EXPECT_THAT(faultsOf(with(lost, "home: HOME", "home: U")),
              HasSubstr("programs.RA has no path from home, U"));
  EXPECT_THAT(faultsOf(with(lost, "path: BACK, from: T1,", "path: BACK, from: U,")),
              AllOf(HasSubstr("has T1, from where no paths lead home, to HOME"),
                    HasSubstr("has U, to where no paths lead from home, HOME")));
  EXPECT_THAT(faultsWith("path: BACK", "path: T1"),
              HasSubstr("programs.RA[1].path is T1, the same as the path of line 11"));
  EXPECT_THAT(faultsWith("RB: *program", "RB: []"), HasSubstr("programs.RB has no paths"));
}

TEST(CellFaults, tellOfWhatIsDoneWhereTheRobotDoesNotStand) {
  for (const char* part :
       {"attach: sheet", "output: {module: EndModule, output: 1, value: true}",
        "input: {module: EndModule, input: 1, value: true}", "dwell: 1", "detach: sheet"}) {
    const std::string key = std::string(part).substr(0, std::string(part).find(':'));
    EXPECT_THAT(
        fullWith("blending_value: 20", std::string("blending_value: 20\n          ") + part),
        HasSubstr("programs.RA[0].steps[2]." + key + " is at a step that blends into the next motion"));
  }
  EXPECT_THAT(fullWith(",30,300,0,true)", ",30,300,50,true)"),
              HasSubstr("steps[5].attach is at a step that blends"));
  EXPECT_THAT(faultsWith("speed: 30", "blending_enable: true, blending_value: 50, speed: 30"),
              HasSubstr("programs.RA[0].steps[0].blending_enable blends at the end of a path"));
}

TEST(CellFaults, tellOfStepsThatLeaveTheListenNode) {
  EXPECT_THAT(faultsWith("speed: 30", "exit_node: true, speed: 30"),
              HasSubstr("steps[0].exit_node leaves the Listen node"));
  EXPECT_THAT(fullWith(",30,300,0,true)\n", ",30,300,0,true)\n            ScriptExit()\n"),
              HasSubstr("steps[5].script leaves the Listen node"));
}

TEST(CellFaults, tellOfFramesByName) {
  EXPECT_THAT(fullWith("base: [1, 2, 3, 0, 0, 90]", "base: VISION"),
              HasSubstr("steps[0].base is \"VISION\", the name of a base of the project"));
  EXPECT_THAT(fullWith("tcp: [0, 0, 100, 0, 0, 0]", "tcp: NOTOOL"), HasSubstr("steps[1].tcp is \"NOTOOL\""));
  EXPECT_THAT(fullWith("tcp: [0, 0, 120, 0, 0, 0]", "tcp: NOTOOL"), HasSubstr("robots.RA.tcp is \"NOTOOL\""));
  EXPECT_THAT(fullWith("base: [1, 2, 3, 0, 0, 90]", "base_name: VISION"),
              HasSubstr("steps[0].base_name names a frame"));
  EXPECT_THAT(fullWith("tcp: [0, 0, 100, 0, 0, 0]", "tcp_name: NOTOOL"),
              HasSubstr("steps[1].tcp_name names a frame"));
  EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", "ChangeBase(\"RobotBase\")"),
              HasSubstr("which names a base of the project"));
  EXPECT_THAT(fullWith("ChangeTCP(0,0,120,0,0,0)", "ChangeTCP(\"NOTOOL\")"),
              HasSubstr("which names a TCP of the project"));
}

TEST(CellFaults, tellOfScriptsThatCannotBePlanned) {
  for (const char* line :
       {"ContinueVJog()", "ContinueVLine(500, 500)", "SetContinueVJog(1,0,0,0,0,0)", "StopContinueVmode()"}) {
    EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", line), HasSubstr("steps[1].script ")) << line;
  }
  EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", "ContinueVJog()"),
              HasSubstr("sets velocities, which cannot be planned"));
  EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", "Pause()"),
              HasSubstr("pauses or clears motions that were permitted"));
  EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", "ChangeLoad(Robot[0].TCPForce3D)"),
              HasSubstr("script cannot be interpreted before it runs"));
  EXPECT_THAT(fullWith("ChangeBase(0,0,0,0,0,0)", "QueueTag(1)"), HasSubstr("is refused by run_script"));
}

TEST(CellFaults, tellOfNamesForPeopleThatNobodyCanRead) {
  EXPECT_THAT(fullWith("name: world", "name: \"a\\nb\""),
              HasSubstr("steps[0].name is \"a\\nb\"; allowed: at most 256 bytes"));
  EXPECT_THAT(fullWith("name: world", "name: " + std::string(257, 'a')), HasSubstr("steps[0].name is "));
}

TEST(CellFaults, tellOfDwellsThatNobodyNeedsToo) {
  EXPECT_THAT(fullWith("dwell: 1.5", "dwell: -1"),
              HasSubstr("programs.RA[0].dwell is \"-1\"; allowed: 0 to 3600 s"));
  EXPECT_THAT(fullWith("dwell: true", "dwell: maybe"),
              HasSubstr("steps[4].dwell is \"maybe\"; allowed: true, false, or"));
}

TEST(CellFaults, ofAFileThatIsNamedAreOfThatFile) {
  EXPECT_THAT(
      fullWith("steps_file: pick.yaml", "steps_file: pik.yaml"),
      HasSubstr("programs.RA[1].steps_file is \"pik.yaml\", which cannot be read: there is no such file"));
  const auto broken = [](const std::string& from, const std::string& to) {
    const auto cell =
        parseCell(kFull, "cell.yaml", [&](const std::string& name) -> Result<std::string, std::string> {
          return with(*readTestFile(name), from, to);
        });
    return cell ? "none" : describe(cell.error().front());
  };
  EXPECT_THAT(broken("speed: 30", "sped: 30"),
              HasSubstr("pick.yaml:2:102: programs.RA[1].steps_file.sped is no key of a step"));
  EXPECT_THAT(broken("speed: 30", "speed: 300"),
              HasSubstr("pick.yaml:2:5: programs.RA[1].steps_file.steps[0] is refused by"));
  EXPECT_THAT(broken("speed: 30", "speed: 30, exit_node: true"), HasSubstr("pick.yaml:2:5: "));
  EXPECT_THAT(fullWith("steps_file: pick.yaml", "steps_file: pick.yaml\n      dwell: 2"),
              HasSubstr("is given together with a steps_file"));
  EXPECT_THAT(fullWith("steps_file: pick.yaml", "steps_file: pick.yaml\n      steps: []"),
              HasSubstr("is given together with steps"));
}

TEST(CellFaults, tellOfTextsThatAreNoCells) {
  EXPECT_THAT(faultsOf(""), HasSubstr("cell.yaml: the file is empty; allowed: a map"));
  EXPECT_THAT(faultsOf("[]"), HasSubstr("the file is a list of 0"));
  EXPECT_THAT(faultsOf("cell: [1"), HasSubstr("not YAML"));
  EXPECT_THAT(faultsOf("cell: a\n---\ncell: b\n"), HasSubstr("the file has a second document"));
  EXPECT_THAT(faultsOf(", a: b}\n"), HasSubstr("cell.yaml"))
      << "which yaml-cpp reads as documents without an end";
  EXPECT_THAT(faultsOf("cell: a # \x04\n"), HasSubstr("cell.yaml:1:11: the file has a control character"));
  EXPECT_THAT(faultsOf("cell: a\n# \xff\n"), HasSubstr("cell.yaml:2:1: the file is not UTF-8"));
  EXPECT_THAT(faultsOf(std::string((1 << 20) + 1, '#')), HasSubstr("has 1048577 bytes"));
  EXPECT_THAT(faultsOf("robots: {}\nstations: {}\nprograms: {}\ncell: a\n"),
              HasSubstr("robots has no entries"));
  EXPECT_THAT(faultsOf("cell: *nobody\n"), HasSubstr("not YAML"));
}

TEST(CellFaults, stayFewAndShortWhateverTheFileIs) {
  std::string many = "cell: a\nrobots:\n";
  for (int i = 0; i < 60; ++i) many += fmt::format("  R{}: {{model: {}}}\n", i, std::string(5000, 'x'));
  const auto cell = parsed(many + "stations: {}\nprograms: {}\n");
  ASSERT_FALSE(cell);
  EXPECT_LE(cell.error().size(), 100U);
  for (const Fault& fault : cell.error()) EXPECT_LT(describe(fault).size(), 1000U);
  EXPECT_THAT(faultsOf("a: &a [*a]\n"), HasSubstr("a is no key of the file"));
  EXPECT_THAT(faultsWith("tool: *gripper", "tool: &t [*t]"), HasSubstr("robots.RB.tool[0]"));
  EXPECT_THAT(faultsWith("steps: [{", "steps: &s [*s, {"), HasSubstr("programs.RA[0].steps[0]"));
}

TEST(CellFaults, areOfNobodyTwice) {
  const std::string faults = faultsWith("target_position: T1", "target_position: T9");
  EXPECT_THAT(faults, Not(HasSubstr("programs.RB"))) << "both robots have the one step";
}

}  // namespace
}  // namespace cobot_command::cell
