// The programs of a cell with each motion planned as it will be executed: the basis of zones and permits.
//
// SI [m, rad].
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::cell {

/// One motion of a frame.
struct PlannedMotion {
  motion::TrajectoryPtr trajectory;        ///< from rest to rest, at the highest project speed
  std::optional<motion::Blend> blend;      ///< into the next motion of the path; std::nullopt: it stops
  arm::Pose tcp = arm::Pose::Identity();   ///< in the flange
  arm::Pose base = arm::Pose::Identity();  ///< the active base, in the robot base
};

/// One script frame: the script that is sent for a step.
struct PlannedFrame {
  std::size_t step = 0;            ///< of the path
  std::vector<std::string> lines;  ///< without queue tag
  std::vector<PlannedMotion> motions;
  std::set<std::string> carried;  ///< during the motion
  bool stands = true;             ///< true: the robot stops at its end; false: it blends into the next frame
  double dwell = 0;               ///< at its end [s]
  /// Since the start of the path, without waiting: the start of its motion, and the time when it stops or the
  /// next frame takes over.
  Duration begin{};
  Duration end{};
};

/// A station where a program may rest, with the parts carried there.
struct PlannedStation {
  std::string name;
  arm::JointVector joints = arm::JointVector::Zero();
  std::set<std::string> carried;
};

struct PlannedPath {
  std::string name;
  std::size_t from = 0;  ///< station
  std::size_t to = 0;
  std::vector<PlannedFrame> frames;
  std::set<std::string> carried_at_end;
  Duration duration{};  ///< without waiting
};

struct PlannedRobot {
  std::string name;
  arm::ArmModel arm;
  std::size_t home = 0;
  std::vector<PlannedStation> stations;  ///< those that a path starts or ends at, in the order of the cell
  std::vector<PlannedPath> paths;        ///< in the order of the cell
};

/// In the order of the cell's robots; mechanisms need no plan. Faults: a step that violates the rules of its
/// block or cannot be planned; a motion with unknown start, base or TCP; a path that does not end at the
/// joints of its station (1e-6 rad).
[[nodiscard]] Result<std::vector<PlannedRobot>, std::vector<Fault>> planCell(const Cell& cell);

}  // namespace cobot_command::cell
