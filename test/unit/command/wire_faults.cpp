#include "wire_faults.h"

#include "block_goals.h"
#include "status_frames.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {

using namespace std::chrono_literals;

namespace {

/// Of the command that was sent last.
void tellTag(CoreRig& rig, protocol::TagState state = protocol::TagState::Complete) {
  rig.tag(rig.latest().open_tags.at(0), state);
}

}  // namespace

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
  tellTag(rig);
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
  tellTag(rig, protocol::TagState::Unknown);
}

void driveAPath(CoreRig& rig, float begin, blocks::Execution execution) {
  rig.stream(StatusFrames().at({begin, 0, 90, 0, 90, 0}));
  rig.submit(with<blocks::LoadPathGoal>([execution](auto& g) {
    g.path = {pathPoint({0, 0, 90, 0, 90, 0})};
    g.number_of_moves = 1;
    g.execution = static_cast<int>(execution);
    if (execution == blocks::Execution::Script) g.path[0].speed = 1.8;  // 1 %
    g.allow_approximation = true;
  }));
  while (rig.isPlanning()) rig.finishPlan();
  rig.reply(rig.takeScript().id);
  tellTag(rig);
  rig.stream(StatusFrames());
}

Scenario scenarioOf(const blocks::Goal& goal, const WireFault& fault) {
  return [=] {
    CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    if (blocks::blockOf(goal) == blocks::kBlock<blocks::RetraceGoal>) driveAPath(rig);
    const blocks::GoalId id = rig.submit(goal);
    fault(rig, rig.takeScript().id);
    return endOf(rig, id);
  };
}

Scenarios wireScenariosOfATurn(const blocks::Goal& goal, float end) {
  using namespace blocks;
  const auto row = [&](int id) { return Row{blockOf(goal), ownErrorId(blockOf(goal), id)}; };
  const auto overdue = [=](const std::function<void(CoreRig&)>& answer) {
    return scenarioOf(goal, [=](CoreRig& rig, const std::string& id) {
      rig.reply(id);
      for (float turned = 2.5F; rig.nothingSent(); turned = std::min(end, turned + 2.5F)) {
        rig.pass(500ms);
        rig.status(StatusFrames().at({turned, 0, 90, 0, 90, 0}).moving());
      }
      rig.takeTagQuery();
      answer(rig);
    });
  };
  return {
      {row(motion_error::kReceiveReply), scenarioOf(goal, [](auto& rig, const auto&) { rig.pass(1s); })},
      {row(motion_error::kRejected),
       scenarioOf(goal, [](auto& rig, const auto& id) { rig.reply(id, false, {1}); })},
      {row(motion_error::kLinkDropped), scenarioOf(goal, lose)},
      {row(own_error::kCommunication),
       scenarioOf(goal,
                  [](auto& rig, const auto&) {
                    rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::Checksum});
                  })},
      {row(motion_error::kReceiveTag), overdue([](CoreRig& rig) { rig.pass(1s); })},
      {row(motion_error::kMotionFailed), overdue([end](CoreRig& rig) {
         rig.streamFor(600ms, StatusFrames().at({end, 0, 90, 0, 90, 0}));
         tellTag(rig, protocol::TagState::Incomplete);
       })},
      {row(own_error::kTagLost), overdue([](CoreRig& rig) { tellTag(rig, protocol::TagState::Unknown); })},
      {row(own_error::kStoppedElsewhere), scenarioOf(goal,
                                                     [](CoreRig& rig, const std::string& id) {
                                                       standAt({3, 0, 90, 0, 90, 0}, rig, id);
                                                     })},
  };
}

}  // namespace cobot_command::testing
