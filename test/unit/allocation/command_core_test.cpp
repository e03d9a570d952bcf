// A command core that runs out of memory, at each single allocation of a run.
#include "cobot_command/command/command_core.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "failing_allocation.h"
#include "status_frames.h"

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::allocation {
namespace {

using blocks::Ending;
using link::Channel;

/// A core and, at the other end, a robot that does as it is told. Only what the core does may run out of
/// memory.
class Story {
 public:
  Story(const FailingAllocation& failing, std::optional<arm::ArmModel> arm)
      : failing_(failing),
        core_(failing.during([&] { return command::CommandCore(std::move(arm), link::LinkSettings{}); })) {}

  void connect() {
    submit(blocks::ConnectGoal{"robot", 5890, 10, {}});
    for (const Channel channel : {Channel::Script, Channel::Status}) {
      tell([&](auto& core) { core.opened(connections_.at(channel), now_); });
    }
    say(protocol::ListenNodeState{true, "Listen1"});
    stream(testing::StatusFrames());
  }

  void submit(const blocks::Goal& goal) {
    ++last_goal_;
    tell([&](auto& core) { core.submit(last_goal_, goal, now_); });
  }
  void cancel(blocks::GoalId goal) {
    tell([&](auto& core) { core.cancel(goal, now_); });
  }
  void accept() { say(protocol::ScriptReply{last_script_, true, {}}); }
  void complete(int tag) { say(protocol::TagReport{tag, protocol::TagState::Complete}); }
  void say(const protocol::ControllerMessage& message) { receive(protocol::encode(message)); }
  void receive(const std::string& bytes) {
    tell([&](auto& core) { core.received(connections_.at(Channel::Script), bytes, now_); });
  }
  void stream(const testing::StatusFrames& items) {
    const auto bytes = protocol::encode(protocol::StatusFrame{"0", 1, protocol::encodeBinaryItems(items)});
    tell([&](auto& core) { core.received(connections_.at(Channel::Status), bytes, now_); });
  }
  void lose() {
    tell(
        [&](auto& core) { core.closed(connections_.at(Channel::Script), "connection reset by peer", now_); });
  }
  void pass(Duration duration) {
    now_ += duration;
    tell([&](auto& core) { core.advance(now_); });
  }

  [[nodiscard]] const std::vector<Ending>& endings() const { return endings_; }

 private:
  template <class Event>
  void tell(const Event& event) {
    const auto actions = failing_.during([&] {
      event(core_);
      return core_.takeActions();
    });
    for (const auto& action : actions) {
      std::visit([this](const auto& what) { this->take(what); }, action);
    }
  }

  void take(const command::OpenConnection& open) { connections_[open.channel] = open.id; }
  void take(const command::SendBytes& send) {
    if (send.id != connections_[link::Channel::Script]) return;  // who the controller is: nobody answers
    sent_.feed(send.bytes);
    while (const auto event = sent_.next()) {
      const auto message = protocol::parseClientMessage(std::get<protocol::Frame>(*event));
      if (const auto* const script = std::get_if<protocol::ScriptRequest>(&*message)) {
        last_script_ = script->id;
      }
    }
  }
  void take(const command::GoalEnded& ended) { endings_.push_back(ended.outcome.ending); }
  template <class Told>
  void take(const Told& /*told*/) {}

  const FailingAllocation& failing_;
  command::CommandCore core_;
  Instant now_{std::chrono::seconds(1000)};
  blocks::GoalId last_goal_ = 0;
  std::map<Channel, link::ConnectionId> connections_;
  protocol::FrameDecoder sent_;
  std::string last_script_;
  std::vector<Ending> endings_;
};

testing::StatusFrames standingAt(float joint_deg) {
  return testing::StatusFrames().with(protocol::item::ofFloats("Joint_Angle", {joint_deg, 0, 90, 0, 90, 0}));
}

blocks::MoveAbsoluteGoal move(int tag) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target = {10.0 * tag, 0, 90, 0, 90, 0};
  goal.speed = 50;
  goal.accel_time = 200;
  goal.command_id = tag;
  return goal;
}

/// A connect, a move, a script, a sequence to check, a cancel with a move that waits, garbage, a lost link.
std::vector<Ending> tell(const FailingAllocation& failing, const std::optional<arm::ArmModel>& arm) {
  Story story(failing, arm);
  story.connect();
  story.submit(move(2));
  story.accept();
  story.stream(standingAt(20));
  story.complete(2);
  story.stream(standingAt(20));
  story.submit(blocks::RunScriptGoal{"ChangeBase(\"RobotBase\")", false, 0, 0});
  story.accept();
  story.submit(move(3));
  story.accept();
  story.stream(testing::StatusFrames().moving());
  auto behind = move(5);
  behind.buffer_mode = static_cast<int>(blocks::BufferMode::Buffered);
  story.submit(behind);
  story.submit(blocks::CheckSequenceGoal{{move(2), move(3)}, "", {0, 0, 90, 0, 90, 0}});
  story.cancel(4);
  story.accept();
  story.stream(standingAt(20));
  story.pass(std::chrono::milliseconds(15));
  story.stream(standingAt(20));
  story.pass(std::chrono::seconds(1));
  story.say(protocol::ListenNodeState{true, "Listen1"});
  story.receive("noise$TMSTA,3,01,*00\r\n");
  story.submit(move(4));
  story.lose();
  story.pass(std::chrono::seconds(1));
  return story.endings();
}

/// A sequence can only be checked by a core that plans.
std::vector<Ending> endingsWith(Ending check) {
  return {Ending::Done,           Ending::Done,    check,          Ending::CommandAborted,
          Ending::CommandAborted, Ending::Aborted, Ending::Aborted};
}

TEST(OutOfMemory, leavesNothingOfACommandCoreThatDoesNotPlan) {
  EXPECT_EQ(tell(FailingAllocation(0), std::nullopt), endingsWith(Ending::Rejected));
  failEachAllocationOf([](const auto& failing) { tell(failing, std::nullopt); });
}

TEST(OutOfMemory, leavesNothingOfACommandCoreThatPlans) {
  const std::optional<arm::ArmModel> arm = *arm::ArmModel::named("tm5-900");
  EXPECT_EQ(tell(FailingAllocation(0), arm), endingsWith(Ending::Done));
  failEachAllocationOf([&](const auto& failing) { tell(failing, arm); });
}

}  // namespace
}  // namespace cobot_command::allocation
