// Reads the steps of a pick-and-place cycle from YAML. config/pick_and_place.yaml is an annotated example.
// The functions for single fields are public for readers of other file types that contain steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/pick_and_place.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::files {

struct FileStep {
  blocks::PickAndPlaceStep step;
  std::string name;  ///< display name; may be empty
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1
};

/// `name` identifies the file in the fault.
[[nodiscard]] Result<std::vector<FileStep>, FileFault> readSteps(const std::string& text,
                                                                 const std::string& name);

// Readers for the fields of a step. They throw a YamlFault.
[[nodiscard]] const YamlNames& movementNames();  ///< "PTP" and so on, with their numbers in blocks::Movement
[[nodiscard]] const YamlNames& absoluteFormatNames();  ///< those of blocks::AbsoluteFormat
/// data_format of a move to a pose or to joints. The fault of an unknown format lists the formats that the
/// movement accepts. The fault of a format relative to the tool says `of_tool`: where such moves belong.
[[nodiscard]] int toAbsoluteFormat(const YamlMap& step, int movement, const std::string& of_tool);
/// data_format of any move: one of `all`. The fault of an unknown format lists the formats of `all` that the
/// movement accepts.
[[nodiscard]] int toFormat(const YamlMap& step, int movement, const YamlNames& all);
/// Six finite numbers.
[[nodiscard]] blocks::SixValues toSix(const YamlMap& map, const char* key);
/// Reads robot_pose if the key exists.
void takePosture(const YamlMap& step, blocks::MoveAbsoluteGoal& move);
[[nodiscard]] std::optional<blocks::SetOutputGoal> toOutput(const YamlMap& step);
[[nodiscard]] std::optional<blocks::WaitForInputGoal> toInput(const YamlMap& step);
/// Dwell time [s]: missing or false: 0; true: `usual`; a number: that time.
[[nodiscard]] double toDwell(const YamlMap& step, double usual);
/// Refuses precise_positioning, the key of an older file format. Its successor disable_precise_positioning
/// has the opposite meaning.
void refuseRetiredKey(const YAML::Node& step);
/// Default dwell time of a file without its own, as in the thesis [s].
inline constexpr double kUsualDwell = 2;

/// Reads the fields that all move goals share: command_id, speed, accel_time, blending_enable,
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
