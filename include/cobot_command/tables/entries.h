// What stands in the tables of tools, frames and loads: sixteen of each, known to paths and to SRCI by
// number.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/arm/types.h"

namespace cobot_command::tables {

inline constexpr int kEntryCount = 16;

/// 0..15. Number 0 is fixed: flange, robot base, no load.
[[nodiscard]] constexpr bool isIndex(int index) {
  return index >= 0 && index < kEntryCount;
}

enum class Kind { Tool, Frame, Load };
/// "tool"
[[nodiscard]] std::string_view toString(Kind kind);

struct Tool {
  std::string name;               ///< of the controller's project; empty: ours alone
  std::optional<arm::Pose> pose;  ///< in the flange; nothing: only the project knows it
  int load = 0;                   ///< number of what it weighs
};

struct Frame {
  std::string name;               ///< of the controller's project; empty: ours alone
  std::optional<arm::Pose> pose;  ///< in its reference; nothing: only the project knows it
  int reference = 0;              ///< number of a frame that stands in the robot base
};

struct Load {
  double mass = 0;                          ///< [kg]
  std::array<double, 3> inertia{};          ///< Ixx, Iyy, Izz about its centre [kg m^2]
  arm::Pose centre{arm::Pose::Identity()};  ///< of its mass, in the flange
};

/// To the last bit.
[[nodiscard]] bool operator==(const Tool& a, const Tool& b);
[[nodiscard]] bool operator==(const Frame& a, const Frame& b);
[[nodiscard]] bool operator==(const Load& a, const Load& b);

template <class Entry>
using Table = std::array<std::optional<Entry>, kEntryCount>;

/// Nothing: not configured.
struct Entries {
  Entries();  ///< only the fixed ones

  Table<Tool> tools;
  Table<Frame> frames;
  Table<Load> loads;
};

}  // namespace cobot_command::tables
