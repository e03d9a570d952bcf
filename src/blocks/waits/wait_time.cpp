#include "cobot_command/blocks/waits/wait_time.h"

#include <utility>

#include "shared/parameter_checks.h"
#include "waits/queue_wait.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

/// Between two reports of what is left of the time, with the frames of the status stream.
constexpr Duration kTellEvery = std::chrono::milliseconds(100);

class TimeWait final : public QueueWait {
 public:
  TimeWait(GoalId id, const WaitTimeGoal& goal) : QueueWait(kBlock<WaitTimeGoal>, id), time_(goal.time) {}

 private:
  [[nodiscard]] std::string name() const override { return fmt::format("{} s to be over", time_); }

  [[nodiscard]] Progress progress(Instant now) const override {
    Progress progress;
    progress.remaining = remaining(now);
    progress.text =
        isHeld() ? "the time does not run while the robot is paused" : fmt::format("waits for {}", name());
    return progress;
  }

  void look(const robot::RobotWatch& robot, Instant now) override {
    // A robot that was held, and of which nothing is told any more, counts as held still.
    if (robot.status() || !isHeld()) followHold(robot.held(), now);
    if (!isHeld() && now - toldAt() >= kTellEvery) tell(now);
  }

  void timeIsOver(Instant now) override { meet(now); }

  double time_;  ///< [s]
};

}  // namespace

ErrorTable WaitTimeGoal::errors() {
  return ErrorTable()
      .turn()
      .shared({motion_error::kNotConnected, motion_error::kLinkDropped, own_error::kShutDown})
      .row(wait_error::kTime, "Time range: 0~86400 s", kSetInRange,
           "the time is negative, above 86400, or not a number");
}

GoalTraits traitsOf(const WaitTimeGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.awaits_rest = true;
  return traits;
}

std::vector<Failure> check(const WaitTimeGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.require(isWithin(goal.time, 0, kMaxQueueWait), wait_error::kTime,
                 fmt::format("time is {} s", goal.time));
  return std::move(checks).violations();
}

std::unique_ptr<Run> runOf(const WaitTimeGoal& goal, GoalId id, const Outcome& /*planned*/, Instant now) {
  auto wait = std::make_unique<TimeWait>(id, goal);
  wait->begin(fromSeconds(goal.time), now);
  return wait;
}

}  // namespace cobot_command::blocks
