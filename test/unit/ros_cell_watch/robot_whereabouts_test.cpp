// In which namespace the monitor listens to each robot.
#include "cell_watch/robot_whereabouts.h"

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::HasSubstr;

Instant at(double seconds) {
  return Instant(fromSeconds(seconds));
}

cell::Cell cellOf(const std::string& first_space, const std::string& second_space) {
  cell::Cell cell;
  cell.robots.resize(2);
  cell.robots[0].name = "RA";
  cell.robots[0].name_space = first_space;
  cell.robots[1].name = "RB";
  cell.robots[1].name_space = second_space;
  return cell;
}

class Whereabouts : public ::testing::Test {
 protected:
  RobotWhereabouts robots = *RobotWhereabouts::of(cellOf("RA", "/hall/RB"));
};

TEST_F(Whereabouts, areAtFirstThoseOfTheFile) {
  EXPECT_EQ(robots.robots()[0].space, "/RA");
  EXPECT_EQ(robots.robots()[1].space, "/hall/RB");
}

TEST_F(Whereabouts, areWhereItIsReportedFromIfNothingIsHeard) {
  EXPECT_EQ(robots.reported("RB", "/right/command_node", at(0)), 1U);
  EXPECT_EQ(robots.robots()[1].space, "/right");
  EXPECT_EQ(robots.reported("RB", "/right/command_node", at(1)), std::nullopt) << "it is there already";
  EXPECT_EQ(robots.reported("RA", "/command_node", at(1)), 0U);
  EXPECT_EQ(robots.robots()[0].space, "");
}

TEST_F(Whereabouts, stayWhereARobotIsHeard) {
  robots.heard(0, at(10));
  EXPECT_EQ(robots.reported("RA", "/elsewhere/command_node", at(10.5)), std::nullopt);
  EXPECT_EQ(robots.robots()[0].space, "/RA");
  EXPECT_EQ(robots.reported("RA", "/elsewhere/command_node", at(12)), 0U) << "its node was moved";
}

TEST_F(Whereabouts, areNeverThoseOfAnotherRobot) {
  EXPECT_EQ(robots.reported("RA", "/hall/RB/command_node", at(0)), std::nullopt);
  EXPECT_EQ(robots.reported("RC", "/RC/command_node", at(0)), std::nullopt) << "there is no such robot";
}

TEST(WhereaboutsOfAFile, areRefusedWhereTheyAreNoNamesOrThoseOfTwo) {
  const auto no_name = RobotWhereabouts::of(cellOf("RA", "R B"));
  ASSERT_FALSE(no_name);
  EXPECT_THAT(no_name.error(), HasSubstr("robots.RB.namespace is \"R B\"; allowed:"));
  const auto same = RobotWhereabouts::of(cellOf("RA", "/RA"));
  ASSERT_FALSE(same);
  EXPECT_THAT(same.error(), HasSubstr("as that of another robot"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
