#include "runs/command_window.h"

#include "motion_goals.h"
#include "recording_wire.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::array<double, 6> kAside{60, 0, 90, 0, 90, 0};
constexpr std::array<double, 6> kBack{-30, 0, 90, 0, 90, 0};

/// Two motions of one goal at the controller, in the order of their keys.
class CommandWindowTest : public ::testing::Test {
 protected:
  CommandWindowTest() {
    link_.start("robot", 5890, now_);
    link_.opened(now_);
  }

  void send(const std::array<double, 6>& joints_deg, blocks::CommandKey key,
            const std::vector<std::size_t>& marks = {}) {
    const blocks::Goal goal = testing::moveJoints(joints_deg);
    blocks::Command command = *blocks::GoalRules(goal).command();
    command.key = key;
    CommandOrder order = forecast_.order(command).value();
    order.marks = marks;
    takePlan(order, *forecast_.plan(order, forecast_.origin(now_)), forecast_.origin(now_));
    ASSERT_FALSE(window_.prepare(order, command.traits, now_));
    tags_of_[key] = *order.tag;
    marks_of_[key] = order.mark_tags;
    window_.send(std::move(order), now_);
    ids_of_[key] = idOf(wire_.sent.back());
  }
  void sendTwo() {
    send(kAside, 1);
    send(kBack, 2);
  }
  /// "$TMSCT,len,ID,..."
  static std::string idOf(const std::string& frame) {
    const auto begin = frame.find(',', frame.find(',') + 1) + 1;
    return frame.substr(begin, frame.find(',', begin) - begin);
  }
  static link::ScriptAnswered reply(const std::string& id, bool accepted) {
    return {id, protocol::ScriptReply{id, accepted, {}}};
  }
  void accept(blocks::CommandKey key) { window_.answered(reply(ids_of_[key], true), now_); }
  bool complete(blocks::CommandKey key) {
    return window_.tagReported({tags_of_[key], false, protocol::TagState::Complete}, now_);
  }
  std::vector<std::pair<blocks::CommandKey, blocks::Ending>> takeEnded() {
    std::vector<std::pair<blocks::CommandKey, blocks::Ending>> all;
    while (const auto ended = window_.takeEnded(now_)) all.emplace_back(ended->key, ended->outcome.ending);
    return all;
  }

  link::LinkSettings settings_;
  testing::RecordingWire wire_;
  link::ScriptLink link_{settings_, wire_};
  link::TagLedger tags_;
  robot::RobotWatch robot_;
  std::vector<Action> actions_;
  std::shared_ptr<const arm::ArmModel> arm_;  ///< nothing is planned
  tables::TableStore tables_;
  SpeedOverride speed_;
  Forecast forecast_{arm_, robot_, tables_, speed_, actions_};
  StopRun stop_{settings_, link_, tags_, robot_, nullptr};
  PlanDesk desk_{settings_.planning_budget, actions_, Planning::AtOnce};
  CommandWindow window_{{settings_, link_, tags_, robot_, stop_, nullptr}, forecast_, desk_, {}};
  Instant now_{};
  std::map<blocks::CommandKey, std::string> ids_of_;
  std::map<blocks::CommandKey, int> tags_of_;
  std::map<blocks::CommandKey, std::vector<int>> marks_of_;
};

TEST_F(CommandWindowTest, sendsTheSecondWhileTheFirstIsUnderWay) {
  const auto before = wire_.sent.size();
  sendTwo();
  EXPECT_EQ(window_.size(), 2U);
  ASSERT_EQ(wire_.sent.size(), before + 2);
  EXPECT_NE(ids_of_[1], ids_of_[2]);
  EXPECT_NE(tags_of_[1], tags_of_[2]);
}

TEST_F(CommandWindowTest, endsEachByItsOwnTag) {
  sendTwo();
  accept(1);
  accept(2);
  EXPECT_TRUE(complete(1));
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::Done)));
  EXPECT_EQ(window_.size(), 1U);
  EXPECT_TRUE(complete(2));
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(2U, blocks::Ending::Done)));
  EXPECT_TRUE(window_.empty());
}

TEST_F(CommandWindowTest, takesATagThatNobodyWaitsForForNothing) {
  send(kAside, 1);
  EXPECT_FALSE(window_.tagReported({tags_of_[1] + 1, false, protocol::TagState::Complete}, now_));
  EXPECT_TRUE(takeEnded().empty());
}

TEST_F(CommandWindowTest, endsTheOneThatTheControllerRefusesAndKeepsTheOther) {
  sendTwo();
  accept(1);
  window_.answered(reply(ids_of_[2], false), now_);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(2U, blocks::Ending::Aborted)));
  EXPECT_EQ(window_.size(), 1U);
}

TEST_F(CommandWindowTest, stopsWhatWasSentBehindOneThatTheControllerRefuses) {
  sendTwo();
  window_.answered(reply(ids_of_[1], false), now_);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::Aborted)));
  EXPECT_THAT(wire_.sent.back(), HasSubstr("StopAndClearBuffer"));
  stop_.answered(reply(idOf(wire_.sent.back()), true), now_);
  while (const auto result = stop_.takeResult()) window_.stopEnded(*result, now_);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(2U, blocks::Ending::CommandAborted)));
}

TEST_F(CommandWindowTest, stopsAllOfThemWithOneStopWhenOneFailsInMotion) {
  sendTwo();
  accept(1);
  accept(2);
  const auto before = wire_.sent.size();
  window_.tagReported({tags_of_[2], false, protocol::TagState::Incomplete}, now_);  // behind the first one
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(2U, blocks::Ending::Aborted)));
  EXPECT_EQ(wire_.sent.size(), before + 1);
  EXPECT_THAT(wire_.sent.back(), HasSubstr("StopAndClearBuffer"));
  stop_.answered(reply(idOf(wire_.sent.back()), true), now_);
  while (const auto result = stop_.takeResult()) window_.stopEnded(*result, now_);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::CommandAborted)));
}

TEST_F(CommandWindowTest, tellsHowFarACommandHasComeByItsMarks) {
  send(kAside, 1, {0, 1});
  ASSERT_EQ(marks_of_[1].size(), 2U);
  EXPECT_THAT(wire_.sent.back(), HasSubstr("QueueTag(" + std::to_string(marks_of_[1][0]) + ",0)\r\nPTP"));
  accept(1);
  EXPECT_TRUE(window_.tagReported({marks_of_[1][1], false, protocol::TagState::Complete}, now_));
  EXPECT_THAT(window_.takePassed(), ElementsAre(std::pair(1U, 1U))) << "the report of the first one was lost";
  EXPECT_TRUE(takeEnded().empty());
  EXPECT_TRUE(complete(1));
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::Done)));
  EXPECT_TRUE(tags_.openTags().empty());
}

/// Its number is that of another client's.
TEST_F(CommandWindowTest, believesNoTagAsLongAsOneInFrontOfItIsOpen) {
  sendTwo();
  accept(1);
  accept(2);
  EXPECT_FALSE(complete(2));
  EXPECT_TRUE(takeEnded().empty());
  EXPECT_TRUE(complete(1));
  EXPECT_TRUE(complete(2));
}

TEST_F(CommandWindowTest, endsAllWithTheLink) {
  sendTwo();
  accept(1);
  window_.linkLost("reset by peer", now_);
  EXPECT_THAT(takeEnded(),
              ElementsAre(std::pair(1U, blocks::Ending::Aborted), std::pair(2U, blocks::Ending::Aborted)));
}

TEST_F(CommandWindowTest, knowsWhereTheLastOfThemGoes) {
  sendTwo();
  ASSERT_TRUE(window_.target());
  EXPECT_TRUE(window_.target()->joints.isApprox(arm::toJointVector(kBack)));
  EXPECT_TRUE(window_.mayMove());
  EXPECT_TRUE(window_.stopsWithACancel());
}

TEST_F(CommandWindowTest, endsAllWhenAStopBehindACancelIsConfirmed) {
  sendTwo();
  accept(1);
  accept(2);
  const auto before = wire_.sent.size();
  window_.cancel("cancelled", now_);
  EXPECT_EQ(wire_.sent.size(), before + 1);
  EXPECT_THAT(wire_.sent.back(), HasSubstr("StopAndClearBuffer"));
  stop_.answered(reply(idOf(wire_.sent.back()), true), now_);
  while (const auto result = stop_.takeResult()) window_.stopEnded(*result, now_);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::CommandAborted),
                                       std::pair(2U, blocks::Ending::CommandAborted)));
}

TEST_F(CommandWindowTest, letsTheOnesBesideEndByTheirAnswer) {
  send(kAside, 1);
  blocks::SetOutputGoal output;
  output.at_once = true;
  const blocks::Goal goal = output;
  window_.sendBeside(*blocks::GoalRules(goal).command(), 9, now_);
  EXPECT_EQ(window_.size(), 1U) << "they take no place";
  EXPECT_FALSE(window_.nothingBeside());

  window_.answered(reply(idOf(wire_.sent.back()), true), now_);
  const auto ended = window_.takeEndedBeside();
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_EQ(ended[0].goal, 9U);
  EXPECT_EQ(ended[0].outcome.ending, blocks::Ending::Done);
  EXPECT_TRUE(window_.nothingBeside());
}

}  // namespace
}  // namespace cobot_command::command
