// A frame for the robot, and what the core says of a goal that it must not get.
#include <cstdio>
#include <variant>

#include "cobot_command/command/command_core.h"
#include "cobot_command/protocol/frame.h"

namespace {

using namespace cobot_command;

blocks::Goal outputThatNoRobotHas() {
  blocks::SetOutputGoal goal;
  goal.module = "ControlBox";
  goal.output = 99;
  return goal;
}

}  // namespace

int main() {
  std::printf("%s", protocol::encodeFrame(protocol::header::kScript, "1,ScriptExit()").c_str());
  command::CommandCore core(std::nullopt, {});
  core.submit(1, outputThatNoRobotHas(), Instant{});
  for (const command::Action& action : core.takeActions()) {
    if (const auto* ended = std::get_if<command::GoalEnded>(&action)) {
      std::printf("%s\n", ended->outcome.error_description.c_str());
    }
  }
}
