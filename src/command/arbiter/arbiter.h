// The arbiter of one robot: goals that come (front_desk), wait (goal_queue), have their turn (turns), are
// planned (goal_plans, next_command) or stopped (stop_desk), and what falls with whom. Here every event goes
// to those that it concerns.
#pragma once

#include <optional>
#include <string>

#include "arbiter/core_parts.h"
#include "arbiter/front_desk.h"
#include "arbiter/goal_plans.h"
#include "arbiter/interrupt_desk.h"
#include "arbiter/interruption.h"
#include "arbiter/stop_desk.h"
#include "arbiter/turns.h"
#include "dynamics/speed_desk.h"
#include "forecast/plan_desk.h"
#include "paths/feedrate_desk.h"
#include "paths/pause_desk.h"
#include "queue/goal_queue.h"
#include "runs/command_window.h"
#include "stops/stop_run.h"

#include "cobot_command/command/core_ports.h"
#include "cobot_command/command/finish.h"
#include "cobot_command/command/planning_job.h"

namespace cobot_command::command {

class Arbiter {
 public:
  Arbiter(const CoreParts& parts, CorePorts ports, Planning planning);
  Arbiter(const Arbiter&) = delete;
  Arbiter& operator=(const Arbiter&) = delete;

  // --- Goals.
  /// Executes it, has it wait, or ends it.
  void take(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
    const auto way_back = interrupts_.withPlace(goal);
    front_desk_.take(id, way_back ? *way_back : goal, now);
  }
  void cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest);
  FinishReport finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest);
  /// All are to end as CommandAborted; a robot that moves is told to stop.
  void retire(const std::string& why, Instant now);
  /// All end now, as CommandAborted.
  void shutDown(const std::string& why, Instant now);
  void planned(PlanJobId id, PlanAnswer answer) { desk_.answered(id, std::move(answer)); }

  // --- Paths.
  [[nodiscard]] std::optional<std::string> switchTracking(const TrackingSwitch& request) {
    return parts_.paths.switchTracking(request);
  }
  void setFeedrate(const FeedrateRequest& request, const FeedrateReply& reply, Instant now) {
    feedrate_.set(request, reply, now);
  }
  [[nodiscard]] InterruptDesk& interrupts() { return interrupts_; }
  void keepJogging() { parts_.jog.keepAlive(); }
  void setSpeedOverride(double percent, const OverrideReply& reply, Instant now) {
    speed_.set(percent, reply, now);
  }

  // --- Events.
  void linkLost(const std::string& reason, Instant now);
  /// There is no connection, for whatever reason: what needs none but for a try ends, too.
  void disconnected(const std::string& reason, Instant now);
  void answered(const link::ScriptAnswered& event, Instant now);
  /// False when nobody waits for that tag.
  bool tagReported(const link::TagReported& event, Instant now) { return window_.tagReported(event, now); }
  void tagQueryFailed(const link::TagQueryFailed& event, Instant now) { window_.tagQueryFailed(event, now); }
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  // --- What follows from an event, to be called behind it until nothing changes.
  /// Ends what has ended.
  void settle(Instant now);
  void watchOrphan(Instant now) { stops_.watchOrphan(now); }
  void dispatch(Instant now) {
    interruption_.look(now);
    interrupts_.look(now);
    turns_.dispatch(now);
  }
  /// Once, at the end: the next plan, and what those that wait are told.
  void proceed(Instant now);

  // --- What is there.
  /// Nothing of any goal is at the controller.
  [[nodiscard]] bool idle() const;
  /// A goal is, or waits, or something of this layer may move the robot.
  [[nodiscard]] bool underWay() const;
  /// Of what has been sent, something may still move the robot.
  [[nodiscard]] bool mayMove() const;
  /// Whatever moves may be moved by this layer.
  [[nodiscard]] bool mayBeMovedByUs() const;
  [[nodiscard]] const Turns& turns() const { return turns_; }
  [[nodiscard]] const GoalQueue& queue() const { return queue_; }
  [[nodiscard]] const StopDesk& stops() const { return stops_; }
  [[nodiscard]] const SpeedDesk& speed() const { return speed_; }
  [[nodiscard]] const SetAside& aside() const { return aside_; }

 private:
  void cancelTurn(blocks::GoalId newest, Instant now);
  void settleStops(Instant now);
  void settleBeside(Instant now);

  CoreParts parts_;
  PlanDesk desk_;
  GoalQueue queue_;
  StopRun stop_;
  CommandWindow window_;
  StopDesk stops_;
  GoalPlans plans_;
  PathTurn paths_;
  SetAside aside_;
  Turns turns_;
  PauseDesk pause_;
  FeedrateDesk feedrate_;
  SpeedDesk speed_;
  Interruption interruption_;
  InterruptDesk interrupts_;
  FrontDesk front_desk_;
};

}  // namespace cobot_command::command
