// The command core of one robot. Its inputs are goals and received bytes, its outputs are frames and
// outcomes.
//
// It owns the link, the blocks and the arbiter. It has no socket, no thread and no clock: its driver passes
// in events with the time, and carries out the actions. Not thread-safe: one thread owns it. Every goal gets
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
  /// `arm`: the model for planning and checks; without a model, moves are sent unplanned. `planning`: who
  /// makes the plans that may take long.
  CommandCore(std::optional<arm::ArmModel> arm, link::LinkSettings settings, CorePorts ports = {},
              Planning planning = Planning::AtOnce);
  ~CommandCore();
  CommandCore(CommandCore&&) noexcept;
  CommandCore& operator=(CommandCore&&) noexcept;

  // --- Goals.
  void submit(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  /// The falling edge of Execute while Busy. A goal that has already ended is ignored. If the goal is
  /// running, all goals received up to then end too. `newest`: the newest goal when the cancel was requested;
  /// nullopt: the newest goal now.
  void cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest = {});
  /// Ends the running goal without a stop. A move is completed and ends as Done. pick_and_place and
  /// run_program end after their move as CommandAborted, or after their cycle as Done. A wait for an input
  /// ends at once, or continues. Queued goals end as CommandAborted. A goal that is already being stopped is
  /// stopped. Returns what was found. If FinishReport::foundAny() is false, nothing has changed. `newest`: as
  /// with cancel().
  FinishReport finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest = {});
  /// Maintains a link automatically while no connect goal is Busy: it tries without end, and again after each
  /// loss. A cancelled connect goal ends this too. Precondition: the target has valid values of a connect
  /// goal.
  void keepConnected(const blocks::ConnectGoal& target, Instant now);
  /// Begins the shutdown. Only stops and pauses are accepted from now on. Queued goals end, and a moving
  /// robot is stopped. The running goal ends as CommandAborted when the robot is at standstill. The
  /// connections are kept for this.
  void retire(Instant now);
  /// True: nothing is running any more, and no stop waits for its answer.
  [[nodiscard]] bool retired() const;
  /// Ends everything: open goals as CommandAborted, connections are closed. Nothing is sent to the robot
  /// afterwards. Call retire() first, and wait briefly, so that the controller receives the stop.
  void shutDown(Instant now);

  /// Changes deadlines, periods and limits, also while connected. A running deadline stays. A heartbeat that
  /// is due later than the new period allows is sent earlier. Limits (tolerances, misses) apply at once. An
  /// open link keeps its status port. `first_tag` and `planning_budget` stay as they were. Precondition: all
  /// values are in the ranges of the node's parameters (doc/parameters.md).
  void useSettings(const link::LinkSettings& settings, Instant now);

  /// Sets all tables at once, as they were stored; for the start.
  void useTables(tables::DataTables tables);
  /// Writes an entry, if it is valid and not in use; otherwise nothing changes.
  [[nodiscard]] TableAnswer writeTable(const TableWrite& write);
  /// The present answer of writeTable(), for a caller that must store the tables before they apply.
  [[nodiscard]] TableAnswer tryTable(const TableWrite& write) const;

  /// Switches a tracking object. Paths that require another state wait. nullopt: it is switched; otherwise
  /// the reason why not.
  [[nodiscard]] std::optional<std::string> switchTracking(const TrackingSwitch& request, Instant now);

  /// Sets the feedrate, which is the time scale of paths, or pauses or resumes them. It stays when a goal
  /// ends. Points that are not sent get the new feedrate; motions at the controller keep their own. `reply`:
  /// called once, at once or later.
  void setFeedrate(const FeedrateRequest& request, const FeedrateReply& reply, Instant now);

  /// The node's rules for the interface. They apply to the next goal of exchange_configuration, and at once
  /// to whether it is required.
  void useExchangeRules(const ExchangeRules& rules);

  /// 0..100 %, for everything that is planned and sent from now on; 0 pauses the robot. `reply`: called once,
  /// at once or later.
  void setSpeedOverride(double percent, const OverrideReply& reply, Instant now);
  /// For goals received from now on.
  [[nodiscard]] DynamicsAnswer writeDefaults(const blocks::DefaultDynamics& defaults);
  [[nodiscard]] const blocks::DefaultDynamics& defaults() const;
  /// nullopt: there is no arm model.
  [[nodiscard]] std::optional<ReferenceDynamics> referenceDynamics() const;
  /// Sets the joint limits of every plan, if nothing is running; otherwise nothing changes.
  [[nodiscard]] DynamicsAnswer writeLimits(const SoftwareLimits& limits, Instant now);
  /// nullopt: there is no arm model.
  [[nodiscard]] std::optional<LimitsReport> limits() const;

  /// Stops the running goal, and suspends it together with all queued goals. `reply`: called once, at once or
  /// when the robot is at standstill.
  void interrupt(const InterruptReply& reply, Instant now);
  /// Resumes the suspended goals, if the robot is where it was interrupted. `reply`: called once, at once.
  void goOn(const InterruptReply& reply, Instant now);

  /// A keep-alive for the running jog; ignored if there is none.
  void keepJogging(Instant now);

  /// Changes the settings of the enabled exchange_configuration goal, because the goal itself cannot change.
  [[nodiscard]] ExchangeAnswer updateExchange(const blocks::ExchangeSettings& settings, Instant now);

  // --- Messages.
  /// Acknowledges all pending errors and warnings. Those of the controller stay while it shows an error,
  /// which cannot be cleared from here.
  ResetAnswer reset(Instant now);
  /// Reports the end of a goal that never reached the core.
  void tellEnd(blocks::Block block, const blocks::Outcome& outcome, Instant now);
  /// Of the last hundred messages, those of at least that severity and with a later id, in order.
  [[nodiscard]] std::vector<Message> messages(Severity least, std::uint32_t after_id) const;

  // --- Connections.
  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes, Instant now);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);

  /// The answer to PlanAsked. An answer that is no longer needed is ignored.
  void planned(PlanJobId id, PlanAnswer answer, Instant now);

  // --- Time.
  void advance(Instant now);
  /// Latest time to call advance(); nullopt: there is nothing to wait for.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  [[nodiscard]] std::vector<Action> takeActions();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::command
