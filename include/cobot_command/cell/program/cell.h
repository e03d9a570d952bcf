// A cell as its file describes it: robots with stations and programs, what they carry, what stands around
// them.
//
// Geometry in SI [m, rad], seen from the world unless said otherwise. Steps are goals of the function blocks,
// in the units of those. Lists of named things are in the order of their names, whatever the order of the
// file; paths, steps and shapes in that of the file.
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

/// Where something stands, for the faults of later stages. No part of what a cell means: not hashed.
struct Place {
  std::string file;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1
};

/// Where a program may rest.
struct Station {
  std::string name;
  arm::JointVector joints = arm::JointVector::Zero();  ///< [rad]
  blocks::SixValues degrees{};  ///< the same as the file has them, and as steps have them as their target
  Place place;
};

using StepGoal = std::variant<blocks::MoveAbsoluteGoal, blocks::MoveRelativeGoal, blocks::MoveCircleGoal,
                              blocks::ChangeBaseGoal, blocks::ChangeTcpGoal, blocks::RunScriptGoal>;

/// A command, and what follows it once the robot stands at its target, in this order.
struct Step {
  std::string name;  ///< for people; may be empty
  StepGoal goal;
  std::string at;      ///< the station that is named in place of a pose, which is in `goal`; empty: none
  std::string attach;  ///< a part that is carried from here on; empty: none
  std::optional<blocks::SetOutputGoal> output;    ///< is set
  std::optional<blocks::WaitForInputGoal> input;  ///< is waited for
  double dwell = 0;                               ///< [s]
  std::string detach;  ///< a part that is not carried behind this step; empty: none
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
  std::string name_space;  ///< of its command node
  arm::Pose base = arm::Pose::Identity();
  std::string home;    ///< a station
  bool holds = false;  ///< holds the zones that its home is in from the start
  /// In the flange, active at home [mm, deg]; the base that is active there is that of the robot.
  blocks::SixValues tcp{};
  std::vector<Shape> tool;  ///< seen from the flange
  std::vector<Station> stations;
  std::vector<Path> program;  ///< a graph of stations
  Place place;
};

/// What robots can carry; it is there only while it is attached.
struct Part {
  std::string name;
  std::vector<Shape> shapes;  ///< seen from the part
  std::string on;             ///< the part that carries it; empty: the flange of the robot that attaches it
  arm::Pose at = arm::Pose::Identity();  ///< seen from what carries it
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

/// A motion of a mechanism from one position to another, straight along or about its axis.
struct MechanismPath {
  std::string name;
  std::string from;  ///< a position
  std::string to;
  double duration = 0;            ///< for schedules [s]; 0: it is not known
  bool controllable_go = true;    ///< false: it begins by itself
  bool controllable_book = true;  ///< false: it enters its zones by itself, once it goes
  Place place;
};

/// Turntable, pallet, track: bodies that move along or about one axis.
struct Mechanism {
  enum class Axis { Prismatic, Revolute };

  std::string name;
  Axis axis = Axis::Prismatic;
  arm::Pose at = arm::Pose::Identity();                  ///< of its frame at position 0
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the axis through the frame, of unit length
  std::vector<Shape> shapes;                             ///< seen from the frame that moves
  std::vector<MechanismPosition> positions;
  std::string home;    ///< a position
  bool holds = false;  ///< as of robots
  std::vector<MechanismPath> program;
  Place place;
};

/// What a cell was read from: its file, and those that it names, by their names in it.
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
  CellText source;  ///< no part of what a cell means: not hashed
};

/// The thing of that name in such a list; nullptr: there is none.
template <class Thing>
[[nodiscard]] const Thing* find(const std::vector<Thing>& things, std::string_view name) {
  for (const Thing& thing : things) {
    if (thing.name == name) return &thing;
  }
  return nullptr;
}

/// Where a mechanism may rest: at home, and where its paths lead from and to; in the order of its positions.
[[nodiscard]] std::vector<MechanismPosition> stationsOf(const Mechanism& mechanism);

/// Does it go over into the next motion, so that the robot never stands at its target?
[[nodiscard]] bool blends(const Step& step);
/// Does it have a motion?
[[nodiscard]] bool moves(const Step& step);

}  // namespace cobot_command::cell
