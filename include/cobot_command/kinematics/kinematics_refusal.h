// Why a kinematics calculation has no result.
#pragma once

#include <string>

#include "cobot_command/tables/refusal.h"

namespace cobot_command::kinematics {

/// Error numbers of SRCI; below 16#6000 the same numbers as own_error of the blocks.
namespace kinematics_error {
inline constexpr int kNoPosture = 0x8C62;      ///< none at all, or none with the requested bits
inline constexpr int kOutsideLimits = 0x8C63;  ///< a joint of a given or found posture
inline constexpr int kTooNear = 0x8C59;        ///< points too close, or poses with too little rotation
inline constexpr int kNotPossible = 0x8C60;    ///< the touches of a tool are too far from one point
inline constexpr int kOnOneLine = 0x8C61;      ///< points on one line, or poses rotated about one axis
inline constexpr int kTooMany = 0x8C65;        ///< poses
inline constexpr int kTooFew = 0x8C66;
inline constexpr int kToolIndex = tables::table_error::kToolIndex;
inline constexpr int kFrameIndex = tables::table_error::kFrameIndex;
inline constexpr int kConfigurationUnknown = 0x8D21;
inline constexpr int kElbowBit = 0x8D05;
inline constexpr int kShoulderBit = 0x8D40;
inline constexpr int kWristBit = 0x8D41;
inline constexpr int kNotFinite = tables::table_error::kNotFinite;
inline constexpr int kCoordinateRange = tables::table_error::kCoordinateRange;
}  // namespace kinematics_error

struct Refusal {
  int error_id = 0;
  std::string message;  ///< what was found, what is allowed, what to do
};

}  // namespace cobot_command::kinematics
