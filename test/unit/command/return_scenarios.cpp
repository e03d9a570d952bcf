// How ways back to where the robot was interrupted are refused, and fail.

#include <array>
#include <string>
#include <vector>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ReturnGoal = ReturnToPrimaryGoal;

Row row(int id) {
  return {kBlock<ReturnGoal>, id};
}

Scenario planned(const char* model, const std::vector<float>& from, const ReturnGoal& goal) {
  return [=] {
    CoreRig rig(*arm::ArmModel::named(model), link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames().at(from).with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0})));
    return endOf(rig, rig.submit(goal));
  };
}

template <class Change>
Scenario withGoal(const Change& change) {
  return planned("tm5-900", {0, 0, 90, 0, 90, 0}, with<ReturnGoal>(change));
}

/// A line from there by so much.
Scenario line(const char* model, const SixValues& from, const std::array<double, 3>& offset_mm, double speed,
              double turn_deg = 0) {
  const ReturnGoal goal = with<ReturnGoal>([&](auto& g) {
    auto pose =
        arm::toControllerPose(arm::forwardKinematics(*arm::ArmModel::named(model), arm::toJointVector(from)));
    for (std::size_t i = 0; i < 3; ++i) pose[i] += offset_mm[i];
    pose[5] += turn_deg;
    g.trajectory_mode = static_cast<int>(ReturnTrajectory::Linear);
    g.place->interrupted.tcp = arm::toPose(pose);
    g.speed = speed;
  });
  return planned(model, std::vector<float>(from.begin(), from.end()), goal);
}

Scenario differing(int id) {
  return withGoal([id](auto& g) { g.place->difference = Failure{id, "it is another one", ""}; });
}

Scenarios goalScenarios() {
  return {
      {row(own_error::kInterruption), withGoal([](auto& g) { g.place.reset(); })},
      {row(return_error::kReturnMode), withGoal([](auto& g) { g.return_mode = 1; })},
      {row(return_error::kTrajectoryMode), withGoal([](auto& g) { g.trajectory_mode = 0; })},
      {row(return_error::kTooFar), withGoal([](auto& g) { g.distance_limit = 92; })},
      {row(return_error::kToolDiffers), differing(return_error::kToolDiffers)},
      {row(return_error::kLoadDiffers), differing(return_error::kLoadDiffers)},
      {row(return_error::kFrameDiffers), differing(return_error::kFrameDiffers)},
      {row(motion_error::kSpeedRangePercent), withGoal([](auto& g) { g.speed = 100.5; })},
      {row(own_error::kNotFinite), withGoal([](auto& g) { g.distance_limit = kNan; })},
      {row(own_error::kCoordinateRange), withGoal([](auto& g) { g.distance_limit = -1; })},
      {row(own_error::kJointLimit), withGoal([](auto& g) {
         g.place->interrupted.joints = arm::toJointVector({0, 0, 170, 0, 90, 0});
       })},
  };
}

/// In a base of the project that nobody has told the value of.
Outcome inAnUnknownBase() {
  CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  rig.submit(with<ChangeBaseGoal>([](auto& g) { g.base_name = "Table"; }));
  rig.reply(rig.takeScript().id);
  return endOf(rig, rig.submit(with<ReturnGoal>([](auto& g) { g.trajectory_mode = 1; })));
}

Scenarios planScenarios() {
  constexpr SixValues kHome{0, 0, 90, 0, 90, 0};
  return {
      {row(own_error::kUnreachable), line("tm5-900", kHome, {0, 0, -2000}, 10)},
      {row(own_error::kPoseBits), line("tm5-900", {10, 15, 80, -5, 85, 20}, {3000, 0, 0}, 10)},
      {row(own_error::kJointSpeed), line("tm12", {0, -40, 130, 0, 90, 0}, {0, 300, 0}, 100)},
      {row(own_error::kSingular), line("tm5-900", {0, 0, 0, 0, 0, 0}, {100, 0, -100}, 1)},
      {row(own_error::kAmbiguousTurn), line("tm5-900", kHome, {0, 0, -50}, 10, 180)},
      {row(own_error::kBaseUnknown), inAnUnknownBase},
      {row(own_error::kPlanningBudget),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, command::Planning::Beside);
         rig.connect();
         rig.status(StatusFrames().with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0})));
         const GoalId id = rig.submit(with<ReturnGoal>([](auto& g) { g.trajectory_mode = 1; }));
         rig.pass(10s);
         return endOf(rig, id);
       }},
  };
}

}  // namespace

Scenarios returnScenarios() {
  Scenarios all = goalScenarios();
  all.merge(planScenarios());
  const Goal goal = good<ReturnGoal>();
  all.merge(stopScenarios(goal));
  all.merge(linkScenarios(goal));
  all.merge(replyScenarios(goal));
  all.merge(motionScenarios(goal));
  Scenarios turn = turnScenarios(goal);
  turn.erase(row(own_error::kQueueFull));  // it does not wait
  all.merge(turn);
  return all;
}

}  // namespace cobot_command::testing
