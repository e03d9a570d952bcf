#include "cobot_command/blocks/run_program.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include <fmt/format.h>

#include "cobot_command/RunProgramAction.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using Message = cobot_command::RunProgramFeedback;

std::uint8_t phaseOf(const blocks::Progress& progress, const blocks::ProgramStand& stand) {
  switch (progress.phase) {
    case blocks::Phase::Held:
      return Message::HELD;
    case blocks::Phase::Dwelling:
      return Message::DWELLING;
    case blocks::Phase::Stopping:
      return Message::STOPPING;
    case blocks::Phase::Queued:
      return stand.is_permitted ? Message::PERMITTED : Message::WAITING;
    default:
      return Message::MOVING;
  }
}

}  // namespace

blocks::RunProgramGoal toGoal(const cobot_command::RunProgramGoal& message, const Lookups& /*lookups*/) {
  blocks::RunProgramGoal goal;
  goal.cycles = message.cycles;
  if (message.paths.size() > blocks::RunProgramGoal::kMostPaths) {
    goal.paths_fault = fmt::format("{} paths are given; at most {} are allowed", message.paths.size(),
                                   blocks::RunProgramGoal::kMostPaths);
  } else {
    goal.paths = message.paths;
  }
  return goal;
}

void fill(cobot_command::RunProgramResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
  const auto& report = outcome.detail.as<blocks::ProgramReport>();
  message.cycles_done = report.cycles_done;
  message.place = report.place;
  for (const Duration waited : report.waited) message.waited.push_back(toRos(waited));
  message.actual_duration = toRos(outcome.actual);
}

void fill(cobot_command::RunProgramFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  const auto& stand = progress.detail.as<blocks::ProgramProgress>().stand;
  message.phase = phaseOf(progress, stand);
  message.path = stand.path;
  message.step = stand.step;
  message.cycle = stand.cycle;
  message.reason = static_cast<std::uint8_t>(stand.reason);
  message.blocked_by = stand.blocked_by;
  message.place_in_queue = static_cast<std::uint32_t>(stand.place_in_queue);
  message.waiting = toSeconds(stand.waiting);
  message.text = forPeople(progress.text);
}

template <>
struct ActionOf<blocks::RunProgramGoal> {
  using Type = cobot_command::RunProgramAction;
};
template std::unique_ptr<GoalListener> serve<blocks::RunProgramGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
