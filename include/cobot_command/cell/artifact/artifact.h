// The verified result of a cell file that is used at run time: zones, programs, supervisors, and the frames
// of each robot.
//
// Its hash binds it to the file; nothing runs with an artifact that does not match (doc/cell.md). SI [m, rad,
// s].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/waits/wait_for_input.h"
#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/zones/holds.h"
#include "cobot_command/cell/zones/zones.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// A piece as the agent of a robot needs it: the range of its joints, and the zones that it touches.
struct ArtifactPiece {
  Piece::Kind kind = Piece::Kind::Motion;
  std::size_t frame = 0;
  std::size_t motion = 0;
  Duration from{};
  Duration to{};
  motion::JointRange range;
  std::vector<ZoneIndex> zones;  ///< ascending
};

struct ArtifactFrame {
  std::size_t step = 0;
  std::vector<std::string> lines;  ///< exactly the lines that may be sent, without queue tag
  /// Start of its first motion, and the base and TCP with which it was planned; std::nullopt if it has no
  /// motion.
  std::optional<arm::JointVector> start;
  arm::Pose base = arm::Pose::Identity();
  arm::Pose tcp = arm::Pose::Identity();
  bool stands = true;
  std::vector<std::string> carried;               ///< parts carried during the motion; ascending
  std::optional<blocks::SetOutputGoal> output;    ///< set when the robot is at standstill at its end
  std::optional<blocks::WaitForInputGoal> input;  ///< then the robot waits for it
  double dwell = 0.0;                             ///< then the robot dwells [s]
  Duration begin{};                               ///< since the start of the path, without waiting
  Duration end{};
};

struct ArtifactPath {
  std::vector<ArtifactFrame> frames;
  std::vector<ArtifactPiece> pieces;
  std::vector<Hold> holds;
  std::vector<ZonePlace> places;  ///< by step of the path's program
  Duration duration{};
};

struct ArtifactStation {
  arm::JointVector joints = arm::JointVector::Zero();
  std::vector<ZoneIndex> zones;
  std::vector<std::string> carried;  ///< parts; ascending
};

struct ArtifactRobot {
  std::string model;
  std::string name_space;
  arm::Pose base = arm::Pose::Identity();  ///< in the world
  std::vector<FlangeCapsules> tool;        ///< always mounted
  std::vector<FlangeCapsules> parts;       ///< carried somewhere in its program
  std::vector<ArtifactStation> stations;   ///< as in the program
  std::vector<ArtifactPath> paths;
};

/// A piece of a mechanism: the range of its axis [m or rad], in the order of motion.
struct ArtifactAxisPiece {
  double from = 0.0;
  double to = 0.0;
  std::vector<ZoneIndex> zones;  ///< ascending
};

struct ArtifactMechanismPath {
  std::vector<ArtifactAxisPiece> pieces;  ///< the last one is the rest at the end
  std::vector<Hold> holds;
  std::vector<ZonePlace> places;  ///< by step of the path's program; the frame is always 0
  std::optional<Duration> duration;
};

struct ArtifactPosition {
  double value = 0.0;  ///< [m or rad]
  std::vector<ZoneIndex> zones;
};

struct ArtifactMechanism {
  MechanismBodies bodies{MotionAxis{}, Capsules{}};
  std::vector<ArtifactPosition> stations;  ///< as in the program
  std::vector<ArtifactMechanismPath> paths;
};

struct Artifact {
  std::string hash;  ///< of the canonical cell
  Parameters parameters;
  CellProgram program;
  std::vector<Zone> zones;
  std::vector<ArtifactRobot> robots;          ///< the first ones of the program
  std::vector<ArtifactMechanism> mechanisms;  ///< the ones after the robots
  Policy policy = Policy::Supervisor;
  std::vector<PartSupervisor> supervisors;
  double least_distance = 0.0;  ///< from the soundness check [m]
  CellText source;              ///< the texts from which the artifact was made
  /// Hash of everything except `source`. The nodes of a cell compare it to ensure that they have the same
  /// artifact. Only set in an artifact that was read; empty before it is written.
  std::string digest;
};

/// Three lines: the result, its source texts, and a checksum of both. The same artifact gives the same bytes
/// in every locale.
[[nodiscard]] std::string toBytes(const Artifact& artifact);

/// The digest of an artifact from its bytes: SHA-256 of the first line.
[[nodiscard]] std::string digestOf(std::string_view bytes);

/// A fault is a sentence: the artifact is damaged, or has another version.
[[nodiscard]] Result<Artifact, std::string> fromBytes(std::string_view bytes);

}  // namespace cobot_command::cell
