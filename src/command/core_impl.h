// The inside of CommandCore: hands events to links and arbiter, until nothing more follows from them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arbiter/arbiter.h"
#include "board/output_board.h"
#include "connecting/link_keeper.h"
#include "dynamics/defaults_desk.h"
#include "dynamics/limits_desk.h"
#include "exchange/exchange_desk.h"
#include "exchange/motion_hold.h"
#include "exchange/motion_permit.h"
#include "forecast/forecast.h"
#include "group_desk.h"
#include "links/links.h"
#include "messages/message_desk.h"
#include "paths/path_desk.h"
#include "status_desk.h"
#include "sync/sync_desk.h"
#include "sync/sync_guard.h"
#include "tables/table_desk.h"

#include "cobot_command/command/command_core.h"
#include "cobot_command/command/speed_override.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stranger_watch.h"

namespace cobot_command::command {

class CommandCore::Impl {
 public:
  Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, CorePorts ports,
       Planning planning);

  void submit(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest);
  FinishReport finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest);
  void keepConnected(const blocks::ConnectGoal& target, Instant now);
  void retire(Instant now);
  [[nodiscard]] bool retired() const;
  void shutDown(Instant now);
  void useSettings(const link::LinkSettings& settings, Instant now);
  [[nodiscard]] TableDesk& tables() { return tables_; }
  /// What is asked of it so takes effect with the next event.
  [[nodiscard]] Arbiter& arbiter() { return arbiter_; }
  [[nodiscard]] MessageDesk& messages() { return messages_; }
  [[nodiscard]] ExchangeDesk& exchange() { return exchange_; }
  [[nodiscard]] DefaultsDesk& defaults() { return defaults_; }
  [[nodiscard]] LimitsDesk& limits() { return limits_; }
  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes, Instant now);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);
  void planned(PlanJobId id, PlanAnswer answer, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  [[nodiscard]] std::vector<Action> takeActions();

 private:
  enum class Life { Working, Retiring, Over };

  /// Handles everything that follows from an event, until nothing more does.
  void settle(Instant now);
  void takeEvents(Instant now);
  void tellOfClosedConnection(Instant now);
  /// True when that changes anything.
  bool changeConnection(Instant now);
  void watchStrangers(Instant now);
  void handle(const link::LinkChanged& event, Instant now);
  void handle(const link::LinkLost& event, Instant now);
  void handle(const link::ScriptAnswered& event, Instant now);
  void handle(const link::TagReported& event, Instant now);
  void handle(const link::TagQueryFailed& event, Instant now);
  void handle(const link::RobotStatus& status, Instant now);
  void robotChanged(Instant now);

  void warn(std::string text);

  link::LinkSettings settings_;  ///< that rule: those of the node, and what is wanted otherwise for now
  std::vector<Action> actions_;
  Links links_;
  link::TagLedger tags_;
  robot::RobotWatch robot_;
  robot::StrangerWatch strangers_;
  MessageDesk messages_;
  TableDesk tables_;
  SpeedOverride speed_;
  DefaultsDesk defaults_;
  PathDesk paths_;
  JogDesk jog_;
  OutputBoard board_;
  LinkKeeper keeper_;
  MotionHold hold_;
  Forecast forecast_;
  LimitsDesk limits_;
  SyncDesk sync_;
  SyncGuard guard_;
  ExchangeDesk exchange_;
  MotionPermit permit_;
  Arbiter arbiter_;
  StatusDesk status_;
  GroupDesk group_;
  Life life_ = Life::Working;
};

}  // namespace cobot_command::command
