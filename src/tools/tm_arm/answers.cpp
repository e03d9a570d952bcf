#include "answers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"

namespace cobot_command::tm_arm {
namespace {

using nlohmann::json;

/// "-0.0000" would only puzzle.
double rounded(double value) {
  return std::abs(value) < 5e-5 ? 0.0 : value;
}

std::string limitsRemark(const arm::ArmModel& arm, const arm::JointVector& joints) {
  const int outside = arm.firstJointOutsideLimits(joints);
  return outside < 0 ? "inside" : fmt::format("J{} outside", outside + 1);
}

std::string asNumbers(const arm::PoseBits& bits) {
  return fmt::format("{}", fmt::join(bits.numbers(), ","));
}

std::string branchTable(const arm::ArmModel& arm, const arm::Branches& branches) {
  std::string table = fmt::format("{:<6}  {:<19}", "bits", "");
  for (int joint = 1; joint <= 6; ++joint) table += fmt::format("  {:>9}", fmt::format("J{}", joint));
  table += "  limits";
  for (const arm::Branch& branch : branches) {
    table += fmt::format("\n{:<6}  {:<19}", asNumbers(branch.bits), toString(branch.bits));
    for (const double joint : arm::toControllerJoints(branch.joints)) {
      table += fmt::format("  {:9.4f}", rounded(joint));
    }
    table += "  " + limitsRemark(arm, branch.joints);
  }
  return table;
}

json branchList(const arm::ArmModel& arm, const arm::Branches& branches) {
  json list = json::array();
  for (const arm::Branch& branch : branches) {
    list.push_back({{"joints_deg", arm::toControllerJoints(branch.joints)},
                    {"pose_bits", branch.bits.numbers()},
                    {"within_limits", arm.firstJointOutsideLimits(branch.joints) < 0}});
  }
  return list;
}

}  // namespace

Answer forward(const arm::ArmModel& arm, const std::array<double, 6>& joints_deg, bool as_json) {
  const arm::JointVector joints = arm::toJointVector(joints_deg);
  const arm::ControllerPose pose = arm::toControllerPose(arm::forwardKinematics(arm, joints));
  const arm::PoseBits bits = arm::poseBitsOf(arm, joints);
  if (as_json) return {json({{"pose", pose}, {"pose_bits", bits.numbers()}}).dump(), true};

  std::string table;
  for (const char* name : {"X", "Y", "Z", "RX", "RY", "RZ"}) table += fmt::format("{:>10}", name);
  table += fmt::format("  {:<6}  {:<19}  limits\n", "bits", "");
  for (const double coordinate : pose) table += fmt::format("{:10.4f}", rounded(coordinate));
  table += fmt::format("  {:<6}  {:<19}  {}", asNumbers(bits), toString(bits), limitsRemark(arm, joints));
  return {table, true};
}

Answer inverse(const arm::ArmModel& arm, const std::array<double, 6>& pose_mm_deg, bool as_json) {
  const arm::Pose flange = arm::toPose(pose_mm_deg);
  arm::Branches branches = arm::allBranches(arm, flange);
  std::sort(branches.begin(), branches.end(),
            [](const auto& a, const auto& b) { return a.bits.numbers() < b.bits.numbers(); });
  const bool reachable = !branches.empty();
  if (as_json) return {branchList(arm, branches).dump(), reachable};
  if (reachable) return {branchTable(arm, branches), true};
  const auto refused = arm::postureFor(arm, flange, arm::PoseBits{}, arm::JointVector::Zero());
  return {refused ? std::string() : refused.error().message, false};
}

}  // namespace cobot_command::tm_arm
