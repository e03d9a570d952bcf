// Entries that are easily written down.
#pragma once

#include <limits>
#include <string>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::testing {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// 4 kg: a TM5-900.
inline const tables::Payload kPayload{4, "tm5-900"};

inline arm::Pose at(double x, double y = 0, double z = 0, double rx = 0, double ry = 0, double rz = 0) {
  return arm::toPose({x, y, z, rx, ry, rz});
}
inline tables::Tool toolAt(double x, int load = 0) {
  return {"", at(x), load};
}
inline tables::Frame frameAt(double x, int reference = 0) {
  return {"", at(x), reference};
}
inline tables::Load weighing(double mass) {
  tables::Load load;
  load.mass = mass;
  return load;
}

/// 0: taken.
inline int idOf(const std::optional<tables::Refusal>& refusal) {
  return refusal ? refusal->error_id : 0;
}

}  // namespace cobot_command::testing
