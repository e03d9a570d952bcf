// A command core with a scripted controller at the other end: pure bytes and invented time.
//
// Every frame that the core sends on the script port has to be taken by the test (lifesigns aside, which the
// rig answers by itself as long as `answers_lifesigns` is set); what is left at the end fails the test. After
// every event the rig checks the rules that always hold: at most one output of a block at a time, one end for
// each goal, no end before its acceptance unless it is a rejection.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "one_frame.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;

class CoreRig {
 public:
  static constexpr Duration kStreamPeriod = 15ms;

  /// With Planning::Beside nothing is planned but by finishPlan().
  explicit CoreRig(std::optional<arm::ArmModel> arm = std::nullopt, link::LinkSettings settings = noStatus(),
                   command::Planning planning = command::Planning::AtOnce);
  ~CoreRig();

  [[nodiscard]] static link::LinkSettings noStatus();
  /// A good PTP CPP.
  [[nodiscard]] static blocks::MoveAbsoluteGoal move(blocks::BufferMode mode = blocks::BufferMode::Refuse);
  [[nodiscard]] static blocks::MoveAbsoluteGoal blended(double percent = 0);
  [[nodiscard]] static blocks::ConnectGoal robot();

  // --- Goals.
  blocks::GoalId submit(const blocks::Goal& goal);
  void cancel(blocks::GoalId id);
  /// A goal has come and waits in front of the core, for its frame, say; pass it on with handOn().
  blocks::GoalId come() { return ++last_goal_; }
  void handOn(blocks::GoalId id, const blocks::Goal& goal);
  void shutDown();
  /// A connect goal that is brought to Ready (and its status link opened, if there is one).
  blocks::GoalId connect();

  // --- The wire.
  [[nodiscard]] std::optional<command::OpenConnection> pendingOpen(link::Channel channel) const;
  void open(link::Channel channel = link::Channel::Script);
  void failOpen(link::OpenFailure::Kind kind, link::Channel channel = link::Channel::Script);
  void close(const std::string& reason, link::Channel channel = link::Channel::Script);
  void receive(const std::string& bytes, link::Channel channel = link::Channel::Script);
  void say(const protocol::ControllerMessage& message) { receive(protocol::encode(message)); }
  void reply(const std::string& id, bool accepted = true, std::vector<int> lines = {});
  void tag(int number, protocol::TagState state = protocol::TagState::Complete);
  void status(const std::vector<protocol::StatusItem>& items);
  /// Frames that all say this, a period of the stream apart: the first one behind an event may be of before
  /// it.
  void stream(const std::vector<protocol::StatusItem>& items, int count = 2);
  /// The stream goes on for so long, with a frame behind each period.
  void streamFor(Duration duration, const std::vector<protocol::StatusItem>& items,
                 Duration period = kStreamPeriod);

  /// The oldest frame that was sent and not yet taken; fails when it is of another kind.
  protocol::ScriptRequest takeScript();
  protocol::TagQuery takeTagQuery();
  [[nodiscard]] bool nothingSent() const { return sent_.empty(); }
  void discardSent() { sent_.clear(); }
  std::deque<protocol::ClientMessage> takeAllSent() { return std::exchange(sent_, {}); }

  // --- Plans beside the core.
  [[nodiscard]] bool isPlanning() const { return !plans_.empty(); }
  /// Makes the plan that was asked for first; answer it with answerPlan().
  command::PlanAnswer makePlan() { return plans_.front().work(); }
  void answerPlan(command::PlanAnswer answer);
  void finishPlan() { answerPlan(makePlan()); }
  /// Of what is to be sent, whatever else is planned.
  void finishPlanToSend();

  // --- Time.
  /// Lets time pass, calling advance() exactly at each deadline.
  void pass(Duration duration);

  // --- What came out.
  [[nodiscard]] bool accepted(blocks::GoalId id) const { return accepted_.count(id) != 0; }
  [[nodiscard]] const blocks::Outcome* outcome(blocks::GoalId id) const;
  [[nodiscard]] const std::vector<blocks::Progress>& progress(blocks::GoalId id) { return progress_[id]; }
  [[nodiscard]] const command::CommandStatus& latest() const { return latest_; }
  [[nodiscard]] const command::BlockOutputs& outputs(blocks::Block block) const;
  [[nodiscard]] bool connectionOpen(link::Channel channel) const { return connections_.count(channel) != 0; }

  command::Gate gate;                                                ///< empty: open
  std::shared_ptr<OneFrame> program = std::make_shared<OneFrame>();  ///< of the robot
  command::CommandCore core;
  Instant now{1000s};
  bool answers_lifesigns = true;
  bool listening = true;
  std::string listen_node = "Listen1";
  int scripts_sent = 0;
  int opens = 0;
  std::vector<command::FrameTraced> traces;
  std::vector<link::RobotStatus> robot_statuses;
  std::vector<robot::ActiveFrames> active_frames;    ///< every change
  std::vector<std::string> warnings;                 ///< of the log
  std::vector<command::Message> messages;            ///< all that were raised
  command::GroupState group_state;                   ///< as told last
  std::shared_ptr<const arm::ArmModel> limited_arm;  ///< as told last
  std::vector<command::Message> pending_messages;    ///< as told last
  std::map<std::string, arm::Pose> frames;           ///< where tf would say that they are now
  std::vector<command::CommandsFell> fell;
  std::vector<tables::DataTables> told_tables;  ///< every change
  std::vector<command::GoalPreviewed> previews;
  int planned_paths = 0;  ///< PathPlanned

  void pump();

 private:
  [[nodiscard]] command::CorePorts ports();
  struct Connection {
    link::ConnectionId id;
    bool open = false;
  };
  void take(const command::OpenConnection& action);
  void take(const command::CloseConnection& action);
  void take(const command::SendBytes& action);
  void take(const command::GoalAccepted& action);
  void take(const command::GoalProgressed& action);
  void take(const command::GoalEnded& action);
  void take(const command::CommandsFell& action);
  void take(const command::PlanAsked& action);
  void take(const command::StatusChanged& action);
  void take(const command::RobotStatusReceived& action);
  void take(const command::ActiveFramesChanged& action);
  void take(const command::TablesChanged& action);
  void take(const command::PathControlsChanged& /*action*/) {}
  void take(const command::PathPlanned& action);
  void take(const command::GoalPreviewed& action);
  void take(const command::RunTold& /*action*/) {}
  void take(const command::FrameTraced& action);
  void take(const command::LogMessage& action);
  void take(const command::MessageRaised& action) { messages.push_back(action.message); }
  void take(const command::PendingChanged& action) { pending_messages = action.pending; }
  void take(const command::GroupStateChanged& action) { group_state = action.state; }
  void take(const command::SoftwareLimitsChanged& action) { limited_arm = action.arm; }
  void answerLifesigns();

  blocks::GoalId last_goal_ = 0;
  std::map<link::Channel, Connection> connections_;
  std::map<link::Channel, command::OpenConnection> opening_;
  protocol::FrameDecoder decoder_;
  std::deque<protocol::ClientMessage> sent_;
  std::map<blocks::GoalId, bool> accepted_;
  std::map<blocks::GoalId, std::vector<blocks::Progress>> progress_;
  std::map<blocks::GoalId, blocks::Outcome> ended_;
  command::CommandStatus latest_;
  std::deque<command::PlanAsked> plans_;
};

}  // namespace cobot_command::testing
