// The queue tag behind a raw script: whoever reads the script sees it as a line of its own, or the script is
// refused. A tag inside a comment that nobody closed would be waited for until its deadline.

#include <algorithm>

#include "decode_events.h"
#include "forecast/command_order.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#ifdef COBOT_HAS_RAPIDCHECK
#include <rapidcheck/gtest.h>
#endif

#include "cobot_command/blocks/run_script.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/tm_script/parser.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

RunScriptGoal script(const std::string& text) {
  RunScriptGoal goal;
  goal.script = text;
  goal.await_motion = true;
  return goal;
}

/// "" when the script is taken.
std::string faultOf(const std::string& text) {
  const auto failures = check(script(text));
  return failures.empty() ? "" : failures.front().found;
}

std::vector<std::string> statementsOf(const std::vector<std::string>& lines) {
  std::vector<std::string> texts;
  for (const auto& statement : tm_script::parse(fmt::format("{}", fmt::join(lines, "\r\n"))).statements) {
    texts.push_back(tm_script::toText(statement));
  }
  return texts;
}

/// What goes over the wire, read as the controller does: is what the layer adds there as if it stood alone?
bool endsWithItsTag(const RunScriptGoal& goal) {
  CommandOrder own;
  own.tag = 7;
  own.exits_node = traitsOf(goal).exits_node;
  addLastLines(own);
  std::vector<std::string> lines = orderOf(goal, arm::Pose::Identity()).lines;
  lines.insert(lines.end(), own.lines.begin(), own.lines.end());
  const auto expected = statementsOf(own.lines);
  const auto found = statementsOf(lines);
  return expected.size() == own.lines.size() && found.size() >= expected.size() &&
         std::equal(expected.rbegin(), expected.rend(), found.rbegin());
}

TEST(ScriptEnd, isRefusedInsideACommentThatIsNotClosed) {
  EXPECT_EQ(faultOf("a()\r\n/* b()"), "the comment that begins in line 2 with /* is not closed");
  EXPECT_EQ(faultOf("/*/"), "the comment that begins in line 1 with /* is not closed");
  EXPECT_EQ(faultOf("/* a */ b() /*\n//*"), "the comment that begins in line 1 with /* is not closed");
  EXPECT_EQ(faultOf("/* a() // */"), "");
  EXPECT_EQ(faultOf("a() // /*"), "");
  EXPECT_EQ(faultOf("string s = \"/*\""), "");
  EXPECT_EQ(faultOf("a()\n//"), "");
}

TEST(ScriptEnd, isRefusedInsideACommentThatItsScriptExitWouldHaveClosed) {
  EXPECT_THAT(faultOf("/*\nScriptExit() // */"), HasSubstr("/* is not closed"));
}

TEST(ScriptEnd, isRefusedBehindATextOrABracketThatIsNotClosed) {
  EXPECT_EQ(faultOf("a()\nstring s = \"x"), "the text that begins in line 2 with \" is not closed in it");
  EXPECT_EQ(faultOf("s = \"a\"\"b"), "the text that begins in line 1 with \" is not closed in it");
  EXPECT_EQ(faultOf("s = \"a\"\"\""), "");
  EXPECT_EQ(faultOf("\n\nPTP(\"JPP\",{1,2}"), "the bracket ( of line 3 is not closed");
  EXPECT_EQ(faultOf("a[1"), "the bracket [ of line 1 is not closed");
  EXPECT_EQ(faultOf("int[] a = {1,2"), "the bracket { of line 1 is not closed");
  EXPECT_EQ(faultOf(")("), "the bracket ( of line 1 is not closed");
  EXPECT_EQ(faultOf("s = \"(\" // ("), "");
}

#ifdef COBOT_HAS_RAPIDCHECK
rc::Gen<std::string> anyScript() {
  const auto piece = rc::gen::element<std::string>(
      "/*", "/* b() */", "(1)", "{2}", "\"c\"", "*/", "//", "\"", "\"\"", "(", ")", "{", "}", "[", "]", "\n",
      "\r\n", " ", "x", "a()", "int i = 1", "ScriptExit()", "\xC3\xA4", "/", "*", ",", "\\");
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece),
                      [](const auto& pieces) { return fmt::format("{}", fmt::join(pieces, "")); });
}

RC_GTEST_PROP(ScriptEnd, isSeenByTheReaderOfEachScriptThatIsTaken, ()) {
  const RunScriptGoal goal = script(*anyScript());
  const bool is_taken = check(goal).empty();
  RC_CLASSIFY(is_taken);
  RC_ASSERT(!is_taken || endsWithItsTag(goal));
}
#endif

TEST(ScriptEnd, isMissedByTheReaderOfAScriptThatLeavesACommentOpen) {
  EXPECT_TRUE(endsWithItsTag(script("a()")));
  EXPECT_TRUE(endsWithItsTag(script("a()\nScriptExit()")));
  EXPECT_FALSE(endsWithItsTag(script("a() /*")));
}

/// Frames are cut by their length: what looks like the end of one, or like another one, is only text.
TEST(ScriptEnd, cannotLeaveItsFrame) {
  for (const std::string& nasty :
       {std::string("a,*00\r\n$TMSCT,4,1,OK,*5C"), std::string("$TMSCT,15,9,ScriptExit(),*5F"),
        std::string("*,$,*,$$**"), std::string(",*6D\r\n$TMSTA,2,00,*41"), std::string("x,*"),
        std::string("\"\",*\xC3\xBC,*12\n,*34"), std::string(4096, '$'), std::string("0x10,0b11,-5")}) {
    ASSERT_EQ(faultOf(nasty), "") << nasty;
    std::string lines;
    for (const std::string& line : orderOf(script(nasty), arm::Pose::Identity()).lines) {
      lines += (lines.empty() ? "" : "\r\n") + line;
    }
    const std::string stream =
        protocol::encode(protocol::ScriptRequest{"7", lines}) + protocol::encode(protocol::ListenNodeQuery{});
    EXPECT_THAT(protocol::decode(stream), ElementsAre("TMSCT:7," + lines, "TMSTA:00"));
  }
}

}  // namespace
}  // namespace cobot_command::testing
