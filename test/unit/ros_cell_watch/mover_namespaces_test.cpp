// In which namespace the monitor listens to each robot and mechanism.
#include "cell_watch/mover_namespaces.h"

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

cell::Cell withMechanism(cell::Cell cell, const std::string& name) {
  cell.mechanisms.resize(1);
  cell.mechanisms[0].name = name;
  return cell;
}

class MoverNamespacesOfACell : public ::testing::Test {
 protected:
  MoverNamespaces known = *MoverNamespaces::of(cellOf("RA", "/hall/RB"));
};

TEST_F(MoverNamespacesOfACell, areAtFirstThoseOfTheFile) {
  EXPECT_EQ(known.movers()[0].space, "/RA");
  EXPECT_EQ(known.movers()[1].space, "/hall/RB");
}

TEST_F(MoverNamespacesOfACell, areWhereItIsReportedFromIfNothingIsHeard) {
  EXPECT_EQ(known.reported("RB", "/right/command_node", at(0)), 1U);
  EXPECT_EQ(known.movers()[1].space, "/right");
  EXPECT_EQ(known.reported("RB", "/right/command_node", at(1)), std::nullopt) << "it is there already";
  EXPECT_EQ(known.reported("RA", "/command_node", at(1)), 0U);
  EXPECT_EQ(known.movers()[0].space, "");
}

TEST_F(MoverNamespacesOfACell, stayWhereARobotIsHeard) {
  known.heard(0, at(10));
  EXPECT_EQ(known.reported("RA", "/elsewhere/command_node", at(10.5)), std::nullopt);
  EXPECT_EQ(known.movers()[0].space, "/RA");
  EXPECT_EQ(known.reported("RA", "/elsewhere/command_node", at(12)), 0U) << "its node was moved";
}

TEST_F(MoverNamespacesOfACell, areNeverThoseOfAnotherRobot) {
  EXPECT_EQ(known.reported("RA", "/hall/RB/command_node", at(0)), std::nullopt);
  EXPECT_EQ(known.reported("RC", "/RC/command_node", at(0)), std::nullopt) << "there is no such robot";
}

TEST(MoverNamespacesOfAMechanism, areTheNamespaceOfItsNameUntilOneReportsFromElsewhere) {
  auto known = *MoverNamespaces::of(withMechanism(cellOf("RA", "RB"), "PALLET"));
  ASSERT_EQ(known.movers().size(), 3U);
  EXPECT_FALSE(known.movers()[1].is_mechanism);
  EXPECT_TRUE(known.movers()[2].is_mechanism);
  EXPECT_EQ(known.movers()[2].space, "/PALLET");
  EXPECT_EQ(known.reported("PALLET", "/RA/cell_mechanism", at(0)), std::nullopt) << "that is a robot's";
  EXPECT_EQ(known.reported("PALLET", "/plc/cell_mechanism", at(0)), 2U);
  EXPECT_EQ(known.movers()[2].space, "/plc");
}

TEST(MoverNamespacesOfAMechanism, areRefusedWhereARobotIs) {
  const auto refused = MoverNamespaces::of(withMechanism(cellOf("RA", "/PALLET"), "PALLET"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(
      refused.error(),
      HasSubstr(
          "mechanisms.PALLET is expected in the namespace \"/PALLET\", which belongs to a robot; give"));
}

TEST(MoverNamespacesOfAFile, areRefusedWhereTheyAreNoNamesOrThoseOfTwo) {
  const auto no_name = MoverNamespaces::of(cellOf("RA", "R B"));
  ASSERT_FALSE(no_name);
  EXPECT_THAT(no_name.error(), HasSubstr("robots.RB.namespace is \"R B\"; allowed:"));
  const auto same = MoverNamespaces::of(cellOf("RA", "/RA"));
  ASSERT_FALSE(same);
  EXPECT_THAT(same.error(), HasSubstr("the same as for another robot"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
