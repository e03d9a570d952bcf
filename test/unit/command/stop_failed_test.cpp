// A stop that failed: the robot may still move, so that is told, and the next reason for a stop sends one.

#include <functional>

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kWords = "the robot may still move";

/// A blended motion, done for its goal, that a stop goal did not stop.
struct LooseMotion : CoreRig {
  explicit LooseMotion(link::LinkSettings settings = noStatus()) : CoreRig(std::nullopt, settings) {
    connection = connect();
    submit(blended());
    reply(takeScript().id);
    if (settings.status_port != 0) status(StatusFrames().moving());
    const GoalId stop = submit(StopGoal{});
    reply(takeScript().id, false, {1});
    EXPECT_EQ(outcome(stop)->error_id, own_error::kStopNotConfirmed);
  }
  GoalId connection = 0;
};

TEST(FailedStop, isFollowedByAnotherWhenThereIsReasonForOne) {
  const std::vector<std::function<void(LooseMotion&)>> kReasons = {
      [](LooseMotion& rig) {
        rig.core.retire(rig.now);
        rig.pump();
        EXPECT_FALSE(rig.core.retired());
      },
      [](LooseMotion& rig) { rig.submit(CoreRig::move(BufferMode::Aborting)); },
      [](LooseMotion& rig) { rig.cancel(rig.connection); },
  };
  for (const auto& reason : kReasons) {
    LooseMotion rig;
    EXPECT_TRUE(rig.nothingSent());
    reason(rig);
    EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
    rig.discardSent();
  }
}

TEST(FailedStop, isToldUntilTheRobotIsSeenToStand) {
  LooseMotion rig{link::LinkSettings{}};
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the controller refused StopAndClearBuffer()"));
  rig.status(StatusFrames().moving());
  rig.pass(600ms);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  rig.status(StatusFrames());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
}

TEST(FailedStop, isToldUntilAStopIsConfirmed) {
  LooseMotion rig;
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  rig.submit(StopGoal{});
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
}

/// Whether it moves on is for the next connection to the same robot to find.
TEST(FailedStop, isToldAsAMotionThatTheLinkHasLeft) {
  LooseMotion rig;
  rig.close("gone");
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("was lost during a motion"));
  rig.connect();
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
}

/// Nobody waits for the stop behind a motion that failed: its goal has its own error.
TEST(FailedStop, ofTheLayerItselfIsToldInLogAndDiagnosis) {
  const std::vector<std::function<void(CoreRig&, const std::string&)>> kFailures = {
      [](CoreRig& rig, const std::string& id) { rig.reply(id, false, {1}); },
      [](CoreRig& rig, const std::string& /*id*/) { rig.pass(1s); },
  };
  for (const auto& failStop : kFailures) {
    CoreRig rig;
    rig.connect();
    rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.tag(1, protocol::TagState::Incomplete);
    const auto stop = rig.takeScript();
    EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
    failStop(rig, stop.id);
    EXPECT_THAT(rig.warnings, Contains(HasSubstr(kWords)));
    EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  }
}

/// What a controller refuses changes nothing: the change behind the motion still comes.
TEST(FailedStop, thatWasRefusedLeavesTheChangeOfBaseBehindTheMotion) {
  for (const bool refused : {true, false}) {
    CoreRig rig;
    rig.connect();
    rig.submit(CoreRig::blended());
    rig.reply(rig.takeScript().id);
    rig.submit(good<ChangeBaseGoal>());
    rig.reply(rig.takeScript().id);
    ASSERT_FALSE(rig.active_frames.empty());
    ASSERT_TRUE(rig.active_frames.back().base);
    rig.submit(StopGoal{});
    rig.reply(rig.takeScript().id, !refused, refused ? std::vector<int>{1} : std::vector<int>{});
    EXPECT_EQ(rig.active_frames.back().base.has_value(), refused);
  }
}

/// What would queue behind a motion that nobody could stop.
TEST(FailedStop, holdsBackTheNextCommandUntilTheRobotIsSeenToStand) {
  LooseMotion rig{link::LinkSettings{}};
  for (const Goal& goal : {Goal(CoreRig::move()), Goal(good<ChangeBaseGoal>())}) {
    const GoalId refused = rig.submit(goal);
    ASSERT_NE(rig.outcome(refused), nullptr);
    EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
    EXPECT_THAT(rig.outcome(refused)->error_description,
                HasSubstr("the controller refused StopAndClearBuffer()"));
  }
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_THAT(rig.progress(waiting).back().text, HasSubstr(kWords));
  rig.pass(600ms);
  rig.status(StatusFrames().moving());
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

/// The controller says OK, and drives on.
TEST(FailedStop, thatWasAcceptedAndIgnoredHoldsBackTheNextCommandToo) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const GoalId motion = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().moving());
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames().moving(), 150);
  ASSERT_NE(rig.outcome(motion), nullptr);
  EXPECT_EQ(rig.outcome(motion)->error_id, own_error::kStopNotConfirmed);
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(FailedStop, isTakenOverWithAStopThatIsConfirmed) {
  LooseMotion rig{link::LinkSettings{}};
  const GoalId goal = rig.submit(CoreRig::move(BufferMode::Aborting));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  EXPECT_TRUE(rig.nothingSent());
  rig.reply(stop.id);
  rig.stream(StatusFrames());
  EXPECT_TRUE(rig.accepted(goal));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(FailedStop, isEndedByAStopWhereNoStreamTells) {
  LooseMotion rig;
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

/// As behind a lost link: what moves on is for the next connection to find.
TEST(FailedStop, holdsNothingBackOnTheNextConnection) {
  LooseMotion rig;
  rig.cancel(rig.connection);
  rig.reply(rig.takeScript().id, false, {1});
  ASSERT_NE(rig.outcome(rig.connection), nullptr);
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
  rig.connect();
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

}  // namespace
}  // namespace cobot_command::testing
