// How a command fails that is good by itself: in planning, because of the robot, or on the wire.

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using protocol::CommunicationErrorCode;
using protocol::TagState;

/// A command that was sent; `fault` gets the rig and the script id.
Outcome until(const Goal& goal, const std::function<void(CoreRig&, const std::string&)>& fault) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId id = rig.submit(goal);
  fault(rig, rig.takeScript().id);
  rig.discardSent();
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

/// The end of a goal that comes after `before`.
Outcome after(const Goal& goal, const std::function<void(CoreRig&)>& before) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  before(rig);
  const GoalId id = rig.submit(goal);
  EXPECT_NE(rig.outcome(id), nullptr);
  rig.discardSent();
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

void line(MoveAbsoluteGoal& goal, AbsoluteFormat format, double speed) {
  goal.movement_command = static_cast<int>(Movement::Line);
  goal.data_format = static_cast<int>(format);
  goal.speed = speed;
}

/// Planned on a TM arm from `joints_deg`.
Outcome plannedOn(const char* model, const std::vector<float>& joints_deg,
                  const std::function<void(MoveAbsoluteGoal&)>& change) {
  CoreRig rig(*arm::ArmModel::named(model), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames().with(protocol::item::ofFloats("Joint_Angle", joints_deg)));
  MoveAbsoluteGoal goal = CoreRig::move();
  change(goal);
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.scripts_sent, 0);
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

}  // namespace

Scenarios planningScenarios() {
  const auto row = [](int id) { return Row{Block::MoveAbsolute, id}; };
  return {
      {row(own_error::kUnreachable),
       [] {
         return plannedOn("tm5-900", {10, 15, 80, -5, 85, 20},
                          [](auto& g) { g.target = {3000, 0, 500, 180, 0, 90}; });
       }},
      {row(own_error::kPoseBits),
       [] {  // nearly stretched: with the wrist flipped the arm would have to be longer
         return plannedOn("tm5-900", {10, 15, 80, -5, 85, 20}, [](auto& g) {
           g.target = {907.1, -122.3, 145, 180, 0, 90};
           g.robot_pose_enable = true;
           g.robot_pose = {0, 2, 5};
         });
       }},
      {row(own_error::kJointLimit),
       [] {
         return plannedOn("tm5-900", {0, 0, 90, 0, 90, 0}, [](auto& g) {
           g.data_format = static_cast<int>(AbsoluteFormat::Jpp);
           g.target = {0, 0, 170, 0, 90, 0};
         });
       }},
      {row(own_error::kJointSpeed),
       [] {
         return plannedOn("tm12", {0, -40, 130, 0, 90, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 1300);
           g.target = {255.9, 143.7, 648.7, 180, 0, 90};
         });
       }},
      {row(own_error::kSingular),
       [] {
         return plannedOn("tm5-900", {0, 0, 0, 0, 0, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 10);
           g.target = {100, -200, 800, 0, 0, 90};
         });
       }},
      {row(own_error::kNotPlannable),
       [] {
         return plannedOn("tm5-900", {0, 0, 90, 0, 90, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 1);
           g.target = {90000, 0, 0, 180, 0, 90};
         });
       }},
  };
}

Scenarios readinessScenarios(const Goal& goal) {
  const auto row = [&](int id) { return Row{static_cast<Block>(goal.index()), id}; };
  return {
      {row(motion_error::kNotConnected), [=] { return after(goal, [](CoreRig&) {}); }},
      {row(motion_error::kOtherBlockBusy),
       [=] {
         return after(goal, [](CoreRig& rig) {
           rig.connect();
           rig.submit(CoreRig::move());
         });
       }},
      {row(own_error::kEmergencyStop),
       [=] {
         return after(goal, [](CoreRig& rig) {
           rig.connect();
           rig.status(StatusFrames().emergencyStop());
         });
       }},
      {row(own_error::kShutDown), [=] { return after(goal, [](CoreRig& rig) { rig.shutDown(); }); }},
  };
}

Scenarios replyScenarios(const Goal& goal) {
  const auto row = [&](int id) { return Row{static_cast<Block>(goal.index()), id}; };
  const auto communicationError = [=](CommunicationErrorCode code) {
    return until(goal, [=](auto& rig, const auto&) { rig.say(protocol::CommunicationError{code}); });
  };
  return {
      {row(motion_error::kReceiveReply),
       [=] { return until(goal, [](auto& rig, const auto&) { rig.pass(1s); }); }},
      {row(motion_error::kRejected),
       [=] { return until(goal, [](auto& rig, const auto& id) { rig.reply(id, false, {1}); }); }},
      {row(motion_error::kLinkDropped),
       [=] { return until(goal, [](auto& rig, const auto&) { rig.close("gone"); }); }},
      {row(own_error::kNotListening),
       [=] { return communicationError(CommunicationErrorCode::NotListening); }},
      {row(own_error::kCommunication), [=] { return communicationError(CommunicationErrorCode::Checksum); }},
      {row(own_error::kRobotError),
       [=] {
         return until(goal, [](auto& rig, const auto&) { rig.status(StatusFrames().error(1, "IK")); });
       }},
  };
}

Scenarios motionScenarios(const Goal& goal) {
  const auto row = [&](int id) { return Row{static_cast<Block>(goal.index()), id}; };
  const auto overdue = [=](const std::function<void(CoreRig&)>& answer) {
    return until(goal, [=](CoreRig& rig, const std::string& id) {
      rig.reply(id);
      for (int i = 0; i < 600; ++i) {
        rig.pass(500ms);
        rig.status(StatusFrames());
      }
      rig.takeTagQuery();
      answer(rig);
    });
  };
  return {
      {row(motion_error::kReceiveTag), [=] { return overdue([](CoreRig& rig) { rig.pass(1s); }); }},
      {row(motion_error::kMotionFailed),
       [=] { return overdue([](CoreRig& rig) { rig.tag(1, TagState::Incomplete); }); }},
      {row(own_error::kTagLost),
       [=] { return overdue([](CoreRig& rig) { rig.tag(1, TagState::Unknown); }); }},
      {row(own_error::kStopNotConfirmed),
       [=] {
         CoreRig rig;
         rig.connect();
         const GoalId id = rig.submit(goal);
         rig.takeScript();
         rig.cancel(id);
         rig.takeScript();
         rig.pass(1s);
         return *rig.outcome(id);
       }},
  };
}

}  // namespace cobot_command::testing
