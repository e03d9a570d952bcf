// Goals that wait become runs: planned when their turn comes, then begun, or taken into the chain that is
// under way, or refused.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "arbiter/core_parts.h"
#include "arbiter/goal_plans.h"
#include "arbiter/occupancy.h"
#include "arbiter/stop_desk.h"
#include "paths/path_turn.h"
#include "queue/goal_queue.h"
#include "runs/command_window.h"
#include "sending/command_sender.h"
#include "sending/set_aside.h"

#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::command {

/// What the arbiter is made of besides; all of them live longer than who has this.
struct ArbiterDesks {
  PlanDesk& planning;
  GoalQueue& queue;
  GoalPlans& plans;
  StopDesk& stops;
  CommandWindow& window;
  PathTurn& paths;
  SetAside& aside;
};

/// The run whose turn it is.
struct UnderWay {
  std::unique_ptr<blocks::Run> run;              ///< nullptr: none
  std::map<blocks::GoalId, tables::Hold> holds;  ///< of its goals
};

class Admission {
 public:
  /// All have to live longer.
  Admission(const CoreParts& parts, const ArbiterDesks& desks, const Occupancy& occupancy,
            CommandSender& sender, UnderWay& under_way)
      : parts_(parts), desks_(desks), occupancy_(occupancy), sender_(sender), under_way_(under_way) {}

  /// False: nothing waits, or it has to wait on. Precondition: no run is under way.
  bool beginNext(Instant now);
  /// The same for one that joins the chain that is under way. Precondition: a run is.
  bool joinNext(Instant now);

 private:
  /// Nothing (false) as long as it is planned.
  bool admitNext(Instant now);
  /// Its plan, or that of its only command, is being made.
  [[nodiscard]] bool isBeingPlanned(Waiting& first, Instant now);
  void admit(Waiting next, Instant now);
  void begin(const Waiting& next, const blocks::Outcome& found, Instant now);
  void join(Waiting next, const blocks::Outcome& found, Instant now);
  void beginCommand(const Waiting& next, std::unique_ptr<blocks::Run> run, Instant now);
  void refuseTurn(const Waiting& next, blocks::Outcome refusal);

  CoreParts parts_;
  ArbiterDesks desks_;
  const Occupancy& occupancy_;
  CommandSender& sender_;
  UnderWay& under_way_;
};

}  // namespace cobot_command::command
