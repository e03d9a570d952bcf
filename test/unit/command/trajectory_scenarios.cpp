// How trajectories fail: by their points and plans, because of the robot, and on the wire.

#include <algorithm>
#include <functional>
#include <string>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using Trajectory = FollowJointTrajectoryGoal;

Row row(int id) {
  return {kBlock<Trajectory>, ownErrorId(kBlock<Trajectory>, id)};
}

/// Connected to a robot that stands where the good goal begins.
struct Ready : CoreRig {
  explicit Ready(Planning planning = Planning::AtOnce)
      : CoreRig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, planning) {
    connect();
    status(StatusFrames());
  }
};

template <class Change>
Scenario withGoal(const Change& change) {
  return [=] {
    Ready rig;
    return endOf(rig, rig.submit(with<Trajectory>(change)));
  };
}

Scenarios goalScenarios() {
  return {
      {row(own_error::kTrajectoryInvalid), withGoal([](auto& g) { g.points[1].time = 0; })},
      {row(own_error::kJointNames), withGoal([](auto& g) { g.names_fault = "joint_7 is none"; })},
      {row(own_error::kStampOld), withGoal([](auto& g) { g.starts_in = -2; })},
      {row(own_error::kBufferModeUnknown), withGoal([](auto& g) { g.buffer_mode = 3; })},
      {row(own_error::kNotAtStart), withGoal([](auto& g) { g.points[0].positions[3] = 0.1; })},
      {row(own_error::kJointLimit), withGoal([](auto& g) {
         g.points[2].positions[2] = 3;
         g.points[2].time = 5;
       })},
      {row(own_error::kJointSpeed), withGoal([](auto& g) { g.points[2].time = 1.03; })},
      {row(own_error::kNotPlannable), withGoal([](auto& g) { g.points[2].time = 20000; })},
      {row(own_error::kStartUnknown),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"));
         rig.connect();
         return endOf(rig, rig.submit(good<Trajectory>()));
       }},
      {row(own_error::kNoModel),
       [] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         return endOf(rig, rig.submit(good<Trajectory>()));
       }},
      {row(own_error::kPlanningBudget),
       [] {
         Ready rig(Planning::Beside);
         const GoalId id = rig.submit(good<Trajectory>());
         rig.pass(10s);
         return endOf(rig, id);
       }},
  };
}

Scenario until(const WireFault& fault) {
  return scenarioOf(good<Trajectory>(), fault);
}

Scenarios wireScenarios() {
  return {
      {row(own_error::kGoalTolerance), until([](CoreRig& rig, const std::string& id) {
         rig.reply(id);
         rig.tag(1);
         for (int i = 0; i < 2; ++i) {
           rig.status(StatusFrames().at({1, 0, 90, 0, 90, 0}));
           rig.pass(500ms);
         }
       })},
      {row(own_error::kPathTolerance), until([](CoreRig& rig, const std::string& id) {
         rig.reply(id);
         rig.stream(StatusFrames().at({0, 6, 90, 0, 90, 0}).moving());
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames().at({0, 6, 90, 0, 90, 0}));
       })},
  };
}

}  // namespace

Scenarios trajectoryScenarios() {
  Scenarios all = goalScenarios();
  all.merge(wireScenarios());
  all.merge(wireScenariosOfATurn(good<Trajectory>(), 10));
  return all;
}

}  // namespace cobot_command::testing
