// Why a path is refused: the error number of the LoadPath manual, the point and the joint.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::path {

/// Decimal as in the manual, followed by numbers that all blocks share.
namespace path_error {
inline constexpr int kMovesExceedArray = 1010;
inline constexpr int kStartIndex = 1012;
inline constexpr int kDynamics = 1013;
inline constexpr int kJerk = 1014;
inline constexpr int kOrientationDynamics = 1015;
inline constexpr int kMoveType = 1017;
inline constexpr int kTargetType = 1018;
inline constexpr int kInterpolation = 1020;
inline constexpr int kTolerance = 1022;
inline constexpr int kPtpTolerance = 1023;
inline constexpr int kTermination = 1024;
inline constexpr int kProfile = 1025;
inline constexpr int kConfiguration = 1026;
inline constexpr int kPoseType = 1027;
inline constexpr int kReference = 1028;
inline constexpr int kToolIndex = 1029;
inline constexpr int kFrameIndex = 1030;
inline constexpr int kToolNotConfigured = 1031;
inline constexpr int kFrameNotConfigured = 1032;
inline constexpr int kJointTarget = 1033;
inline constexpr int kIncrementInFrame = 1035;
inline constexpr int kTargetPose = 1037;
inline constexpr int kManyReferences = 1038;
inline constexpr int kWorldUnknown = 1040;
inline constexpr int kToolUnknown = 1041;
inline constexpr int kFrameUnknown = 1042;
inline constexpr int kStartJoints = 1043;
inline constexpr int kNoSolution = 1044;
inline constexpr int kSingular = 1045;
inline constexpr int kReach = 1046;
inline constexpr int kJointLimit = 1047;
inline constexpr int kOtherConfiguration = 1048;
inline constexpr int kDisabledJoint = 1058;

inline constexpr int kJointSpeed = 0x204;
inline constexpr int kNotPlannable = 0x206;
inline constexpr int kNotInAScript = 0x271;
inline constexpr int kTooLong = 0x277;
}  // namespace path_error

struct PathRefusal {
  int error_id = 0;
  int index = -1;     ///< of the point in the array; -1: none
  int joint = -1;     ///< 0..8; -1: none
  std::string found;  ///< found, allowed, what to do
  /// Where the moved frame of the point would violate the limit, in the robot base [m].
  std::optional<arm::Pose> where = std::nullopt;
};

}  // namespace cobot_command::path
