// How jogs fail: by their goals and plans, because of the robot, and on the wire.

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/tables/refusal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

Row row(int id) {
  return {kBlock<JogGoal>, ownErrorId(kBlock<JogGoal>, id)};
}

/// Connected to a robot that stands there.
struct Ready : CoreRig {
  explicit Ready(const char* model = "tm5-900", const std::vector<float>& joints = {0, 0, 90, 0, 90, 0},
                 Planning planning = Planning::AtOnce, const link::LinkSettings& settings = {})
      : CoreRig(*arm::ArmModel::named(model), settings, planning) {
    connect();
    status(StatusFrames().at(joints));
  }
};

template <class Change>
Scenario withGoal(const Change& change) {
  return [=] {
    Ready rig;
    return endOf(rig, rig.submit(with<JogGoal>(change)));
  };
}

/// By an increment along or about the axes of the base.
JogGoal step(JogMode mode, std::size_t which, int direction, double mm, double deg, double speed) {
  JogGoal goal;
  goal.mode = static_cast<int>(mode);
  goal.directions[which] = direction;
  goal.increment_mm = mm;
  goal.increment_deg = deg;
  goal.speed = speed;
  goal.frame = goal.tool = JogGoal::kActive;
  return goal;
}

Scenario planned(const char* model, const std::vector<float>& from, const JogGoal& goal) {
  return [=] {
    Ready rig(model, from);
    return endOf(rig, rig.submit(goal));
  };
}

Scenarios goalScenarios() {
  return {
      {row(jog_error::kInput), withGoal([](auto& g) { g.directions[0] = 2; })},
      {row(jog_error::kTwoRotations), withGoal([](auto& g) {
         g.mode = static_cast<int>(JogMode::Frame);
         g.directions = {0, 0, 0, 1, -1, 0};
       })},
      {row(motion_error::kSpeedRangePercent), withGoal([](auto& g) { g.speed = 101; })},
      {row(own_error::kNotFinite), withGoal([](auto& g) { g.speed = kNan; })},
      {row(tables::table_error::kFrameIndex), withGoal([](auto& g) {
         g = step(JogMode::Frame, 0, 1, 10, 0, 10);
         g.frame = 16;
       })},
      {row(tables::table_error::kToolIndex), withGoal([](auto& g) {
         g = step(JogMode::Tool, 0, 1, 10, 0, 10);
         g.tool = 7;
       })},
  };
}

Scenarios planScenarios() {
  return {
      {row(own_error::kUnreachable),
       planned("tm5-900", {0, 0, 90, 0, 90, 0}, step(JogMode::Frame, 2, -1, 2000, 0, 10))},
      {row(own_error::kPoseBits),
       planned("tm5-900", {10, 15, 80, -5, 85, 20}, step(JogMode::Frame, 0, 1, 3000, 0, 10))},
      {row(own_error::kJointLimit),
       planned("tm5-900", {0, 0, 90, 0, 90, 0}, step(JogMode::Axes, 2, 1, 0, 170, 10))},
      {row(own_error::kJointSpeed),
       planned("tm12", {0, -40, 130, 0, 90, 0}, step(JogMode::Frame, 1, 1, 300, 0, 100))},
      {row(own_error::kSingular),
       planned("tm5-900", {0, 0, 0, 0, 0, 0}, step(JogMode::Frame, 2, -1, 100, 0, 1))},
      {row(own_error::kAmbiguousTurn),
       planned("tm5-900", {0, 0, 90, 0, 90, 0}, step(JogMode::Tool, 5, 1, 0, 180, 10))},
      {row(own_error::kStartUnknown),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"));
         rig.connect();
         return endOf(rig, rig.submit(good<JogGoal>()));
       }},
      {row(own_error::kNoModel),
       [] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         return endOf(rig, rig.submit(good<JogGoal>()));
       }},
      {row(own_error::kPlanningBudget),
       [] {
         Ready rig("tm5-900", {0, 0, 90, 0, 90, 0}, Planning::Beside);
         const GoalId id = rig.submit(good<JogGoal>());
         rig.pass(10s);
         return endOf(rig, id);
       }},
  };
}

Scenario behind(const std::function<void(CoreRig&)>& before) {
  return [=] {
    Ready rig;
    before(rig);
    return endOf(rig, rig.submit(good<JogGoal>()));
  };
}

Scenarios robotScenarios() {
  return {
      {row(jog_error::kMotionActive), behind([](CoreRig& rig) { rig.submit(CoreRig::move()); })},
      {row(motion_error::kNotConnected),
       [] {
         CoreRig rig;
         return endOf(rig, rig.submit(good<JogGoal>()));
       }},
      {row(own_error::kShutDown), behind([](CoreRig& rig) { rig.shutDown(); })},
      {row(own_error::kNotListening), behind([](CoreRig& rig) {
         rig.listening = false;
         rig.pass(1s);
       })},
      {row(own_error::kEmergencyStop),
       behind([](CoreRig& rig) { rig.status(StatusFrames().emergencyStop()); })},
      {row(own_error::kRobotError), behind([](CoreRig& rig) { rig.status(StatusFrames().error(1, "IK")); })},
  };
}

Scenarios wireScenarios() {
  return {
      {row(own_error::kNotAtTarget), scenarioOf(good<JogGoal>(), tellTheEndTooEarly)},
      {row(own_error::kStopNotConfirmed),
       [] {
         Ready rig;
         const GoalId id = rig.submit(good<JogGoal>());
         rig.takeScript();
         rig.cancel(id);
         rig.takeScript();
         rig.pass(3s);
         return endOf(rig, id);
       }},
  };
}

}  // namespace

Scenarios jogScenarios() {
  Scenarios all = goalScenarios();
  all.merge(planScenarios());
  all.merge(robotScenarios());
  all.merge(wireScenarios());
  all.merge(wireScenariosOfATurn(good<JogGoal>(), 9));
  return all;
}

}  // namespace cobot_command::testing
