// The steps of a pick-and-place cycle as YAML; config/pick_and_place.yaml is such a file, and explains it.
// Its pieces are for who reads steps in files of another kind.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/pick_and_place.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::files {

struct FileStep {
  blocks::PickAndPlaceStep step;
  std::string name;  ///< for people; may be empty
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1
};

/// `name` stands for the file in the fault.
[[nodiscard]] Result<std::vector<FileStep>, FileFault> readSteps(const std::string& text,
                                                                 const std::string& name);

// Pieces of a step; they throw a YamlFault.
[[nodiscard]] const YamlNames& movementNames();  ///< "PTP" and so on, with their numbers of blocks::Movement
[[nodiscard]] const YamlNames& absoluteFormatNames();  ///< those of blocks::AbsoluteFormat
/// data_format of a move to a pose or to joints. One that is none is told what the movement takes, and one
/// that is relative to the tool, `of_tool`: where such moves belong.
[[nodiscard]] int toAbsoluteFormat(const YamlMap& step, int movement, const std::string& of_tool);
/// That of any move: one of `all`; what is none of them is told those among them that the movement takes.
[[nodiscard]] int toFormat(const YamlMap& step, int movement, const YamlNames& all);
/// Six finite numbers.
[[nodiscard]] blocks::SixValues toSix(const YamlMap& map, const char* key);
/// robot_pose, where there is one.
void takePosture(const YamlMap& step, blocks::MoveAbsoluteGoal& move);
[[nodiscard]] std::optional<blocks::SetOutputGoal> toOutput(const YamlMap& step);
[[nodiscard]] std::optional<blocks::WaitForInputGoal> toInput(const YamlMap& step);
/// true: `usual`; a number: that long [s].
[[nodiscard]] double toDwell(const YamlMap& step, double usual);
/// The key of a file from before, which says the contrary of the one that it has become.
void refuseRetiredKey(const YAML::Node& step);
/// The file's own, where it has none: as in the thesis [s].
inline constexpr double kUsualDwell = 2;

/// What the goals of all moves have under the same keys: command_id, speed, accel_time, blending_enable,
/// blending_value, exit_node, disable_precise_positioning.
template <class Move>
void takeMotion(const YamlMap& step, Move& move) {
  move.speed = step.whole("speed");
  move.accel_time = step.whole("accel_time");
  if (step.has("command_id")) move.command_id = step.whole("command_id");
  if (step.has("blending_enable")) move.blending_enable = step.truth("blending_enable");
  if (step.has("blending_value")) move.blending_value = step.whole("blending_value");
  if (step.has("exit_node")) move.exit_node = step.truth("exit_node");
  if (step.has("disable_precise_positioning")) {
    move.disable_precise_positioning = step.truth("disable_precise_positioning");
  }
}

}  // namespace cobot_command::files
