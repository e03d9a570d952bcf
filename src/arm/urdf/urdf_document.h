// A URDF as urdfdom reads it, and where the arm is in it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <urdf_model/model.h>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

/// How the names of the joints of the arm end, from the base on.
inline constexpr std::array<const char*, kJointCount> kJointNames = {
    "shoulder_1_joint", "shoulder_2_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"};

struct UrdfDocument {
  std::shared_ptr<urdf::ModelInterface> model;
  std::string prefix;                           ///< what stands before the names of links and joints
  std::vector<urdf::JointConstSharedPtr> path;  ///< from the base to the flange, fixed ones included
};

/// Nothing when the text is XML with one <robot> and no other element or text beside it.
[[nodiscard]] std::optional<ModelError> whyNotOneRobot(const std::string& text);

/// Whatever the joints of the path are like. Refused when the text is no URDF, or of none or several arms, or
/// has no path from the base to the flange.
[[nodiscard]] Result<UrdfDocument, ModelError> readUrdfDocument(const std::string& urdf);

}  // namespace cobot_command::arm
