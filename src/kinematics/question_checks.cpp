#include "question_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cobot_command::kinematics {
namespace {

using Reason = tables::Gap::Reason;

Refusal refusalOf(tables::Kind kind, const tables::Gap& gap) {
  const int id = kind == tables::Kind::Tool ? kinematics_error::kToolIndex : kinematics_error::kFrameIndex;
  const std::string_view name = toString(kind);
  switch (gap.reason) {
    case Reason::OutOfRange:
      return {id, fmt::format("{}. Give the number of a {}", gap.found, name)};
    case Reason::NotConfigured:
      return {id, fmt::format("{}; allowed: one that is. Write it with write_{}, or give another number",
                              gap.found, name)};
    case Reason::ValueUnknown:
      break;
  }
  return {id, fmt::format("{}; allowed: one whose pose is known here. Write it with write_{} with its pose "
                          "in addition to its name, or give another number",
                          gap.found, name)};
}

}  // namespace

Result<arm::JointVector, Refusal> finiteJoints(const arm::ControllerJoints& joints_deg) {
  for (std::size_t i = 0; i < joints_deg.size(); ++i) {
    if (std::isfinite(joints_deg[i])) continue;
    return refuse(Refusal{kinematics_error::kNotFinite,
                          fmt::format("joint {} is {}; allowed: finite numbers. Give angles in degrees",
                                      i + 1, joints_deg[i])});
  }
  return arm::toJointVector(joints_deg);
}

Result<arm::JointVector, Refusal> jointsInRange(const arm::ControllerJoints& joints_deg) {
  for (std::size_t i = 0; i < joints_deg.size(); ++i) {
    if (!(std::abs(joints_deg[i]) > arm::kMaxCoordinate)) continue;
    if (!std::isfinite(joints_deg[i])) break;
    return refuse(Refusal{kinematics_error::kCoordinateRange,
                          fmt::format("joint {} is {} degrees; allowed: -{} to {}. Give angles in degrees",
                                      i + 1, joints_deg[i], arm::kMaxCoordinate, arm::kMaxCoordinate)});
  }
  return finiteJoints(joints_deg);
}

Result<arm::Pose, Refusal> poseInRange(std::string_view what, const arm::ControllerPose& pose) {
  const auto read = tables::poseIn(pose);
  if (read) return *read;
  return refuse(Refusal{read.error().error_id, fmt::format("{}: {}; allowed: {}. Give mm and degrees", what,
                                                           read.error().found, read.error().allowed)});
}

Result<Mounting, Refusal> mountingOf(const tables::DataTables& tables, const ToolAndFrame& numbers) {
  const auto frame = tables.frameInRobotBase(numbers.frame);
  if (!frame) return refuse(refusalOf(tables::Kind::Frame, frame.error()));
  const auto tool = tables.toolInFlange(numbers.tool);
  if (!tool) return refuse(refusalOf(tables::Kind::Tool, tool.error()));
  return Mounting{*tool, *frame};
}

}  // namespace cobot_command::kinematics
