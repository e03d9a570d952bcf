// Asks the controller for the values of its project, and gives it ours: one script at a time, in between
// those of goals, which it waits for.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/link/script_link.h"
#include "cobot_command/robot/read_ledger.h"

namespace cobot_command::command {

class ProjectLine {
 public:
  /// Ours were not taken, and why.
  struct NotWritten {
    std::string reason;
  };
  struct Written {};
  using Result = std::variant<robot::ReadOutcome, Written, NotWritten>;

  /// Both have to live longer.
  ProjectLine(link::ScriptLink& script, const link::LinkSettings& settings)
      : script_(script), settings_(settings) {}

  /// A script can go out now: none of this line, and no other one, is unanswered.
  [[nodiscard]] bool isFree() const;
  [[nodiscard]] bool isReading() const { return ledger_.waiting(); }
  /// Preconditions of both: isFree(); not empty.
  void read(std::vector<script::AttributeRead> reads, Instant now);
  void write(const std::vector<script::AttributeWrite>& writes, Instant now);
  /// What is still to come is nobody's.
  void forget();

  // --- Events. The first two: whether it was for this line.
  bool take(const protocol::ListenData& data) { return ledger_.take(data); }
  bool take(const link::ScriptAnswered& answered);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return ledger_.nextDeadline(); }

  /// What has come of the last one, once.
  [[nodiscard]] std::optional<Result> takeResult() { return std::exchange(result_, std::nullopt); }

 private:
  link::ScriptLink& script_;
  const link::LinkSettings& settings_;
  robot::ReadLedger ledger_;
  std::optional<std::string> writing_;  ///< the id of that script
  int marks_ = 0;
  std::optional<Result> result_;
};

}  // namespace cobot_command::command
