// A script that stops the robot by itself: where that leaves it nobody can foresee, so its end asks for none.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

constexpr const char* kAside = "PTP(\"JPP\",60,0,90,0,90,0,30,300,0,false)";
constexpr const char* kStop = "StopAndClearBuffer()";

std::vector<std::optional<arm::ArmModel>> withAndWithoutAModel() {
  return {*arm::ArmModel::named("tm5-900"), std::nullopt};
}

/// How a script of these lines ends of which the tag comes when the robot stands at J1 = 30 deg.
Outcome standingHalfWay(const std::vector<std::string>& lines, const std::optional<arm::ArmModel>& model) {
  CoreRig rig(model, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  RunScriptGoal goal;
  for (const std::string& line : lines) goal.script += line + "\n";
  goal.await_motion = true;
  const GoalId id = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().moving());
  rig.tag(rig.latest().open_tags.at(0));
  for (int i = 0; i < 40; ++i) {
    rig.pass(CoreRig::kStreamPeriod);
    rig.status(StatusFrames().at({30, 0, 90, 0, 90, 0}));
  }
  rig.discardSent();
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

TEST(ScriptWithAStop, isDoneWhereverItStandsThen) {
  for (const auto& model : withAndWithoutAModel()) {
    for (const auto& lines : {std::vector<std::string>{kAside, kStop}, {kAside, kStop, "ChangeLoad(1)"}}) {
      const Outcome outcome = standingHalfWay(lines, model);
      EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
    }
  }
}

TEST(ScriptWithAStop, hasTheTargetOfTheMotionBehindTheStop) {
  for (const auto& model : withAndWithoutAModel()) {
    for (const auto& lines : {std::vector<std::string>{kStop, kAside}, {kAside, kStop, kAside}}) {
      const Outcome outcome = standingHalfWay(lines, model);
      EXPECT_EQ(outcome.ending, Ending::Aborted);
      EXPECT_EQ(outcome.error_id, own_error::kNotAtTarget);
    }
  }
}

}  // namespace
}  // namespace cobot_command::testing
