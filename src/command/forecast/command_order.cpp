#include "forecast/command_order.h"

namespace cobot_command::command {

void addLastLines(CommandOrder& order) {
  if (order.tag) {
    order.lines.push_back(script::toText(script::ScriptCommand(script::QueueTag{*order.tag, false})));
  }
  if (order.exits_node) {
    order.lines.push_back(script::toText(script::ScriptCommand(script::ScriptExit{})));
  }
}

}  // namespace cobot_command::command
