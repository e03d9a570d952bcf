// The inside of CommandCore: hands events to the links and the runs, goals to their blocks, and decides who
// may execute (the arbiter: one command at a time, others are refused).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "connect_run.h"
#include "motion_run.h"
#include "output_board.h"
#include "preflight.h"
#include "robot_watch.h"

#include "cobot_command/blocks/command_core.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/status_link.h"
#include "cobot_command/link/tag_ledger.h"

namespace cobot_command::blocks {

class CommandCore::Impl : private link::Wire {
 public:
  Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings);

  void submit(GoalId id, const Goal& goal, Instant now);
  void cancel(GoalId id, Instant now);
  void shutDown(Instant now);
  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes, Instant now);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  [[nodiscard]] std::vector<Action> takeActions();

 private:
  // --- Wire, for the links.
  link::ConnectionId open(link::Channel channel, const std::string& host, int port,
                          Duration timeout) override;
  void close(link::ConnectionId id) override;
  void send(link::ConnectionId id, std::string bytes) override;
  void trace(Instant now, link::Channel channel, bool sent, std::string_view bytes,
             std::string meaning) override;

  // --- Goals (core_goals.cpp).
  void execute(GoalId id, const ConnectGoal& goal, Instant now);
  void execute(GoalId id, const MoveAbsoluteGoal& goal, Instant now);
  /// Why no command may be executed now, whatever it is; in table order.
  [[nodiscard]] std::vector<Failure> checkReadiness() const;
  void start(MotionOrder order, Instant now);

  // --- Events (core_events.cpp).
  void settle(Instant now);
  void handle(const link::LinkChanged& event, Instant now);
  void handle(const link::LinkLost& event, Instant now);
  void handle(const link::ScriptAnswered& event, Instant now);
  void handle(const link::TagReported& event, Instant now);
  void handle(const link::TagQueryFailed& event, Instant now);
  void handle(const link::RobotStatus& status, Instant now);
  void publishStatus();
  void log(Severity severity, std::string text);

  link::LinkSettings settings_;
  std::vector<Action> actions_;
  link::ConnectionId last_connection_ = 0;
  link::ScriptLink script_;
  link::StatusLink status_;
  link::TagLedger tags_;
  RobotWatch robot_;
  Preflight preflight_;
  OutputBoard board_;
  ConnectRun connect_;
  std::optional<MotionRun> run_;
  bool shut_down_ = false;
  std::uint64_t late_events_ = 0;
  CommandStatus published_;
};

}  // namespace cobot_command::blocks
