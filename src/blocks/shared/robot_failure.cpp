#include "cobot_command/blocks/shared/robot_failure.h"

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr const char* kStartTheProject = "Start the project on the controller, then connect again";

}  // namespace

Failure emergencyStop() {
  return {motion_error::kLinkDropped, "emergency stop",
          "Release the emergency stop and start the project again"};
}

void tellStoppedProject(const robot::RobotWatch& robot, Failure& loss) {
  if (!robot.projectStopped() || loss.remedy == kStartTheProject) return;
  loss.found = "the project was stopped: " + loss.found;
  loss.remedy = kStartTheProject;
}

Failure robotError(const robot::RobotWatch& robot) {
  const std::string way_out = !robot.tooMuch()
                                  ? ""
                                  : fmt::format(
                                        "Execute stop, then change_tcp with the mounted tool, and at most {} "
                                        "kg of tool and load (change_load) together: the next motion then "
                                        "clears the error. If it does not, clear it on the controller",
                                        robot.tooMuch()->payload);
  return {own_error::kRobotError, robot.errorText(), way_out};
}

}  // namespace cobot_command::blocks
