// A retrace on its way: one PVT.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// Two places on the way that was driven.
struct RetraceWay {
  Duration from{};
  Duration to{};
};

class RetraceRun final : public Run {
 public:
  RetraceRun(GoalId goal, Command command, const RetraceWay& way);

  [[nodiscard]] std::optional<Command> next() const override;
  void commandStarted(CommandKey /*key*/) override { is_sent_ = true; }
  void commandProgressed(CommandKey /*key*/, const Progress& progress, Instant /*now*/) override;
  void commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant /*now*/) override;

  [[nodiscard]] std::optional<Duration> placeOnTheWay() const override;
  [[nodiscard]] GoesOn goesOn() const override { return GoesOn::Never; }
  void cancel(const std::string& why, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;

 private:
  /// Nothing of it is at the controller, and nothing will be.
  void endUnsent(Outcome outcome);

  Command command_;
  RetraceWay way_;
  double share_ = 0;  ///< of the way that is gone, by the time
  bool is_sent_ = false;
};

}  // namespace cobot_command::blocks
