// The commands that ask an artifact what it decides.
#pragma once

#include <string>
#include <vector>

#include "answer.h"

namespace cobot_command::tools {

/// Whether an event is granted behind those that have happened, each by its name, and why not.
[[nodiscard]] Answer explainEvent(const std::string& artifact_file, const std::vector<std::string>& happened,
                                  const std::string& event);
/// What the supervisors keep out of, as rules over few robots; and whether these refuse the same.
[[nodiscard]] Answer tellRules(const std::string& artifact_file);
/// The shortest way of one cycle of all robots, and who goes first where.
[[nodiscard]] Answer scheduleCell(const std::string& artifact_file, double seconds);

}  // namespace cobot_command::tools
