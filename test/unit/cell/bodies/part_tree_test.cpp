// What robots carry moves with what carries it, to any depth (cell.md, M2 and oracle 29).
#include "cobot_command/cell/bodies/part_tree.h"

#include "cell_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

CarriedPart partOf(const std::string& name, const std::string& on, const Vector3d& at = Vector3d::Zero()) {
  CarriedPart part;
  part.name = name;
  part.shapes = {{SphereShape{0.05}, arm::Pose::Identity()}};
  part.on = on;
  part.at.translation() = at;
  return part;
}

CarriedPart sheetOn(const std::string& carrier, const arm::ControllerPose& at) {
  CarriedPart sheet = partOf("sheet", carrier);
  sheet.shapes = {{BoxShape{{0.400, 0.300, 0.005}}, arm::Pose::Identity()}};
  sheet.at = arm::toPose(at);
  return sheet;
}

PartTree treeOf(const std::vector<CarriedPart>& parts) {
  auto tree = PartTree::of(parts);
  if (!tree) throw std::runtime_error(tree.error().message);
  return *tree;
}

std::string refusalOf(const std::vector<CarriedPart>& parts) {
  const auto tree = PartTree::of(parts);
  return tree ? "" : tree.error().message;
}

/// That some body of the sheet contains each of its corners, where `sheet` in the flange is, at many joints.
void expectCornersInside(const RobotBodies& robot, const arm::Pose& sheet) {
  const auto arm = arm::ArmModel::named("tm5-900");
  RandomNumbers random(7);
  for (int i = 0; i < 300; ++i) {
    const arm::JointVector joints = random.joints(3);
    const PlacedRobot placed = robot.at(joints);
    const arm::Pose in_world = robot.base() * arm::forwardKinematics(*arm, joints) * sheet;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      const Vector3d point = in_world * sign.cwiseProduct(Vector3d(0.200, 0.150, 0.0025));
      double outside = 1;
      for (std::size_t k = 0; k < robot.bodies().size(); ++k) {
        if (robot.bodies()[k].name != "sheet") continue;
        const Capsule& body = placed.capsules[k];
        outside = std::min(outside, distanceToSegment(point, body.from, body.to) - body.radius);
      }
      ASSERT_LT(outside, 1e-9);
    }
  }
}

TEST(PartTree, aSheetOnTheGripperMovesWithTheFlange) {
  const arm::ControllerPose at = {0, 0, 125, 0, 0, 30};
  const PartTree tree = treeOf({sheetOn(kOnFlange, at)});
  const RobotBodies robot = robotAt({100, 200, 0, 0, 0, 45});
  const RobotBodies loaded = robot.carrying(tree.bodiesOf({"sheet"}));
  EXPECT_EQ(loaded.bodies().size(), robot.bodies().size() + 6);
  expectCornersInside(loaded, arm::toPose(at));
}

TEST(PartTree, aSheetOnAPartThatHangsOnTheGripperMovesWithItToo) {
  CarriedPart frame = partOf("frame", kOnFlange);
  frame.at = arm::toPose({10, 20, 150, 20, -30, 40});
  CarriedPart rail = partOf("rail", "frame");
  rail.at = arm::toPose({0, 200, 0, 0, 90, 0});
  const arm::ControllerPose at = {0, 0, 125, 0, 45, 30};
  const PartTree tree = treeOf({sheetOn("rail", at), rail, frame});
  const RobotBodies loaded =
      robotAt({100, 200, 0, 0, 0, 45}).carrying(tree.bodiesOf({"frame", "rail", "sheet"}));
  expectCornersInside(loaded, frame.at * rail.at * arm::toPose(at));
}

TEST(PartTree, hasTheBodiesOfWhatIsCarriedOnly) {
  const PartTree tree = treeOf({partOf("tray", kOnFlange), partOf("cup", "tray")});
  EXPECT_EQ(tree.bodiesOf({"tray", "cup"}).size(), 2u);
  EXPECT_EQ(tree.bodiesOf({"tray"}).size(), 1u);
  EXPECT_TRUE(tree.bodiesOf({}).empty());
}

TEST(PartTree, isRefusedWhereItIsNoTree) {
  EXPECT_THAT(refusalOf({partOf("a", "b")}), HasSubstr("which does not exist"));
  EXPECT_THAT(refusalOf({partOf("a", "a")}), HasSubstr("on itself"));
  EXPECT_THAT(refusalOf({partOf("a", "b"), partOf("b", "c"), partOf("c", "b")}), HasSubstr("on itself"));
  EXPECT_THAT(refusalOf({partOf("a", kOnFlange), partOf("a", kOnFlange)}), HasSubstr("Two parts"));
  EXPECT_THAT(refusalOf({partOf("flange", kOnFlange)}), HasSubstr("flange itself"));
  CarriedPart wrong = partOf("a", kOnFlange);
  wrong.shapes.front().kind = SphereShape{-1};
  EXPECT_THAT(refusalOf({wrong}), HasSubstr("The part \"a\""));
}

}  // namespace
}  // namespace cobot_command::cell
