// The end of the layer: every open goal ends as CommandAborted, whatever it is and however far it came.

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

std::vector<Goal> commands() {
  return {good<MoveAbsoluteGoal>(), good<MoveRelativeGoal>(),   good<MoveCircleGoal>(),
          good<ChangeBaseGoal>(),   good<ChangeTcpGoal>(),      good<ExitListenNodeGoal>(),
          good<RunScriptGoal>(),    good<ProgramControlGoal>(), StopGoal{},
          good<PickAndPlaceGoal>()};
}

/// What may only take motion away from the robot.
bool halts(const Goal& goal) {
  return std::holds_alternative<StopGoal>(goal) || std::holds_alternative<ProgramControlGoal>(goal);
}

void expectAborted(const CoreRig& rig, GoalId id, std::size_t kind) {
  ASSERT_NE(rig.outcome(id), nullptr) << toString(static_cast<Block>(kind));
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted) << toString(static_cast<Block>(kind));
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("shutting down"));
}

void expectSilence(CoreRig& rig) {
  rig.discardSent();
  EXPECT_FALSE(rig.connectionOpen(link::Channel::Script));
  EXPECT_EQ(rig.core.nextDeadline(), std::nullopt);
}

TEST(ShutDown, endsACommandOfEveryKindThatWasSent) {
  for (const Goal& goal : commands()) {
    CoreRig rig;
    const GoalId connect = rig.connect();
    const GoalId id = rig.submit(goal);
    ASSERT_EQ(rig.outcome(id), nullptr);
    rig.shutDown();
    expectAborted(rig, id, goal.index());
    expectAborted(rig, connect, 0);
    expectSilence(rig);
  }
}

TEST(ShutDown, endsACommandOfEveryKindThatWaits) {
  for (const Goal& goal : commands()) {
    CoreRig rig;
    rig.connect();
    const GoalId running = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    const GoalId id = rig.submit(inMode(BufferMode::Buffered, goal));
    ASSERT_EQ(rig.outcome(id), nullptr);
    rig.shutDown();
    expectAborted(rig, id, goal.index());
    expectAborted(rig, running, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
    expectSilence(rig);
  }
}

TEST(ShutDown, endsAConnectGoalInEveryState) {
  for (int step = 0; step < 4; ++step) {
    CoreRig rig;
    rig.answers_lifesigns = step == 3;
    rig.listening = false;
    const GoalId connect = rig.submit(CoreRig::robot());
    if (step == 1) rig.failOpen(link::OpenFailure::Kind::Refused);
    if (step >= 2) rig.open();
    rig.shutDown();
    expectAborted(rig, connect, 0);
    expectSilence(rig);
  }
}

TEST(ShutDown, endsAMotionInEveryState) {
  const std::vector<void (*)(CoreRig&, GoalId)> kStates = {
      [](CoreRig& rig, GoalId) { rig.reply(rig.takeScript().id); },
      [](CoreRig& rig, GoalId) { rig.pass(500ms); },
      [](CoreRig& rig, GoalId id) { rig.cancel(id); },
      [](CoreRig& rig, GoalId) {
        rig.reply(rig.takeScript().id);
        rig.pass(300s);  // its tag is asked for
      },
  };
  for (const auto& bringTo : kStates) {
    CoreRig rig;
    rig.connect();
    const GoalId id = rig.submit(CoreRig::move());
    bringTo(rig, id);
    ASSERT_EQ(rig.outcome(id), nullptr);
    rig.shutDown();
    expectAborted(rig, id, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
    expectSilence(rig);
  }
}

TEST(ShutDown, endsACycleInADwellAndAMotionBeforeItsExit) {
  CoreRig rig;
  rig.connect();
  PickAndPlaceGoal cycle = good<PickAndPlaceGoal>();
  cycle.steps[0].output.reset();
  const GoalId dwelling = rig.submit(cycle);
  rig.reply(rig.takeScript().id);
  rig.tag(1);
  rig.shutDown();
  expectAborted(rig, dwelling, static_cast<std::size_t>(kBlock<PickAndPlaceGoal>));

  CoreRig other;
  other.connect();
  const GoalId leaving = other.submit(with<MoveAbsoluteGoal>([](auto& g) { g.exit_node = true; }));
  other.reply(other.takeScript().id);
  other.tag(1);
  other.shutDown();
  expectAborted(other, leaving, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
  other.discardSent();
}

/// A check is answered in the event that asks for it: it cannot be open.
TEST(ShutDown, findsNoCheckOpen) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal check = CoreRig::move();
  check.check_only = true;
  EXPECT_NE(rig.outcome(rig.submit(check)), nullptr);
  EXPECT_NE(rig.outcome(rig.submit(CheckSequenceGoal{})), nullptr);
  rig.shutDown();
}

TEST(ShutDown, stopsABlendedMotionThatIsDoneForItsGoal) {
  CoreRig rig;
  rig.connect();
  rig.submit(CoreRig::blended());
  rig.reply(rig.takeScript().id);
  rig.core.shutDown(rig.now);
  bool stopped = false;
  for (const auto& action : rig.core.takeActions()) {
    if (const auto* sent = std::get_if<SendBytes>(&action)) {
      stopped = stopped || sent->bytes.find("StopAndClearBuffer()") != std::string::npos;
    }
  }
  EXPECT_TRUE(stopped);
}

void retire(CoreRig& rig) {
  rig.core.retire(rig.now);
  rig.pump();
}

TEST(Retirement, stopsAMotionAndEndsItsGoalWhenTheStopWasAccepted) {
  for (const bool accepted_before : {false, true}) {
    CoreRig rig;
    const GoalId connect = rig.connect();
    const GoalId id = rig.submit(CoreRig::move());
    const auto motion = rig.takeScript();
    if (accepted_before) rig.reply(motion.id);
    retire(rig);
    const auto stop = rig.takeScript();
    EXPECT_EQ(stop.script, "StopAndClearBuffer()");
    EXPECT_EQ(rig.outcome(id), nullptr);
    EXPECT_FALSE(rig.core.retired());
    rig.reply(stop.id);
    expectAborted(rig, id, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
    EXPECT_TRUE(rig.core.retired());
    EXPECT_EQ(rig.outcome(connect), nullptr);
    rig.shutDown();
    expectAborted(rig, connect, 0);
    expectSilence(rig);
  }
}

TEST(Retirement, endsACycleWhoseRobotStands) {
  CoreRig rig;
  rig.connect();
  const GoalId cycle = rig.submit(good<PickAndPlaceGoal>());
  rig.reply(rig.takeScript().id);
  retire(rig);
  rig.reply(rig.takeScript().id);
  expectAborted(rig, cycle, static_cast<std::size_t>(kBlock<PickAndPlaceGoal>));
  EXPECT_TRUE(rig.core.retired());
}

TEST(Retirement, stopsABlendedMotionThatIsDoneForItsGoal) {
  CoreRig rig;
  rig.connect();
  rig.submit(CoreRig::blended());
  rig.reply(rig.takeScript().id);
  retire(rig);
  EXPECT_FALSE(rig.core.retired());
  rig.reply(rig.takeScript().id);
  EXPECT_TRUE(rig.core.retired());
}

TEST(Retirement, takesNothingMoreAndEndsWhatWaits) {
  CoreRig rig;
  rig.connect();
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  retire(rig);
  expectAborted(rig, waiting, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
  rig.takeScript();  // its stop
  for (const Goal& goal : commands()) {
    if (!halts(goal)) expectAborted(rig, rig.submit(goal), goal.index());
  }
  ProgramControlGoal resume;
  resume.command = static_cast<int>(ProgramCommand::Resume);
  expectAborted(rig, rig.submit(resume), static_cast<std::size_t>(kBlock<ProgramControlGoal>));
  EXPECT_TRUE(rig.nothingSent());
}

/// Who stops the robot must not be told that it is too late, as long as there is a wire.
TEST(Retirement, stillSendsAStopAndWaitsForItsAnswer) {
  for (const bool moves : {false, true}) {
    CoreRig rig;
    rig.connect();
    const GoalId move = moves ? rig.submit(CoreRig::move()) : 0;
    if (moves) rig.reply(rig.takeScript().id);
    retire(rig);
    const std::string own = moves ? rig.takeScript().id : "";
    const GoalId stop = rig.submit(StopGoal{});
    EXPECT_TRUE(rig.accepted(stop));
    const auto frame = rig.takeScript();
    EXPECT_EQ(frame.script, "StopAndClearBuffer()");
    EXPECT_FALSE(rig.core.retired());
    if (moves) rig.reply(own);
    rig.reply(frame.id);
    ASSERT_NE(rig.outcome(stop), nullptr);
    EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
    if (moves) expectAborted(rig, move, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
    EXPECT_TRUE(rig.core.retired());
  }
}

TEST(Retirement, stillSendsAPauseAndWaitsForItsAnswer) {
  CoreRig rig;
  rig.connect();
  retire(rig);
  const GoalId pause = rig.submit(ProgramControlGoal{});
  const auto frame = rig.takeScript();
  EXPECT_EQ(frame.script, "Pause()");
  EXPECT_FALSE(rig.core.retired());
  rig.reply(frame.id);
  EXPECT_EQ(rig.outcome(pause)->ending, Ending::Done);
  EXPECT_TRUE(rig.core.retired());
}

TEST(Retirement, refusesAStopWhereThereIsNoWire) {
  CoreRig rig;
  retire(rig);
  const GoalId stop = rig.submit(StopGoal{});
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->error_id, motion_error::kNotConnected);
}

TEST(Retirement, endsAStopThatIsNotAnsweredAndSaysThatTheRobotMayMove) {
  CoreRig rig;
  rig.connect();
  retire(rig);
  const GoalId stop = rig.submit(StopGoal{});
  rig.takeScript();
  rig.shutDown();
  expectAborted(rig, stop, static_cast<std::size_t>(kBlock<StopGoal>));
  EXPECT_THAT(rig.outcome(stop)->error_description, HasSubstr("may still move"));
  expectSilence(rig);
}

TEST(Retirement, isOverAtOnceWhenNothingIsUnderWay) {
  CoreRig rig;
  EXPECT_FALSE(rig.core.retired());
  rig.connect();
  retire(rig);
  EXPECT_TRUE(rig.core.retired());
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Retirement, ofARobotThatDoesNotAnswerIsTold) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  retire(rig);
  rig.takeScript();
  rig.pass(300ms);
  EXPECT_FALSE(rig.core.retired());
  rig.shutDown();
  expectAborted(rig, id, static_cast<std::size_t>(kBlock<MoveAbsoluteGoal>));
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("may still move"));
  expectSilence(rig);
}

}  // namespace
}  // namespace cobot_command::testing
