// The command core of one robot: goals and bytes in, frames and outcomes out.
//
// It owns the link, the blocks and the arbiter. No socket, no thread, no clock: whoever drives it hands in
// events with the time and carries out the actions. Not thread-safe: one thread owns it. Every goal gets
// exactly one GoalEnded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/core_ports.h"
#include "cobot_command/command/dynamics.h"
#include "cobot_command/command/exchange_answer.h"
#include "cobot_command/command/exchange_rules.h"
#include "cobot_command/command/finish.h"
#include "cobot_command/command/interruption.h"
#include "cobot_command/command/path_requests.h"
#include "cobot_command/command/planning_job.h"
#include "cobot_command/command/speed_override.h"
#include "cobot_command/command/table_write.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/connection.h"

namespace cobot_command::command {

class CommandCore {
 public:
  /// `arm`: the model for planning and checks; without one, moves are sent unplanned. `planning`: who plans
  /// what may take long.
  CommandCore(std::optional<arm::ArmModel> arm, link::LinkSettings settings, CorePorts ports = {},
              Planning planning = Planning::AtOnce);
  ~CommandCore();
  CommandCore(CommandCore&&) noexcept;
  CommandCore& operator=(CommandCore&&) noexcept;

  // --- Goals.
  void submit(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  /// The falling edge of Execute while Busy. A goal that has ended already is left alone. With what is under
  /// way all that came until then falls. `newest`: the newest goal when the cancel was asked for; nothing:
  /// that of now.
  void cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest = {});
  /// Ends what is under way in its own time, without a stop: a move is finished and Done; a pick and place
  /// ends behind its move as CommandAborted, behind its cycle as Done; a wait for an input ends at once, or
  /// waits on. What waits ends as CommandAborted.
  /// What is being stopped already is stopped. Returns what was found; FinishReport::foundAny() tells whether
  /// there was anything, without which nothing has changed. `newest`: as with cancel().
  FinishReport finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest = {});
  /// Keeps a link by itself whenever no connect goal is Busy: tries for ever, and again after each loss. A
  /// cancelled connect goal ends that too. Precondition: the target is what a connect goal may be.
  void keepConnected(const blocks::ConnectGoal& target, Instant now);
  /// Begins the end: no goal is taken any more, but for a stop and a pause, what waits ends, and a robot that
  /// moves is told to stop. What is under way ends as CommandAborted when the robot stands. The connections
  /// are kept for that.
  void retire(Instant now);
  /// Nothing is under way any more, and no stop waits for its answer.
  [[nodiscard]] bool retired() const;
  /// Ends everything: open goals as CommandAborted, connections closed. Nothing is sent to the robot
  /// afterwards. Call retire() first, and wait a little, so that the stop is heard.
  void shutDown(Instant now);

  /// Other deadlines, periods and limits from now on, also while connected. A deadline that runs already
  /// stays; a lifesign that would come later than the new period says comes sooner. Limits (tolerances,
  /// misses) count at once. A link that is up keeps its status port; `first_tag` and `planning_budget` stay
  /// as they were. Precondition: all are in the ranges of the node's parameters (doc/parameters.md).
  void useSettings(const link::LinkSettings& settings, Instant now);

  /// All tables at once, as they were kept; for the start.
  void useTables(tables::DataTables tables);
  /// Writes an entry, if it may be what it is to be and nobody uses it; else nothing changes.
  [[nodiscard]] TableAnswer writeTable(const TableWrite& write);
  /// What that would answer now; for who has to keep the tables before they rule.
  [[nodiscard]] TableAnswer tryTable(const TableWrite& write) const;

  /// A tracking object, which holds paths back that want it otherwise. Nothing: it is so now; else why not.
  [[nodiscard]] std::optional<std::string> switchTracking(const TrackingSwitch& request, Instant now);

  /// How fast the time of paths runs, or whether they stand. It outlives goals. What is not sent goes at the
  /// new one, what is at the controller keeps its own. `reply`: called once, at once or later.
  void setFeedrate(const FeedrateRequest& request, const FeedrateReply& reply, Instant now);

  /// What the node wants of the interface; for the next goal of exchange_configuration, and at once where it
  /// is required.
  void useExchangeRules(const ExchangeRules& rules);

  /// 0..100 %: for what is planned and sent from now on; 0 holds the robot. `reply`: called once, at once or
  /// later.
  void setSpeedOverride(double percent, const OverrideReply& reply, Instant now);
  /// For goals that come from now on.
  [[nodiscard]] DynamicsAnswer writeDefaults(const blocks::DefaultDynamics& defaults);
  [[nodiscard]] const blocks::DefaultDynamics& defaults() const;
  /// Nothing without a model.
  [[nodiscard]] std::optional<ReferenceDynamics> referenceDynamics() const;
  /// Between which angles every motion is planned, if nothing is under way; else nothing changes.
  [[nodiscard]] DynamicsAnswer writeLimits(const SoftwareLimits& limits, Instant now);
  /// Nothing without a model.
  [[nodiscard]] std::optional<LimitsReport> limits() const;

  /// Stops what is under way, and keeps it with all that waits, to go on later. `reply`: called once, at once
  /// or when the robot stands.
  void interrupt(const InterruptReply& reply, Instant now);
  /// What was interrupted goes on, if the robot is where it was. `reply`: called once, at once.
  void goOn(const InterruptReply& reply, Instant now);

  /// Somebody holds the jog that is under way; without one nothing comes of it.
  void keepJogging(Instant now);

  /// Other settings for the exchange_configuration goal that is enabled, as the goal itself cannot change.
  [[nodiscard]] ExchangeAnswer updateExchange(const blocks::ExchangeSettings& settings, Instant now);

  // --- Messages.
  /// Acknowledges all errors and warnings that are pending. Not those of the controller as long as it shows
  /// an error: that cannot be cleared from here.
  ResetAnswer reset(Instant now);
  /// A goal ended that never came to the core.
  void tellEnd(blocks::Block block, const blocks::Outcome& outcome, Instant now);
  /// Of the last hundred, those of that severity and above behind that id, in their order.
  [[nodiscard]] std::vector<Message> messages(Severity least, std::uint32_t after_id) const;

  // --- Connections.
  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes, Instant now);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);

  /// The answer to PlanAsked. One that nobody waits for any more is left alone.
  void planned(PlanJobId id, PlanAnswer answer, Instant now);

  // --- Time.
  void advance(Instant now);
  /// When advance() has to be called at the latest; nothing while there is nothing to wait for.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  [[nodiscard]] std::vector<Action> takeActions();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::command
