#include "cobot_command/files/steps/steps_file.h"

#include <fstream>
#include <sstream>
#include <string>

#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// How each key is read, and refused, is in test/unit/ros/pick_and_place_file_test.cpp.

std::string inFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(test_support::inSourceTree(path)).rdbuf();
  return text.str();
}

TEST(StepsFile, hasTheCycleOfTheThesisWithNamesAndLines) {
  const auto steps = readSteps(inFile("config/pick_and_place.yaml"), "steps.yaml");
  ASSERT_TRUE(steps) << describe(steps.error());
  ASSERT_EQ(steps->size(), 6U);
  EXPECT_EQ(steps->at(1).name, "pick");
  EXPECT_EQ(steps->at(1).column, 5);
  EXPECT_EQ(steps->at(1).line, steps->at(0).line + 7);
  EXPECT_THAT(steps->at(1).step.move.target, ElementsAre(430, -220, 260, 180, 0, 90));
  EXPECT_THAT(steps->at(0).step.move.robot_pose, ElementsAre(0, 2, 4));
  EXPECT_EQ(steps->at(2).step.dwell, 2);
}

TEST(StepsFile, isRefusedWithFileLineAndColumn) {
  const auto steps = readSteps("dwell: 1\nsteps:\n  - {movement_command: FLY}\n", "steps.yaml");
  ASSERT_FALSE(steps);
  EXPECT_EQ(steps.error().file, "steps.yaml");
  EXPECT_EQ(steps.error().line, 3);
  EXPECT_EQ(steps.error().column, 24);
  EXPECT_EQ(steps.error().finding.field, "movement_command");
  EXPECT_EQ(steps.error().finding.found, "is \"FLY\"");
  EXPECT_EQ(steps.error().finding.allowed, "LINE, PTP");
  EXPECT_THAT(describe(steps.error()), Not(HasSubstr("FLY"))) << "what a goal names may be any file";
}

TEST(StepsFile, saysThatFormatsOfTheToolHaveNoPlaceInIt) {
  const auto steps = readSteps(
      "steps:\n  - {movement_command: LINE, data_format: TPP, target_position: [0, 0, 0, 0, 0, 0]}\n",
      "steps.yaml");
  ASSERT_FALSE(steps);
  EXPECT_EQ(steps.error().finding.found, "is TPP, which is relative to the tool");
  EXPECT_THAT(steps.error().finding.advice, HasSubstr("this file cannot contain moves relative to the tool"));
}

}  // namespace
}  // namespace cobot_command::files
