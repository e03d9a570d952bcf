// What is wrong with the parameters of a goal: the checks that several blocks share, and the list that all
// of them fill.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_traits.h"
#include "cobot_command/blocks/shared/goal_values.h"

namespace cobot_command::blocks {

/// False for NaN too.
[[nodiscard]] inline bool isWithin(double value, double lowest, double highest) {
  return value >= lowest && value <= highest;
}

/// Of a tool, or of a load, in kg; whether the arm carries both is told when they come together.
inline constexpr double kMaxWeight = 14;
/// Of what is repeated; 0 for ever.
inline constexpr int kMaxCycles = 1000000;

/// What command_id 0 does where there is no queue tag.
inline constexpr const char* kNoCommandId = "gives none";

class ParameterChecks {
 public:
  void require(bool satisfied, int error_id, std::string found);

  /// 0 or 2..9. `zero`: what 0 does.
  void commandId(int command_id, const char* zero);
  void bufferMode(int buffer_mode);
  /// Finite, and no larger than any arm of the family could mean. `field` as the caller knows it.
  void sixValues(const char* field, const SixValues& values);
  /// The number of an output or input: each module has as many of both. `error_id`: when there is none.
  void io(const char* field, const std::string& module, int number, int error_id);
  /// The name of a base or TCP in the controller's project.
  void name(const char* field, const std::string& name);

  /// In the order of the tables, which is that of the ids.
  [[nodiscard]] std::vector<Failure> violations() &&;

 private:
  std::vector<Failure> failures_;
};

}  // namespace cobot_command::blocks
