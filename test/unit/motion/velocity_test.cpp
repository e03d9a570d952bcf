#include "cobot_command/motion/velocity.h"

#include <cmath>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

using namespace std::chrono_literals;

JointState standing() {
  return {workingPosture(), arm::JointVector::Zero()};
}

VelocityMotion made(const Result<VelocityMotion, Refusal>& result) {
  if (!result) {
    ADD_FAILURE() << toString(result.error().reason) << ": " << result.error().message;
    return {};
  }
  return *result;
}

VelocityMotion joints(const JointState& now, const arm::JointVector& velocity,
                      std::optional<Duration> lasting = 1s, const Setting& setting = {}) {
  return made(planVelocity(model(), now, {velocity, 200ms, lasting}, setting));
}

TEST(JointVelocity, growsEvenlyIsKeptAndFallsEvenlyToRest) {
  const VelocityMotion motion = joints(standing(), degrees(10, 0, 0, 0, 0, -20));
  ASSERT_TRUE(motion.trajectory);
  EXPECT_FALSE(motion.ends_at);
  EXPECT_EQ(motion.trajectory->duration(), 1200ms);
  const struct {
    Duration time;
    double speed, way;  // of J1 [deg/s, deg]
  } cases[] = {{0ms, 0, 0},     {100ms, 5, 0.25},  {200ms, 10, 1},  {600ms, 10, 5},
               {1000ms, 10, 9}, {1100ms, 5, 9.75}, {1200ms, 0, 10}, {5s, 0, 10}};
  for (const auto& expected : cases) {
    const JointState state = motion.trajectory->at(expected.time);
    EXPECT_NEAR(radToDeg(state.velocity[0]), expected.speed, 1e-9) << toSeconds(expected.time);
    EXPECT_NEAR(radToDeg(state.position[0]), 10 + expected.way, 1e-9) << toSeconds(expected.time);
    EXPECT_NEAR(radToDeg(state.position[5]), 20 - 2 * expected.way, 1e-9) << toSeconds(expected.time);
  }
}

TEST(JointVelocity, goesOnFromTheVelocityThatTheArmHas) {
  const JointState now = joints(standing(), degrees(10, 0, 0, 0, 0, 0)).trajectory->at(500ms);
  const VelocityMotion next = joints(now, degrees(-10, 5, 0, 0, 0, 0));
  EXPECT_TRUE(next.trajectory->at(0ms).velocity.isApprox(now.velocity));
  EXPECT_TRUE(next.trajectory->at(0ms).position.isApprox(now.position));
  EXPECT_NEAR(next.trajectory->at(100ms).velocity[0], 0.0, 1e-12);
  EXPECT_NEAR(radToDeg(next.trajectory->at(200ms).velocity[0]), -10.0, 1e-9);
  EXPECT_NEAR(next.trajectory->at(200ms).position[0], now.position[0], 1e-12) << "there and back";
}

TEST(JointVelocity, isScaledByTheProjectSpeed) {
  Setting half;
  half.speed_override = 0.5;
  const VelocityMotion motion = joints(standing(), degrees(10, 0, 0, 0, 0, 0), 1s, half);
  EXPECT_NEAR(radToDeg(motion.trajectory->at(500ms).velocity[0]), 5.0, 1e-9);
}

TEST(JointVelocity, thatLastsTillTheLimitRestsAtIt) {
  const VelocityMotion motion = joints(standing(), degrees(0, 0, 20, 0, 0, 0), std::nullopt);
  ASSERT_TRUE(motion.ends_at);
  EXPECT_EQ(motion.ends_at->reason, Refusal::Reason::JointLimit);
  EXPECT_EQ(motion.ends_at->joint, 2);
  EXPECT_NEAR(motion.trajectory->end().position[2], model().limits()[2].upper, 1e-9);
  EXPECT_NEAR(toSeconds(motion.trajectory->duration()), (155.0 - 80.0) / 20.0 + 0.2, 1e-6);
}

TEST(JointVelocity, isRefusedWhereItIsFasterThanRatedOrTooCloseToALimit) {
  const auto fast = planVelocity(model(), standing(), {degrees(181, 0, 0, 0, 0, 0), 200ms, 1s}, {});
  ASSERT_FALSE(fast.has_value());
  EXPECT_EQ(fast.error().reason, Refusal::Reason::JointSpeed);
  JointState close = standing();
  close.position[2] = degToRad(154);
  const auto out = planVelocity(model(), close, {degrees(0, 0, 20, 0, 0, 0), 200ms, 1s}, {});
  ASSERT_FALSE(out.has_value());
  EXPECT_EQ(out.error().reason, Refusal::Reason::JointLimit);
  EXPECT_TRUE(planVelocity(model(), close, {degrees(0, 0, -20, 0, 0, 0), 200ms, 1s}, {}).has_value());
  const auto no_number = planVelocity(model(), standing(), {degrees(0, NAN, 0, 0, 0, 0), 200ms, 1s}, {});
  ASSERT_FALSE(no_number.has_value());
  EXPECT_EQ(no_number.error().reason, Refusal::Reason::NotFinite);
}

class ToolVelocity : public ::testing::Test {
 protected:
  [[nodiscard]] VelocityMotion drive(const TcpVelocity& velocity, const JointState& now,
                                     std::optional<Duration> lasting = 1s) const {
    return made(planVelocity(arm, now, {velocity, 200ms, lasting}, setting));
  }
  [[nodiscard]] arm::Pose tcp(const JointState& state) const { return tcpAt(arm, state.position, setting); }

  arm::ArmModel arm = model();
  Setting setting = displacedSetting();
  arm::Pose start = tcp(standing());
};

TEST_F(ToolVelocity, movesAlongAndTurnsAboutTheAxesOfTheBase) {
  const VelocityMotion motion = drive({{0.05, 0, 0}, {0, 0, 0.3}}, standing());
  ASSERT_TRUE(motion.trajectory);
  for (const auto& [time, way] :
       {std::pair(100ms, 0.025), std::pair(200ms, 0.1), std::pair(700ms, 0.6), std::pair(1200ms, 1.0)}) {
    const arm::Pose expected = moved(start, 0.05 * way, 0, 0, 0.3 * way);
    EXPECT_TRUE(tcp(motion.trajectory->at(time)).isApprox(expected, 1e-8)) << toSeconds(time);
  }
}

TEST_F(ToolVelocity, passesEvenlyToTheNextOne) {
  const JointState now = drive({{0.05, 0, 0}, {0, 0, 0.3}}, standing()).trajectory->at(500ms);
  const VelocityMotion next = drive({{0, 0.05, 0}, {0.3, 0, 0}}, now);
  EXPECT_TRUE(next.trajectory->at(0ms).velocity.isApprox(now.velocity, 1e-8));
  const Duration step = std::chrono::microseconds(50);
  for (Duration time = 1ms; time < next.trajectory->duration(); time += 20ms) {
    const arm::JointVector slope =
        (next.trajectory->at(time + step).position - next.trajectory->at(time - step).position) /
        toSeconds(2 * step);
    EXPECT_LT((slope - next.trajectory->at(time).velocity).cwiseAbs().maxCoeff(), 1e-4) << toSeconds(time);
  }
  // Half of the ramp is left of the one velocity, and half is there of the other.
  const Eigen::Vector3d way = tcp(next.trajectory->at(200ms)).translation() - tcp(now).translation();
  EXPECT_TRUE(way.isApprox(Eigen::Vector3d(0.005, 0.005, 0), 1e-8)) << way.transpose();
}

TEST_F(ToolVelocity, restsBeforeWhatIsInItsWay) {
  const VelocityMotion motion = drive({{0.1, 0, 0}, {0, 0, 0}}, standing(), 60s);
  ASSERT_TRUE(motion.trajectory);
  ASSERT_TRUE(motion.ends_at);
  EXPECT_LT(toSeconds(motion.trajectory->duration()), 60.0);
  EXPECT_GT(toSeconds(motion.trajectory->duration()), 1.0);
  const JointState end = motion.trajectory->end();
  EXPECT_LT(arm.firstJointOutsideLimits(end.position), 0);
  const double way = (tcp(end).translation() - start.translation()).norm();
  const auto farther =
      plan(arm, standing().position,
           MoveLine{PoseOffset{moved(arm::Pose::Identity(), way + 0.002, 0, 0), PoseOffset::Axes::Base},
                    TcpSpeed{0.01}, 200ms},
           setting);
  const auto same = plan(arm, standing().position,
                         MoveLine{PoseOffset{moved(arm::Pose::Identity(), way, 0, 0), PoseOffset::Axes::Base},
                                  TcpSpeed{0.01}, 200ms},
                         setting);
  EXPECT_TRUE(same.has_value());
  EXPECT_TRUE(!farther.has_value() || motion.ends_at->reason == Refusal::Reason::JointSpeed)
      << motion.ends_at->message;
}

TEST_F(ToolVelocity, isRefusedBeyondTheHighestSpeed) {
  const auto fast = planVelocity(arm, standing(), {TcpVelocity{{5, 0, 0}, {0, 0, 0}}, 200ms, 1s}, setting);
  ASSERT_FALSE(fast.has_value());
  EXPECT_EQ(fast.error().reason, Refusal::Reason::BadParameter);
}

}  // namespace
}  // namespace cobot_command::motion
