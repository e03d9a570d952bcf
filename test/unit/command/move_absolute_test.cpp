// What a MoveAbsolute sends, and when it is done.

#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(MoveAbsolute, isDoneWhenItsTagComesBack) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  EXPECT_TRUE(rig.accepted(goal));
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script, "PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,false)\r\nQueueTag(1,0)");
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);

  rig.reply(script.id);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  EXPECT_EQ(rig.latest().queue_depth, 1);
  EXPECT_EQ(rig.latest().open_tags, std::vector<int>{1});

  rig.now += 3s;
  rig.tag(1);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(goal)->command_id_ack, 1);
  EXPECT_EQ(rig.outcome(goal)->actual, Duration(3s));
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).done);
  EXPECT_EQ(rig.latest().queue_depth, 0);
  EXPECT_TRUE(rig.latest().open_tags.empty());
}

TEST(MoveAbsolute, sendsLineWithTheSpeedAndBlendingOfItsFormat) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.movement_command = 0;
  goal.data_format = static_cast<int>(AbsoluteFormat::Car);
  goal.speed = 250;
  goal.blending_enable = true;
  goal.blending_value = 2000;
  const GoalId id = rig.submit(goal);
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script, "Line(\"CAR\",417.5,-122.3,343.9,180,0,90,250,200,2000,false)");
  rig.reply(script.id);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(id)->command_id_ack, 0);
  EXPECT_FALSE(rig.outcome(id)->actual.has_value());
}

TEST(MoveAbsolute, honoursTheCommandIdAsTag) {
  for (const int command_id : {2, 9}) {
    CoreRig rig;
    rig.connect();
    MoveAbsoluteGoal goal = CoreRig::move();
    goal.command_id = command_id;
    const GoalId id = rig.submit(goal);
    const auto script = rig.takeScript();
    EXPECT_THAT(script.script, HasSubstr("QueueTag(" + std::to_string(command_id) + ",0)"));
    rig.reply(script.id);
    rig.tag(command_id);
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->command_id_ack, command_id);
  }
}

TEST(MoveAbsolute, acknowledgesTheCommandIdOfABlendedMotionToo) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = CoreRig::blended();
  goal.command_id = 7;
  const GoalId id = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->command_id_ack, 7);
}

TEST(MoveAbsolute, countsATagThatComesBeforeTheReply) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.now += 1ms;
  rig.tag(1);
  EXPECT_EQ(rig.outcome(goal), nullptr) << "not done before the controller accepted it";
  rig.reply(script.id);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(goal)->actual, Duration(1ms));
}

TEST(MoveAbsolute, takesReplyAndTagFromOneSegmentAndFromSingleBytes) {
  for (const bool bytewise : {false, true}) {
    CoreRig rig;
    rig.connect();
    const GoalId goal = rig.submit(CoreRig::move());
    const auto script = rig.takeScript();
    const std::string stream = protocol::encode(protocol::ScriptReply{script.id, true, {}}) +
                               protocol::encode(protocol::TagReport{1, protocol::TagState::Complete});
    if (bytewise) {
      for (const char byte : stream) rig.receive(std::string(1, byte));
    } else {
      rig.receive(stream);
    }
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  }
}

TEST(MoveAbsolute, acceptsAReplyWithWarnings) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, true, {1});
  rig.tag(1);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST(MoveAbsolute, isNotDoneByAnotherTag) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const auto late = rig.latest().late_replies;
  rig.tag(2);
  rig.tag(11);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.latest().late_replies, late + 2);
  rig.tag(1);
  EXPECT_NE(rig.outcome(goal), nullptr);
}

TEST(MoveAbsolute, usesEachTagAsLateAsPossibleAgain) {
  CoreRig rig;
  rig.connect();
  for (int round = 0; round < 2; ++round) {
    for (int tag = 1; tag <= 15; ++tag) {
      const GoalId goal = rig.submit(CoreRig::move());
      const auto script = rig.takeScript();
      EXPECT_THAT(script.script, HasSubstr("QueueTag(" + std::to_string(tag) + ",0)"));
      rig.reply(script.id);
      rig.tag(tag);
      ASSERT_NE(rig.outcome(goal), nullptr);
    }
  }
}

TEST(MoveAbsolute, leavesTheListenNodeWhenAskedTo) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.exit_node = true;
  const GoalId id = rig.submit(goal);
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, EndsWith("QueueTag(1,0)"));
  rig.reply(script.id);
  rig.tag(1);
  EXPECT_EQ(rig.outcome(id), nullptr) << "it is done when the node is to be left";
  const auto exit = rig.takeScript();
  EXPECT_EQ(exit.script, "ScriptExit()");
  rig.reply(exit.id);
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
  rig.pass(1500ms);  // the lifesign is answered "true" as long as the node is not really left
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);

  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kNotListening);

  rig.say(protocol::ListenNodeEntered{"Listen2"});
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::Ready);
  EXPECT_EQ(rig.latest().listen_node, "Listen2");
  rig.submit(CoreRig::move());
  rig.takeScript();
}

TEST(MoveAbsolute, letsTheNextOneFollowABlendedOneAtOnce) {
  CoreRig rig;
  rig.connect();
  const GoalId first = rig.submit(CoreRig::blended(50));
  rig.reply(rig.takeScript().id);
  const GoalId second = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.reply(script.id);
  rig.tag(1);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::Done);
  ASSERT_NE(rig.outcome(second), nullptr);
  EXPECT_EQ(rig.outcome(second)->ending, Ending::Done);
}

TEST(MoveAbsolute, tracesEveryFrameWithItsMeaning) {
  CoreRig rig;
  rig.connect();
  rig.traces.clear();
  rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.reply(script.id);
  rig.reply("Stranger");
  ASSERT_EQ(rig.traces.size(), 3u);
  EXPECT_TRUE(rig.traces[0].sent);
  EXPECT_THAT(rig.traces[0].bytes, HasSubstr("PTP("));
  EXPECT_FALSE(rig.traces[1].sent);
  EXPECT_THAT(rig.traces[1].meaning, HasSubstr(script.id));
  EXPECT_THAT(rig.traces[2].meaning, HasSubstr("no request waits for it"));
}

}  // namespace
}  // namespace cobot_command::testing
