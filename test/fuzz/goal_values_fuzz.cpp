// Any goals with any values in their fields, with and without a robot, with and without an arm to plan for:
// one end for each of them, errors that the tables know, texts that a screen can show.
#include "any_goal.h"
#include "fuzz_input.h"
#include "robot_peer.h"
#include "status_frames.h"
#include "watched_core.h"

using namespace cobot_command;

namespace {

using fuzz::AnyGoal;
using fuzz::FuzzInput;
using fuzz::RobotPeer;
using fuzz::WatchedCore;
using link::Channel;

/// Each of them may be planned: more would only make slow inputs.
constexpr int kMostGoals = 12;

std::string stream(const testing::StatusFrames& items) {
  return protocol::encode(protocol::StatusFrame{"0", 1, protocol::encodeBinaryItems(items)});
}

/// A robot that stands and listens, and tells where it is.
void connect(WatchedCore& core, RobotPeer& peer) {
  core.submit(blocks::ConnectGoal{"robot", 5890, 10, {}});
  core.opened(core.connection(Channel::Script));
  core.received(core.connection(Channel::Script),
                protocol::encode(protocol::ListenNodeState{true, "Listen1"}));
  core.opened(core.connection(Channel::Status));
  core.received(core.connection(Channel::Status), stream(testing::StatusFrames()));
  peer.hear(core.takeSent());
}

/// The robot says OK to all, and has done all that it may have been told.
void obey(WatchedCore& core, RobotPeer& peer) {
  peer.hear(core.takeSent());
  std::string answers = peer.accepted() + protocol::encode(protocol::ListenNodeState{true, "Listen1"});
  for (int tag = 1; tag <= 15; ++tag) {
    answers += protocol::encode(protocol::TagReport{tag, protocol::TagState::Complete});
  }
  core.received(core.connection(Channel::Status), stream(testing::StatusFrames()));
  core.received(core.connection(Channel::Script), answers);
}

void step(FuzzInput& input, WatchedCore& core, RobotPeer& peer, AnyGoal& goals, int& submitted) {
  switch (input.choice(8)) {
    case 0:
      return core.pass(std::chrono::milliseconds(20) * input.byte());
    case 1:
      return core.cancel(input.choice(16));
    case 2:
      return core.finish(input.flag() ? blocks::FinishAfter::Move : blocks::FinishAfter::Cycle);
    case 3:
      peer.hear(core.takeSent());
      return core.received(core.connection(Channel::Script), peer.answer(input));
    case 4:
      return obey(core, peer);
    default:
      if (submitted++ < kMostGoals) core.submit(goals.next());
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::optional<arm::ArmModel> kArm = *arm::ArmModel::named("tm5-900");
  FuzzInput input(data, size);
  const bool plans = input.flag();
  WatchedCore core(plans ? kArm : std::nullopt);
  RobotPeer peer;
  if (input.choice(4) != 0) connect(core, peer);
  AnyGoal goals(input, plans);
  for (int submitted = 0; !input.empty();) step(input, core, peer, goals, submitted);
  peer.hear(core.takeSent());
  core.shutDown();
  return 0;
}
