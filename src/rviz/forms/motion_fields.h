// What the moves have in common: data formats, speed, blending, and what the robot does at the target.
#pragma once

#include <string>
#include <vector>

#include "forms/form.h"

namespace cobot_command::rviz_plugin {

inline constexpr int kLine = 0;  ///< movement_command
inline constexpr int kPtp = 1;

/// A data format of a block, by its three letters (thesis 5.3.2.5 and the like): target, speed, blending.
struct Format {
  int value;
  const char* letters;  ///< "CAR": J, C or T; P or A; P or R
  const char* meaning;
};

[[nodiscard]] bool isInJoints(const Format& format);
[[nodiscard]] bool hasAbsoluteSpeed(const Format& format);
[[nodiscard]] bool blendsByRadius(const Format& format);
/// Whether a movement command can be given in it: PTP in % alone, Line not in joints.
[[nodiscard]] bool suits(const Format& format, int movement_command);

[[nodiscard]] Option toOption(const Format& format);
[[nodiscard]] Field movementField();
[[nodiscard]] Field bufferModeField();
/// Speed and ramps, blending, and the end of the motion.
void addMotion(std::vector<Field>& fields);
/// Shows the speed and the blending in the units of the format.
void showUnits(Form& form, const Format& format);

}  // namespace cobot_command::rviz_plugin
