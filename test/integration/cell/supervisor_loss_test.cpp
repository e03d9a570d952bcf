// A supervisor that is gone, is another one, cannot write, or has another artifact: robots end what was sent,
// and stand.
#include "run_rig.h"

namespace cobot_command::trial {
namespace {

using cell::SupervisorMode;
using ::testing::HasSubstr;

std::size_t sentBy(RunRig& rig) {
  std::size_t sent = 0;
  for (cell::RobotIndex robot = 0; robot < rig.trial->robots(); ++robot) {
    sent += rig.robot(robot).scripts().size();
  }
  return sent;
}

bool anyMoves(RunRig& rig) {
  bool moves = false;
  for (cell::RobotIndex robot = 0; robot < rig.trial->robots(); ++robot) moves = moves || rig.isMoving(robot);
  return moves;
}

TEST(RobotsWithoutASupervisor, endWhatWasSentAndGoOnWhenItIsBack) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(2);
  for (int i = 0; i < 8; ++i) {
    rig.pass(std::chrono::milliseconds(900 + 470 * (i % 4)));
    rig.trial->killSupervisor();
    rig.pass(rig.artifact->parameters.lease);
    const std::size_t sent = sentBy(rig);
    rig.pass(15s);
    EXPECT_EQ(sentBy(rig), sent);
    EXPECT_FALSE(anyMoves(rig));
    rig.trial->startSupervisor();
    const auto goes_on = [&] {
      return rig.mode() == SupervisorMode::Running || rig.mode() == SupervisorMode::Ready;
    };
    EXPECT_TRUE(rig.passUntil(goes_on, 1s)) << rig.trial->status().diagnosis;
  }
  EXPECT_TRUE(rig.endsAll());
}

TEST(ASecondSupervisor, closesTheGatesAsLongAsItIsHeard) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(2);
  rig.pass(2s);
  cell::CellStatus other = rig.trial->status();
  ++other.instance;
  std::uint64_t number = 1000000;
  const auto disturbed = [&] {
    for (cell::RobotIndex robot = 0; robot < 2; ++robot) rig.robot(robot).hear(other, ++number);
    return false;
  };
  static_cast<void>(rig.passUntil(disturbed, 200ms));
  const std::size_t sent = sentBy(rig);
  static_cast<void>(rig.passUntil(disturbed, 15s));
  EXPECT_EQ(sentBy(rig), sent);
  EXPECT_FALSE(anyMoves(rig));
  EXPECT_THAT(rig.robot(0).agent().stand(rig.trial->now()).text, HasSubstr("second supervisor"));
  EXPECT_TRUE(rig.endsAll());
}

TEST(AStateOfAnotherArtifact, isNoneToARobot) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  cell::CellStatus other = rig.trial->status();
  other.hash[0] = other.hash[0] == '0' ? '1' : '0';
  rig.robot(0).hear(other, 1000000);
  rig.order(0, 1);
  ASSERT_TRUE(rig.robot(0).hasEnded());
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kSupervisorSilent);
  EXPECT_THAT(rig.robot(0).lastOutcome()->error_description, HasSubstr("another artifact"));
  EXPECT_EQ(rig.robot(0).scripts().size(), 0U);
}

TEST(AJournalThatCannotBeWritten, grantsNothingUntilTheSupervisorIsStartedAnew) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(2);
  rig.pass(2s);
  rig.trial->limitJournal(rig.trial->journal().size() + 20);
  ASSERT_TRUE(rig.passUntil([&] { return rig.mode() == SupervisorMode::Fault; }, 10s));
  EXPECT_THAT(rig.trial->status().diagnosis, HasSubstr("cannot be written"));
  rig.pass(100ms);
  const std::size_t sent = sentBy(rig);
  const std::uint64_t events = rig.trial->status().events;
  rig.pass(20s);
  EXPECT_EQ(sentBy(rig), sent);
  EXPECT_EQ(rig.trial->status().events, events);
  EXPECT_FALSE(anyMoves(rig));
  rig.trial->limitJournal(std::nullopt);
  rig.trial->killSupervisor();
  rig.trial->startSupervisor();
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARequestThatWaitsForTooLong, endsItsGoalWithWhoIsInTheWay) {
  RunRig rig(artifactOf("handover", [](cell::Parameters& parameters) { parameters.wait_timeout = 8s; }));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).operate(simulator::PauseProject{});
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(1).hasEnded(); }, 15s));
  EXPECT_EQ(rig.errorOf(1), blocks::own_error::kPermitLate);
  EXPECT_THAT(rig.robot(1).lastOutcome()->error_description, HasSubstr("ZONE_HELD by RA"));
  rig.robot(0).operate(simulator::ResumeProject{});
  EXPECT_TRUE(rig.ends(0));
  rig.order(1, 1);
  EXPECT_TRUE(rig.ends(1));
}

}  // namespace
}  // namespace cobot_command::trial
