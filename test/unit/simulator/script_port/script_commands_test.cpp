// What single commands do to the robot, and what their lines wait for, without a script.
#include "script_port/script_commands.h"

#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

Instant at(Duration since_start) {
  return Instant{} + since_start;
}

struct Commands : ::testing::Test {
  arm::ArmModel model = arm::ArmModel::named("tm5-900").value();
  Settings settings;
  FaultSwitches faults;
  Outbox outbox;
  Outgoing outgoing{faults, outbox};
  MotionQueue queue{model, settings.start_posture, {}, faults};
  IoBoard io{outbox};
  ProjectData project{settings, model};
  TagTable tags;
  ScriptClients clients{{}, faults, outgoing, outbox};
  ScriptCommands commands{
      {model, queue, io, project, [] { return RobotState(); }}, tags, faults, clients, {1, 80}};

  [[nodiscard]] std::string failureOf(const script::ScriptCommand& command) {
    const auto answer = commands.perform(command);
    const auto* failure = std::get_if<tm_script::CallFailure>(&answer);
    return failure == nullptr ? "" : failure->reason;
  }
  [[nodiscard]] bool waits(const script::ScriptCommand& command) {
    return std::holds_alternative<tm_script::Wait>(commands.perform(command));
  }
};

TEST_F(Commands, queueWhatTheyQueueAndDoTheRestAtOnce) {
  script::WriteOutput write;
  write.index = 3;
  write.on = true;
  EXPECT_EQ(failureOf(write), "");
  EXPECT_EQ(queue.waiting().size(), 1U);
  EXPECT_FALSE(io.outputs().at(write.module, 3));
  write.instant = true;
  EXPECT_EQ(failureOf(write), "");
  EXPECT_EQ(queue.waiting().size(), 1U);
  EXPECT_TRUE(io.outputs().at(write.module, 3));
}

TEST_F(Commands, haveNoRoomInAFullQueueButForWhatIsNotQueued) {
  while (commands.room().entries > 0) queue.push(LoadChange{});
  EXPECT_EQ(queue.waiting().size(), ScriptCommands::kMostQueued);
  EXPECT_EQ(failureOf(script::QueueTag{1, false}), "the queue of motions is full");
  EXPECT_EQ(failureOf(script::Pause{}), "");
  EXPECT_TRUE(queue.paused());
}

TEST_F(Commands, haveRoomForThePointsOfPvtApartFromAllElse) {
  EXPECT_EQ(failureOf(script::PvtEnter{}), "");
  while (commands.room().points > 0) ASSERT_EQ(failureOf(script::PvtPoint{}), "");
  EXPECT_EQ(queue.waiting().pvtPoints(), ScriptCommands::kMostPvtPoints);
  EXPECT_EQ(failureOf(script::PvtPoint{}), "the queue of motions is full");
  EXPECT_EQ(failureOf(script::QueueTag{1, false}), "");
  EXPECT_EQ(failureOf(script::PvtExit{}), "");
  EXPECT_EQ(failureOf(script::PvtEnter{}), "");
  EXPECT_EQ(failureOf(script::PvtPoint{}), "the queue of motions is full") << "those that wait count, too";
}

TEST_F(Commands, waitForTheTagThatTheyQueue) {
  EXPECT_FALSE(waits(script::QueueTag{5, false}));
  EXPECT_FALSE(commands.takeWait());
  EXPECT_TRUE(waits(script::QueueTag{6, true}));
  const auto wait = commands.takeWait();
  ASSERT_TRUE(wait);
  EXPECT_EQ(wait->tag->tag, 6);
  EXPECT_EQ(wait->until, Instant::max());
  EXPECT_FALSE(wait->is_question);
  EXPECT_FALSE(commands.takeWait()) << "told once";
}

TEST_F(Commands, waitForAKnownTagAsLongAsTheySay) {
  commands.setTime(at(2s));
  EXPECT_FALSE(waits(script::WaitQueueTag{7, 100})) << "nobody has queued it";
  EXPECT_FALSE(waits(script::QueueTag{7, false}));
  EXPECT_TRUE(waits(script::WaitQueueTag{7, 100}));
  const auto wait = commands.takeWait();
  ASSERT_TRUE(wait);
  EXPECT_EQ(wait->until, at(2100ms));
  EXPECT_TRUE(wait->is_question);
}

TEST_F(Commands, takePointsOnlyWithinAPvtAndNoOtherMotionThere) {
  EXPECT_EQ(failureOf(script::PvtPoint{}), "PVTPoint is only allowed after PVTEnter");
  EXPECT_EQ(failureOf(script::PvtExit{}), "PVTExit is only allowed after PVTEnter");
  EXPECT_EQ(failureOf(script::PvtEnter{}), "");
  EXPECT_EQ(failureOf(script::Ptp{}), "another motion is not allowed between PVTEnter and PVTExit");
  EXPECT_EQ(failureOf(script::PvtPoint{}), "");
  EXPECT_EQ(failureOf(script::PvtExit{}), "");
  EXPECT_EQ(queue.motionCount(), 1);
}

TEST_F(Commands, endTheScriptWithScriptExit) {
  EXPECT_FALSE(commands.takeExit());
  EXPECT_TRUE(std::holds_alternative<tm_script::EndScript>(commands.perform(script::ScriptExit{})));
  EXPECT_TRUE(commands.takeExit());
  EXPECT_FALSE(commands.takeExit()) << "told once";
}

}  // namespace
}  // namespace cobot_command::simulator
