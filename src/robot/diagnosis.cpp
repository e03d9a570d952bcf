#include "cobot_command/robot/diagnosis.h"

#include <fmt/format.h>

#include "cobot_command/link/stream_items.h"

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
    add("a safeguard stops the robot: motions wait until it is released");
  }
  return text;
}

std::string whatIsUnseen(const RobotWatch& robot) {
  if (!robot.status()) {
    return "no status stream shows the robot: motions are sent unplanned and unchecked, and only their queue "
           "tags report that they are done";
  }
  const auto missing = link::missingForReady(*robot.status());
  if (missing.empty()) return "";
  const char* motions = !robot.tellsMotion() ? ", so only their queue tags report that motions are done"
                        : !robot.joints()    ? ", so the end positions of motions are not confirmed"
                                             : "";
  return fmt::format("the status stream does not have {}{}", namesOf(missing), motions);
}

}  // namespace cobot_command::robot
