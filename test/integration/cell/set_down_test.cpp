// What a robot sets down keeps no zone from others any more.
#include "run_rig.h"
#include "source_tree.h"

#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::trial {
namespace {

/// The robot of the pallet leaves its sheet at S, where nothing else of it reaches into the pallet's zone, as
/// the last thing on its path, and goes home without it.
std::string palletWhoseSheetIsLeftAtTheEdgeOfItsZone() {
  std::string text = *runtime::readFile(test_support::inSourceTree("config/cells/pallet.yaml"));
  const std::string station = "T1: [0, 45, 60, -15, 90, 0]";
  text.insert(text.find(station), "S: [0, 29, 60, -15, 90, 0], ");
  text.resize(text.find("    - path: BRING"));
  return text + R"(    - path: BRING
      from: T1
      to: S
      steps:
        - {movement_command: PTP, data_format: JPP, target_position: S, speed: 30, accel_time: 300, dwell: 1, detach: sheet}
    - path: AWAY
      from: S
      to: HOME
      steps:
        - {movement_command: PTP, data_format: JPP, target_position: HOME, speed: 30, accel_time: 300}
)";
}

TEST(ARobotThatSetsAPartDown, givesTheZoneBackThatOnlyThePartReachedInto) {
  RunRig rig(artifactOfText(palletWhoseSheetIsLeftAtTheEdgeOfItsZone()));
  rig.begin(3);
  EXPECT_TRUE(rig.endsAll());
}

/// Where it stands it dwells first.
TEST(ARobotThatSetsAPartDown, keepsThatZoneUntilItHasDoneSo) {
  RunRig rig(artifactOfText(palletWhoseSheetIsLeftAtTheEdgeOfItsZone()));
  rig.begin(1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.placeOf(0) == "BRING>" && rig.isMoving(0); }));
  ASSERT_TRUE(rig.passUntil([&] { return !rig.isMoving(0); }));
  rig.pass(900ms);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  rig.pass(500ms);
  EXPECT_EQ(rig.zone(0).owner, "PALLET") << "that waits for it";
}

/// No cell that was built is like that.
TEST(ARobotThatIsNeverMeasuredBehindItsZone, endsItsGoalWithTheReason) {
  auto artifact = std::make_shared<cell::Artifact>(*artifactOf("handover"));
  artifact->parameters.wait_timeout = 5s;
  for (auto& path : artifact->robots[0].paths) {
    for (cell::ZonePlace& place : path.places) place.piece = path.pieces.size() - 1;
  }
  RunRig rig(artifact);
  rig.begin(1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }));
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kPermitLate);
  EXPECT_THAT(rig.robot(0).lastOutcome()->error_description,
              ::testing::HasSubstr("do not allow it to continue there"));
}

}  // namespace
}  // namespace cobot_command::trial
