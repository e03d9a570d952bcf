// A goal that is one command, on its way.
#pragma once

#include <string>
#include <utility>

#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

class SingleCommand final : public Run {
 public:
  SingleCommand(GoalId goal, Command command) : Run(command.block, goal), command_(std::move(command)) {}

  [[nodiscard]] bool isOneCommand() const override { return true; }
  [[nodiscard]] std::optional<Command> next() const override {
    return sent_ ? std::nullopt : std::make_optional(command_);
  }
  void commandStarted(CommandKey /*key*/) override { sent_ = true; }
  void commandProgressed(CommandKey /*key*/, const Progress& progress, Instant /*now*/) override {
    report(progress);
  }
  void commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant /*now*/) override { end(outcome); }
  /// It is its command that is cancelled.
  void cancel(const std::string& /*why*/, Instant /*now*/) override {}

 private:
  Command command_;
  bool sent_ = false;
};

}  // namespace cobot_command::blocks
