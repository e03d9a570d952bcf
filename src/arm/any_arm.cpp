#include "cobot_command/arm/any_arm.h"

#include <algorithm>
#include <cassert>
#include <string>

#include <fmt/format.h>
#include <tinyxml2.h>

namespace cobot_command::arm {
namespace {

std::array<JointLimit, kJointCount> widestLimits() {
  std::array<JointLimit, kJointCount> widest;
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel model = *ArmModel::named(name);
    for (std::size_t i = 0; i < kJointCount; ++i) {
      const JointLimit& own = model.limits()[i];
      widest[i].lower = std::min(widest[i].lower, own.lower);
      widest[i].upper = std::max(widest[i].upper, own.upper);
      widest[i].max_velocity = std::max(widest[i].max_velocity, own.max_velocity);
    }
  }
  return widest;
}

/// Its joints stand in the order of the arm.
std::string withLimits(const std::string& urdf, const std::array<JointLimit, kJointCount>& limits) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf.c_str());
  auto next = limits.begin();
  for (auto* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    tinyxml2::XMLElement* const limit = joint->FirstChildElement("limit");
    if (limit == nullptr) continue;
    assert(next != limits.end());
    // Not by the library's own way for numbers, which follows the locale.
    limit->SetAttribute("lower", fmt::to_string(next->lower).c_str());
    limit->SetAttribute("upper", fmt::to_string(next->upper).c_str());
    limit->SetAttribute("velocity", fmt::to_string(next->max_velocity).c_str());
    ++next;
  }
  assert(next == limits.end());
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace

const ArmModel& anyArm() {
  static const ArmModel model =
      ArmModel::fromUrdf(withLimits(ArmModel::urdfOf(ArmModel::knownNames().front()), widestLimits()))
          .value();
  return model;
}

}  // namespace cobot_command::arm
