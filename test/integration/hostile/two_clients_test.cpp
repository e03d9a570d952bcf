// Two command layers at one controller, which tells everybody of every tag and lets everybody command.
#include <algorithm>

#include "block_cases.h"
#include "hostile_rig.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::hostile {
namespace {

using blocks::Ending;
using blocks::GoalId;
using blocks::Outcome;
using blocks::Phase;

/// Neither stops what the other has under way when it connects.
link::LinkSettings neighbourly() {
  link::LinkSettings settings = quickSettings();
  settings.stop_orphaned_motion = false;
  return settings;
}

struct TwoClients : ::testing::Test {
  TwoClients()
      : robot(kTimeScale, {}, robotSettings()),
        ours(robot.ports().status, neighbourly()),
        theirs(robot.ports().status, neighbourly()) {
    for (Layer* const layer : {&ours, &theirs}) {
      const auto link = layer->submit(blocks::ConnectGoal{"127.0.0.1", robot.ports().script, 10, {}});
      EXPECT_TRUE(layer->waitUntil(
          [&](const Told& told) { return told.reached(link, Phase::Connected) && told.robot_statuses > 0; }));
    }
  }
  ~TwoClients() override {
    for (Layer* const layer : {&ours, &theirs}) {
      layer->stop();
      for (const auto& [id, ends] : layer->told().ends) EXPECT_EQ(ends.size(), 1u) << "goal " << id;
    }
  }
  /// Our motion is under way, and our stream has shown it for some frames.
  [[nodiscard]] bool isSeenMoving(GoalId move) {
    if (!ours.reaches(move, Phase::Active)) return false;
    const int before = ours.told().robot_statuses;
    return ours.waitUntil([&](const Told& told) { return told.robot_statuses > before + 10; });
  }
  [[nodiscard]] double firstJointDeg() { return radToDeg(robot.state().joints[0]); }

  Robot robot;
  Layer ours;
  Layer theirs;
};

blocks::MoveRelativeGoal turn(double degrees, double speed_percent, int tag) {
  blocks::MoveRelativeGoal goal;
  goal.command_id = tag;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::RelativeFormat::Jpp);
  goal.target = {degrees, 0, 0, 0, 0, 0};
  goal.speed = speed_percent;
  goal.accel_time = 200;
  return goal;
}

/// The finding, word for word: both use one number, the first motion's tag comes while the second is under
/// way.
TEST_F(TwoClients, noTagOfTheOneIsTakenForTheOthers) {
  const GoalId first = theirs.submit(turn(40, 2, 3));
  ASSERT_TRUE(theirs.reaches(first, Phase::Active));
  const GoalId second = ours.submit(turn(-40, 2, 3));
  const auto outcome = ours.endOf(second);
  const double joint = firstJointDeg();
  ASSERT_TRUE(outcome.has_value());
  if (outcome->ending == Ending::Done) {
    EXPECT_NEAR(joint, 0, 1e-2) << "a success that did not happen";
  } else {
    EXPECT_EQ(outcome->ending, Ending::Aborted) << outcome->error_description;
    EXPECT_FALSE(outcome->remedy.empty());
  }
  EXPECT_TRUE(theirs.endOf(first).has_value());
}

/// Absolute targets: whoever is Done stands, or stood, where it was to go.
TEST_F(TwoClients, whoIsDoneHasBeenAtItsTarget) {
  for (int round = 0; round < 4; ++round) {
    const double way = 20 + round;
    auto there = runtime::moveJoints({way, 0, 90, 0, 90, 0}, 20);
    auto back = runtime::moveJoints({-way, 0, 90, 0, 90, 0}, 20);
    const GoalId first = theirs.submit(there);
    ASSERT_TRUE(theirs.waitUntil(
        [&](const Told& told) { return told.reached(first, Phase::Active) || told.ended(first); }));
    const GoalId second = ours.submit(back);
    const auto ends = std::pair(theirs.endOf(first), ours.endOf(second));
    ASSERT_TRUE(ends.first.has_value() && ends.second.has_value());
    if (ends.second->ending == Ending::Done) {
      EXPECT_NEAR(firstJointDeg(), -way, 1e-2) << "a success that did not happen";
    }
    for (const auto& end : {ends.first, ends.second}) {
      EXPECT_NE(end->ending, Ending::CommandAborted) << end->error_description;
    }
  }
}

/// What the one stops, the other must not call done.
TEST_F(TwoClients, aStopOfTheOneIsNoSuccessOfTheOther) {
  const GoalId move = ours.submit(turn(120, 1, 3));
  ASSERT_TRUE(ours.reaches(move, Phase::Active));
  ASSERT_EQ(theirs.endOf(theirs.submit(blocks::StopGoal{}))->ending, Ending::Done);
  // The number is used again by the one that has stopped: its question would be answered with true.
  ASSERT_TRUE(theirs.endOf(theirs.submit(turn(1, 50, 3))).has_value());
  const auto outcome = ours.endOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Aborted) << outcome->error_description;
  EXPECT_LT(firstJointDeg(), 119);
}

void expectStoppedElsewhere(const std::optional<Outcome>& outcome) {
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Aborted);
  EXPECT_EQ(outcome->error_id, blocks::own_error::kStoppedElsewhere) << outcome->error_description;
}

/// It need not wait until its tag is due, which takes half a minute here.
TEST_F(TwoClients, areToldThatTheOtherHasStoppedTheRobot) {
  const GoalId move = ours.submit(turn(120, 1, 3));
  ASSERT_TRUE(isSeenMoving(move));
  ASSERT_EQ(theirs.endOf(theirs.submit(blocks::StopGoal{}))->ending, Ending::Done);
  expectStoppedElsewhere(ours.endOf(move));
}

/// As it does by default with what it finds in motion.
TEST_F(TwoClients, areToldThatAThirdHasStoppedTheRobotWhenItConnected) {
  const GoalId move = ours.submit(turn(120, 1, 3));
  ASSERT_TRUE(isSeenMoving(move));
  Layer third(robot.ports().status);
  const auto link = third.submit(blocks::ConnectGoal{"127.0.0.1", robot.ports().script, 10, {}});
  ASSERT_TRUE(third.reaches(link, Phase::Connected));
  expectStoppedElsewhere(ours.endOf(move));
  third.stop();
}

/// The second client is told of, in the words of the status.
TEST_F(TwoClients, areToldOfEachOther) {
  ASSERT_EQ(theirs.endOf(theirs.submit(turn(10, 50, 7)))->ending, Ending::Done);
  EXPECT_TRUE(ours.waitUntil([](const Told& told) {
    return told.status.diagnosis.find("another client") != std::string::npos;
  })) << ours.told().status.diagnosis;
}

}  // namespace
}  // namespace cobot_command::hostile
