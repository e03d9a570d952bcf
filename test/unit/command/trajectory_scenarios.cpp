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
using protocol::TagState;
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

/// One that was sent; `fault` gets the rig and the script id.
Scenario until(const std::function<void(CoreRig&, const std::string&)>& fault) {
  return [=] {
    Ready rig;
    const GoalId id = rig.submit(good<Trajectory>());
    fault(rig, rig.takeScript().id);
    return endOf(rig, id);
  };
}

Scenario overdue(const std::function<void(CoreRig&)>& answer) {
  return until([=](CoreRig& rig, const std::string& id) {
    rig.reply(id);
    for (float turned = 2.5F; rig.nothingSent(); turned = std::min(10.0F, turned + 2.5F)) {
      rig.pass(500ms);
      rig.status(StatusFrames().at({turned, 0, 90, 0, 90, 0}).moving());
    }
    rig.takeTagQuery();
    answer(rig);
  });
}

Scenarios wireScenarios() {
  return {
      {row(motion_error::kReceiveReply), until([](auto& rig, const auto&) { rig.pass(1s); })},
      {row(motion_error::kRejected), until([](auto& rig, const auto& id) { rig.reply(id, false, {1}); })},
      {row(motion_error::kLinkDropped), until(lose)},
      {row(own_error::kCommunication), until([](auto& rig, const auto&) {
         rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::Checksum});
       })},
      {row(motion_error::kReceiveTag), overdue([](CoreRig& rig) { rig.pass(1s); })},
      {row(motion_error::kMotionFailed), overdue([](CoreRig& rig) {
         rig.status(StatusFrames().at({10, 0, 90, 0, 90, 0}));
         rig.tag(1, TagState::Incomplete);
       })},
      {row(own_error::kTagLost), overdue([](CoreRig& rig) { rig.tag(1, TagState::Unknown); })},
      {row(own_error::kGoalTolerance), until([](CoreRig& rig, const std::string& id) {
         rig.reply(id);
         rig.tag(1);
         for (int i = 0; i < 2; ++i) {
           rig.status(StatusFrames().at({1, 0, 90, 0, 90, 0}));
           rig.pass(500ms);
         }
       })},
      {row(own_error::kStoppedElsewhere), until([](CoreRig& rig, const std::string& id) {
         standAt({3, 0, 90, 0, 90, 0}, rig, id);
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
  return all;
}

}  // namespace cobot_command::testing
