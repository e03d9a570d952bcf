// Any sequence of (event, time, bytes) at the links of a core that is given good goals: one end for each of
// them.
#include "fuzz_input.h"
#include "robot_peer.h"
#include "status_frames.h"
#include "watched_core.h"

using namespace cobot_command;

namespace {

using fuzz::FuzzInput;
using fuzz::RobotPeer;
using fuzz::WatchedCore;
using link::Channel;

blocks::MoveAbsoluteGoal move(FuzzInput& input) {
  blocks::MoveAbsoluteGoal goal;
  goal.target = {417.5, -122.3, 343.9, 180, 0, 90};
  goal.speed = 10;
  goal.accel_time = 200;
  goal.command_id = static_cast<int>(input.choice(10));
  goal.blending_enable = input.choice(4) == 0;
  goal.exit_node = input.choice(8) == 0;
  goal.buffer_mode = static_cast<int>(input.choice(3));
  return goal;
}

blocks::Goal goodGoal(FuzzInput& input) {
  switch (input.choice(8)) {
    case 0:
      return blocks::StopGoal{};
    case 1:
      return blocks::ProgramControlGoal{0, static_cast<int>(input.choice(2))};
    case 2:
      return blocks::ExitListenNodeGoal{};
    case 3:
      return blocks::RunScriptGoal{"ChangeBase(1,2,3,0,0,0)", input.flag(), 0,
                                   static_cast<int>(input.choice(3))};
    case 4: {
      blocks::PickAndPlaceGoal cycle;
      cycle.steps = {{move(input), blocks::SetOutputGoal{0, "EndModule", 1, 1}, std::nullopt, 1},
                     {move(input), std::nullopt, std::nullopt, 0}};
      cycle.cycles = static_cast<int>(input.choice(3));
      return cycle;
    }
    case 5: {
      blocks::ChangeBaseGoal base;
      base.buffer_mode = static_cast<int>(input.choice(3));
      return base;
    }
    default:
      return move(input);
  }
}

Channel anyChannel(FuzzInput& input) {
  return input.choice(4) == 0 ? Channel::Status : Channel::Script;
}

std::string statusFrame(FuzzInput& input) {
  testing::StatusFrames frame;
  switch (input.choice(5)) {
    case 0:
      frame.moving();
      break;
    case 1:
      frame.emergencyStop();
      break;
    case 2:
      frame.error(static_cast<int>(input.byte()), input.text());
      break;
    case 3:
      return protocol::encode(protocol::StatusFrame{"0", 1, input.text()});
    default:
      break;
  }
  return protocol::encode(protocol::StatusFrame{"0", 1, protocol::encodeBinaryItems(frame)});
}

/// What the sockets tell of a connection, or its peer.
void connectionEvent(FuzzInput& input, WatchedCore& core) {
  const link::ConnectionId id = core.connection(anyChannel(input));
  switch (input.choice(4)) {
    case 0:
      return core.opened(id);
    case 1:
      return core.openFailed(id, static_cast<link::OpenFailure::Kind>(input.choice(5)));
    case 2:
      return core.received(id, input.text());
    default:
      return core.closed(id);
  }
}

void step(FuzzInput& input, WatchedCore& core, RobotPeer& peer) {
  switch (input.choice(9)) {
    case 0:
      return core.submit(blocks::ConnectGoal{"robot", 5890, 10, {}});
    case 1:
      return core.submit(goodGoal(input));
    case 2:
      return core.cancel(input.choice(16));
    case 3:
      return connectionEvent(input, core);
    case 4:
      return core.opened(core.connection(anyChannel(input)));
    case 5:
      return core.received(core.connection(Channel::Status), statusFrame(input));
    case 6:  // a late one
      return core.received(input.byte(), protocol::encode(protocol::ListenNodeState{true, "Listen1"}));
    case 7:
      return core.pass(std::chrono::milliseconds(20) * input.byte());
    default:
      peer.hear(core.takeSent());
      return core.received(core.connection(Channel::Script), peer.answer(input));
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  WatchedCore core;
  RobotPeer peer;
  while (!input.empty()) step(input, core, peer);
  core.shutDown();
  return 0;
}
