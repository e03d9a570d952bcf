// Raw script: what is taken, what is refused, and that no script leaves its frame.

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

RunScriptGoal script(const std::string& text) {
  RunScriptGoal goal;
  goal.script = text;
  return goal;
}

std::string faultOf(const std::string& text) {
  const auto failures = check(script(text));
  if (failures.empty()) return "";
  EXPECT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures.front().error_id, own_error::kScriptInvalid);
  return failures.front().found;
}

TEST(RunScriptRules, takeLinesEndedByEitherSeparatorAndDropEmptyOnes) {
  const auto goal = script("\r\nint i = 1\r\ni++\n\n \t\nvar_x = i\t// text\r\n");
  EXPECT_EQ(errorOf(goal), 0);
  EXPECT_THAT(orderOf(goal, arm::Pose::Identity()).lines,
              ElementsAre("int i = 1", "i++", "var_x = i\t// text"));
}

TEST(RunScriptRules, takeWhatTheLayerHasNoBlockFor) {
  for (const char* line :
       {"IO[\"ControlBox\"].DO[2]=1", "ListenSend(90,GetString(Robot[0].CoordRobot))", "ChangeLoad(5.3)",
        "StopAndClearBuffer()", "ScriptExit(0)", "string s = \"\xE9\x81\x94\xE6\x98\x8E\"", "MyQueueTag(1)",
        "QueueTags = 1", "QueueTag2 = 1", "_QueueTag = 1"}) {
    EXPECT_EQ(faultOf(line), "") << line;
  }
}

TEST(RunScriptRules, refuseAScriptWithoutAnyLine) {
  for (const char* text : {"", "\n", "\r\n\r\n", "  \t"}) EXPECT_EQ(faultOf(text), "it is empty");
}

TEST(RunScriptRules, takeUpTo4096Bytes) {
  EXPECT_EQ(faultOf(std::string(4096, 'x')), "");
  EXPECT_EQ(faultOf(std::string(4097, 'x')), "it has 4097 bytes");
  EXPECT_EQ(faultOf(std::string(1000000, '\n')), "it has 1000000 bytes");
}

TEST(RunScriptRules, refuseControlCharactersAndWhatIsNotUtf8) {
  for (const std::string& bad :
       {std::string("a\rb"), std::string("a\r\r\nb"), std::string("a\0b", 3), std::string("\x1B[2J"),
        std::string("\x7F"), std::string("\x02"), std::string("\xFF"), std::string("\xC3"),
        std::string("\xED\xA0\x80"), std::string("\xC0\x8A")}) {
    EXPECT_EQ(faultOf("good()\n" + bad), "line 2 has control characters, or is not UTF-8");
  }
}

TEST(RunScriptRules, refuseQueueTagsWhereverTheyHide) {
  for (const char* line : {"QueueTag(1)", "QueueTag(1,1)", " \tQueueTag (3)", "i=1;QueueTag(1)",
                           "queuetag(1)", "QUEUETAG(1)", "//QueueTag(1)", "if(a)QueueTag(1)"}) {
    EXPECT_THAT(faultOf(std::string("x()\r\n\r\n") + line), HasSubstr("line 3 has QueueTag")) << line;
  }
  EXPECT_THAT(faultOf("int r = WaitQueueTag(1,5000)"), HasSubstr("line 1 has WaitQueueTag"));
  EXPECT_THAT(faultOf("QueueTag"), HasSubstr("line 1 has QueueTag"));
  EXPECT_THAT(faultOf("QueueTags(QueueTag(1))"), HasSubstr("line 1 has QueueTag"));
}

TEST(RunScriptRules, leaveTheNodeBehindTheQueueTag) {
  const auto goal = script("PTP(1)\n ScriptExit() // done\n\n");
  EXPECT_EQ(errorOf(goal), 0);
  EXPECT_TRUE(traitsOf(goal).exits_node);
  EXPECT_THAT(orderOf(goal, arm::Pose::Identity()).lines, ElementsAre("PTP(1)"));
  EXPECT_THAT(orderOf(script("ScriptExit()"), arm::Pose::Identity()).lines, ElementsAre());
  EXPECT_FALSE(traitsOf(script("PTP(1)")).exits_node);
}

TEST(RunScriptRules, refuseLinesThatWouldNeverRun) {
  EXPECT_EQ(faultOf("a()\nScriptExit()\nb()"), "the lines after line 2, ScriptExit(), would never run");
}

TEST(RunScriptRules, takePriorityCommandsOnlyByThemselves) {
  for (const char* line : {"StopAndClearBuffer(0)", "StopAndClearBuffer ( 2 )", "ScriptExit(1) // now"}) {
    EXPECT_EQ(faultOf(line), "") << line;
    EXPECT_THAT(faultOf(std::string("a()\n") + line), HasSubstr("line 2 is a priority command")) << line;
    auto awaited = script(line);
    awaited.await_motion = true;
    EXPECT_EQ(errorOf(awaited), own_error::kScriptInvalid) << line;
  }
  EXPECT_EQ(faultOf("a()\nStopAndClearBuffer( )\nb()"), "");
}

TEST(RunScriptRules, takeReplyTimeoutsOfTheirRangeAndZero) {
  const auto timeout = [](double seconds) {
    return with<RunScriptGoal>([&](auto& g) { g.reply_timeout = seconds; });
  };
  for (const double seconds : {0.0, 0.05, 3600.0}) EXPECT_EQ(errorOf(timeout(seconds)), 0) << seconds;
  for (const double seconds : {-1.0, 0.049, 3600.001, kNan, kInf}) {
    EXPECT_EQ(errorOf(timeout(seconds)), own_error::kReplyTimeoutRange) << seconds;
  }
  EXPECT_FALSE(traitsOf(timeout(0)).reply_timeout);
  EXPECT_EQ(traitsOf(timeout(0.05)).reply_timeout, Duration(50ms));
  EXPECT_EQ(traitsOf(timeout(3600)).reply_timeout, Duration(3600s));
}

TEST(RunScriptRules, awaitTheirMotionsWhenAskedTo) {
  EXPECT_FALSE(traitsOf(good<RunScriptGoal>()).awaits_motion);
  EXPECT_TRUE(traitsOf(with<RunScriptGoal>([](auto& g) { g.await_motion = true; })).awaits_motion);
}

TEST(RunScriptRules, nameTheFirstViolationAndListTheOthers) {
  const auto goal = with<RunScriptGoal>([](auto& g) {
    g.reply_timeout = -1;
    g.script = "";
    g.buffer_mode = -1;
  });
  EXPECT_EQ(idsOf(goal), (std::vector<int>{own_error::kBufferModeUnknown, own_error::kScriptInvalid,
                                           own_error::kReplyTimeoutRange}));
}

}  // namespace
}  // namespace cobot_command::testing
