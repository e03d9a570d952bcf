// What waits in the queue of the robot, and what the queue tells.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "drive/robot_error.h"
#include "queue/queued_tag.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/planning/script_motion.h"

namespace cobot_command::simulator {

using MotionRequest = planning::ScriptMotion;
struct BaseChange {
  arm::Pose pose;    ///< in the robot base [m]
  std::string name;  ///< empty when given by value
};
struct TcpChange {
  arm::Pose pose;                              ///< in the flange [m]
  std::string name;                            ///< empty when given by value
  std::optional<double> mass;                  ///< [kg]; absent: as before
  std::optional<script::ToolInertia> inertia;  ///< likewise
};
struct LoadChange {
  double mass = 0;  ///< [kg]
};
/// Within a PVT that is under way, what is behind this waits until so long after its start, at a project
/// speed of 100 % [s].
struct PvtMark {
  double time = 0.0;
};
using Velocity = std::variant<arm::JointVector, motion::TcpVelocity>;
/// From here on the arm takes velocities, of one kind.
struct VelocityMode {
  bool of_tcp = false;
  /// Since the last velocity: the arm comes to rest, the mode ends.
  std::optional<Duration> time_to_rest, time_to_end;
  std::optional<Velocity> first{};  ///< came before the mode began
};
using QueueEntry = std::variant<MotionRequest, BaseChange, TcpChange, LoadChange, QueuedTag, PvtMark,
                                VelocityMode, script::WriteOutput, script::WriteAnalogOutput>;

[[nodiscard]] inline bool moves(const QueueEntry& entry) {
  return std::holds_alternative<MotionRequest>(entry) || std::holds_alternative<VelocityMode>(entry);
}

/// What the queue tells: a tag came to its end.
struct TagSettled {
  QueuedTag tag;
  bool complete = false;  ///< false: a motion before it could not be made
};
/// A tag was thrown away with the queue.
struct TagDropped {
  QueuedTag tag;
};
struct MotionStarted {
  Duration duration;  ///< as planned
};
struct MotionFailed {
  RobotError error;
};
/// WriteOutput, WriteAnalogOutput: the motions before it are done, it is to be written now.
using QueueEvent = std::variant<TagSettled, TagDropped, MotionStarted, MotionFailed, script::WriteOutput,
                                script::WriteAnalogOutput>;

}  // namespace cobot_command::simulator
