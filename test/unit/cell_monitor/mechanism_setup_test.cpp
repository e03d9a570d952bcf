// The monitor of a cell with mechanisms, made of the cell's file.
#include <string>
#include <utility>
#include <vector>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;
using Mode = MonitorSettings::Mode;

Cell pallet() {
  return *runtime::readCellFile(test_support::inSourceTree("config/cells/pallet.yaml"));
}

TEST(TheMonitorOfAFileWithMechanisms, hasTheMechanismsOfItsFile) {
  Cell cell = pallet();
  cell.mechanisms.push_back(cell.mechanisms.front());
  cell.mechanisms.back().name = "SECOND";
  const auto monitor = runtime::monitorOf(cell, Mode::Stop, std::nullopt);
  ASSERT_TRUE(monitor) << monitor.error();
  std::vector<std::string> pairs;
  for (const auto& pair : monitor->status().pairs) pairs.push_back(pair.first + " " + pair.second);
  EXPECT_THAT(pairs, ::testing::ElementsAre("RA PALLET", "RA SECOND", "RA fence", "PALLET SECOND"));
}

TEST(TheMonitorOfAFileWithMechanisms, hasAMechanismWhereItsPositionSays) {
  Cell cell = pallet();
  auto monitor = runtime::monitorOf(cell, Mode::Stop, std::nullopt);
  ASSERT_TRUE(monitor);
  for (const double position : {0.0, 0.9}) {
    monitor->takePosition("PALLET", position, Duration(0), Instant(fromSeconds(1 + position)));
    const auto seen = monitor->bodies()[1];
    ASSERT_EQ(seen.name, "PALLET");
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& capsule : seen.capsules) middle += 0.5 * (capsule.from + capsule.to);
    middle /= static_cast<double>(seen.capsules.size());
    EXPECT_TRUE(middle.isApprox(Eigen::Vector3d(0, -0.9 + position, 0.15), 1e-9)) << middle.transpose();
  }
}

/// A cell whose program may be run has to be let run.
TEST(TheMonitorOfAFileWithMechanisms, hasNoReasonToStopWhereItsProgramLeads) {
  const arm::JointVector home = arm::toJointVector({0, -30, 120, 0, 90, 0});
  const arm::JointVector t1 = arm::toJointVector({0, 45, 60, -15, 90, 0});
  for (const auto& [joints, position] : {std::pair(home, 0.9), std::pair(home, 0.0), std::pair(t1, 0.0)}) {
    auto monitor = runtime::monitorOf(pallet(), Mode::Stop, std::nullopt);
    ASSERT_TRUE(monitor);
    monitor->take("RA", joints, arm::JointVector::Zero(), Duration(0), Instant(fromSeconds(1)));
    monitor->takePosition("PALLET", position, Duration(0), Instant(fromSeconds(1)));
    monitor->tick(Instant(fromSeconds(1)));
    EXPECT_FALSE(monitor->latched()) << monitor->status().diagnosis;
  }
}

TEST(TheMonitorOfAFileWithMechanisms, isRefusedWhereAShapeOrTheStopDistanceIsNone) {
  Cell cell = pallet();
  cell.mechanisms.front().shapes = {{CapsuleShape{{0, 0, 0}, {0, 0, 1}, -1}, arm::Pose::Identity()}};
  const auto refused = runtime::monitorOf(cell, Mode::Stop, std::nullopt);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), HasSubstr("mechanisms.PALLET: "));
  const auto too_far = runtime::monitorOf(pallet(), Mode::Stop, 0.03);
  ASSERT_FALSE(too_far);
  EXPECT_THAT(too_far.error(), HasSubstr("must be at most the margin"));
}

}  // namespace
}  // namespace cobot_command::cell
