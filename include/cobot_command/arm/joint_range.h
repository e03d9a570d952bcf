// The range of one joint as written in settings.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace cobot_command::arm {

inline constexpr const char* kJointRangesAllowed = "a list of texts N=LOWER,UPPER [deg], N the joint, 1 to 6";

struct JointRange {
  std::size_t joint = 1;  ///< 1 to 6
  double lower = 0;       ///< [deg]
  double upper = 0;       ///< [deg]
};
/// Parses "1=-90,90", without blanks. All numbers are accepted, also nan. std::nullopt for other text.
[[nodiscard]] std::optional<JointRange> parseJointRange(std::string_view text);

}  // namespace cobot_command::arm
