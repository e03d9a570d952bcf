// How a command fails that is good by itself, and can be planned: because of the robot, or on the wire.

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/common/overloaded.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using protocol::CommunicationErrorCode;
using protocol::TagState;

void connect(CoreRig& rig) {
  rig.connect();
  rig.status(StatusFrames());
}

/// Under the block's own number.
Row rowOf(const Goal& goal, int general) {
  return {blockOf(goal), ownErrorId(blockOf(goal), general)};
}

Goal buffered(const Goal& goal) {
  return inMode(BufferMode::Buffered, goal);
}

/// A command that was sent; `fault` gets the rig and the script id.
Outcome until(const Goal& goal, const std::function<void(CoreRig&, const std::string&)>& fault) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  connect(rig);
  const GoalId id = rig.submit(goal);
  fault(rig, rig.takeScript().id);
  return endOf(rig, id);
}

/// The end of a goal that comes after `before`: it is refused, and nothing of it is sent.
Outcome after(const Goal& goal, const std::function<void(CoreRig&)>& before) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  before(rig);
  const int scripts = rig.scripts_sent;
  const std::vector<int> tags = rig.latest().open_tags;
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.scripts_sent, scripts);
  EXPECT_EQ(rig.latest().open_tags, tags);
  const Outcome outcome = endOf(rig, id);
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  return outcome;
}

}  // namespace

Goal inMode(BufferMode mode, Goal goal) {
  std::visit(Overloaded{[](ConnectGoal&) {}, [](ProgramControlGoal&) {}, [](StopGoal&) {},
                        [](CheckSequenceGoal&) {}, [](ExchangeConfigurationGoal&) {}, [](JogGoal&) {},
                        [](ReturnToPrimaryGoal&) {}, [](RunProgramGoal&) {},
                        [mode](auto& command) { command.buffer_mode = static_cast<int>(mode); }},
             goal);
  return goal;
}

Scenarios triedScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
  return {
      {row(motion_error::kNotConnected), [=] { return after(goal, [](CoreRig&) {}); }},
      {row(own_error::kShutDown), [=] { return after(goal, [](CoreRig& rig) { rig.shutDown(); }); }},
  };
}

Scenarios linkScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
  Scenarios scenarios = triedScenarios(goal);
  scenarios[row(own_error::kNotListening)] = [=] {
    return after(goal, [](CoreRig& rig) {
      connect(rig);
      rig.listening = false;
      rig.pass(1s);
    });
  };
  return scenarios;
}

Scenarios turnScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
  return {
      {row(motion_error::kOtherBlockBusy),
       [=] {
         return after(goal, [](CoreRig& rig) {
           connect(rig);
           rig.submit(CoreRig::move());
         });
       }},
      {row(own_error::kQueueFull),
       [=] {
         return after(buffered(goal), [](CoreRig& rig) {
           connect(rig);
           rig.submit(CoreRig::move());
           while (rig.outcome(rig.submit(CoreRig::move(BufferMode::Buffered))) == nullptr) {
           }
         });
       }},
      {row(own_error::kStopNotConfirmed),
       [=] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         connect(rig);
         rig.status(StatusFrames().moving());
         const GoalId id = rig.submit(inMode(BufferMode::Aborting, goal));
         rig.reply(rig.takeScript().id, false, {1});
         return *rig.outcome(id);
       }},
      {row(own_error::kEmergencyStop),
       [=] {
         return after(goal, [](CoreRig& rig) {
           connect(rig);
           rig.status(StatusFrames().emergencyStop());
         });
       }},
      {row(own_error::kOrphanMoves),
       [=] {
         link::LinkSettings settings;
         settings.stop_orphaned_motion = false;
         CoreRig rig(std::nullopt, settings);
         rig.submit(CoreRig::robot());
         rig.open();
         rig.open(link::Channel::Status);
         rig.status(StatusFrames().moving());
         return *rig.outcome(rig.submit(goal));
       }},
      {row(own_error::kRobotError),
       [=] {
         return after(goal, [](CoreRig& rig) {
           connect(rig);
           rig.status(StatusFrames().error(1, "IK"));
         });
       }},
  };
}

Scenarios replyScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
  const auto communicationError = [=](CommunicationErrorCode code) {
    return until(goal, [=](auto& rig, const auto&) { rig.say(protocol::CommunicationError{code}); });
  };
  return {
      {row(motion_error::kReceiveReply),
       [=] { return until(goal, [](auto& rig, const auto&) { rig.pass(1s); }); }},
      {row(motion_error::kRejected),
       [=] { return until(goal, [](auto& rig, const auto& id) { rig.reply(id, false, {1}); }); }},
      {row(motion_error::kLinkDropped), [=] { return until(goal, lose); }},
      {row(own_error::kNotListening),
       [=] { return communicationError(CommunicationErrorCode::NotListening); }},
      {row(own_error::kCommunication), [=] { return communicationError(CommunicationErrorCode::Checksum); }},
  };
}

Scenarios motionScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
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
      {row(own_error::kNotAtTarget), [=] { return until(goal, tellTheEndTooEarly); }},
      {row(own_error::kStoppedElsewhere),
       [=] {
         return until(goal, [](CoreRig& rig, const std::string& id) {
           standAt({33, 0, 90, 0, 90, 0}, rig, id);
         });
       }},
      {row(own_error::kTagLost),
       [=] { return overdue([](CoreRig& rig) { rig.tag(1, TagState::Unknown); }); }},
  };
}

Scenarios movedFrameScenarios() {
  FramedPose table = framedPose();
  table.latest = true;
  const Goal goals[] = {with<MoveAbsoluteGoal>([&](auto& g) { g.target_pose = table; }),
                        with<MoveCircleGoal>([&](auto& g) { g.arc_pose = table; }),
                        with<ChangeBaseGoal>([&](auto& g) { g.base_pose = table; })};
  Scenarios scenarios;
  for (const Goal& goal : goals) {
    scenarios[{static_cast<Block>(goal.index()), own_error::kFrameMoved}] = [=] {
      const auto standing = StatusFrames().with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0}));
      CoreRig rig(std::nullopt, link::LinkSettings{});
      rig.connect();
      rig.status(standing);
      rig.frames["table"] = arm::Pose::Identity();
      rig.submit(CoreRig::move());
      const GoalId id = rig.submit(buffered(goal));
      rig.reply(rig.takeScript().id);
      rig.tag(rig.latest().open_tags.at(0));
      rig.status(standing);
      return *rig.outcome(id);
    };
  }
  return scenarios;
}

Scenarios stopScenarios(const Goal& goal) {
  const auto row = [&](int id) { return rowOf(goal, id); };
  return {
      {row(own_error::kStopNotConfirmed),
       [=] {
         CoreRig rig;
         rig.connect();
         const GoalId id = rig.submit(goal);
         if (goal.index() != static_cast<std::size_t>(kBlock<StopGoal>)) {
           rig.takeScript();
           rig.cancel(id);
         }
         rig.takeScript();
         rig.pass(1s);
         EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
         return *rig.outcome(id);
       }},
      {row(motion_error::kLinkDropped), [=] { return until(goal, lose); }},
  };
}

}  // namespace cobot_command::testing
