#include "runs/evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;
using Verdict = Evidence::Verdict;

constexpr double kTarget = 30;  // [deg] of the first joint

robot::Target target() {
  robot::Target target;
  target.joints = arm::JointVector::Zero();
  target.joints[0] = degToRad(kTarget);
  return target;
}

/// A command that is to take the first joint to 30 degrees; 10 frames of the robot in a second.
class EvidenceTest : public ::testing::Test {
 protected:
  void frame(double j1_deg, std::optional<double> speed_deg, bool paused = false) {
    now_ += 100ms;
    link::RobotStatus status;
    status.received = now_;
    status.joints = arm::JointVector::Zero();
    (*status.joints)[0] = degToRad(j1_deg);
    if (speed_deg) {
      status.joint_velocities = arm::JointVector::Zero();
      (*status.joint_velocities)[0] = degToRad(*speed_deg);
    }
    status.project_paused = paused;
    robot_.update(status);
  }
  void watch(double j1_deg, double speed_deg, bool paused = false) {
    frame(j1_deg, speed_deg, paused);
    evidence_.watch(now_);
  }
  void watchRest(double j1_deg, bool paused = false) {
    for (Duration rest{}; rest <= settings_.evidence_timeout + 100ms; rest += 100ms) watch(j1_deg, 0, paused);
  }

  link::LinkSettings settings_;
  robot::RobotWatch robot_;
  Instant now_{1s};
  Evidence evidence_{robot_, settings_, nullptr, target()};
  Evidence of_anywhere_{robot_, settings_, nullptr, std::nullopt};
};

TEST_F(EvidenceTest, seesARobotThatComesToRestOnItsWay) {
  watch(5, 20);
  watch(10, 20);
  EXPECT_FALSE(evidence_.stalled());
  watchRest(12);
  EXPECT_TRUE(evidence_.stalled());
  EXPECT_TRUE(evidence_.stalledOnTheWay());
  EXPECT_THAT(evidence_.stallText(7), HasSubstr("J1 is 18"));
  EXPECT_THAT(evidence_.stallText(7), HasSubstr("no longer knows tag 7"));

  evidence_.lookedInto();
  EXPECT_FALSE(evidence_.stalled());
  watchRest(12);
  EXPECT_TRUE(evidence_.stalled()) << "the rest begins anew";
}

TEST_F(EvidenceTest, seesNoneAtTheTargetUnderAPauseOrBeforeItHasMoved) {
  watchRest(0);
  EXPECT_FALSE(evidence_.stalled()) << "it has not moved yet";
  watch(5, 20);
  watchRest(12, true);
  EXPECT_FALSE(evidence_.stalled()) << "the pause holds it";
  watch(20, 20);
  watchRest(kTarget);
  EXPECT_TRUE(evidence_.stalled());
  EXPECT_FALSE(evidence_.stalledOnTheWay()) << "it is where it should be, and its tag late";
}

TEST_F(EvidenceTest, confirmsARobotThatStandsAtItsTarget) {
  frame(29, 20);
  EXPECT_FALSE(evidence_.confirms()) << "may be of before the tag";
  frame(kTarget, 20);
  EXPECT_FALSE(evidence_.confirms()) << "still moves";
  frame(kTarget, 0);
  EXPECT_TRUE(evidence_.confirms());
}

TEST_F(EvidenceTest, confirmsWhatNobodyCanTell) {
  EXPECT_TRUE(evidence_.confirms()) << "no stream";
  robot_.update({});
  EXPECT_TRUE(evidence_.confirms()) << "a stream without angles and speeds";
}

TEST_F(EvidenceTest, confirmsAnyPlaceWithoutATargetOnceTheRobotStands) {
  frame(3, 20);
  EXPECT_FALSE(of_anywhere_.confirms());
  frame(3, 0);
  EXPECT_TRUE(of_anywhere_.confirms());
}

TEST_F(EvidenceTest, isContradictedByARobotThatStandsElsewhere) {
  frame(20, 0);
  EXPECT_FALSE(evidence_.confirms());
  EXPECT_EQ(evidence_.verdict(), Verdict::Contradicted);
  EXPECT_THAT(evidence_.contradiction(3), HasSubstr("tag 3 was reported complete, but J1 is 10"));
}

TEST_F(EvidenceTest, isContradictedByARobotThatMovesOnWithoutATarget) {
  frame(20, 20);
  EXPECT_FALSE(of_anywhere_.confirms());
  EXPECT_EQ(of_anywhere_.verdict(), Verdict::Contradicted);
  EXPECT_THAT(of_anywhere_.contradiction(3), HasSubstr("the robot still moves"));
}

TEST_F(EvidenceTest, leavesARobotThatWasAtItsTargetToWhoMovesItNow) {
  frame(kTarget, 20);
  EXPECT_FALSE(evidence_.confirms());
  frame(40, 20);
  EXPECT_FALSE(evidence_.confirms());
  EXPECT_EQ(evidence_.verdict(), Verdict::Confirmed);
}

TEST_F(EvidenceTest, takesNothingFromATargetThatIsTheStart) {
  robot::Target there = target();
  there.is_the_start = true;
  Evidence evidence(robot_, settings_, nullptr, there);
  frame(kTarget, 20);
  EXPECT_FALSE(evidence.confirms());
  frame(40, 20);
  EXPECT_FALSE(evidence.confirms());
  EXPECT_EQ(evidence.verdict(), Verdict::Contradicted);
}

TEST_F(EvidenceTest, staysOpenWithTooFewFrames) {
  frame(kTarget, std::nullopt);
  EXPECT_FALSE(evidence_.confirms());
  Evidence fresh(robot_, settings_, nullptr, std::nullopt);
  EXPECT_EQ(fresh.verdict(), Verdict::Open) << "by one frame without speeds nobody can tell whether it moves";
}

}  // namespace
}  // namespace cobot_command::command
