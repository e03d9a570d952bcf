// A target given as a pose in any frame (FramedPose): its checks, and its values for the controller.
#pragma once

#include <string>

#include "shared/parameter_checks.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/goal_values.h"

namespace cobot_command::blocks {

/// Its frame is known, all is finite, the quaternion is of unit length within 1e-3, and the place is no
/// further from the robot base than any arm could reach.
void checkPose(ParameterChecks& checks, const char* field, const FramedPose& pose);

/// So far may the length of its quaternion be from 1; inRobotBase() takes it as a direction.
inline constexpr double kUnitLengthTolerance = 1e-3;

[[nodiscard]] bool hasKnownFrame(const FramedPose& pose);
/// `in "table": ...`, with why the frame is not known.
[[nodiscard]] std::string frameInWords(const FramedPose& pose);
/// Of the numbers that came from outside.
[[nodiscard]] bool isFinite(const FramedPose& pose);
[[nodiscard]] double lengthOfQuaternion(const FramedPose& pose);
[[nodiscard]] bool isOfUnitLength(const FramedPose& pose);

/// The frame's name, for people: cut and escaped.
[[nodiscard]] std::string printableFrame(const FramedPose& pose);

/// The target itself. Precondition: checkPose() found nothing.
[[nodiscard]] arm::Pose inRobotBase(const FramedPose& pose);

/// In mm and degrees, seen from `base`, which is given in the robot base. Precondition: checkPose() found
/// nothing.
[[nodiscard]] SixValues seenFrom(const arm::Pose& base, const FramedPose& pose);

/// The pose where there is one, else the numbers.
[[nodiscard]] SixValues targetOf(const SixValues& values, const std::optional<FramedPose>& pose,
                                 const arm::Pose& base);

}  // namespace cobot_command::blocks
