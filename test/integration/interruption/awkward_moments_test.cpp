// Interruptions, and what comes behind them, at moments when something is half done.
#include <functional>

#include "interrupted_robot.h"
#include <fmt/format.h>

#include "cobot_command/blocks/load_path.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using ::testing::HasSubstr;

const blocks::SixValues kBelow = {517.5, -122.3, 361.05, 180, 0, 90};

blocks::SetOutputGoal output() {
  blocks::SetOutputGoal goal{0, "ControlBox", 2, 1};
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  return goal;
}

blocks::LoadPathGoal pathTo(const std::vector<double>& angles, BufferMode mode) {
  blocks::LoadPathGoal goal;
  for (const double angle : angles) goal.path.push_back(pathPoint({angle, 0, 90, 0, 90, 0}));
  goal.number_of_moves = static_cast<int>(angles.size());
  goal.buffer_mode = static_cast<int>(mode);
  return goal;
}

class AtAnAwkwardMoment : public ::testing::Test {
 protected:
  void fault(const std::string& name, int count, double seconds = 0) {
    simulator::SetFault fault;
    fault.name = name;
    fault.count = count;
    fault.seconds = seconds;
    rig.operate(fault);
  }
  void repliesAreLate() { fault("delay_reply", 0, 0.05); }
  /// A blended line down, whose goal has ended, and one aside behind it; interrupted, and going on since
  /// then.
  GoalId chainThatGoesOn() {
    rig.expectDone(rig.submit(blended(30, lineTo(kBelow))));
    const GoalId id = rig.submit(inMode(BufferMode::Buffered, lineTo({517.5, -22.3, 361.05, 180, 0, 90})));
    EXPECT_TRUE(rig.passUntilZ(420));
    rig.expectInterrupted();
    repliesAreLate();
    rig.expectGoesOn();
    rig.pass(10ms);
    return id;
  }
  [[nodiscard]] int outputsWritten() const {
    return static_cast<int>(std::count_if(rig.scripts().begin(), rig.scripts().end(), [](const auto& script) {
      return script.find("DO[") != std::string::npos;
    }));
  }

  InterruptedRobot rig;
};

/// In front of its lowest place: neither that, nor the output there, may be left out, and near it nothing is
/// known for certain but by the time.
TEST(AWayThatTurnsBack, losesNeitherItsCornerNorWhatStandsThere) {
  for (const int speed : {100, 400}) {
    for (double at = 440; at > 361.5; at -= 3) {
      SCOPED_TRACE(::testing::Message() << speed << " mm/s, " << at << " mm");
      InterruptedRobot rig;
      const std::string down =
          fmt::format(R"(Line("CAP",517.5,-122.3,361.05,180,0,90,{},200,0,false))", speed);
      const std::string up = fmt::format(R"(Line("CAP",517.5,-122.3,461.05,180,0,90,{},200,0,false))", speed);
      blocks::RunScriptGoal goal;
      goal.script = down + "\r\n" + R"(IO["ControlBox"].DO[2]=1)" + "\r\n" + up;
      goal.await_motion = true;
      const GoalId id = rig.submit(goal);
      ASSERT_TRUE(rig.passUntilZ(at));
      double lowest = 1000;
      const auto answer = rig.interrupt();
      rig.passUntil([&] {
        lowest = std::min(lowest, rig.place().z());
        return answer->has_value();
      });
      ASSERT_TRUE((*answer)->success) << (*answer)->message;
      rig.expectGoesOn();
      for (const auto& place : rig.wayUntilTheEndOf(id)) lowest = std::min(lowest, place.z());
      rig.expectDone(id);
      EXPECT_LT(lowest, 361.3);
      EXPECT_TRUE(rig.robot().outputs.control_box.at(2));
      EXPECT_NEAR(rig.place().z(), 461.05, 0.01);
    }
  }
}

TEST_F(AtAnAwkwardMoment, aStopBehindContinueEndsTheGoalWhenTheRobotStands) {
  const GoalId id = chainThatGoesOn();
  const GoalId stop = rig.submit(blocks::StopGoal{});
  rig.expectDone(stop);
  EXPECT_EQ(rig.endOf(id).ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.stands());
}

TEST_F(AtAnAwkwardMoment, aCancelBehindContinueDoesSo) {
  const GoalId id = chainThatGoesOn();
  rig.cancel(id);
  EXPECT_EQ(rig.endOf(id).ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.stands());
  rig.pass(1s);
  rig.expectDone(rig.submit(lineBy({0, 0, 10, 0, 0, 0})));
}

TEST_F(AtAnAwkwardMoment, aLinkThatIsLostBehindContinueFailsTheGoal) {
  const GoalId id = chainThatGoesOn();
  rig.dropConnections();
  EXPECT_EQ(rig.endOf(id).ending, Ending::Aborted);
  EXPECT_EQ(rig.endOf(id).error_id, 0x99);
}

TEST_F(AtAnAwkwardMoment, anOutputThatIsAnsweredDuringTheStoppingLetsNothingGo) {
  rig.expectDone(rig.submit(blended(30, lineTo(kBelow))));
  ASSERT_TRUE(rig.passUntilZ(420));
  repliesAreLate();
  const GoalId out = rig.submit(output());
  const GoalId last = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 100, 0, 0, 0, 0})));
  rig.pass(10ms);
  rig.expectInterrupted();
  rig.expectDone(out);
  rig.pass(2s);
  EXPECT_FALSE(rig.accepted(last));
  rig.expectGoesOn();
  rig.expectDone(last);
  EXPECT_NEAR(rig.place().z(), 361.05, 0.05);
  EXPECT_NEAR(rig.place().y(), -22.3, 0.05);
}

TEST_F(AtAnAwkwardMoment, anOutputAloneLetsNothingGoThatWaits) {
  repliesAreLate();
  rig.submit(output());
  const GoalId motion = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, -20, 0, 0, 0})));
  rig.pass(10ms);
  rig.expectInterrupted();
  rig.pass(2s);
  EXPECT_FALSE(rig.accepted(motion));
  EXPECT_NEAR(rig.place().z(), 461.05, 1e-3);
  rig.expectGoesOn();
  rig.expectDone(motion);
}

TEST_F(AtAnAwkwardMoment, anOutputThatIsWrittenIsNotWrittenAgain) {
  repliesAreLate();
  auto goal = good<blocks::PickAndPlaceGoal>();
  goal.steps[0].move = moveJoints({5, 0, 90, 0, 90, 0}, 50);
  goal.steps[0].dwell = 1;
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntil([&] { return outputsWritten() == 1; }, 1min));
  rig.expectInterrupted();
  rig.expectGoesOn();
  rig.expectDone(id);
  EXPECT_EQ(outputsWritten(), 1);
}

/// Between two commands of a cycle, the first of which moves the robot still.
TEST(AStopThatIsRefused, failsTheCycleThatWasToBeInterrupted) {
  InterruptedRobot rig({}, 600ms);
  simulator::SetFault fault;
  fault.name = "refuse_stop";
  fault.count = 1;
  auto goal = good<blocks::PickAndPlaceGoal>();
  goal.steps[0].move = blended(30, lineTo(kBelow));
  goal.steps[0].output.reset();
  goal.steps[0].dwell = 0;
  goal.steps.push_back({moveJoints({20, 0, 90, 0, 90, 0}, 20), std::nullopt, std::nullopt, 0});
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntilZ(455));
  rig.operate(fault);
  const auto answer = rig.interruptNow();
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(rig.endOf(id).ending, Ending::Aborted) << "it must not go on from somewhere";
  EXPECT_THAT(rig.endOf(id).error_description, HasSubstr("refused"));
}

TEST_F(AtAnAwkwardMoment, nothingGoesOnWithoutTheInterfaceThatMotionsNeed) {
  command::ExchangeRules rules;
  rules.required = true;
  rig.useRules(rules);
  const GoalId exchange = rig.submit(good<blocks::ExchangeConfigurationGoal>());
  rig.pass(100ms);
  const GoalId id = rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.cancel(exchange);
  rig.pass(1s);
  EXPECT_EQ(rig.goOn().error_id, 0x8C05);
  rig.submit(good<blocks::ExchangeConfigurationGoal>());
  rig.pass(100ms);
  rig.expectGoesOn();
  rig.expectDone(id);
}

TEST_F(AtAnAwkwardMoment, aGoalOfAPathThatNothingWasSentOfIsCancelledAlone) {
  const GoalId first = rig.submit(pathTo({20, 30}, BufferMode::Buffered));
  const GoalId second = rig.submit(pathTo({40, 50}, BufferMode::Buffered));
  const GoalId third = rig.submit(pathTo({60, 70}, BufferMode::Buffered));
  ASSERT_TRUE(rig.passUntil([&] { return rig.jointDeg(0) > 10; }, 1min));
  rig.expectInterrupted();
  rig.cancel(third);
  EXPECT_NE(rig.outcome(third), nullptr);
  EXPECT_EQ(rig.outcome(first), nullptr);
  EXPECT_EQ(rig.outcome(second), nullptr);
  rig.expectGoesOn();
  rig.expectDone(first);
  rig.expectDone(second);
  EXPECT_NEAR(rig.jointDeg(0), 50, 0.05);
}

TEST_F(AtAnAwkwardMoment, aGoalThatDoesNotWaitIsRefusedDuringTheStopping) {
  rig.expectDone(rig.submit(blended(30, lineTo(kBelow))));
  ASSERT_TRUE(rig.passUntilZ(420));
  const auto answer = rig.interrupt();
  const GoalId refused = rig.submit(lineBy({0, 0, 20, 0, 0, 0}));
  EXPECT_EQ(rig.endOf(refused).error_id, 0x11);
  rig.pass(1s);
  EXPECT_TRUE((*answer)->success);
}

TEST_F(AtAnAwkwardMoment, aSecondPathJoinsTheFirstOneMeanwhile) {
  rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  const GoalId first = rig.submit(pathTo({20}, BufferMode::Refuse));
  rig.pass(100ms);
  const GoalId second = rig.submit(pathTo({40}, BufferMode::Refuse));
  rig.expectDone(first);
  rig.expectDone(second);
}

TEST_F(AtAnAwkwardMoment, noMoreGoalsWaitThanMay) {
  rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  GoalId last = 0;
  for (int i = 0; i < 65; ++i) last = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 1, 0, 0, 0})));
  EXPECT_EQ(rig.endOf(last).error_id, 0x216);
  EXPECT_LE(rig.group().queue_usage, 100);
}

TEST_F(AtAnAwkwardMoment, whatIsLeftOfABlendedMotionIsSeenToBeThere) {
  rig.expectDone(rig.submit(blended(30, lineTo(kBelow))));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.setSpeedOverride(0);
  rig.expectGoesOn();
  rig.pass(500ms);
  EXPECT_EQ(rig.status().commands_under_way, 1);
  EXPECT_NE(rig.group().sequence, command::GroupState::Sequence::Idle);
  rig.setSpeedOverride(100);
  EXPECT_TRUE(rig.passUntil([&] { return rig.place().z() < 361.1; }, 10s));
}

/// Its goal has ended long ago.
TEST_F(AtAnAwkwardMoment, whatIsLeftOfABlendedMotionEndsWithEverythingElse) {
  const std::function<void()> ends[] = {
      [this] { rig.expectDone(rig.submit(blocks::StopGoal{})); },
      [this] {
        rig.expectDone(rig.submit(inMode(BufferMode::Aborting, lineBy({0, 0, 5, 0, 0, 0}))));
      },
      [this] {
        rig.dropConnections();
        rig.pass(1s);
        rig.connect();
      }};
  for (const auto& end : ends) {
    rig.moveTo({0, 0, 90, 0, 90, 0});
    rig.expectDone(rig.submit(blended(30, lineTo(kBelow))));
    ASSERT_TRUE(rig.passUntilZ(420));
    rig.expectInterrupted();
    end();
    rig.pass(300ms);
    EXPECT_EQ(rig.goOn().error_id, 0x233);
    EXPECT_EQ(rig.group().sequence, command::GroupState::Sequence::Idle);
    rig.expectDone(rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 5, 0, 0, 0}))));
  }
}

TEST_F(AtAnAwkwardMoment, anotherLoadIsNoticed) {
  rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.expectDone(rig.submit(good<blocks::ChangeLoadGoal>()));
  rig.pass(300ms);
  EXPECT_EQ(rig.goOn().error_id, 0x8C23);
}

TEST_F(AtAnAwkwardMoment, theWayBackBeginsAtRest) {
  rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.expectDone(rig.submit(blended(50, moveJoints({-60, 0, 90, 0, 90, 0}, 20))));
  rig.pass(300ms);
  blocks::ReturnToPrimaryGoal back;
  back.distance_limit = 100;
  EXPECT_EQ(rig.endOf(rig.submit(back)).error_id, 0x11);
}

TEST_F(AtAnAwkwardMoment, theOverrideIsToldOfThatHoldsWhatGoesOn) {
  const GoalId id = rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.setSpeedOverride(0);
  EXPECT_THAT(rig.goOn().message, HasSubstr("override"));
  rig.pass(1s);
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("override"));
}

/// As long as the way back was not gone.
TEST_F(AtAnAwkwardMoment, otherFramesAreAllowedByAWayBackThatIsDone) {
  const GoalId id = rig.submit(lineTo(kBelow));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.expectDone(rig.submit(good<blocks::ChangeTcpGoal>()));
  rig.pass(500ms);
  blocks::ReturnToPrimaryGoal back;
  back.trajectory_mode = 2;
  back.allow_differences = true;
  rig.setGate([](const auto&, Instant) {
    return blocks::Failure{blocks::own_error::kNotListening, "closed", ""};
  });
  EXPECT_EQ(rig.endOf(rig.submit(back)).ending, Ending::Rejected);
  rig.setGate(nullptr);
  EXPECT_EQ(rig.goOn().error_id, 0x8C22);
  rig.expectDone(rig.submit(back));
  rig.pass(300ms);
  rig.expectDone(rig.submit(good<blocks::ChangeBaseGoal>()));
  rig.pass(500ms);
  EXPECT_NE(rig.goOn().error_id, 0) << "that was not allowed";
  EXPECT_EQ(rig.outcome(id), nullptr);
}

}  // namespace
}  // namespace cobot_command::testing
