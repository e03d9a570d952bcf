// What a step must not be, whatever it is planned like: the rules of its block, and those of cells.
#pragma once

#include "checks/fault_list.h"

namespace cobot_command::cell {

/// How long a robot may dwell, as in pick_and_place.
[[nodiscard]] inline bool isDwell(double seconds) {
  return seconds >= 0 && seconds <= 3600;  // false for NaN, too
}
inline constexpr const char* kDwellRange = "0 to 3600 s";

/// `field`: of the step.
void checkStep(const Step& step, const std::string& field, FaultList& faults);

/// The frames in which a robot moves, as the controller has them [mm, deg].
struct ActiveFrames {
  blocks::SixValues base{};  ///< in the robot base
  blocks::SixValues tcp{};   ///< in the flange
};
/// What is active once the step is done; what it does not set stays as it is. Precondition: it names none of
/// the project.
void takeFrames(const Step& step, ActiveFrames& frames);

}  // namespace cobot_command::cell
