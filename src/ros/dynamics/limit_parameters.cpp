#include "dynamics/limit_parameters.h"

#include <charconv>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr const char* kName = "software_limits";
constexpr const char* kAllowed = "a list of texts N=LOWER,UPPER [deg], N the joint, 1 to 6";

/// The number in front of `text`, which is shorter then; nothing: there is none.
template <class Number>
std::optional<Number> take(std::string_view& text) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

bool takeMark(std::string_view& text, char mark) {
  if (text.empty() || text.front() != mark) return false;
  text.remove_prefix(1);
  return true;
}

/// Its joint, from 1 on; nothing: it is none of these texts.
std::optional<int> takeLimits(std::string_view text, command::SoftwareLimits& limits) {
  const auto joint = take<int>(text);
  if (!joint || *joint < 1 || *joint > static_cast<int>(arm::kJointCount) || !takeMark(text, '=')) {
    return std::nullopt;
  }
  const auto lower = take<double>(text);
  if (!lower || !takeMark(text, ',')) return std::nullopt;
  const auto upper = take<double>(text);
  if (!upper || !text.empty()) return std::nullopt;
  limits.lower[*joint - 1] = degToRad(*lower);
  limits.upper[*joint - 1] = degToRad(*upper);
  return joint;
}

}  // namespace

Setting limitsRow(std::vector<std::string>& texts) {
  return {kName, setting_kinds::texts(texts, kAllowed),
          "narrower limits of joints, with which everything is planned from the start on; see "
          "doc/dynamics.md"};
}

std::optional<SettingFault> readLimits(const std::vector<std::string>& texts, const arm::ArmModel* arm,
                                       std::optional<command::SoftwareLimits>& limits) {
  if (texts.empty()) return std::nullopt;
  if (arm == nullptr) {
    return SettingFault{kName, "is given, and there is no model of the arm", "none without a model"};
  }
  const command::SoftwareLimits model = command::limitsOf(*arm);
  command::SoftwareLimits wanted = model;
  std::set<int> named;
  for (const std::string& text : texts) {
    const auto joint = takeLimits(text, wanted);
    if (!joint) return SettingFault{kName, "holds " + quoted(text), kAllowed};
    if (!named.insert(*joint).second) {
      return SettingFault{kName, fmt::format("names joint {} twice", *joint), kAllowed};
    }
  }
  if (const auto fault = command::faultIn(wanted, model)) {
    return SettingFault{kName, "does not do: " + *fault, kAllowed};
  }
  limits = wanted;
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
