#include "cobot_command/robot/diagnosis.h"

namespace cobot_command::robot {

std::string diagnose(const link::ScriptLink& link, const RobotWatch& robot) {
  std::string text = link.diagnosis();
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (robot.emergencyStop()) {
    add("the emergency stop is pressed: release it and start the project again");
  } else if (robot.inError()) {
    const char* relief =
        robot.tooMuch() ? "execute stop, then change_tcp or change_load with less: " : "execute stop, then ";
    add("the controller is in error, " + robot.errorText() + ": " + relief +
        "the next motion clears it; if not, clear it on the controller");
  } else if (robot.showsError()) {
    add("the controller shows " + robot.errorText() + ", which was acknowledged: the next motion clears it");
  } else if (robot.paused()) {
    add("the project is paused: motions wait until it is resumed");
  } else if (robot.held()) {
    add("a safeguard holds the robot: motions wait until it is released");
  }
  return text;
}

}  // namespace cobot_command::robot
