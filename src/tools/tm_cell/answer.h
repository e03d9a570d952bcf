// What a command of tm_cell found, for people or, with --json, for programs.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace cobot_command::tools {

using Clock = std::chrono::steady_clock;

/// Exit statuses.
inline constexpr int kYes = 0;
inline constexpr int kNo = 1;

/// One stage of what was done.
struct AnswerStage {
  std::string name;
  double seconds = 0.0;
  std::vector<std::string> report;
  std::vector<std::string> faults;
};

struct Answer {
  std::vector<AnswerStage> stages;

  [[nodiscard]] bool isYes() const;
};

/// A line of each thing that was found; with `json` one line with all of it. Returns the exit status.
[[nodiscard]] int print(const Answer& answer, bool json);

[[nodiscard]] double secondsSince(Clock::time_point begin);

/// Answers that one thing is wrong.
[[nodiscard]] Answer wrong(const std::string& stage, const std::string& fault);

}  // namespace cobot_command::tools
