// Stops that are asked for again and again: each goes out, and each goal ends in its own time.

#include <algorithm>

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;

class RepeatedStop : public ::testing::Test {
 protected:
  RepeatedStop() : rig(std::nullopt, link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
    move = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.status(StatusFrames().moving());
  }
  /// One more stop, on the wire at once.
  std::string ask() {
    goals.push_back(rig.submit(StopGoal{}));
    const auto frame = rig.takeScript();
    EXPECT_EQ(frame.script, "StopAndClearBuffer()");
    return frame.id;
  }
  std::size_t open() const {
    return static_cast<std::size_t>(
        std::count_if(goals.begin(), goals.end(), [this](GoalId id) { return rig.outcome(id) == nullptr; }));
  }
  void expectEnd(GoalId id, Ending ending) {
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, ending) << rig.outcome(id)->error_description;
  }

  CoreRig rig;
  GoalId move = 0;
  std::vector<GoalId> goals;
};

TEST_F(RepeatedStop, endsInItsOwnTimeWhenTheRobotDoesNotStand) {
  for (int i = 0; i < 60; ++i) {
    rig.reply(ask());
    rig.pass(100ms);
    rig.status(StatusFrames().moving());
    EXPECT_LE(open(), 20u);
  }
  expectEnd(goals.front(), Ending::Aborted);
  EXPECT_EQ(rig.outcome(goals.front())->error_id, own_error::kStopNotConfirmed);
  expectEnd(move, Ending::Aborted);
}

TEST_F(RepeatedStop, endsInItsOwnTimeWhenNothingIsAnswered) {
  for (int i = 0; i < 60; ++i) {
    ask();
    rig.pass(100ms);
    rig.status(StatusFrames().moving());
    EXPECT_LE(open(), 30u);
  }
  expectEnd(goals.front(), Ending::Aborted);
  EXPECT_EQ(rig.outcome(goals.front())->error_id, own_error::kStopNotConfirmed);
  rig.pass(3s);
  EXPECT_EQ(open(), 0u);
}

TEST_F(RepeatedStop, isDoneWhileOthersGoOnAsking) {
  for (int i = 0; i < 20; ++i) {
    rig.reply(ask());
    rig.pass(15ms);
    rig.status(StatusFrames());
    EXPECT_LE(open(), 2u);
  }
  expectEnd(goals.front(), Ending::Done);
  expectEnd(move, Ending::CommandAborted);
}

/// Who was not answered in time is served by the one behind it, if that is confirmed.
TEST_F(RepeatedStop, servesThoseInFrontOfIt) {
  ask();
  rig.stream(StatusFrames().moving(), 60);  // 0.9 s
  const auto second = ask();
  rig.stream(StatusFrames().moving(), 10);
  EXPECT_EQ(rig.outcome(goals[0]), nullptr) << "the answer to the second is still to come";
  rig.reply(second);
  rig.stream(StatusFrames());
  expectEnd(goals[0], Ending::Done);
  expectEnd(goals[1], Ending::Done);
  expectEnd(move, Ending::CommandAborted);
}

TEST_F(RepeatedStop, thatIsRefusedAsWellEndsThemAll) {
  const auto first = ask();
  const auto second = ask();
  rig.reply(first, false, {1});
  EXPECT_EQ(open(), 2u);
  rig.reply(second, false, {1});
  expectEnd(goals[0], Ending::Aborted);
  expectEnd(goals[1], Ending::Aborted);
  EXPECT_EQ(rig.outcome(move)->error_id, own_error::kStopNotConfirmed);
}

TEST_F(RepeatedStop, takesNothingFromTheOneInFrontWhenItIsRefused) {
  rig.reply(ask());
  rig.reply(ask(), false, {1});
  expectEnd(goals[1], Ending::Aborted);
  EXPECT_EQ(rig.outcome(goals[0]), nullptr);
  EXPECT_EQ(rig.outcome(move), nullptr);
  rig.stream(StatusFrames());
  expectEnd(goals[0], Ending::Done);
  expectEnd(move, Ending::CommandAborted);
}

TEST_F(RepeatedStop, keepsTheReasonOfTheFirst) {
  rig.cancel(move);
  rig.takeScript();
  rig.reply(ask());
  rig.stream(StatusFrames());
  expectEnd(move, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr("cancelled"));
}

/// What goes out behind a stop could be taken for what is to be stopped.
TEST_F(RepeatedStop, holdsBackTheNextCommandUntilTheLast) {
  const auto first = ask();
  rig.reply(first);
  rig.stream(StatusFrames(), 1);
  const auto second = ask();
  rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.pass(CoreRig::kStreamPeriod);
  rig.stream(StatusFrames(), 1);
  expectEnd(goals[0], Ending::Done);
  EXPECT_TRUE(rig.nothingSent());
  rig.reply(second);
  rig.stream(StatusFrames());
  expectEnd(goals[1], Ending::Done);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

/// The stream told when the first was asked for: so it has to show the robot standing, whoever asks again.
TEST_F(RepeatedStop, withoutAStreamConfirmsNoneThatHadToBeSeen) {
  for (const bool accepted : {true, false}) {
    const auto first = ask();
    if (accepted) rig.reply(first);
    rig.close("gone", link::Channel::Status);
    rig.pass(500ms);
    const auto second = ask();
    if (!accepted) rig.reply(first);
    rig.reply(second);
    EXPECT_EQ(open(), 2u);
    rig.pass(2s);
    EXPECT_EQ(open(), 0u);
    for (const GoalId id : goals) {
      expectEnd(id, Ending::Aborted);
      EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStopNotConfirmed);
    }
    expectEnd(move, Ending::Aborted);
    EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the robot may still move"));
    rig.open(link::Channel::Status);
    goals.clear();
    rig.status(StatusFrames().moving());
  }
}

TEST_F(RepeatedStop, withoutAStreamIsSeenInTheOneThatComesBack) {
  rig.reply(ask());
  rig.close("gone", link::Channel::Status);
  rig.pass(500ms);
  rig.reply(ask());
  rig.open(link::Channel::Status);
  rig.stream(StatusFrames());
  expectEnd(goals[0], Ending::Done);
  expectEnd(goals[1], Ending::Done);
  EXPECT_EQ(rig.outcome(goals[1])->error_description, "");
  expectEnd(move, Ending::CommandAborted);
}

/// So a robot whose stream is off for good can be stopped with success.
TEST_F(RepeatedStop, withoutAStreamIsDoneOnceNoneIsOpenThatHadToBeSeen) {
  rig.reply(ask());
  rig.close("gone", link::Channel::Status);
  rig.pass(3s);
  expectEnd(goals[0], Ending::Aborted);
  rig.reply(ask());
  expectEnd(goals[1], Ending::Done);
  EXPECT_THAT(rig.outcome(goals[1])->error_description, HasSubstr("no status stream shows"));
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr("the robot may still move")));
}

}  // namespace
}  // namespace cobot_command::testing
