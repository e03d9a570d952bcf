#include "shared/parameter_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {
namespace {

constexpr int kMinCommandId = 2;
constexpr int kMaxCommandId = 9;

bool isBufferMode(int buffer_mode) {
  return buffer_mode >= static_cast<int>(BufferMode::Refuse) &&
         buffer_mode <= static_cast<int>(BufferMode::Aborting);
}

}  // namespace

void ParameterChecks::require(bool satisfied, int error_id, std::string found) {
  if (!satisfied) failures_.push_back({error_id, std::move(found), ""});
}

void ParameterChecks::commandId(int command_id, const char* zero) {
  require(command_id == 0 || (command_id >= kMinCommandId && command_id <= kMaxCommandId),
          motion_error::kCommandIdRange, fmt::format("command_id is {}; 0 {}", command_id, zero));
}

void ParameterChecks::bufferMode(int buffer_mode) {
  require(isBufferMode(buffer_mode), own_error::kBufferModeUnknown,
          fmt::format("buffer_mode is {}", buffer_mode));
}

void ParameterChecks::sixValues(const char* field, const SixValues& values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) {
    return !isWithin(v, -arm::kMaxCoordinate, arm::kMaxCoordinate);
  });
  if (bad == values.end()) return;
  const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  require(false, finite ? own_error::kCoordinateRange : own_error::kNotFinite,
          fmt::format("coordinate {} of {} is {}", bad - values.begin() + 1, field, *bad));
}

void ParameterChecks::io(const char* field, const std::string& module, int number, int error_id) {
  const auto known = script::ioModule(module);
  require(known && number >= 0 && number < script::ioCount(*known), error_id,
          fmt::format("{} {} of module '{}'", field, number, foreignText(module, kQuoteLimit)));
}

void ParameterChecks::name(const char* field, const std::string& name) {
  require(script::isName(name), own_error::kNameInvalid,
          fmt::format("{} is \"{}\", {} bytes", field, foreignText(name, kQuoteLimit), name.size()));
}

std::vector<Failure> ParameterChecks::violations() && {
  std::stable_sort(failures_.begin(), failures_.end(),
                   [](const Failure& a, const Failure& b) { return a.error_id < b.error_id; });
  return std::move(failures_);
}

BufferMode bufferModeOf(int buffer_mode) {
  return isBufferMode(buffer_mode) ? static_cast<BufferMode>(buffer_mode) : BufferMode::Refuse;
}

}  // namespace cobot_command::blocks
