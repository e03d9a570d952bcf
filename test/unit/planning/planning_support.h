// What the planning tests share: script lines as they are written, planned as they are sent.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/script/script_reader.h"

namespace cobot_command::planning {

inline arm::ArmModel model() {
  return *arm::ArmModel::named("tm5-900");
}

/// A posture far from every singularity and limit.
inline arm::JointVector workingPosture() {
  return arm::toJointVector({10, 15, 80, -5, 85, 20});
}

inline script::ScriptCommand line(const std::string& text) {
  const auto read = script::readScript(text);
  if (!read) ADD_FAILURE() << text << ": " << read.error().front().reason;
  return read ? read->front().command : script::Pause{};
}

/// The step, or a failed test that names the refusal.
inline PlannedStep append(ScriptPlanner& planner, const std::string& text) {
  const auto step = planner.append(line(text));
  if (!step) ADD_FAILURE() << text << ": " << step.error().message;
  return step.value_or(PlannedStep{});
}

inline motion::Refusal refusalOf(ScriptPlanner& planner, const std::string& text) {
  const auto step = planner.append(line(text));
  if (step) ADD_FAILURE() << text << " was not refused";
  return step ? motion::Refusal{} : step.error();
}

}  // namespace cobot_command::planning
