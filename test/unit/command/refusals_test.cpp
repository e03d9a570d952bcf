// What the core refuses before a byte is sent, with which ErrorID. The parameters of the commands: the tests
// of their rules.

#include <cmath>
#include <functional>
#include <limits>

#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// The ErrorID of a refusal, 0 when the goal was sent.
int errorOf(CoreRig& rig, const MoveAbsoluteGoal& goal) {
  const int scripts = rig.scripts_sent;
  const GoalId id = rig.submit(goal);
  const Outcome* outcome = rig.outcome(id);
  if (outcome == nullptr) {
    EXPECT_EQ(rig.scripts_sent, scripts + 1);
    rig.reply(rig.takeScript().id, false, {1});  // out of the way
    return 0;
  }
  EXPECT_EQ(outcome->ending, Ending::Rejected);
  EXPECT_EQ(rig.scripts_sent, scripts) << "a refusal sends nothing";
  EXPECT_EQ(
      outcome->error_description.find(findError(kBlock<MoveAbsoluteGoal>, outcome->error_id)->description),
      0u);
  EXPECT_FALSE(outcome->remedy.empty());
  EXPECT_TRUE(rig.latest().open_tags.empty());
  return outcome->error_id;
}

class Refusal : public ::testing::Test {
 protected:
  Refusal() { rig.connect(); }
  CoreRig rig;
};

TEST_F(Refusal, namesTheFirstViolationOfTheTableAndListsTheOthers) {
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.target[2] = kNan;
  goal.command_id = 1;
  goal.accel_time = 3;
  const GoalId id = rig.submit(goal);
  const Outcome& outcome = *rig.outcome(id);
  EXPECT_EQ(outcome.error_id, motion_error::kAccelTimeRange);
  EXPECT_THAT(outcome.error_description, HasSubstr("accel_time is 3"));
  EXPECT_THAT(outcome.error_description,
              HasSubstr("also 16#28 Command ID range: 0, or 2~9: command_id is 1"));
  EXPECT_THAT(outcome.error_description,
              HasSubstr("also 16#200 Target not finite: coordinate 3 of target_position"));
}

TEST_F(Refusal, ofASecondCommandWhileOneIsBusy) {
  const GoalId first = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  for (int i = 0; i < 99; ++i) {
    const GoalId id = rig.submit(CoreRig::move());
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kOtherBlockBusy);
    EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy)
        << "the outputs stay those of the running command";
  }
  rig.reply(script.id);
  rig.tag(1);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::Done);
}

TEST(RefusalUnconnected, ofMotionsBeforeAndDuringConnect) {
  CoreRig rig;
  EXPECT_EQ(errorOf(rig, CoreRig::move()), motion_error::kNotConnected);
  rig.answers_lifesigns = false;
  rig.submit(CoreRig::robot());
  EXPECT_EQ(errorOf(rig, CoreRig::move()), motion_error::kNotConnected);
  rig.open();
  EXPECT_EQ(errorOf(rig, CoreRig::move()), motion_error::kNotConnected);
  rig.discardSent();
}

TEST(RefusalOfConnect, hasBothEndsOfEachRange) {
  const auto error = [](const std::function<void(ConnectGoal&)>& change) {
    CoreRig rig;
    ConnectGoal goal = CoreRig::robot();
    change(goal);
    const GoalId id = rig.submit(goal);
    EXPECT_EQ(rig.pendingOpen(link::Channel::Script).has_value(), rig.outcome(id) == nullptr);
    return rig.outcome(id) == nullptr ? 0 : rig.outcome(id)->error_id;
  };
  for (const double good : {10.0, 300.0}) EXPECT_EQ(error([&](auto& g) { g.timeout = good; }), 0);
  for (const double bad : {0.0, 9.999, 300.001, -10.0, kNan, kInf}) {
    EXPECT_EQ(error([&](auto& g) { g.timeout = bad; }), connect_error::kTimeoutRange) << bad;
  }
  for (const int good : {1, 65535}) EXPECT_EQ(error([&](auto& g) { g.port = good; }), 0);
  for (const int bad : {-1, 0, 65536}) {
    EXPECT_EQ(error([&](auto& g) { g.port = bad; }), own_error::kPortRange);
  }
  for (const int good : {0, 1, 65535}) EXPECT_EQ(error([&](auto& g) { g.status_port = good; }), 0);
  for (const int bad : {-1, 65536}) {
    EXPECT_EQ(error([&](auto& g) { g.status_port = bad; }), own_error::kPortRange);
  }
  for (const std::string& good :
       {std::string("192.168.1.10"), std::string("fe80::1%eth0"), std::string(255, 'a')}) {
    EXPECT_EQ(error([&](auto& g) { g.host = good; }), 0);
  }
  for (const std::string& bad : {std::string(), std::string(256, 'a'), std::string(10000, 'a'),
                                 std::string("a b"), std::string("a\r\nb"), std::string("a\0b", 3),
                                 std::string("r\xC3\xB6"
                                             "bot")}) {
    EXPECT_EQ(error([&](auto& g) { g.host = bad; }), own_error::kHostInvalid);
  }
}

TEST(RefusalOfConnect, ofASecondConnect) {
  CoreRig rig;
  const GoalId first = rig.connect();
  const GoalId second = rig.submit(CoreRig::robot());
  ASSERT_NE(rig.outcome(second), nullptr);
  EXPECT_EQ(rig.outcome(second)->error_id, own_error::kConnectBusy);
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).busy);
  EXPECT_EQ(rig.outcome(first), nullptr);
}

}  // namespace
}  // namespace cobot_command::testing
