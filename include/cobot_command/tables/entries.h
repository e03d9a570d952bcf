// The entries of the tables of tools, frames and loads: sixteen of each. Paths and SRCI refer to them by
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
  std::string name;               ///< in the controller's project; empty: only in this table
  std::optional<arm::Pose> pose;  ///< in the flange; std::nullopt: only in the project
  int load = 0;                   ///< number of its load
};

struct Frame {
  std::string name;               ///< in the controller's project; empty: only in this table
  std::optional<arm::Pose> pose;  ///< in its reference; std::nullopt: only in the project
  int reference = 0;              ///< number of a frame that itself refers to the robot base
};

struct Load {
  double mass = 0;                          ///< [kg]
  std::array<double, 3> inertia{};          ///< Ixx, Iyy, Izz about the centre of mass [kg m^2]
  arm::Pose centre{arm::Pose::Identity()};  ///< centre of mass, in the flange
};

/// Exact comparison, to the last bit.
[[nodiscard]] bool operator==(const Tool& a, const Tool& b);
[[nodiscard]] bool operator==(const Frame& a, const Frame& b);
[[nodiscard]] bool operator==(const Load& a, const Load& b);

template <class Entry>
using Table = std::array<std::optional<Entry>, kEntryCount>;

/// std::nullopt: not configured.
struct Entries {
  Entries();  ///< only the fixed entries

  Table<Tool> tools;
  Table<Frame> frames;
  Table<Load> loads;
};

}  // namespace cobot_command::tables
