#include "checks/step_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::cell {

namespace {

using blocks::RunScriptGoal;
using script::ScriptCommand;

/// The rules of a block, with the words of its catalogue.
template <class Goal>
void checkGoal(const Goal& goal, const Step& step, const std::string& field, FaultList& faults) {
  for (const blocks::Failure& failure : check(goal)) {
    const blocks::ErrorEntry* entry = blocks::findError(blocks::kBlock<Goal>, failure.error_id);
    const std::string allowed = entry == nullptr ? "" : entry->description;
    const std::string remedy = entry == nullptr ? "" : entry->remedy;
    faults.add(step.place, field,
               {"",
                fmt::format("is refused by {}: {}", Goal::kName,
                            foreignText(failure.found.empty() ? allowed : failure.found)),
                allowed, failure.remedy.empty() ? remedy : failure.remedy});
  }
}

std::vector<ScriptCommand> commandsOf(const Step& step) {
  const auto commands = [](const auto& goal) { return orderOf(goal, arm::Pose::Identity()).commands; };
  return std::visit(commands, step.goal).value_or(std::vector<ScriptCommand>());
}

/// Why a command of a script has no place in a cell; empty: it has.
std::string whyNot(const ScriptCommand& command) {
  using namespace script;
  const auto named = [](const auto& frame) { return std::holds_alternative<std::string>(frame); };
  return std::visit(
      Overloaded{[](const ContinueVJog&) { return "sets velocities, which cannot be planned"; },
                 [](const ContinueVLine&) { return "sets velocities, which cannot be planned"; },
                 [](const SetContinueVJog&) { return "sets velocities, which cannot be planned"; },
                 [](const SetContinueVLine&) { return "sets velocities, which cannot be planned"; },
                 [](const StopContinueVmode&) { return "sets velocities, which cannot be planned"; },
                 [](const SuspendContinueVmode&) { return "sets velocities, which cannot be planned"; },
                 [](const ScriptExit&) { return "leaves the Listen node, after which no permit is valid"; },
                 [](const Pause&) { return "pauses or clears motions that were permitted"; },
                 [](const Resume&) { return "pauses or clears motions that were permitted"; },
                 [](const PvtPause&) { return "pauses or clears motions that were permitted"; },
                 [](const PvtResume&) { return "pauses or clears motions that were permitted"; },
                 [](const StopAndClearBuffer&) { return "pauses or clears motions that were permitted"; },
                 [&named](const ChangeBase& change) {
                   return named(change.base) ? "names a base of the project, whose value is unknown here"
                                             : "";
                 },
                 [&named](const ChangeTcp& change) {
                   return named(change.tcp) ? "names a TCP of the project, whose value is unknown here" : "";
                 },
                 [](const auto& /*any other*/) { return ""; }},
      command);
}

void checkScript(const RunScriptGoal& goal, const Step& step, const std::string& field, FaultList& faults) {
  if (!check(goal).empty()) return;  // told by the block's own rules
  const auto order = orderOf(goal, arm::Pose::Identity());
  if (traitsOf(goal).exits_node) {
    faults.add(step.place, field,
               {"script", "leaves the Listen node, after which no permit is valid",
                "scripts without ScriptExit()", "remove ScriptExit()"});
  }
  if (!order.commands) {
    faults.add(step.place, field,
               {"script", "cannot be interpreted before it runs",
                "lines that can be interpreted from their text alone",
                "write values instead of what only the controller knows, and no velocities"});
    return;
  }
  for (const ScriptCommand& command : *order.commands) {
    const std::string why = whyNot(command);
    if (why.empty()) continue;
    faults.add(step.place, field,
               {"script", fmt::format("has {}, which {}", foreignText(toText(command), kQuoteLimit), why),
                "motions that can be planned, frames by value", "remove it, or write values"});
  }
}

/// A robot that does not stand at the target can do nothing there.
void checkStand(const Step& step, const std::string& field, FaultList& faults) {
  const std::vector<std::pair<const char*, bool>> parts{{"attach", !step.attach.empty()},
                                                        {"output", step.output.has_value()},
                                                        {"input", step.input.has_value()},
                                                        {"dwell", step.dwell > 0},
                                                        {"detach", !step.detach.empty()}};
  for (const auto& [key, is_there] : parts) {
    if (!is_there || !blends(step)) continue;
    faults.add(step.place, field,
               {key, "is at a step that blends into the next motion",
                "at a step at whose target the robot stops", "remove blending from the step"});
  }
  if (!isDwell(step.dwell)) {
    faults.add(step.place, field, {"dwell", fmt::format("is {} s", step.dwell), kDwellRange, ""});
  }
  if (!step.attach.empty() && step.attach == step.detach) {
    faults.add(step.place, field, {"detach", "is the part that the step attaches", "another one", ""});
  }
}

template <class Goal>
bool exits(const Goal& goal) {
  return goal.exit_node;
}
bool exits(const RunScriptGoal& /*goal*/) {
  return false;  // looked for in its lines
}

}  // namespace

void takeFrames(const Step& step, ActiveFrames& frames) {
  for (const ScriptCommand& command : commandsOf(step)) {
    if (const auto* base = std::get_if<script::ChangeBase>(&command)) {
      frames.base = std::get<script::SixNumbers>(base->base);
    }
    if (const auto* tcp = std::get_if<script::ChangeTcp>(&command)) {
      frames.tcp = std::get<script::SixNumbers>(tcp->tcp);
    }
  }
}

void checkStep(const Step& step, const std::string& field, FaultList& faults) {
  std::visit([&](const auto& goal) { checkGoal(goal, step, field, faults); }, step.goal);
  if (const auto* goal = std::get_if<RunScriptGoal>(&step.goal)) checkScript(*goal, step, field, faults);
  if (std::visit([](const auto& goal) { return exits(goal); }, step.goal)) {
    faults.add(step.place, field,
               {"exit_node", "leaves the Listen node, after which no permit is valid", "false, or nothing",
                "remove it"});
  }
  if (step.output) checkGoal(*step.output, step, joined(field, "output"), faults);
  if (step.input) checkGoal(*step.input, step, joined(field, "input"), faults);
  checkStand(step, field, faults);
}

}  // namespace cobot_command::cell
