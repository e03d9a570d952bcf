#include "shared/motion_parameters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

using script::DataFormat;

const char* noDefault(double value) {
  return value < 0 ? "; there is no default for it" : "";
}

/// 0 is refused too, though the tables have it in the range: such a motion never ends.
void checkSpeed(ParameterChecks& checks, double speed, bool absolute) {
  const double highest = absolute ? kMaxSpeedMmPerSecond : kMaxSpeedPercent;
  checks.require(speed > 0 && speed <= highest,
                 absolute ? motion_error::kSpeedRangeAbsolute : motion_error::kSpeedRangePercent,
                 fmt::format("speed is {} {}, it must be above 0 and at most {}{}", speed,
                             absolute ? "mm/s" : "%", highest, noDefault(speed)));
}

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

std::optional<DataFormat> FormatList::at(int number) const {
  if (number < 0 || static_cast<std::size_t>(number) >= count_) return std::nullopt;
  const std::string_view name = names_[number];
  return DataFormat{static_cast<DataFormat::Target>(name[0]), static_cast<DataFormat::Speed>(name[1]),
                    static_cast<DataFormat::Blending>(name[2])};
}

std::string FormatList::found(int number) const {
  std::string text = fmt::format("data_format is {} (", number);
  for (std::size_t i = 0; i < count_; ++i) text += fmt::format("{}{} {}", i == 0 ? "" : ", ", names_[i], i);
  return text + ")";
}

void checkMotion(ParameterChecks& checks, const MotionParameters& parameters,
                 const std::optional<DataFormat>& format) {
  const DataFormat units = format.value_or(DataFormat{});
  checkSpeed(checks, parameters.speed, units.speed == DataFormat::Speed::Absolute);
  checks.require(isWithin(parameters.accel_time, kMinAccelTime, kMaxAccelTime), motion_error::kAccelTimeRange,
                 fmt::format("accel_time is {}{}", parameters.accel_time, noDefault(parameters.accel_time)));
  checks.commandId(parameters.command_id, "lets the layer choose");
  checks.bufferMode(parameters.buffer_mode);
  if (!parameters.blending_enable) return;
  const bool radius = units.blending == DataFormat::Blending::Radius;
  checks.require(isWithin(parameters.blending_value, 0, radius ? kMaxBlendingMm : kMaxBlendingPercent),
                 own_error::kBlendingRange,
                 fmt::format("blending_value is {} {}{}", parameters.blending_value, radius ? "mm" : "%",
                             noDefault(parameters.blending_value)));
}

void checkMovement(ParameterChecks& checks, int movement_command, int data_format, const FormatList& formats,
                   int ptp_error, int line_error) {
  const auto format = formats.at(data_format);
  if (movement_command == static_cast<int>(Movement::Ptp)) {
    checks.require(format && format->speed == DataFormat::Speed::Percent &&
                       format->blending == DataFormat::Blending::Percent,
                   ptp_error, formats.found(data_format));
  } else if (movement_command == static_cast<int>(Movement::Line)) {
    checks.require(format && format->target != DataFormat::Target::Joint, line_error,
                   formats.found(data_format));
  } else {
    checks.require(false, own_error::kMovementUnknown,
                   fmt::format("movement_command is {}", movement_command));
  }
}

script::MotionOptions optionsOf(const MotionParameters& parameters) {
  script::MotionOptions options;
  options.speed = std::max(1, rounded(parameters.speed));
  options.accel_time = rounded(parameters.accel_time);
  options.blending = parameters.blending_enable ? rounded(parameters.blending_value) : 0;
  options.disable_precise_positioning = parameters.disable_precise_positioning;
  return options;
}

}  // namespace cobot_command::blocks
