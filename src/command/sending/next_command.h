// The command that goes out next: its lines, and its plan, which is made beside the core when that may take
// long, and anew when the robot, or its frames, are not where they were any more. However often: its budget
// counts from the first beginning on.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "forecast/command_order.h"
#include "forecast/forecast.h"
#include "forecast/plan_desk.h"

#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/command/planning_job.h"

namespace cobot_command::command {

class NextCommand {
 public:
  /// Where a command starts that goes out now.
  using OriginNow = std::function<Origin(Instant now)>;
  /// All have to live longer.
  NextCommand(const link::LinkSettings& settings, const Forecast& forecast, PlanDesk& desk, OriginNow origin)
      : settings_(settings), forecast_(forecast), desk_(desk), origin_(std::move(origin)) {}

  enum class State {
    Planning,  ///< to be looked at again behind the next event
    Refused,   ///< see failure()
    Ready      ///< see order()
  };
  /// Of a command of that goal, now.
  [[nodiscard]] State look(const blocks::Command& command, blocks::GoalId goal, Instant now);
  /// Nothing, unless look() said Refused.
  [[nodiscard]] const std::optional<blocks::Failure>& failure() const { return failure_; }
  /// As it goes out, without a tag. Precondition: look() said Ready, in this event.
  [[nodiscard]] CommandOrder& order() { return order_; }
  /// Its goal has ended, or the command is out.
  void forget();

 private:
  /// For the plan of one command; the answer for another one is for nobody.
  struct Asked {
    blocks::GoalId goal = 0;
    blocks::CommandKey key = 0;
    Instant first;         ///< when a plan of it was asked for first
    double speed_share{};  ///< that it is planned with
    bool answered = false;
    std::shared_ptr<PlannedCommand> planned = nullptr;  ///< nothing in the answer: it took too long
  };

  [[nodiscard]] bool isAsked(const blocks::Command& command, blocks::GoalId goal) const;
  [[nodiscard]] State make(const blocks::Command& command, blocks::GoalId goal, Instant first, Instant now);
  void ask(const Asked& asked, const Origin& origin, Instant now);
  [[nodiscard]] State take(PlannedCommand& planned, const Origin& now);
  [[nodiscard]] State refuse(blocks::Failure failure);

  const link::LinkSettings& settings_;
  const Forecast& forecast_;
  PlanDesk& desk_;
  OriginNow origin_;
  CommandOrder order_;
  std::optional<blocks::Failure> failure_;
  std::optional<Asked> asked_;
};

}  // namespace cobot_command::command
