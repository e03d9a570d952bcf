// Whatever comes from outside, what the core says of it is short, UTF-8, and has no control characters: in
// results, progress, status, frames, traces and the log.

#include "cobot_command/common/foreign_text.h"

#include <numeric>

#include "block_goals.h"
#include "core_rig.h"
#include "foreign_bytes.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using namespace robot;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Room for the words around a text, and for more than one of them.
constexpr std::size_t kLongest = 4096;

std::vector<std::string> hostileTexts() {
  return {std::string(50000, 'x'),  std::string(50000, '\x1B'), std::string(50000, '\xFF'),
          test_support::allBytes(), "\xED\xA0\x80\xC0\xAF",     "a\u0085b\u2028c\u202Ed"};
}

void expectFit(const std::string& text) {
  EXPECT_LE(text.size(), kLongest);
  EXPECT_EQ(text, escaped(text));
  EXPECT_THAT(text, test_support::IsHarmless());
}

void expectAllFit(CoreRig& rig) {
  const CommandStatus& status = rig.latest();
  for (const std::string& text :
       {status.diagnosis, status.status_diagnosis, status.listen_node, status.host}) {
    expectFit(text);
  }
  for (const BlockOutputs& outputs : status.blocks) expectFit(outputs.error_description);
  for (const FrameTraced& trace : rig.traces) expectFit(trace.meaning);
  for (const std::string& warning : rig.warnings) expectFit(warning);
  for (const link::RobotStatus& robot : rig.robot_statuses) {
    for (const auto& text : {robot.error_text, robot.base_name, robot.tcp_name}) expectFit(text.value_or(""));
  }
  for (const ActiveFrames& frames : rig.active_frames) {
    expectFit(frames.base_name);
    expectFit(frames.tcp_name);
  }
}

void expectOutcomeFits(CoreRig& rig, GoalId id) {
  ASSERT_NE(rig.outcome(id), nullptr);
  expectFit(rig.outcome(id)->error_description);
  expectFit(rig.outcome(id)->remedy);
  for (const Progress& progress : rig.progress(id)) expectFit(progress.text);
}

TEST(ForeignTexts, ofAListenNodeAreToldShort) {
  for (const std::string& text : hostileTexts()) {
    CoreRig rig;
    rig.listen_node = text;
    const GoalId connect = rig.connect();
    rig.say(protocol::ListenNodeEntered{text});
    rig.say(protocol::ListenData{90, text});
    expectAllFit(rig);
    rig.shutDown();
    expectOutcomeFits(rig, connect);
  }
}

TEST(ForeignTexts, ofTheStatusStreamAreToldShort) {
  for (const std::string& text : hostileTexts()) {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames()
                   .error(0x13, text)
                   .with({"Base_Name", text})
                   .with({"TCP_Name", text})
                   .with({text.substr(0, 30000), text}));
    expectAllFit(rig);
    const GoalId refused = rig.submit(CoreRig::move());
    expectOutcomeFits(rig, refused);
  }
}

TEST(ForeignTexts, thatAreNoFramesAreToldShort) {
  for (const std::string& text : hostileTexts()) {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.connect();
    for (const auto channel : {link::Channel::Script, link::Channel::Status}) {
      rig.receive(text + "\r\n", channel);
      rig.receive(protocol::encodeFrame("TMSCT", text), channel);
      rig.receive(protocol::encodeFrame("TMSTA", text), channel);
      rig.receive(protocol::encodeFrame("TMSVR", text), channel);
      rig.receive(protocol::encodeFrame("TMSVR", "1,2," + text), channel);
      rig.receive(protocol::encodeFrame("CPERR", text), channel);
      rig.receive(protocol::encodeFrame(std::string(5000, 'H'), text), channel);
    }
    rig.discardSent();
    expectAllFit(rig);
  }
}

TEST(ForeignTexts, ofGoalsAreToldShort) {
  for (const std::string& text : hostileTexts()) {
    CoreRig rig;
    rig.connect();
    ConnectGoal elsewhere = CoreRig::robot();
    elsewhere.host = text;
    const std::vector<Goal> goals = {elsewhere,
                                     with<ChangeBaseGoal>([&](auto& g) { g.base_name = text; }),
                                     with<ChangeTcpGoal>([&](auto& g) { g.tcp_name = text; }),
                                     with<RunScriptGoal>([&](auto& g) { g.script = text; }),
                                     with<PickAndPlaceGoal>([&](auto& g) {
                                       g.steps[0].output = SetOutputGoal{0, text, 0, 1};
                                     }),
                                     with<MoveAbsoluteGoal>([&](auto& g) {
                                       g.target_pose.emplace();
                                       g.target_pose->frame = text;
                                       g.target_pose->fault = text;
                                     })};
    for (const Goal& goal : goals) {
      const GoalId id = rig.submit(goal);
      if (rig.outcome(id) != nullptr) expectOutcomeFits(rig, id);
    }
    rig.discardSent();
    expectAllFit(rig);
  }
}

TEST(RefusedLines, aListOfAMillionIsToldShortAndAsTheFaultOfTheController) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(CoreRig::move());
  std::vector<int> lines(1000000);
  std::iota(lines.begin(), lines.end(), 1);
  rig.reply(rig.takeScript().id, false, lines);
  expectOutcomeFits(rig, id);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kRejected);
  EXPECT_THAT(rig.outcome(id)->error_description,
              AllOf(HasSubstr("line 1: PTP("), HasSubstr("line 2: QueueTag("),
                    HasSubstr("999998 lines that the script of 2 lines does not have, such as line 3")));
  expectAllFit(rig);
}

TEST(RefusedLines, areToldOnceEachAndOnlyThoseThatThereAre) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, false, {2, 2, 0, 1});
  expectOutcomeFits(rig, id);
  const std::string& found = rig.outcome(id)->error_description;
  EXPECT_THAT(found, HasSubstr("line 1: PTP("));
  EXPECT_THAT(found, HasSubstr("one that the script of 2 lines does not have, such as line 0"));
  EXPECT_EQ(found.find("line 2: "), found.rfind("line 2: "));

  const GoalId other = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, false, {1});
  expectOutcomeFits(rig, other);
  EXPECT_THAT(rig.outcome(other)->error_description, Not(HasSubstr("does not have")));
}

TEST(RefusedLines, areNoDetailOfTheBlock) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, false, {2, 9, 1});
  EXPECT_THAT(rig.outcome(id)->refused_lines, ElementsAre(StartsWith("QueueTag("), StartsWith("PTP(")));
  EXPECT_TRUE(rig.outcome(id)->detail.isNone());
}

TEST(RefusedLines, ofALongScriptAreCut) {
  CoreRig rig;
  rig.connect();
  RunScriptGoal goal;
  for (int i = 0; i < 40; ++i) goal.script += "g_note = \"" + std::string(80, 'x') + "\"\r\n";
  const GoalId id = rig.submit(goal);
  std::vector<int> lines(40);
  std::iota(lines.begin(), lines.end(), 1);
  rig.reply(rig.takeScript().id, false, lines);
  expectOutcomeFits(rig, id);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("and 32 more lines"));
}

}  // namespace
}  // namespace cobot_command::testing
