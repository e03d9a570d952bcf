#include "dynamics/limit_parameters.h"

#include <set>

#include <fmt/format.h>

#include "cobot_command/arm/joint_range.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr const char* kName = "software_limits";

}  // namespace

Setting limitsRow(std::vector<std::string>& texts) {
  return {kName, setting_kinds::texts(texts, arm::kJointRangesAllowed),
          "narrower joint limits, used for all planning from the start; see doc/dynamics.md"};
}

std::optional<SettingFault> readLimits(const std::vector<std::string>& texts, const arm::ArmModel* arm,
                                       std::optional<command::SoftwareLimits>& limits) {
  if (texts.empty()) return std::nullopt;
  if (arm == nullptr) {
    return SettingFault{kName, "is given, but there is no model of the arm", "no limits without a model"};
  }
  const command::SoftwareLimits model = command::limitsOf(*arm);
  command::SoftwareLimits wanted = model;
  std::set<std::size_t> named;
  for (const std::string& text : texts) {
    const auto range = arm::parseJointRange(text);
    if (!range) return SettingFault{kName, "holds " + quoted(text), arm::kJointRangesAllowed};
    if (!named.insert(range->joint).second) {
      return SettingFault{kName, fmt::format("names joint {} twice", range->joint), arm::kJointRangesAllowed};
    }
    const auto index = static_cast<Eigen::Index>(range->joint - 1);
    wanted.lower[index] = degToRad(range->lower);
    wanted.upper[index] = degToRad(range->upper);
  }
  if (const auto fault = command::faultIn(wanted, model)) {
    return SettingFault{kName, "cannot be used: " + *fault, arm::kJointRangesAllowed};
  }
  limits = wanted;
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
