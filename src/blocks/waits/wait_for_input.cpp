#include "cobot_command/blocks/waits/wait_for_input.h"

#include <cstddef>
#include <utility>

#include "shared/parameter_checks.h"
#include "waits/queue_wait.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

class InputWait final : public QueueWait {
 public:
  InputWait(GoalId id, WaitForInputGoal goal)
      : QueueWait(kBlock<WaitForInputGoal>, id), goal_(std::move(goal)) {}

 private:
  [[nodiscard]] std::string name() const override {
    return fmt::format("input {} of {}", goal_.input, goal_.module);
  }

  [[nodiscard]] Progress progress(Instant /*now*/) const override {
    Progress progress;
    progress.text =
        isHeld() ? fmt::format("waits for {}; the timeout does not run while the robot is paused", name())
                 : fmt::format("waits for {} to be {}", name(), goal_.value ? "on" : "off");
    return progress;
  }

  [[nodiscard]] std::optional<bool> levelIn(const link::RobotStatus& status) const {
    const auto index = static_cast<std::size_t>(goal_.input);
    const bool on_box = script::ioModule(goal_.module) == script::IoModule::ControlBox;
    return on_box ? status.inputs.control_box.at(index) : status.inputs.end_module.at(index);
  }

  void look(const robot::RobotWatch& robot, Instant now) override {
    const auto level = robot.status() ? levelIn(*robot.status()) : std::nullopt;
    // A frame from before its turn may show what was before the commands in front of it.
    const bool is_new = robot.status() && robot.status()->received > beganAt();
    seen_ = seen_ || is_new;
    if (!level) {
      fail({own_error::kInputUnknown,
            robot.status() ? name() + " is not among its items" : "there is no status stream", ""},
           now);
    } else if (is_new && *level == goal_.value) {
      meet(now);
    } else {
      followHold(robot.held(), now);
    }
  }

  void timeIsOver(Instant now) override {
    fail({own_error::kInputTimedOut,
          seen_ ? fmt::format("{} was {} for {} s", name(), goal_.value ? "off" : "on", goal_.timeout)
                : fmt::format("no status frame arrived in {} s", goal_.timeout),
          ""},
         now);
  }

  WaitForInputGoal goal_;
  bool seen_ = false;  ///< in a frame of its turn
};

}  // namespace

ErrorTable WaitForInputGoal::errors() {
  return ErrorTable().turn().shared({motion_error::kNotConnected, motion_error::kLinkDropped,
                                     own_error::kShutDown, own_error::kInputInvalid, own_error::kWaitRange,
                                     own_error::kInputTimedOut, own_error::kInputUnknown});
}

GoalTraits traitsOf(const WaitForInputGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  return traits;
}

std::vector<Failure> check(const WaitForInputGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.io("input", goal.module, goal.input, own_error::kInputInvalid);
  checks.require(isWithin(goal.timeout, 0, kMaxQueueWait), own_error::kWaitRange,
                 fmt::format("timeout is {} s", goal.timeout));
  return std::move(checks).violations();
}

std::unique_ptr<Run> runOf(const WaitForInputGoal& goal, GoalId id, const Outcome& /*planned*/, Instant now) {
  auto wait = std::make_unique<InputWait>(id, goal);
  wait->begin(goal.timeout > 0 ? std::optional(fromSeconds(goal.timeout)) : std::nullopt, now);
  return wait;
}

}  // namespace cobot_command::blocks
