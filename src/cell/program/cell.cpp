#include "cobot_command/cell/program/cell.h"

#include <algorithm>
#include <type_traits>

namespace cobot_command::cell {

namespace {

using blocks::RunScriptGoal;
using script::ScriptCommand;

template <class Goal>
bool blendsOf(const Goal& goal) {
  return goal.blending_enable;
}
bool blendsOf(const blocks::ChangeBaseGoal& /*goal*/) {
  return false;
}
bool blendsOf(const blocks::ChangeTcpGoal& /*goal*/) {
  return false;
}
template <class Command, class = void>
constexpr bool kHasOptions = false;
template <class Command>
constexpr bool kHasOptions<Command, std::void_t<decltype(std::declval<Command>().options)>> = true;

std::vector<ScriptCommand> commandsOf(const RunScriptGoal& goal) {
  return orderOf(goal, arm::Pose::Identity()).commands.value_or(std::vector<ScriptCommand>());
}

/// By its last motion.
bool blendsOf(const RunScriptGoal& goal) {
  bool blend = false;
  const auto take = [&blend](const auto& command) {
    if constexpr (kHasOptions<std::decay_t<decltype(command)>>) blend = command.options.blending > 0;
  };
  for (const ScriptCommand& command : commandsOf(goal)) std::visit(take, command);
  return blend;
}

template <class Goal>
bool movesOf(const Goal& /*goal*/) {
  return true;
}
bool movesOf(const blocks::ChangeBaseGoal& /*goal*/) {
  return false;
}
bool movesOf(const blocks::ChangeTcpGoal& /*goal*/) {
  return false;
}
bool movesOf(const RunScriptGoal& goal) {
  const auto is_motion = [](const auto& command) {
    using Command = std::decay_t<decltype(command)>;
    return kHasOptions<Command> || std::is_same_v<Command, script::PvtPoint>;
  };
  const auto commands = commandsOf(goal);
  return std::any_of(commands.begin(), commands.end(),
                     [&](const ScriptCommand& command) { return std::visit(is_motion, command); });
}

}  // namespace

std::vector<MechanismPosition> stationsOf(const Mechanism& mechanism) {
  std::vector<MechanismPosition> stations;
  for (const MechanismPosition& position : mechanism.positions) {
    const bool rests =
        position.name == mechanism.home ||
        std::any_of(mechanism.program.begin(), mechanism.program.end(), [&](const MechanismPath& path) {
          return path.from == position.name || path.to == position.name;
        });
    if (rests) stations.push_back(position);
  }
  return stations;
}

bool blends(const Step& step) {
  return std::visit([](const auto& goal) { return blendsOf(goal); }, step.goal);
}

bool moves(const Step& step) {
  return std::visit([](const auto& goal) { return movesOf(goal); }, step.goal);
}

}  // namespace cobot_command::cell
