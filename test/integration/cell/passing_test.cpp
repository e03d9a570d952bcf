// What a supervisor costs a robot that nobody is in the way of (P6), and how soon a zone that one has left is
// of use to the next (P7).
#include <algorithm>
#include <chrono>
#include <iostream>

#include "figure.h"
#include "run_rig.h"
#include "source_tree.h"
#include "thorough.h"

#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::trial {
namespace {

/// So long each message is under way at most, as over ROS on one machine.
constexpr Duration kMessageDelay = 5ms;

/// Slowly, so that the way in is cut before the zone.
std::shared_ptr<const cell::Artifact> slowHandover() {
  std::string text = *runtime::readFile(test_support::inSourceTree("config/cells/handover.yaml"));
  for (std::size_t at = text.find("speed: 30"); at != std::string::npos; at = text.find("speed: 30", at)) {
    text.replace(at, 9, "speed: 10");
  }
  return artifactOfText(text);
}

struct Passage {
  Duration cycle{};
  int stops = 0;
  std::size_t frames = 0;
};

/// Of the first robot, while the other one stays at home.
Passage pass(const std::shared_ptr<const cell::Artifact>& artifact, std::uint64_t seed) {
  TrialSettings settings;
  settings.delay = kMessageDelay;
  settings.seed = seed;
  RunRig rig(artifact, settings);
  EXPECT_TRUE(rig.trial->start());
  const Instant began = rig.trial->now();
  rig.order(0, 1);
  Passage passage;
  bool moved = false;
  EXPECT_TRUE(rig.passUntil([&] {
    const bool moves = rig.isMoving(0);
    if (moved && !moves) ++passage.stops;
    moved = moves;
    return rig.robot(0).hasEnded();
  }));
  passage.cycle = rig.trial->now() - began;
  passage.frames = rig.robot(0).scripts().size();
  return passage;
}

TEST(ARobotThatNobodyIsInTheWayOf, passesWithoutAStopOnItsWay) {
  const auto artifact = slowHandover();
  double planned = 0.0;
  for (const auto& path : artifact->robots[0].paths) planned += toSeconds(path.duration);
  testing::Figure figure("P6", "a crossing with look-ahead, longer than planned by", "%", 1.0);
  for (std::uint64_t seed = 1; seed <= testing::quickOrThorough(3U, 100U); ++seed) {
    const Passage passage = pass(artifact, seed);
    EXPECT_EQ(passage.frames, 3U) << "the way in is two frames";
    EXPECT_EQ(passage.stops, 2) << "at T1, and at home";
    figure.add(100.0 * (toSeconds(passage.cycle) / planned - 1.0));
    EXPECT_LE(toSeconds(passage.cycle), 1.01 * planned);
  }
}

/// The robot that waits for the zone; the other one is in it.
cell::RobotIndex whoWaits(RunRig& rig) {
  cell::RobotIndex waiting = 0;
  EXPECT_TRUE(rig.passUntil([&] {
    waiting = rig.of(0).reason == cell::WaitReason::ZoneHeld ? 0 : 1;
    return rig.of(waiting).reason == cell::WaitReason::ZoneHeld;
  }));
  return waiting;
}

/// By its joints it may be in a piece of its way back that touches the zone. Such a piece is released as a
/// whole.
bool isInAPieceOf(RunRig& rig, cell::RobotIndex robot, cell::ZoneIndex zone) {
  const arm::JointVector joints = rig.robot(robot).state().joints;
  const auto& pieces = rig.artifact->robots[robot].paths.back().pieces;
  return std::any_of(pieces.begin(), pieces.end(), [&](const cell::ArtifactPiece& piece) {
    const bool touches = std::binary_search(piece.zones.begin(), piece.zones.end(), zone);
    return touches && piece.range.contains(joints);
  });
}

TEST(AZoneThatARobotHasLeft, isOfUseToTheNextAtOnce) {
  const auto artifact = artifactOf("handover", [](cell::Parameters& parameters) {
    parameters.voxel = cell::Parameters().voxel;
    parameters.step_bound = cell::Parameters().step_bound;
  });
  const double limit = 1000.0 * toSeconds(2 * simulator::Settings().status_period + 20ms);
  testing::Figure figure("P7", "from out of the last piece of a zone to the frame of the next", "ms", limit);
  TrialSettings settings;
  settings.delay = kMessageDelay;
  for (settings.seed = 1; settings.seed <= testing::quickOrThorough(3U, 100U); ++settings.seed) {
    RunRig rig(artifact, settings);
    rig.begin(1);
    const cell::RobotIndex next = whoWaits(rig);
    const cell::RobotIndex owner = 1 - next;
    const std::size_t sent = rig.robot(next).scripts().size();
    ASSERT_TRUE(rig.passUntil([&] { return rig.of(owner).place == "BACK>" && rig.isMoving(owner); }));
    while (rig.isIn(owner, 0)) rig.trial->pass(1ms);
    const Instant out = rig.trial->now();
    while (isInAPieceOf(rig, owner, 0)) rig.trial->pass(1ms);
    const Instant clear = rig.trial->now();
    EXPECT_EQ(rig.robot(next).scripts().size(), sent);
    ASSERT_TRUE(rig.passUntil([&] { return rig.robot(next).scripts().size() > sent; }));
    const double took = 1000.0 * toSeconds(rig.trial->now() - clear);
    figure.add(took);
    std::cout << took << " ms, and " << 1000.0 * toSeconds(rig.trial->now() - out)
              << " ms behind its bodies\n";
    EXPECT_LE(took, limit);
  }
}

}  // namespace
}  // namespace cobot_command::trial
