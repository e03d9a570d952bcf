#include "cobot_command/blocks/jog.h"

#include <cstdint>

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/JogAction.h"

namespace cobot_command::ros_adapter {
namespace {

/// An int8 of a message is a number with a sign, no character.
int toNumber(std::int8_t value) {
  return value;
}

}  // namespace

blocks::JogGoal toGoal(const cobot_command::JogGoal& message, const Lookups& /*lookups*/) {
  blocks::JogGoal goal;
  goal.mode = message.mode;
  for (std::size_t i = 0; i < goal.directions.size(); ++i) {
    goal.directions[i] = toNumber(message.directions[i]);
  }
  goal.speed = message.speed;
  goal.increment_mm = message.increment_mm;
  goal.increment_deg = message.increment_deg;
  goal.frame = toNumber(message.frame);
  goal.tool = toNumber(message.tool);
  return goal;
}

void fill(cobot_command::JogResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  const auto& report = outcome.detail.as<blocks::JogReport>();
  fillEnd(message, outcome);
  message.ended_by = static_cast<std::uint8_t>(report.ended_by);
  message.joint = static_cast<std::uint8_t>(report.joint + 1);
  message.why = report.why;
  message.means = static_cast<std::uint8_t>(report.means);
  message.way = report.way_mm;
  message.turn = report.way_deg;
  fillFinalPlace(message, outcome);
}

void fill(cobot_command::JogFeedback& message, const blocks::Progress& progress, const FillSite& /*site*/) {
  const auto& place = progress.detail.as<blocks::JogPlace>();
  fillPhase(message, progress);
  message.means = static_cast<std::uint8_t>(place.means);
  message.way = place.way_mm;
  message.turn = place.way_deg;
  message.room_mm = place.room_mm;
  message.room_deg = place.room_deg;
  message.keep_alive_age = place.keep_alive_age ? toSeconds(*place.keep_alive_age) : -1;
}

template <>
struct ActionOf<blocks::JogGoal> {
  using Type = cobot_command::JogAction;
};
template std::unique_ptr<GoalListener> serve<blocks::JogGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
