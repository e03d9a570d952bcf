// A robot whose moves are planned beside the core, by the test.
#pragma once

#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {

inline blocks::MoveAbsoluteGoal toJoints(double j1, blocks::BufferMode mode = blocks::BufferMode::Refuse) {
  blocks::MoveAbsoluteGoal goal = moveJoints({j1, 0, 90, 0, 90, 0});
  goal.buffer_mode = static_cast<int>(mode);
  return goal;
}

inline blocks::MoveAbsoluteGoal blendedTo(double j1) {
  blocks::MoveAbsoluteGoal goal = toJoints(j1);
  goal.blending_enable = true;
  return goal;
}

/// In joint space it can be made from anywhere; where it is not possible, the third joint is too far.
inline blocks::MoveAbsoluteGoal tooFar(blocks::BufferMode mode = blocks::BufferMode::Refuse) {
  blocks::MoveAbsoluteGoal goal = toJoints(0, mode);
  goal.target[2] = 170;
  return goal;
}

class CommandPlannedBeside : public ::testing::Test {
 protected:
  CommandPlannedBeside() {
    rig.connect();
    rig.status(StatusFrames());
  }
  [[nodiscard]] bool isSent(const std::string& beginning) {
    if (rig.nothingSent()) return false;
    script = rig.takeScript();
    return script.script.rfind(beginning, 0) == 0;
  }
  blocks::Ending endingOf(blocks::GoalId id) {
    EXPECT_NE(rig.outcome(id), nullptr);
    return rig.outcome(id) == nullptr ? blocks::Ending::Rejected : rig.outcome(id)->ending;
  }
  /// The last script that was sent is accepted, its tag is back, and the robot stands there.
  void arrive(float j1) {
    rig.reply(script.id);
    rig.tag(rig.latest().open_tags.at(0));
    rig.stream(StatusFrames().at({j1, 0, 90, 0, 90, 0}));
  }

  CoreRig rig{*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, command::Planning::Beside};
  protocol::ScriptRequest script;
};

}  // namespace cobot_command::testing
