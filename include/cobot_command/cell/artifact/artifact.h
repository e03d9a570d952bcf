// What is made of a cell file, proved, and run: zones, programs, supervisors, and what each robot has to know
// of its own frames.
//
// It is bound to the file by its hash; nothing runs on one that does not fit (cell.md, M5). SI [m, rad, s].
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

/// A piece as a robot's side needs it: where its joints are, and which zones it touches.
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
  std::vector<std::string> lines;  ///< exactly what may be sent, without queue tag
  /// Where its first motion starts, and the frames in which it was planned; nothing, where it does not move.
  std::optional<arm::JointVector> start;
  arm::Pose base = arm::Pose::Identity();
  arm::Pose tcp = arm::Pose::Identity();
  bool stands = true;
  std::vector<std::string> carried;               ///< parts, while it moves; ascending
  std::optional<blocks::SetOutputGoal> output;    ///< is set once the robot stands at its end
  std::optional<blocks::WaitForInputGoal> input;  ///< then it is waited for
  double dwell = 0.0;                             ///< then [s]
  Duration begin{};                               ///< since the path began, when nothing waits
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
  std::vector<FlangeCapsules> tool;        ///< always there
  std::vector<FlangeCapsules> parts;       ///< that it carries somewhere
  std::vector<ArtifactStation> stations;   ///< as in the program
  std::vector<ArtifactPath> paths;
};

/// A piece of a mechanism: between which values of its axis [m or rad] it is, as it passes them.
struct ArtifactAxisPiece {
  double from = 0.0;
  double to = 0.0;
  std::vector<ZoneIndex> zones;  ///< ascending
};

struct ArtifactMechanismPath {
  std::vector<ArtifactAxisPiece> pieces;  ///< the last one is its rest at the end
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
  std::vector<ArtifactMechanism> mechanisms;  ///< those behind them
  Policy policy = Policy::Supervisor;
  std::vector<PartSupervisor> supervisors;
  double least_distance = 0.0;  ///< of the soundness check [m]
  CellText source;              ///< what all of this is made of
  /// Of all of this but `source`: by that the nodes of a cell know that they have the same artifact. Of one
  /// that was read; empty before it is written.
  std::string digest;
};

/// Three lines: what was made, what it was made of, and a checksum of both. The same bytes for the same
/// artifact, on any locale.
[[nodiscard]] std::string toBytes(const Artifact& artifact);

/// That of Artifact, of the bytes of one: SHA-256 of the first line.
[[nodiscard]] std::string digestOf(std::string_view bytes);

/// A fault is a sentence: it is damaged, or of another version.
[[nodiscard]] Result<Artifact, std::string> fromBytes(std::string_view bytes);

}  // namespace cobot_command::cell
