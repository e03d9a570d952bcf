#include <string>
#include <vector>

#include "cell_texts.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Thing>
std::vector<std::string> namesIn(const std::vector<Thing>& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const Thing& thing : things) names.push_back(thing.name);
  return names;
}

TEST(CellFile, ofTheSpecificationIsReadAsItStands) {
  const Cell cell = cellOf(kExample);
  EXPECT_EQ(cell.name, "handover");
  EXPECT_EQ(cell.parameters.voxel, 0.02);
  EXPECT_EQ(cell.parameters.step_bound, 0.01);
  EXPECT_EQ(cell.parameters.margin, 0.02);
  ASSERT_THAT(namesIn(cell.robots), ElementsAre("RA", "RB"));
  const Robot& robot = cell.robots[1];
  EXPECT_EQ(robot.model, "tm5-900");
  EXPECT_EQ(robot.name_space, "RB");
  EXPECT_EQ(robot.home, "HOME");
  EXPECT_FALSE(robot.holds);
  EXPECT_TRUE(robot.base.isApprox(arm::toPose({720, -122.3, 0, 0, 0, 180}), 1e-12));
  ASSERT_EQ(robot.tool.size(), 1U);
  const auto& capsule = std::get<CapsuleShape>(robot.tool[0].kind);
  EXPECT_EQ(capsule.radius, 0.05);
  EXPECT_EQ(capsule.to.z(), 0.12);
  ASSERT_THAT(namesIn(robot.stations), ElementsAre("HOME", "T1"));
  EXPECT_NEAR(robot.stations[1].joints[3], degToRad(-15), 1e-15);
  EXPECT_TRUE(cell.parts.empty() && cell.obstacles.empty() && cell.mechanisms.empty());
}

TEST(CellFile, ofTheSpecificationHasTheProgramOfBothRobots) {
  const Cell cell = cellOf(kExample);
  for (const Robot& robot : cell.robots) {
    ASSERT_THAT(namesIn(robot.program), ElementsAre("T1", "BACK")) << "in the order of the file";
    const Path& path = robot.program[0];
    EXPECT_EQ(path.from, "HOME");
    EXPECT_EQ(path.to, "T1");
    EXPECT_EQ(path.place.line, 11) << "behind an alias: of what it stands for";
    ASSERT_EQ(path.steps.size(), 1U);
    const auto& move = std::get<blocks::MoveAbsoluteGoal>(path.steps[0].goal);
    EXPECT_EQ(move.movement_command, static_cast<int>(blocks::Movement::Ptp));
    EXPECT_EQ(move.data_format, static_cast<int>(blocks::AbsoluteFormat::Jpp));
    EXPECT_THAT(move.target, ElementsAre(0, 45, 60, -15, 90, 0));
    EXPECT_EQ(move.speed, 30);
    EXPECT_EQ(move.accel_time, 300);
    EXPECT_FALSE(blends(path.steps[0]));
  }
}

TEST(CellFile, ofEachDemoIsRight) {
  EXPECT_EQ(hashOf(cellOf(inFile("config/cells/handover.yaml"))), hashOf(cellOf(kExample)));
  const Cell head_on = cellOf(inFile("config/cells/head_on.yaml"));
  EXPECT_EQ(head_on.parameters.zone_size, 0.6);
  EXPECT_THAT(namesIn(head_on.robots), ElementsAre("RA", "RB"));
  const Cell iris = cellOf(inFile("config/cells/iris.yaml"));
  EXPECT_EQ(iris.parameters.zone_size, 1);
  EXPECT_THAT(namesIn(iris.robots), ElementsAre("R1", "R2", "R3"));
  for (const Cell* cell : {&head_on, &iris}) {
    for (const Robot& robot : cell->robots) {
      ASSERT_EQ(robot.program.size(), 2U);
      EXPECT_EQ(robot.program[0].steps.size(), 2U) << "through P";
    }
  }
  const Cell pallet = cellOf(inFile("config/cells/pallet.yaml"));
  ASSERT_EQ(pallet.mechanisms.size(), 1U);
  const MechanismPath& feed = pallet.mechanisms[0].program[0];
  EXPECT_TRUE(feed.controllable_go);
  EXPECT_FALSE(feed.controllable_book) << "it enters by itself once it is let go";
}

TEST(CellFile, mayHaveAllKeysAtOnce) {
  const Cell cell = cellOf(kFull);
  ASSERT_EQ(cell.robots.size(), 1U);
  const Robot& robot = cell.robots[0];
  EXPECT_EQ(robot.name_space, "line/RA");
  EXPECT_TRUE(robot.holds);
  EXPECT_TRUE(robot.base.isApprox(arm::toPose({-720, 122.3, 0, 0, 0, 180}), 1e-12)) << "by a quaternion";
  ASSERT_THAT(namesIn(robot.program), ElementsAre("WORK", "AGAIN", "BACK"));
  const std::vector<Step>& steps = robot.program[0].steps;
  ASSERT_EQ(steps.size(), 7U);
  EXPECT_EQ(steps[0].name, "world");
  EXPECT_THAT(std::get<blocks::ChangeBaseGoal>(steps[0].goal).transformation, ElementsAre(1, 2, 3, 0, 0, 90));
  EXPECT_EQ(std::get<blocks::ChangeTcpGoal>(steps[1].goal).weight, 1.5);
  EXPECT_EQ(std::get<blocks::MoveRelativeGoal>(steps[2].goal).data_format,
            static_cast<int>(blocks::RelativeFormat::Tar));
  EXPECT_TRUE(blends(steps[2]));
  EXPECT_EQ(std::get<blocks::MoveCircleGoal>(steps[3].goal).arc_angle, 90);
  EXPECT_EQ(steps[4].attach, "sheet");
  EXPECT_EQ(steps[4].dwell, 1.5) << "true: that of the path";
  EXPECT_EQ(steps[4].output->output, 1);
  EXPECT_EQ(steps[4].input->timeout, 3);
  EXPECT_TRUE(moves(steps[5]));
  EXPECT_EQ(steps[6].detach, "clip");
  EXPECT_FALSE(moves(robot.program[2].steps[1])) << "a script that only sets frames";
}

TEST(CellFile, readsTheStepsOfAPickAndPlaceFile) {
  const Cell cell = cellOf(kFull);
  const Path& path = cell.robots.at(0).program.at(1);
  ASSERT_EQ(path.steps.size(), 1U);
  EXPECT_EQ(path.steps[0].name, "to T1");
  EXPECT_EQ(path.steps[0].place.file, "pick.yaml");
  EXPECT_EQ(path.steps[0].place.line, 2);
}

TEST(CellFile, hasRobotsAndStationsInTheOrderOfTheirNames) {
  std::string text = with(kExample, "{HOME: [0, -30, 120, 0, 90, 0], T1: [0, 45, 60, -15, 90, 0]}",
                          "{T1: [0, 45, 60, -15, 90, 0], HOME: [0, -30, 120, 0, 90, 0]}");
  EXPECT_THAT(namesIn(cellOf(text).robots.at(0).stations), ElementsAre("HOME", "T1"));
}

TEST(CellFile, tellsAllThatIsWrongAtOnce) {
  std::string text = with(kExample, "voxel: 20", "voxel: 2");
  text = with(text, "speed: 30", "speed: 300");
  text = with(text, "radius: 50", "radius: -50");
  const std::string faults = faultsOf(text);
  EXPECT_THAT(faults, HasSubstr("cell.yaml:2:21: parameters.voxel is 2"));
  EXPECT_THAT(faults, HasSubstr("robots.RA.tool[0].capsule.radius is \"-50\""));
  EXPECT_THAT(faultsOf(with(with(kExample, "voxel: 20", "voxel: 2"), "speed: 30", "speed: 300")),
              HasSubstr("programs.RA[0].steps[0]"));
}

}  // namespace
}  // namespace cobot_command::cell
