#include "cobot_command/blocks/wait_for_input.h"

#include <cstddef>
#include <utility>

#include "runs/wait_for_input_states.h"
#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMaxTimeout = 86400;

using Event = InputWaitEvent;
using State = InputWaitState;

class InputWait final : public Run {
 public:
  InputWait(GoalId id, WaitForInputGoal goal, Instant now)
      : Run(kBlock<WaitForInputGoal>, id), goal_(std::move(goal)), began_at_(now) {
    if (goal_.timeout > 0) deadline_ = now + fromSeconds(goal_.timeout);
    tellWhatFor();
  }

  [[nodiscard]] bool leavesTheRobot() const override { return true; }

  void cancel(const std::string& why, Instant now) override {
    words_ = why + " while it waited for " + name();
    fire(Event::Cancelled, now);
  }

  /// There is nothing that moves, so nothing to let come to its end but the wait itself.
  void finish(FinishAfter after, Instant now) override {
    if (after != FinishAfter::Move) return;
    words_ = "finished on request, while it waited for " + name();
    fire(Event::Cancelled, now);
  }

  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override {
    failure_ = {motion_error::kLinkDropped, reason, ""};
    if (patience) deadline_ = now + *patience;
    fire(patience ? Event::Unexplained : Event::Failed, now);
  }

  void robotChanged(const robot::RobotWatch& robot, Instant now) override {
    if (robot.emergencyStop()) {
      fail(emergencyStop(), now);
    } else if (robot.inError()) {
      fail(robotError(robot), now);
    } else if (state_ == State::Explaining) {
      tellStoppedProject(robot, failure_);
      if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
    } else if (state_ == State::Waiting) {
      look(robot, now);
    }
  }

  void setAside(Instant now) override { followHold(true, now); }
  void putBack(Instant now) override { followHold(false, now); }

  void advance(Instant now) override {
    if (!nextDeadline() || now < *deadline_) return;
    if (state_ == State::Waiting) failure_ = timedOut();
    fire(Event::Failed, now);
  }

  [[nodiscard]] std::optional<Instant> nextDeadline() const override {
    return state_ == State::Ended || held_since_ ? std::nullopt : deadline_;
  }

 private:
  [[nodiscard]] std::string name() const { return fmt::format("input {} of {}", goal_.input, goal_.module); }

  [[nodiscard]] std::optional<bool> levelIn(const link::RobotStatus& status) const {
    const auto index = static_cast<std::size_t>(goal_.input);
    const bool on_box = script::ioModule(goal_.module) == script::IoModule::ControlBox;
    return on_box ? status.inputs.control_box.at(index) : status.inputs.end_module.at(index);
  }

  void look(const robot::RobotWatch& robot, Instant now) {
    const auto level = robot.status() ? levelIn(*robot.status()) : std::nullopt;
    // A frame from before its turn may show what was before the commands in front of it.
    const bool is_new = robot.status() && robot.status()->received > began_at_;
    seen_ = seen_ || is_new;
    if (!level) {
      fail({own_error::kInputUnknown,
            robot.status() ? name() + " is not among its items" : "there is no status stream", ""},
           now);
    } else if (is_new && *level == goal_.value) {
      fire(Event::Seen, now);
    } else {
      followHold(robot.held(), now);
    }
  }

  /// A paused robot gives the wait its time back.
  void followHold(bool held, Instant now) {
    if (held && !held_since_) {
      held_since_ = now;
      tell(Phase::Held,
           fmt::format("waits for {}; the timeout stands still while the robot is held", name()));
    } else if (!held && held_since_) {
      if (deadline_) *deadline_ += now - *held_since_;
      held_since_.reset();
      tellWhatFor();
    }
  }

  [[nodiscard]] Failure timedOut() const {
    return {own_error::kInputTimedOut,
            seen_ ? fmt::format("{} was {} for {} s", name(), goal_.value ? "off" : "on", goal_.timeout)
                  : fmt::format("no status frame came in {} s", goal_.timeout),
            ""};
  }

  void fail(Failure failure, Instant now) {
    failure_ = std::move(failure);
    fire(Event::Failed, now);
  }

  void fire(Event event, Instant now) {
    const auto row = findTransition<InputWaitTable>(state_, event);
    if (!row) return;
    state_ = row->to;
    switch (row->action) {
      case InputWaitAction::None:
        return;
      case InputWaitAction::AwaitReason:
        held_since_.reset();
        reason_.begin(now);
        tell(Phase::Stopping, robot::ReasonWait::text("failed, " + failure_.found));
        return;
      case InputWaitAction::EndDone:
        endWith({}, now);
        return;
      case InputWaitAction::EndError:
        endWith(toOutcome(block(), Ending::Aborted, failure_), now);
        return;
      case InputWaitAction::EndAborted:
        endWith(commandAborted(words_), now);
        return;
    }
  }

  void endWith(Outcome outcome, Instant now) {
    outcome.actual = now - began_at_;
    end(std::move(outcome));
  }

  void tellWhatFor() {
    tell(Phase::Active, fmt::format("waits for {} to be {}", name(), goal_.value ? "on" : "off"));
  }

  void tell(Phase phase, std::string text) {
    Progress progress;
    progress.phase = phase;
    progress.text = std::move(text);
    report(std::move(progress));
  }

  WaitForInputGoal goal_;
  State state_ = State::Waiting;
  Instant began_at_;
  std::optional<Instant> deadline_;  ///< of the input, or of the reason of a loss
  std::optional<Instant> held_since_;
  bool seen_ = false;  ///< in a frame of its turn
  robot::ReasonWait reason_;
  Failure failure_;
  std::string words_;  ///< of an end that was asked for
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
  checks.require(isWithin(goal.timeout, 0, kMaxTimeout), own_error::kWaitRange,
                 fmt::format("timeout is {} s", goal.timeout));
  return std::move(checks).violations();
}

std::unique_ptr<Run> runOf(const WaitForInputGoal& goal, GoalId id, const Outcome& /*planned*/, Instant now) {
  return std::make_unique<InputWait>(id, goal, now);
}

}  // namespace cobot_command::blocks
