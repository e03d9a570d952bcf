#include "command_order.h"

#include <algorithm>

#include "block_rules.h"
#include <fmt/format.h>

#include "cobot_command/script/script_reader.h"

namespace cobot_command::blocks {
namespace {

CommandOrder orderOf(Block block, script::ScriptCommand command, bool moves) {
  CommandOrder order;
  order.block = block;
  order.moves = moves;
  order.lines.push_back(script::toText(command));
  order.commands.emplace().push_back(std::move(command));
  return order;
}

/// ContinueVJog(), SetContinueVLine() and the like move the arm for as long as nothing else comes, also
/// behind a queue tag. Looked for in the text, as not every script can be read.
bool setsVelocities(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.find("ContinueV") != std::string::npos; });
}

/// Pause(), and not PVTPause(), which holds a PVT alone and is not shown as a pause.
bool pauses(const std::string& line) {
  for (std::size_t at = line.find("Pause("); at != std::string::npos; at = line.find("Pause(", at + 1)) {
    if (at == 0 || line.compare(at - 1, 1, "T") != 0) return true;
  }
  return false;
}

}  // namespace

CommandOrder orderOf(const MoveAbsoluteGoal& goal, const arm::Pose& base) {
  return orderOf(Block::MoveAbsolute, commandOf(goal, base), true);
}

CommandOrder orderOf(const MoveRelativeGoal& goal, const arm::Pose& base) {
  return orderOf(Block::MoveRelative, commandOf(goal, base), true);
}

CommandOrder orderOf(const MoveCircleGoal& goal, const arm::Pose& base) {
  return orderOf(Block::MoveCircle, commandOf(goal, base), true);
}

CommandOrder orderOf(const ChangeBaseGoal& goal, const arm::Pose& base) {
  return orderOf(Block::ChangeBase, commandOf(goal, base), false);
}

CommandOrder orderOf(const ChangeTcpGoal& goal, const arm::Pose& base) {
  return orderOf(Block::ChangeTcp, commandOf(goal, base), false);
}

CommandOrder orderOf(const ExitListenNodeGoal& /*goal*/, const arm::Pose& /*base*/) {
  CommandOrder order;
  order.block = Block::ExitListenNode;
  order.commands.emplace();
  return order;
}

CommandOrder orderOf(const RunScriptGoal& goal, const arm::Pose& /*base*/) {
  CommandOrder order;
  order.block = Block::RunScript;
  order.moves = true;
  order.lines = linesOf(goal);
  order.stands_at_end = !setsVelocities(order.lines);
  order.pauses = std::any_of(order.lines.begin(), order.lines.end(), pauses);
  if (const auto read = script::readScript(fmt::format("{}", fmt::join(order.lines, "\r\n")))) {
    order.commands.emplace();
    for (const auto& [line, command] : *read) order.commands->push_back(command);
    order.has_exit =
        !order.commands->empty() && std::holds_alternative<script::ScriptExit>(order.commands->back());
  }
  return order;
}

CommandOrder orderOf(const ProgramControlGoal& goal) {
  CommandOrder order = orderOf(Block::ProgramControl, commandOf(goal), false);
  order.beside = true;
  return order;
}

CommandOrder orderOf(const OutputAction& output) {
  script::WriteOutput write;
  write.module = *script::ioModule(output.module);
  write.index = output.output;
  write.on = output.value;
  // A line of script, and it fails as one: the cycle tells that error as the one of its step.
  return orderOf(Block::RunScript, write, false);
}

void addLastLines(CommandOrder& order) {
  if (order.tag) {
    order.lines.push_back(script::toText(script::ScriptCommand(script::QueueTag{*order.tag, false})));
  }
  if (order.exits_node) {
    order.lines.push_back(script::toText(script::ScriptCommand(script::ScriptExit{})));
  }
}

}  // namespace cobot_command::blocks
