#include "ways_back/retrace_run.h"

#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::blocks {

RetraceRun::RetraceRun(GoalId goal, Command command, const RetraceWay& way)
    : Run(command.block, goal), command_(std::move(command)), way_(way) {}

std::optional<Command> RetraceRun::next() const {
  return is_sent_ || outcome() ? std::nullopt : std::make_optional(command_);
}

void RetraceRun::commandProgressed(CommandKey /*key*/, const Progress& progress, Instant /*now*/) {
  share_ = progress.fraction;
  report(progress);
}

void RetraceRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant /*now*/) {
  if (outcome.ending == Ending::Done) share_ = 1;
  end(outcome);
}

std::optional<Duration> RetraceRun::placeOnTheWay() const {
  return way_.from + fromSeconds(share_ * toSeconds(way_.to - way_.from));
}

/// What is sent ends with its command.
void RetraceRun::endUnsent(Outcome outcome) {
  if (!is_sent_ && !this->outcome()) end(std::move(outcome));
}

void RetraceRun::cancel(const std::string& why, Instant /*now*/) {
  endUnsent(commandAborted(why + "; no motion was running"));
}

void RetraceRun::linkLost(const std::string& reason, std::optional<Duration> /*patience*/, Instant /*now*/) {
  endUnsent(toOutcome(block(), Ending::Aborted, {motion_error::kLinkDropped, reason, ""}));
}

void RetraceRun::robotChanged(const robot::RobotWatch& robot, Instant /*now*/) {
  if (robot.emergencyStop()) endUnsent(toOutcome(block(), Ending::Aborted, emergencyStop()));
  if (robot.inError()) endUnsent(toOutcome(block(), Ending::Aborted, robotError(robot)));
}

}  // namespace cobot_command::blocks
