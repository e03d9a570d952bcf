// Default dynamics: what a move has in place of a negative value, wherever in a goal it stands.

#include <type_traits>
#include <utility>
#include <variant>

#include "shared/motion_parameters.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"

namespace cobot_command::blocks {
namespace {

using script::DataFormat;
using Default = std::optional<double>;

void replace(double& value, const Default& by) {
  if (value < 0 && by) value = *by;
}

/// A move: what says its data format.
template <class Kind, class = void>
constexpr bool kIsMove = false;
template <class Kind>
constexpr bool kIsMove<Kind, std::void_t<decltype(formatOf(std::declval<const Kind&>()))>> = true;

/// Of which unit a number is, an unknown format does not say: it is refused as it is.
template <class Move>
void useIn(Move& move, const DefaultDynamics& defaults) {
  replace(move.accel_time, defaults.accel_time);
  const auto format = formatOf(move);
  if (!format) return;
  const bool is_absolute = format->speed == DataFormat::Speed::Absolute;
  replace(move.speed, is_absolute ? defaults.speed_mm_s : defaults.speed_percent);
  const bool is_radius = format->blending == DataFormat::Blending::Radius;
  if (move.blending_enable) {
    replace(move.blending_value, is_radius ? defaults.blending_mm : defaults.blending_percent);
  }
}

template <class Kind>
void use(Kind& goal, const DefaultDynamics& defaults) {
  if constexpr (kIsMove<Kind>) useIn(goal, defaults);
}

void use(PickAndPlaceGoal& goal, const DefaultDynamics& defaults) {
  for (PickAndPlaceStep& step : goal.steps) useIn(step.move, defaults);
}

void use(CheckSequenceGoal& goal, const DefaultDynamics& defaults) {
  for (SequenceStep& step : goal.steps) {
    std::visit([&](auto& move) { use(move, defaults); }, step);
  }
}

struct Range {
  const char* name;
  Default value;
  double lowest;
  double highest;
  bool is_above;  ///< the lowest itself is none
};

}  // namespace

Goal withDefaults(Goal goal, const DefaultDynamics& defaults) {
  std::visit([&](auto& kind) { use(kind, defaults); }, goal);
  return goal;
}

std::optional<std::string> faultIn(const DefaultDynamics& defaults) {
  const Range ranges[] = {
      {"speed_percent", defaults.speed_percent, 0, kMaxSpeedPercent, true},
      {"speed_mm_s", defaults.speed_mm_s, 0, kMaxSpeedMmPerSecond, true},
      {"accel_time", defaults.accel_time, kMinAccelTime, kMaxAccelTime, false},
      {"blending_percent", defaults.blending_percent, 0, kMaxBlendingPercent, false},
      {"blending_mm", defaults.blending_mm, 0, kMaxBlendingMm, false},
  };
  for (const Range& range : ranges) {
    if (!range.value) continue;
    const double value = *range.value;
    if (isWithin(value, range.lowest, range.highest) && !(range.is_above && value == range.lowest)) continue;
    return fmt::format("{} is {}, allowed: {}{} to {}, or a negative number for none", range.name, value,
                       range.is_above ? "above " : "", range.lowest, range.highest);
  }
  return std::nullopt;
}

}  // namespace cobot_command::blocks
