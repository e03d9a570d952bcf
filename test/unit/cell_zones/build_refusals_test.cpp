// Cells of which nothing can be proved are refused, with who, where and what helps (oracle 32).
#include <functional>

#include "zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/cell/artifact/cell_build.h"

namespace cobot_command::cell {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

struct Refusal {
  BuildStage stage = BuildStage::Verify;
  std::vector<std::string> faults;  ///< none: it was built
};

/// A cell of config/cells with something changed, built as far as it goes.
Refusal refusalOf(const std::string& name, const std::function<void(Cell&)>& change,
                  Policy policy = Policy::Supervisor) {
  Cell cell = cellOf(name);
  cell.parameters.voxel = 0.04;
  cell.parameters.step_bound = 0.02;
  change(cell);
  CellBuild build(std::move(cell), policy, 1);
  for (const BuildStage stage : kBuildStages) {
    auto faults = build.run(stage);
    if (!faults.empty()) return {stage, std::move(faults)};
  }
  return {};
}

void place(Robot& robot, const blocks::SixValues& base) {
  robot.base = arm::toPose(base);
}

TEST(ACellWhoseMarginIsTooLarge, isRefusedWithTheRobotThatIsInAZoneAtHome) {
  const auto closer = [](Cell& cell) {
    place(cell.robots[0], {-600, 122.3, 0, 0, 0, 0});
    place(cell.robots[1], {600, -122.3, 0, 0, 0, 180});
  };
  const Refusal refusal = refusalOf("handover", [&](Cell& cell) {
    closer(cell);
    cell.parameters.margin = 0.2;
    cell.parameters.body_tolerance = 0.05;
  });
  EXPECT_EQ(refusal.stage, BuildStage::Zones);
  EXPECT_THAT(refusal.faults, Contains(HasSubstr("RA is in Z1 at its home HOME, which RA and RB share")));
  EXPECT_THAT(refusal.faults, Contains(HasSubstr("choose another home")));
}

TEST(ACellWithABaseInTheClaimOfAnother, isRefusedWithTheRobotThatNeverLeavesTheZone) {
  const Refusal refusal = refusalOf("handover", [](Cell& cell) {
    place(cell.robots[1], {-100, 122.3, 0, 0, 0, 180});
  });
  EXPECT_EQ(refusal.stage, BuildStage::Zones);
  EXPECT_THAT(refusal.faults, Contains(HasSubstr("RB never leaves Z")));
}

TEST(ARobotThatHoldsAZoneForEver, isRefusedThoughItsHomeMayBeThere) {
  const Refusal refusal = refusalOf("handover", [](Cell& cell) {
    place(cell.robots[1], {-100, 122.3, 0, 0, 0, 180});
    for (Robot& robot : cell.robots) robot.holds = true;
  });
  EXPECT_EQ(refusal.stage, BuildStage::Zones);
  EXPECT_THAT(refusal.faults, Contains(HasSubstr("RB never leaves")));
}

TEST(ACellOfTooManyZones, isRefusedWithHowManyThereAre) {
  const Refusal refusal = refusalOf("handover", [](Cell& cell) {
    cell.parameters.zone_size = 0.05;
    cell.parameters.zone_overlap = 1.0;
    cell.parameters.voxel = 0.02;
  });
  EXPECT_EQ(refusal.stage, BuildStage::Zones);
  ASSERT_EQ(refusal.faults.size(), 1U);
  EXPECT_THAT(refusal.faults.front(), HasSubstr("at most max_zones = 256 are allowed"));
  const Refusal two = refusalOf("head_on", [](Cell& cell) { cell.parameters.max_zones = 1; });
  EXPECT_THAT(two.faults, Contains(HasSubstr("there are 2 zones, but at most max_zones = 1 are allowed")));
}

TEST(ACellOfTooManyStates, isRefusedWhereSafeOrdersCannotDecideEither) {
  const Refusal refusal = refusalOf("pallet", [](Cell& cell) { cell.parameters.max_states = 3; });
  EXPECT_EQ(refusal.stage, BuildStage::Synthesize);
  EXPECT_THAT(refusal.faults, Contains(HasSubstr("a supervisor has more than max_states = 3 states")));
}

/// Else the above would say nothing.
TEST(TheSameCells, areBuiltAsTheyAre) {
  for (const char* name : {"handover", "head_on", "pallet"}) {
    EXPECT_THAT(refusalOf(name, [](Cell&) {}).faults, ::testing::IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace cobot_command::cell
