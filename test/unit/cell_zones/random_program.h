// Programs at random, of all that a cell may have: for promises that have to hold of all of them.
#pragma once

#include <random>
#include <string>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::cell {

/// The same numbers in every run.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  double within(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(engine_); }
  bool coin() { return upTo(1) == 0; }
  arm::JointVector joints(double most);
  /// Each order of size as often as the next one.
  double ofAnySize(double lower, double upper);

 private:
  std::mt19937_64 engine_;
};

/// A part "sheet" on the flange, and one "clip" on the sheet.
[[nodiscard]] std::vector<Part> sheetAndClip();

/// A TM5-900 "R" with the gripper of the demos, one station and no program yet.
[[nodiscard]] Cell cellOfOne(const arm::JointVector& home);

/// Adds steps that can be planned to the path of the robot of a cell with one robot.
class RandomProgram {
 public:
  RandomProgram(std::uint64_t seed, int steps);

  Cell cell;

 private:
  [[nodiscard]] Step anyStep();
  [[nodiscard]] StepGoal ptp();
  [[nodiscard]] StepGoal line();
  [[nodiscard]] StepGoal circle();
  [[nodiscard]] StepGoal relative();
  [[nodiscard]] StepGoal script();
  [[nodiscard]] StepGoal frame();
  template <class Goal>
  void takeDynamics(Goal& goal);
  /// A pose of the TCP near where it is now, in the active base [mm, deg].
  [[nodiscard]] blocks::SixValues nearby(double metres, double radians);
  /// False: it cannot be planned here.
  bool add(Step step);
  void carry(Step& step);
  void endAtHome();

  Dice dice_;
  planning::ScriptPlanner planner_;
};

}  // namespace cobot_command::cell
