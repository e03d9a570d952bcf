// The one circle through three points, or why there is none.
#pragma once

#include <string>

#include "curves/tcp_path.h"

#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"

namespace cobot_command::motion {

/// Two points of a circle must be this far apart, and the third this far off the line through them [m]: about
/// the repeatability of the arms, below which plane and radius would be noise.
inline constexpr double kMinCircleHeight = 1e-4;
/// A larger circle [m] is a line by mistake: over the reach of the arms it differs from one by about 1 mm.
inline constexpr double kMaxCircleRadius = 100.0;

/// Which of the three points spoils the circle, and how.
struct NoCircle {
  std::string message;  ///< found, allowed, what to do
};

/// The path of `circle` from `start`; all three poses are of the TCP in one frame.
[[nodiscard]] Result<TcpPath, NoCircle> circlePath(const arm::Pose& start, const Circle& circle);

}  // namespace cobot_command::motion
