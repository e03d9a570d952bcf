// The queue of motions: its tags, its stop, its pause; and the end of the Listen node.

#include <utility>

#include "function_row.h"

namespace cobot_command::script {
namespace {

constexpr int kLastTag = 15;

QueueTag makeQueueTag(CallArguments& arguments) {
  const int tag = arguments.integer();
  return {tag, arguments.more() && arguments.integer() == 1};
}

void writeQueueTag(CallText& text, const QueueTag& queue) {
  text << queue.tag << (queue.wait ? 1 : 0);
}

WaitQueueTag makeWaitQueueTag(CallArguments& arguments) {
  WaitQueueTag wait{arguments.integer(), {}};
  if (arguments.more()) wait.timeout = arguments.integer();
  return wait;
}

void writeWaitQueueTag(CallText& text, const WaitQueueTag& wait) {
  text << wait.tag << wait.timeout;
}

/// StopAndClearBuffer and ScriptExit.
template <class Command>
Command makeWithMode(CallArguments& arguments) {
  Command command;
  if (arguments.more()) command.mode = arguments.integer();
  return command;
}

template <class Command>
void writeWithMode(CallText& text, const Command& command) {
  text << command.mode;
}

/// Immediate, with a number since TMflow 1.82.
template <class Command>
FunctionRow modeRow(std::string_view name, tm_script::Version since, int last_mode) {
  FunctionRow row{"bool",
                  name,
                  {{"", since}, {"literal int", {1, 82}}},
                  FunctionRow::Way::Immediate,
                  {},
                  {{0, "the mode", 0, last_mode}}};
  return rowOf<Command, makeWithMode<Command>, writeWithMode<Command>>(std::move(row));
}

}  // namespace

std::vector<FunctionRow> queueFunctions() {
  using Way = FunctionRow::Way;
  return {
      rowOf<QueueTag, makeQueueTag, writeQueueTag>(
          {"bool",
           "QueueTag",
           {{"int, int?", {1, 76}}},
           Way::Queued,
           {},
           {{0, "the tag", 1, kLastTag}, {1, "whether to wait", 0, 1}}}),
      rowOf<WaitQueueTag, makeWaitQueueTag, writeWaitQueueTag>(
          {"int", "WaitQueueTag", {{"int, int?", {1, 76}}}, Way::Immediate}),
      modeRow<StopAndClearBuffer>("StopAndClearBuffer", {1, 72}, 2),
      plainRow<Pause>("Pause", {1, 72}, Way::Immediate),
      plainRow<Resume>("Resume", {1, 72}, Way::Immediate),
      modeRow<ScriptExit>("ScriptExit", {1, 68}, 1),
  };
}

}  // namespace cobot_command::script
