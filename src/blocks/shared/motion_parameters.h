// What the parameters of the three moves have in common: data formats, speed, time, blending.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "shared/parameter_checks.h"

#include "cobot_command/common/units.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {

/// The data formats of a block, by their numbers (thesis tables 5.3.2.5, 5.3.3.5, 5.3.4.4).
class FormatList {
 public:
  template <std::size_t N>
  constexpr FormatList(const std::array<std::string_view, N>& names) : names_(names.data()), count_(N) {}

  /// Nothing for a number that is not in the list.
  [[nodiscard]] std::optional<script::DataFormat> at(int number) const;
  /// "data_format is 9 (CPP 0, CAP 1)"
  [[nodiscard]] std::string found(int number) const;

 private:
  const std::string_view* names_;
  std::size_t count_;
};

/// Of a move, as they came.
struct MotionParameters {
  int command_id = 0;
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;
  bool disable_precise_positioning = false;
  int buffer_mode = 0;
};
template <class Move>
[[nodiscard]] MotionParameters parametersOf(const Move& goal) {
  return {goal.command_id,      goal.speed,          goal.accel_time,
          goal.blending_enable, goal.blending_value, goal.disable_precise_positioning,
          goal.buffer_mode};
}

/// The ranges of what moves have, in the units of their fields; 0 is no speed.
inline constexpr double kMaxSpeedPercent = 100;
inline constexpr double kMaxSpeedMmPerSecond = mToMm(motion::kMaxTcpSpeed);
inline constexpr double kMinAccelTime = 150;
inline constexpr double kMaxAccelTime = 9999;
inline constexpr double kMaxBlendingPercent = 100;
inline constexpr double kMaxBlendingMm = 2000;

/// Unknown formats count as speed and blending in %: which format is wrong is checked elsewhere.
void checkMotion(ParameterChecks& checks, const MotionParameters& parameters,
                 const std::optional<script::DataFormat>& format);

/// PTP takes joints and poses with speed and blending in %, Line takes poses.
void checkMovement(ParameterChecks& checks, int movement_command, int data_format, const FormatList& formats,
                   int ptp_error, int line_error);

[[nodiscard]] script::MotionOptions optionsOf(const MotionParameters& parameters);

template <class Move>
[[nodiscard]] GoalTraits traitsOfMove(const Move& goal) {
  GoalTraits traits = traitsOfCommand(goal);
  // Behind an exit nothing can blend with it, and nobody else would know when it ends.
  traits.awaits_motion = !goal.blending_enable || goal.exit_node;
  traits.check_only = goal.check_only;
  traits.may_move = true;
  return traits;
}

}  // namespace cobot_command::blocks
