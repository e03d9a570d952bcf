#include "forecast/command_order.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace cobot_command::command {
namespace {

std::string lineOfTag(int tag) {
  return script::toText(script::ScriptCommand(script::QueueTag{tag, false}));
}

}  // namespace

/// Behind a motion the robot gets it later than it was planned for, by as much as its plan took to make.
void takePlan(CommandOrder& order, PlannedCommand& planned, const Origin& now) {
  order.plan = std::move(*planned.plan);
  order.start = now.start.joints;
  order.tool_path = std::move(planned.tool_path);
  if (!order.plan) {
    order.target = robot::jointTargetOf(*order.commands);
    return;
  }
  order.target = order.plan->target;
  order.origin = now;
  if (!now.isBehindMotion()) return;
  const Duration since = now.arrival - order.plan->arrival;
  order.plan->arrival = now.arrival;
  order.plan->start_delay = std::max(Duration::zero(), order.plan->start_delay - since);
}

void addMarks(CommandOrder& order) {
  assert(order.mark_tags.size() == order.marks.size());
  for (std::size_t i = order.marks.size(); i-- > 0;) {
    order.lines.insert(order.lines.begin() + static_cast<std::ptrdiff_t>(order.marks[i]),
                       lineOfTag(order.mark_tags[i]));
  }
}

void addLastLines(CommandOrder& order) {
  if (order.tag) order.lines.push_back(lineOfTag(*order.tag));
  if (order.exits_node) {
    order.lines.push_back(script::toText(script::ScriptCommand(script::ScriptExit{})));
  }
}

}  // namespace cobot_command::command
