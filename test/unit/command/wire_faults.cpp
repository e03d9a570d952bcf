#include "wire_faults.h"

#include "status_frames.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {

using namespace std::chrono_literals;

blocks::Outcome endOf(CoreRig& rig, blocks::GoalId id) {
  rig.discardSent();
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? blocks::Outcome{} : *rig.outcome(id);
}

void lose(CoreRig& rig, const std::string& /*script_id*/) {
  rig.close("gone");
  rig.pass(500ms);
}

void tellTheEndTooEarly(CoreRig& rig, const std::string& script_id) {
  rig.reply(script_id);
  rig.tag(1);
  for (int i = 0; i < 2; ++i) {
    rig.status(StatusFrames().moving());
    rig.pass(500ms);
  }
}

void standAt(const std::vector<float>& joints_deg, CoreRig& rig, const std::string& script_id) {
  rig.reply(script_id);
  rig.status(StatusFrames().moving());
  while (rig.nothingSent()) {
    rig.pass(100ms);
    rig.status(StatusFrames().at(joints_deg));
  }
  rig.takeTagQuery();
  rig.tag(1, protocol::TagState::Unknown);
}

}  // namespace cobot_command::testing
