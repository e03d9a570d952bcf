#include "cobot_command/cell/supervision/report.h"

#include <algorithm>
#include <cmath>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

constexpr std::size_t kMaxEvents = 256;  // since the last one that was acknowledged
constexpr std::size_t kMaxZones = 4096;
/// No joint of an arm turns so far.
constexpr double kMaxJoint = 100.0;    // [rad]
constexpr double kMaxStatusAge = 1e6;  // [s]

}  // namespace

const char* toString(RobotCondition condition) {
  switch (condition) {
    case RobotCondition::Ok:
      return "OK";
    case RobotCondition::Paused:
      return "PAUSED";
    case RobotCondition::Manual:
      return "MANUAL";
    case RobotCondition::Stopped:
      return "STOPPED";
    case RobotCondition::Error:
      return "ERROR";
    case RobotCondition::OffPath:
      return "OFF_PATH";
    case RobotCondition::Unlinked:
      return "UNLINKED";
  }
  return "";
}

std::optional<std::string> malformed(const RobotReport& report) {
  const auto is_text = [](const std::string& text) { return text.size() <= kLongestText && isUtf8(text); };
  const bool are_texts =
      is_text(report.robot) && is_text(report.hash) && is_text(report.place) && is_text(report.text);
  if (!are_texts || report.robot.empty()) return "a text is too long, or not UTF-8";
  if (report.events.size() > kMaxEvents) return "there are too many events";
  if (report.touched_zones.size() > kMaxZones) return "there are too many zones";
  if (!std::is_sorted(report.touched_zones.begin(), report.touched_zones.end())) {
    return "its zones are not sorted";
  }
  if (report.session == 0 || report.number == 0) return "it has no session or no number";
  if (report.condition > RobotCondition::Unlinked) return "its condition is invalid";
  const bool are_joints = std::all_of(report.joints.begin(), report.joints.end(),
                                      [](double joint) { return std::abs(joint) <= kMaxJoint; });
  if (!are_joints) return "its joints are not angles";
  if (!(report.status_age >= 0.0 && report.status_age <= kMaxStatusAge)) {
    return "the age of its status is invalid";
  }
  const bool are_kinds =
      std::all_of(report.events.begin(), report.events.end(),
                  [](const NumberedEvent& event) { return event.kind <= NumberedEvent::Kind::Withdrawn; });
  if (!are_kinds) return "an event has an invalid kind";
  return std::nullopt;
}

}  // namespace cobot_command::cell
