// The active base and TCP: a change counts at once, and the stream is believed when it has caught up.

#include <functional>

#include "core_rig.h"
#include "status_frames.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using namespace robot;
namespace item = protocol::item;

const std::array<double, 6> kBase{100, 200, 300, 0, 0, 90};

StatusFrames withBase(float x, const std::string& name) {
  return StatusFrames()
      .with(item::ofFloats("Base_Value", {x, 200, 300, 0, 0, 90}))
      .with(item::ofString("Base_Name", name));
}

struct Rig : CoreRig {
  Rig() : CoreRig(std::nullopt, link::LinkSettings{}) {
    connect();
    status(withBase(0, "RobotBase"));
  }
  double baseX() const { return active_frames.back().base->translation().x(); }
  void changeBase() {
    ChangeBaseGoal goal;
    goal.transformation = kBase;
    submit(goal);
    reply(takeScript().id);
  }
};

TEST(ActiveFrames, areThoseOfTheStreamAtFirst) {
  Rig rig;
  EXPECT_DOUBLE_EQ(rig.baseX(), 0);
  EXPECT_EQ(rig.active_frames.back().base_name, "RobotBase");
}

TEST(ActiveFrames, changeWithTheAcceptanceNotWithTheNextStatusFrame) {
  Rig rig;
  rig.changeBase();
  EXPECT_DOUBLE_EQ(rig.baseX(), 0.1);
  EXPECT_EQ(rig.active_frames.back().base_name, "");
}

TEST(ActiveFrames, doNotFallBackToAStreamThatIsBehind) {
  Rig rig;
  rig.changeBase();
  const auto changes = rig.active_frames.size();
  rig.status(withBase(0, "RobotBase"));
  EXPECT_EQ(rig.active_frames.size(), changes);
  rig.status(withBase(100, ""));
  EXPECT_NEAR(rig.baseX(), 0.1, 1e-6);
  rig.status(withBase(500, "fixture"));
  EXPECT_NEAR(rig.baseX(), 0.5, 1e-6) << "from then on the stream tells";
}

TEST(ActiveFrames, believeAStreamThatInsistsWhileTheRobotStands) {
  Rig rig;
  rig.changeBase();
  for (int i = 0; i < 15; ++i) {
    rig.pass(100ms);
    rig.status(withBase(0, "RobotBase"));
  }
  EXPECT_DOUBLE_EQ(rig.baseX(), 0);
}

TEST(ActiveFrames, ofANameAreUnknownUntilTheStreamTells) {
  Rig rig;
  ChangeBaseGoal goal;
  goal.base_name = "fixture";
  rig.submit(goal);
  rig.reply(rig.takeScript().id);
  EXPECT_FALSE(rig.active_frames.back().base);
  EXPECT_EQ(rig.active_frames.back().base_name, "fixture");
  rig.status(withBase(250, "fixture"));
  EXPECT_NEAR(rig.baseX(), 0.25, 1e-6);
}

TEST(ActiveFrames, ofARefusedChangeStayAsTheyWere) {
  Rig rig;
  ChangeBaseGoal goal;
  goal.transformation = kBase;
  rig.submit(goal);
  rig.reply(rig.takeScript().id, false, {1});
  EXPECT_DOUBLE_EQ(rig.baseX(), 0);
}

TEST(ActiveFrames, tellTheToolAndItsMass) {
  Rig rig;
  ChangeTcpGoal goal;
  goal.tcp_offset = {0, 0, 150, 0, 0, 0};
  goal.weight = 1.5;
  rig.submit(goal);
  rig.reply(rig.takeScript().id);
  EXPECT_DOUBLE_EQ(rig.active_frames.back().tcp->translation().z(), 0.15);
  EXPECT_DOUBLE_EQ(*rig.active_frames.back().tool_mass, 1.5);
}

TEST(ActiveFrames, turnATargetInAnotherFrameIntoTheActiveBase) {
  Rig rig;
  rig.changeBase();
  MoveAbsoluteGoal goal = CoreRig::move();
  FramedPose pose;
  pose.frame = "fixture";
  pose.frame_in_robot_base = arm::toPose({100, 200, 300, 0, 0, 90});
  pose.position = {0.5, 0.1, 0.2};
  pose.quaternion = {0, 0, 0, 1};
  goal.target_pose = pose;
  rig.submit(goal);
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script.substr(0, 33), "PTP(\"CPP\",500,100,200,0,0,0,10,20") << script.script;
  rig.discardSent();
}

/// Behind the next connection there may be another robot, or another project.
TEST(ActiveFrames, thatWereCommandedEndWithTheConnectionHoweverThatEnds) {
  const std::function<void(CoreRig&, GoalId)> ends[] = {
      [](CoreRig& rig, GoalId connection) { rig.cancel(connection); },
      [](CoreRig& rig, GoalId) { rig.close("closed by the peer"); },
  };
  for (const auto& end : ends) {
    CoreRig rig;
    const GoalId connection = rig.connect();
    ChangeBaseGoal goal;
    goal.transformation = kBase;
    rig.submit(goal);
    rig.reply(rig.takeScript().id);
    ASSERT_TRUE(rig.active_frames.back().base);
    end(rig, connection);
    EXPECT_FALSE(rig.active_frames.back().base);
    rig.connect();
    EXPECT_FALSE(rig.active_frames.back().base);
  }
}

TEST(ActiveFrames, thatWereCommandedEndWithALinkThatGivesWayToAnother) {
  CoreRig rig;
  rig.core.keepConnected(CoreRig::robot(), rig.now);
  rig.pump();
  rig.open();
  ChangeBaseGoal goal;
  goal.transformation = kBase;
  rig.submit(goal);
  rig.reply(rig.takeScript().id);
  ASSERT_TRUE(rig.active_frames.back().base);
  ConnectGoal other = CoreRig::robot();
  other.host = "another";
  rig.submit(other);
  rig.open();
  EXPECT_FALSE(rig.active_frames.back().base);
}

TEST(ActiveFrames, unknownRefuseATargetInAnotherFrame) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = CoreRig::move();
  FramedPose pose;
  pose.frame = "fixture";
  pose.frame_in_robot_base = arm::Pose::Identity();
  pose.quaternion = {0, 0, 0, 1};
  goal.target_pose = pose;
  const GoalId id = rig.submit(goal);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kBaseUnknown);
}

}  // namespace
}  // namespace cobot_command::testing
