#include "cobot_command/kinematics/inverse.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "question_checks.h"
#include <fmt/format.h>

#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::kinematics {
namespace {

using Reason = arm::IkRefusal::Reason;

/// The question in SI, checked.
struct Task {
  arm::Pose flange;  ///< in the robot base
  arm::JointVector from;
  std::optional<arm::PoseBits> bits;  ///< nothing: any
};

/// Below, bits are read in the order of their numbers.
Result<arm::PoseBits, Refusal> bitsOf(const std::array<int, 3>& numbers) {
  const auto bits = arm::PoseBits::fromNumbers(numbers[0], numbers[1], numbers[2]);
  if (bits) return *bits;
  struct Row {
    int error_id;
    const char* name;
    int least;
  };
  static constexpr Row kRows[] = {{kinematics_error::kShoulderBit, "config1", 0},
                                  {kinematics_error::kElbowBit, "config2", 2},
                                  {kinematics_error::kWristBit, "config3", 4}};
  const auto is_wrong = [&numbers](const Row& row) {
    const int number = numbers[static_cast<std::size_t>(&row - kRows)];
    return number != row.least && number != row.least + 1;
  };
  const Row& row = *std::find_if(std::begin(kRows), std::end(kRows), is_wrong);
  return refuse(Refusal{
      row.error_id, fmt::format("{} is {}; allowed: {} and {}. Choose one of these", row.name,
                                numbers[static_cast<std::size_t>(&row - kRows)], row.least, row.least + 1)});
}

Result<std::optional<arm::PoseBits>, Refusal> wantedBits(const arm::ArmModel& arm,
                                                         const arm::JointVector& from,
                                                         const InverseQuestion& question) {
  switch (static_cast<Configuration>(question.configuration)) {
    case Configuration::Given: {
      const auto bits = bitsOf(question.bits);
      if (!bits) return refuse(bits.error());
      return std::optional(*bits);
    }
    case Configuration::Same:
      return std::optional(poseBitsOf(arm, from));
    case Configuration::Free:
      return std::optional<arm::PoseBits>();
  }
  return refuse(
      Refusal{kinematics_error::kConfigurationUnknown,
              fmt::format("configuration is {}; allowed: 0 (GIVEN), 1 (SAME) and 2 (FREE). Choose one "
                          "of these",
                          question.configuration)});
}

Result<Task, Refusal> taskOf(const arm::ArmModel& arm, const tables::DataTables& tables,
                             const InverseQuestion& question) {
  const auto pose = poseInRange("the pose", question.pose);
  if (!pose) return refuse(pose.error());
  const auto from = jointsInRange(question.joints);
  if (!from) return refuse(from.error());
  const auto mounting = mountingOf(tables, question.numbers);
  if (!mounting) return refuse(mounting.error());
  const auto bits = wantedBits(arm, *from, question);
  if (!bits) return refuse(bits.error());
  return Task{mounting->frame * *pose * mounting->tool.inverse(), *from, *bits};
}

/// As arm/ tells it; `joints` are those of the branch, anywhere.
Branch branchOf(const arm::ArmModel& arm, const Task& task, const arm::Branch& found) {
  const auto turned = postureFor(arm, task.flange, found.bits, task.from);
  if (turned) return {postureOf(*turned, found.bits), std::nullopt};
  return {postureOf(found.joints, found.bits), turned.error().joint};
}

std::vector<Branch> branchesOf(const arm::ArmModel& arm, const Task& task) {
  arm::Branches found = allBranches(arm, task.flange, task.from);
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.bits.numbers() < b.bits.numbers(); });
  std::vector<Branch> branches;
  std::transform(found.begin(), found.end(), std::back_inserter(branches),
                 [&](const arm::Branch& branch) { return branchOf(arm, task, branch); });
  return branches;
}

Refusal toRefusal(const arm::IkRefusal& refusal) {
  const bool is_outside = refusal.reason == Reason::OutsideLimits;
  return {is_outside ? kinematics_error::kOutsideLimits : kinematics_error::kNoPosture, refusal.message};
}

/// How long the slowest joint takes at its rated speed [s].
double timeTo(const arm::ArmModel& arm, const arm::JointVector& from, const Posture& posture) {
  const arm::JointVector way = arm::toJointVector(posture.joints) - from;
  double longest = 0;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    longest = std::max(longest, std::abs(way[static_cast<Eigen::Index>(i)]) / arm.limits()[i].max_velocity);
  }
  return longest;
}

Refusal allOutside(const std::vector<Branch>& branches) {
  std::vector<std::string> reasons;
  std::transform(branches.begin(), branches.end(), std::back_inserter(reasons), [](const Branch& branch) {
    return fmt::format("{}: joint {}", toString(branch.posture.bits), *branch.outside + 1);
  });
  return {
      kinematics_error::kOutsideLimits,
      fmt::format("Each posture that reaches the pose has a joint outside its limits ({}). Choose another "
                  "pose.",
                  fmt::join(reasons, ", "))};
}

Result<Posture, Refusal> nearestOf(const arm::ArmModel& arm, const Task& task,
                                   const std::vector<Branch>& branches) {
  if (branches.empty()) {
    const auto refused = postureFor(arm, task.flange, {}, task.from);
    return refuse(toRefusal(refused.error()));
  }
  const Posture* nearest = nullptr;
  double least = 0;
  for (const Branch& branch : branches) {
    if (branch.outside) continue;
    const double time = timeTo(arm, task.from, branch.posture);
    if (nearest != nullptr && time >= least) continue;
    nearest = &branch.posture;
    least = time;
  }
  if (nearest == nullptr) return refuse(allOutside(branches));
  return *nearest;
}

Result<Posture, Refusal> chosenOf(const arm::ArmModel& arm, const Task& task,
                                  const std::vector<Branch>& branches) {
  if (!task.bits) return nearestOf(arm, task, branches);
  const auto joints = postureFor(arm, task.flange, *task.bits, task.from);
  if (!joints) return refuse(toRefusal(joints.error()));
  return postureOf(*joints, *task.bits);
}

}  // namespace

InverseAnswer inverse(const arm::ArmModel& arm, const tables::DataTables& tables,
                      const InverseQuestion& question) {
  const auto task = taskOf(arm, tables, question);
  if (!task) return {{}, refuse(task.error())};
  std::vector<Branch> branches = branchesOf(arm, *task);
  auto chosen = chosenOf(arm, *task, branches);
  return {std::move(branches), std::move(chosen)};
}

}  // namespace cobot_command::kinematics
