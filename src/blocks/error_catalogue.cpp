#include "cobot_command/blocks/error_catalogue.h"

#include <algorithm>
#include <utility>

#include "error_tables.h"

namespace cobot_command::blocks {

const char* toString(Block block) {
  switch (block) {
    case Block::Connect:
      return "connect";
    case Block::MoveAbsolute:
      return "move_absolute";
    case Block::MoveRelative:
      return "move_relative";
    case Block::MoveCircle:
      return "move_circle";
    case Block::ChangeBase:
      return "change_base";
    case Block::ChangeTcp:
      return "change_tcp";
    case Block::ProgramControl:
      return "program_control";
    case Block::Stop:
      return "stop";
    case Block::ExitListenNode:
      return "exit_listen_node";
    case Block::RunScript:
      return "run_script";
    case Block::CheckSequence:
      return "check_sequence";
    case Block::PickAndPlace:
      return "pick_and_place";
  }
  return "unknown";
}

const std::vector<ErrorEntry>& errorCatalogue() {
  static const std::vector<ErrorEntry> kCatalogue = [] {
    std::vector<ErrorEntry> all;
    for (const auto& table :
         {connectErrors(), moveAbsoluteErrors(), moveRelativeErrors(), moveCircleErrors(), changeBaseErrors(),
          changeTcpErrors(), programControlErrors(), stopErrors(), exitListenNodeErrors(), runScriptErrors(),
          checkSequenceErrors(), pickAndPlaceErrors()}) {
      all.insert(all.end(), table.begin(), table.end());
    }
    return all;
  }();
  return kCatalogue;
}

const ErrorEntry* findError(Block block, int id) {
  const auto& all = errorCatalogue();
  const auto found = std::lower_bound(
      all.begin(), all.end(), std::pair(block, id),
      [](const ErrorEntry& entry, auto wanted) { return std::pair(entry.block, entry.id) < wanted; });
  return found != all.end() && found->block == block && found->id == id ? &*found : nullptr;
}

}  // namespace cobot_command::blocks
