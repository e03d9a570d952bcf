// One motion on the arm by itself: held, let go, stopped, blended.
#include "drive/moving_arm.h"

#include "table_checks.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

/// 1 rad/s of all joints, from one angle on.
class Even final : public motion::Trajectory {
 public:
  Even(double from, Duration duration) : from_(from), duration_(duration) {}

  [[nodiscard]] Duration duration() const override { return duration_; }
  [[nodiscard]] motion::JointState at(Duration time) const override {
    const double way = toSeconds(std::clamp(time, Duration::zero(), duration_));
    return {arm::JointVector::Constant(from_ + way), arm::JointVector::Ones()};
  }
  [[nodiscard]] Duration timeUp() const override { return {}; }
  [[nodiscard]] Duration timeDown() const override { return {}; }

 private:
  double from_;
  Duration duration_;
};

ArmMotion even(double from, Duration duration, std::optional<motion::Blend> blend = {}) {
  const auto path = std::make_shared<Even>(from, duration);
  return {path, path, blend};
}

Instant at(Duration since_start) {
  return Instant{} + since_start;
}

struct ArmThatMoves : ::testing::Test {
  MovingArm arm{arm::JointVector::Zero(), 200ms};

  [[nodiscard]] double angle(Duration since_start) const { return arm.at(at(since_start)).position[0]; }
  [[nodiscard]] double speed(Duration since_start) const { return arm.at(at(since_start)).velocity[0]; }
};

TEST(ArmTable, isSound) {
  testing::expectSoundTable<ArmTable>(ArmState::Braking, ArmEvent::Halt, ArmState::Standing);
}

TEST(ArmTable, standsAfterHaltAndEndFromEveryMotion) {
  for (const ArmState state : {ArmState::Moving, ArmState::Held, ArmState::Braking}) {
    for (const ArmEvent event : {ArmEvent::End, ArmEvent::Halt}) {
      EXPECT_EQ(findTransition<ArmTable>(state, event)->to, ArmState::Standing);
    }
  }
}

TEST_F(ArmThatMoves, standsWhereItIsPutAndIgnoresAllButAMotion) {
  arm.hold(at(0s));
  arm.release(at(0s));
  arm.brake(at(0s));
  arm.halt(at(0s));
  EXPECT_EQ(arm.state(), ArmState::Standing);
  EXPECT_EQ(angle(1s), 0.0);
  EXPECT_EQ(speed(1s), 0.0);
  EXPECT_FALSE(arm.endsAt());
}

TEST_F(ArmThatMoves, isAtTheEndOfItsPathAfterItsTime) {
  arm.begin(even(0, 2s), at(1s));
  EXPECT_EQ(arm.endsAt(), at(3s));
  EXPECT_EQ(arm.left(at(1500ms)), 1500ms);
  EXPECT_DOUBLE_EQ(angle(2s), 1.0);
  EXPECT_TRUE(arm.inMotion(at(2s)));
  EXPECT_FALSE(arm.end().was_stopped);
  EXPECT_EQ(arm.state(), ArmState::Standing);
  EXPECT_DOUBLE_EQ(angle(9s), 2.0);
}

TEST_F(ArmThatMoves, standsOnItsPathWhileItIsHeldAndGoesOnBehind) {
  arm.begin(even(0, 2s), at(0s));
  arm.hold(at(1s));
  EXPECT_EQ(arm.state(), ArmState::Held);
  EXPECT_FALSE(arm.endsAt());
  EXPECT_DOUBLE_EQ(angle(5s), 1.1);
  EXPECT_FALSE(arm.inMotion(at(5s)));
  arm.release(at(5s));
  EXPECT_EQ(arm.state(), ArmState::Moving);
  EXPECT_EQ(arm.endsAt(), at(6s));
}

TEST_F(ArmThatMoves, endsAsPlannedWhereTheHoldComesTooLateForIt) {
  arm.begin(even(0, 2s), at(0s));
  arm.hold(at(1950ms));
  ASSERT_TRUE(arm.endsAt());
  EXPECT_LT(*arm.endsAt(), at(2150ms));
  EXPECT_FALSE(arm.end().was_stopped);
  EXPECT_DOUBLE_EQ(angle(3s), 2.0);
}

TEST_F(ArmThatMoves, givesUpTheRestWhenItIsStopped) {
  arm.begin(even(0, 2s), at(0s));
  arm.brake(at(1s));
  EXPECT_EQ(arm.state(), ArmState::Braking);
  EXPECT_EQ(arm.endsAt(), at(1200ms));
  arm.hold(at(1100ms));
  EXPECT_EQ(arm.state(), ArmState::Braking) << "an arm that brakes cannot be held";
  EXPECT_TRUE(arm.end().was_stopped);
  EXPECT_DOUBLE_EQ(angle(9s), 1.1);
}

TEST_F(ArmThatMoves, doesNotBrakeTwiceWhenItIsStoppedWhileItIsHeld) {
  arm.begin(even(0, 2s), at(0s));
  arm.hold(at(1s));
  arm.brake(at(1100ms));
  EXPECT_EQ(arm.endsAt(), at(1200ms));
  EXPECT_TRUE(arm.end().was_stopped);
}

TEST_F(ArmThatMoves, standsAtOnceWhenItIsHalted) {
  arm.begin(even(0, 2s), at(0s));
  arm.halt(at(1s));
  EXPECT_EQ(arm.state(), ArmState::Standing);
  EXPECT_DOUBLE_EQ(angle(1s), 1.0);
  EXPECT_EQ(speed(1s), 0.0);
}

TEST_F(ArmThatMoves, takesAVelocityOutOfItsBraking) {
  arm.begin(even(0, 2s), at(0s));
  arm.brake(at(1s));
  arm.begin(even(1, 3s), at(1s));
  EXPECT_EQ(arm.state(), ArmState::Moving);
  EXPECT_EQ(arm.endsAt(), at(4s));
}

TEST_F(ArmThatMoves, tellsWhatIsInTheWayOfAVelocity) {
  ArmMotion motion = even(0, 2s);
  motion.obstacle = RobotError{0x1405A, "limit"};
  arm.begin(std::move(motion), at(0s));
  const auto ended = arm.end();
  ASSERT_TRUE(ended.obstacle);
  EXPECT_EQ(ended.obstacle->code, 0x1405A);
}

TEST_F(ArmThatMoves, passesPlacesAtTheSpeedOfTheProject) {
  ArmMotion motion = even(0, 2s);
  motion.speed_override = 0.5;
  arm.begin(std::move(motion), at(0s));
  EXPECT_EQ(arm.passes(0.5), at(1s));
  EXPECT_EQ(arm.passes(99), at(2s)) << "at its end, the latest";
}

TEST_F(ArmThatMoves, passesPlacesLaterWhenItLags) {
  ArmMotion motion = even(0, 2s);
  motion.lag = 50ms;
  arm.begin(std::move(motion), at(0s));
  EXPECT_EQ(arm.passes(0.5), at(550ms));
}

TEST_F(ArmThatMoves, runsAtTheProjectSpeedThatItGetsOnItsWay) {
  ArmMotion motion = even(0, 2s);
  motion.speed_override = 0.5;
  arm.begin(std::move(motion), at(0s));
  arm.setSpeedOverride(0.25, at(1s));
  EXPECT_EQ(arm.endsAt(), at(3s));
  EXPECT_DOUBLE_EQ(angle(1s), 1.0);
  EXPECT_DOUBLE_EQ(speed(1s), 0.5);
  EXPECT_DOUBLE_EQ(angle(2s), 1.5);
  arm.setSpeedOverride(1.0, at(2s));
  EXPECT_EQ(arm.endsAt(), at(2250ms));
}

TEST_F(ArmThatMoves, takesOverInTimeAtAnotherProjectSpeed) {
  arm.begin(even(0, 2s, motion::BlendShare{1.0}), at(0s));
  arm.prepareNext(even(2, 3s), 500ms, at(1s));
  arm.setSpeedOverride(0.5, at(1s));
  EXPECT_EQ(arm.takesOverAt(), at(2s));
  arm.takeOver(at(2s));
  EXPECT_EQ(arm.endsAt(), at(8s)) << "at the same pace";
}

TEST_F(ArmThatMoves, takesNoProjectSpeedWhileItStands) {
  arm.setSpeedOverride(0.5, at(0s));
  arm.begin(even(0, 2s), at(0s));
  EXPECT_EQ(arm.endsAt(), at(2s));
}

TEST_F(ArmThatMoves, blendsIntoThePreparedMotionAndRunsOn) {
  arm.begin(even(0, 2s, motion::BlendShare{1.0}), at(0s));
  EXPECT_TRUE(arm.seeksNext());
  arm.seekNoMore();
  EXPECT_FALSE(arm.seeksNext());
  EXPECT_FALSE(arm.takesOverAt());
  arm.prepareNext(even(2, 3s), 500ms, at(1s));
  EXPECT_EQ(arm.takesOverAt(), at(1500ms));
  arm.takeOver(at(1500ms));
  EXPECT_FALSE(arm.takesOverAt());
  EXPECT_FALSE(arm.seeksNext()) << "the second does not blend";
  EXPECT_EQ(arm.endsAt(), at(4500ms));
}

TEST_F(ArmThatMoves, takesNothingOverWhileItIsHeldBefore) {
  arm.begin(even(0, 2s, motion::BlendShare{1.0}), at(0s));
  arm.prepareNext(even(2, 3s), 500ms, at(0s));
  arm.hold(at(1s));
  EXPECT_FALSE(arm.takesOverAt());
  arm.release(at(5s));
  EXPECT_EQ(arm.takesOverAt(), at(5500ms));
}

TEST_F(ArmThatMoves, forgetsWhatWasPreparedWhenItIsStoppedOrPlannedAnew) {
  arm.begin(even(0, 2s, motion::BlendShare{1.0}), at(0s));
  arm.seekNoMore();
  arm.prepareNext(even(2, 3s), 500ms, at(0s));
  arm.seekAnew();
  EXPECT_TRUE(arm.seeksNext());
  EXPECT_FALSE(arm.takesOverAt());
  arm.prepareNext(even(2, 3s), 500ms, at(0s));
  arm.brake(at(1s));
  EXPECT_FALSE(arm.takesOverAt());
  EXPECT_FALSE(arm.seeksNext());
}

}  // namespace
}  // namespace cobot_command::simulator
