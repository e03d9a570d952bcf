// A cell as its file describes it: robots with stations and programs, carried parts, obstacles and
// mechanisms.
//
// Geometry is in SI [m, rad], in the world unless stated otherwise. Steps are goals of the function blocks,
// in their units. Lists of named objects are sorted by name, regardless of the order in the file; paths,
// steps and shapes keep the order of the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/change_base.h"
#include "cobot_command/blocks/change_tcp.h"
#include "cobot_command/blocks/move_absolute.h"
#include "cobot_command/blocks/move_circle.h"
#include "cobot_command/blocks/move_relative.h"
#include "cobot_command/blocks/run_script.h"
#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/waits/wait_for_input.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/cell/program/parameters.h"

namespace cobot_command::cell {

/// Position in the file, for the faults of later stages. Not part of the meaning of a cell: not hashed.
struct Place {
  std::string file;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1
};

/// A posture in which a program may rest.
struct Station {
  std::string name;
  arm::JointVector joints = arm::JointVector::Zero();  ///< [rad]
  blocks::SixValues degrees{};  ///< the same as written in the file and in step targets
  Place place;
};

using StepGoal = std::variant<blocks::MoveAbsoluteGoal, blocks::MoveRelativeGoal, blocks::MoveCircleGoal,
                              blocks::ChangeBaseGoal, blocks::ChangeTcpGoal, blocks::RunScriptGoal>;

/// A command, and the actions after the robot has stopped at its target, in this order.
struct Step {
  std::string name;  ///< for display; may be empty
  StepGoal goal;
  std::string at;      ///< station named as target instead of a pose, which is in `goal`; empty: none
  std::string attach;  ///< part that is carried from here; empty: none
  std::optional<blocks::SetOutputGoal> output;    ///< is set
  std::optional<blocks::WaitForInputGoal> input;  ///< is waited for
  double dwell = 0;                               ///< [s]
  std::string detach;                             ///< part that is not carried after this step; empty: none
  Place place;
};

struct Path {
  std::string name;
  std::string from;  ///< a station
  std::string to;
  std::vector<Step> steps;  ///< at least one
  Place place;
};

struct Robot {
  std::string name;
  std::string model;       ///< one of arm::ArmModel::knownNames()
  std::string name_space;  ///< namespace of its command node
  arm::Pose base = arm::Pose::Identity();
  std::string home;    ///< a station
  bool holds = false;  ///< owns the zones around its home from the start
  /// The TCP in the flange that is active at home [mm, deg]. The active base there is the robot base.
  blocks::SixValues tcp{};
  std::vector<Shape> tool;  ///< in the flange
  std::vector<Station> stations;
  std::vector<Path> program;  ///< paths form a graph of stations
  Place place;
};

/// An object that robots can carry. It exists only while it is attached.
struct Part {
  std::string name;
  std::vector<Shape> shapes;             ///< in the frame of the part
  std::string on;                        ///< parent part; empty: the flange of the robot that attaches it
  arm::Pose at = arm::Pose::Identity();  ///< in the frame of its parent
  Place place;
};

struct Obstacle {
  std::string name;
  std::vector<Shape> shapes;
  Place place;
};

struct MechanismPosition {
  std::string name;
  double value = 0;  ///< [m] or [rad] along or about the axis
};

/// A motion of a mechanism between two positions, straight along or about its axis.
struct MechanismPath {
  std::string name;
  std::string from;  ///< a position
  std::string to;
  double duration = 0;            ///< for schedules [s]; 0: unknown
  bool controllable_go = true;    ///< false: it starts automatically
  bool controllable_book = true;  ///< false: it enters its zones automatically after its go
  Place place;
};

/// Turntable, pallet, track: bodies that move along or about one axis.
struct Mechanism {
  enum class Axis { Prismatic, Revolute };

  std::string name;
  Axis axis = Axis::Prismatic;
  arm::Pose at = arm::Pose::Identity();                  ///< of its frame at position 0
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the axis through the frame, unit vector
  std::vector<Shape> shapes;                             ///< in the moving frame
  std::vector<MechanismPosition> positions;
  std::string home;    ///< a position
  bool holds = false;  ///< as for robots
  std::vector<MechanismPath> program;
  Place place;
};

/// The texts from which a cell was read: its file, and the files that it names, by their names in it.
struct CellText {
  std::string text;
  std::map<std::string, std::string> files;
};

struct Cell {
  std::string name;
  Parameters parameters;
  std::vector<Robot> robots;
  std::vector<Part> parts;
  std::vector<Obstacle> obstacles;
  std::vector<Mechanism> mechanisms;
  CellText source;  ///< not part of the meaning of a cell: not hashed
};

/// The object with that name in the list; nullptr: not found.
template <class Thing>
[[nodiscard]] const Thing* find(const std::vector<Thing>& things, std::string_view name) {
  for (const Thing& thing : things) {
    if (thing.name == name) return &thing;
  }
  return nullptr;
}

/// Where a mechanism may rest: at home, and at the ends of its paths; in the order of its positions.
[[nodiscard]] std::vector<MechanismPosition> stationsOf(const Mechanism& mechanism);

/// True if it blends into the next motion, so that the robot does not stop at its target.
[[nodiscard]] bool blends(const Step& step);
/// True if it has a motion.
[[nodiscard]] bool moves(const Step& step);

}  // namespace cobot_command::cell
