#include "command_order.h"

#include "block_rules.h"
#include <fmt/format.h>

namespace cobot_command::blocks {
namespace {

CommandOrder orderOf(Block block, protocol::ScriptCommand command, bool moves) {
  CommandOrder order;
  order.block = block;
  order.moves = moves;
  order.lines.push_back(protocol::toText(command));
  order.commands.emplace().push_back(std::move(command));
  return order;
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
  if (const auto parsed = protocol::parseScript(fmt::format("{}", fmt::join(order.lines, "\r\n")))) {
    order.commands.emplace();
    for (const auto& line : parsed->lines) order.commands->push_back(line.command);
  }
  return order;
}

CommandOrder orderOf(const ProgramControlGoal& goal) {
  return orderOf(Block::ProgramControl, commandOf(goal), false);
}

std::optional<protocol::IoModule> moduleOf(const OutputAction& output) {
  if (output.module == "EndModule") return protocol::IoModule::EndModule;
  if (output.module == "ControlBox") return protocol::IoModule::ControlBox;
  return std::nullopt;
}

CommandOrder orderOf(const OutputAction& output) {
  protocol::WriteOutput write;
  write.module = *moduleOf(output);
  write.index = output.output;
  write.on = output.value;
  // A line of script, and it fails as one: the cycle tells that error as the one of its step.
  return orderOf(Block::RunScript, write, false);
}

void addLastLines(CommandOrder& order) {
  if (order.tag) {
    order.lines.push_back(protocol::toText(protocol::ScriptCommand(protocol::QueueTag{*order.tag, false})));
  }
  if (order.exits_node) {
    order.lines.push_back(protocol::toText(protocol::ScriptCommand(protocol::ScriptExit{})));
  }
}

}  // namespace cobot_command::blocks
