#include <cmath>
#include <functional>
#include <vector>

#include "motion_support.h"

#include "cobot_command/motion/blend.h"

namespace cobot_command::motion {
namespace {

/// By an offset in the base [m], at a speed [m/s], turning by `turn` [rad].
MovePLine straight(double x, double y, double z, double speed = 0.1, double turn = 0.0) {
  return {PoseOffset{moved(arm::Pose::Identity(), x, y, z, turn, {1, 2, 1}), PoseOffset::Axes::Base},
          TcpSpeed{speed}, milliseconds(100)};
}

/// What the arm does with lines that are all known at the start.
class PLines : public ::testing::Test {
 protected:
  struct Part {
    Duration begin;
    TrajectoryPtr path;
  };

  void run(const std::vector<Command>& lines, double share = 0.5) {
    TrajectoryPtr before;
    Duration end{};
    arm::JointVector from = start;
    for (const Command& line : lines) {
      const auto next = planned(plan(arm, from, line, setting));
      ASSERT_TRUE(next);
      Passage passage{Duration::zero(), next, next};
      if (before) passage = passInto(arm, before, next, setting.tcp, BlendShare{share});
      parts.push_back({end - passage.overlap, passage.path});
      end = parts.back().begin + passage.path->duration();
      before = passage.planned;
      from = before->end().position;
    }
    duration = end;
  }
  [[nodiscard]] JointState at(Duration time) const {
    auto part = parts.end() - 1;
    while (part != parts.begin() && part->begin > time) --part;
    return part->path->at(time - part->begin);
  }
  [[nodiscard]] Eigen::Vector3d tcp(Duration time) const {
    return tcpAt(arm, at(time).position, setting).translation();
  }
  [[nodiscard]] double speed(Duration time) const {
    const Duration step = std::chrono::microseconds(10);
    return (tcp(time + step) - tcp(time - step)).norm() / toSeconds(2 * step);
  }
  void expectContinuous() const {
    const Duration step = std::chrono::microseconds(100);
    for (Duration time = step; time < duration; time += milliseconds(1)) {
      const JointState a = at(time - step);
      const JointState b = at(time);
      const arm::JointVector mean = (b.position - a.position) / toSeconds(step);
      ASSERT_LT((mean - 0.5 * (a.velocity + b.velocity)).cwiseAbs().maxCoeff(), 2e-3) << toSeconds(time);
      ASSERT_LT((b.velocity - a.velocity).cwiseAbs().maxCoeff(), 2e-3) << toSeconds(time);
    }
  }

  arm::ArmModel arm = model();
  arm::JointVector start = workingPosture();
  Setting setting;
  std::vector<Part> parts;
  Duration duration{};
};

TEST_F(PLines, oneAloneIsALine) {
  const MovePLine chained = straight(0, 0.08, 0.02);
  const auto line = planned(plan(
      arm, start, MoveLine{std::get<PoseOffset>(chained.offset), chained.speed, milliseconds(100)}, setting));
  run({chained});
  EXPECT_EQ(duration, line->duration());
  for (Duration time{}; time <= duration; time += milliseconds(37)) {
    EXPECT_TRUE(at(time).position.isApprox(line->at(time).position, 1e-9));
  }
}

TEST_F(PLines, passesClosePointsAtItsSpeed) {
  // 10 mm at 100 mm/s with 100 ms to the top speed: each by itself would just reach it.
  run(std::vector<Command>(15, straight(0, 0.01, 0)));
  EXPECT_NEAR(toSeconds(duration), 1.5 + 0.1, 1e-6) << "150 mm, and one ramp";
  for (Duration time = milliseconds(101); time < duration - milliseconds(101); time += milliseconds(3)) {
    EXPECT_NEAR(speed(time), 0.1, 1e-6) << toSeconds(time);
  }
}

TEST_F(PLines, passesPointsThatAreTooCloseForItsSpeedEach) {
  run(std::vector<Command>(80, straight(0, 0.001, 0)));
  EXPECT_NEAR(toSeconds(duration), 0.8 + 0.1, 1e-6);
  EXPECT_NEAR(speed(duration / 2), 0.1, 1e-6);
  expectContinuous();
}

TEST_F(PLines, speedsUpAndSlowsDownOnceWhereTheWholeIsShort) {
  run(std::vector<Command>(4, straight(0, 0.001, 0)));
  EXPECT_NEAR(toSeconds(duration), 2.0 * std::sqrt(0.04 * 0.1), 1e-6);
}

TEST_F(PLines, withoutABlendStopAtEachPoint) {
  run(std::vector<Command>(3, straight(0, 0.01, 0)), 0.0);
  EXPECT_NEAR(toSeconds(duration), 3 * 0.2, 1e-6);
  EXPECT_NEAR(speed(milliseconds(200)), 0.0, 1e-5);
}

TEST_F(PLines, roundACornerWithAParabola) {
  // Half of 50 % of 80 mm on either side: 20 mm. In the middle a quarter of that is left of both.
  const Eigen::Vector3d from = tcpAt(arm, start, setting).translation();
  run({straight(0, 0.08, 0), straight(0, 0, 0.08)});
  EXPECT_NEAR(toSeconds(duration), 1.6 + 0.1, 1e-6);
  const Duration middle = milliseconds(800 + 50);
  const Duration away = milliseconds(200);
  EXPECT_LT((tcp(middle - away) - from - Eigen::Vector3d(0, 0.06, 0)).norm(), 1e-9);
  EXPECT_LT((tcp(middle) - from - Eigen::Vector3d(0, 0.075, 0.005)).norm(), 1e-9);
  EXPECT_LT((tcp(middle + away) - from - Eigen::Vector3d(0, 0.08, 0.02)).norm(), 1e-9);
  EXPECT_NEAR(speed(middle), 0.1 * std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(speed(middle - away), 0.1, 1e-5);
  expectContinuous();
}

TEST_F(PLines, turnBackAtAPointWithoutAJump) {
  run({straight(0, 0.08, 0), straight(0, -0.08, 0)});
  EXPECT_NEAR(speed(milliseconds(850)), 0.0, 1e-5);
  expectContinuous();
}

TEST_F(PLines, changeTheirSpeedWithinTheCorner) {
  run({straight(0, 0.08, 0, 0.1), straight(0, 0.08, 0, 0.2)});
  expectContinuous();
  EXPECT_NEAR(speed(milliseconds(400)), 0.1, 1e-6);
  EXPECT_NEAR(speed(duration - milliseconds(150)), 0.2, 1e-6);
}

TEST_F(PLines, turnEvenlyThroughBaseAndTcp) {
  setting = displacedSetting();
  run({straight(0, 0.06, 0, 0.1, 0.2), straight(0.02, 0.03, 0.03, 0.1, -0.3),
       straight(0, 0, 0.05, 0.1, 0.4)});
  expectContinuous();
  arm::Pose end = tcpAt(arm, start, setting);
  for (const double turn : {0.2, -0.3, 0.4}) end = moved(end, 0, 0, 0, turn, {1, 2, 1});
  end.translation() += Eigen::Vector3d(0.02, 0.09, 0.08);
  EXPECT_TRUE(tcpAt(arm, at(duration).position, setting).isApprox(end, 1e-9));
}

TEST_F(PLines, thatComeLateTakeOverFromWhatIsLeft) {
  const auto before = planned(plan(arm, start, straight(0, 0.08, 0), setting));
  const auto next = planned(plan(arm, before->end().position, straight(0, 0, 0.08), setting));
  const Passage passage =
      passInto(arm, before, next, setting.tcp, BlendShare{1.0}, milliseconds(60));  // it slows down already
  EXPECT_EQ(passage.overlap, milliseconds(60));
  const JointState left = before->at(before->duration() - passage.overlap);
  const JointState taken = passage.path->at(Duration::zero());
  EXPECT_TRUE(taken.position.isApprox(left.position, 1e-9));
  EXPECT_TRUE(taken.velocity.isApprox(left.velocity, 1e-6));
  EXPECT_TRUE(passage.path->end().position.isApprox(next->end().position, 1e-9));
}

TEST_F(PLines, passIntoOtherMotionsAsTheseDo) {
  const auto before = planned(plan(arm, start, straight(0, 0.08, 0), setting));
  const auto ptp = planned(plan(arm, before->end().position,
                                MovePtp{degrees(20, 0, 0, 0, 0, 0), 0.5, milliseconds(100)}, setting));
  const Passage passage = passInto(arm, before, ptp, setting.tcp, BlendShare{1.0});
  EXPECT_EQ(passage.overlap, overlapAt(arm, {*before, *ptp, setting.tcp}, BlendShare{1.0}));
  EXPECT_GT(passage.overlap, Duration::zero());
  EXPECT_EQ(passage.planned, ptp);
}

TEST_F(PLines, stopForAnotherTool) {
  const auto before = planned(plan(arm, start, straight(0, 0.08, 0), setting));
  Setting other = setting;
  other.tcp = moved(other.tcp, 0, 0, 0.1);
  const auto next = planned(plan(arm, before->end().position, straight(0, 0, 0.08), other));
  const Passage passage = passInto(arm, before, next, other.tcp, BlendShare{1.0});
  EXPECT_EQ(passage.planned, next) << "blended as any other";
}

TEST(PLine, endsAtTheJointsThatItIsGiven) {
  const arm::JointVector target = workingPosture() + degrees(3, 2, -2, 1, 0, 4);
  const auto motion =
      planned(plan(model(), workingPosture(), PLine{target, TcpSpeed{0.2}, milliseconds(200)}, Setting{}));
  EXPECT_TRUE(motion->end().position.isApprox(target, 1e-9));
  const auto by_offset =
      planned(plan(model(), workingPosture(),
                   MovePLine{degrees(3, 2, -2, 1, 0, 4), TcpSpeed{0.2}, milliseconds(200)}, Setting{}));
  EXPECT_TRUE(by_offset->end().position.isApprox(target, 1e-9));
}

TEST(PLine, isRefusedWhereALineLeadsToOtherJoints) {
  arm::JointVector target = workingPosture();
  target[5] -= 2.0 * kPi;  // the same pose
  target[0] += 0.1;
  const auto result =
      plan(model(), workingPosture(), PLine{target, TcpSpeed{0.2}, milliseconds(200)}, Setting{});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().reason, Refusal::Reason::PoseBits);
  EXPECT_EQ(result.error().joint, 5);
}

TEST(PLine, isRefusedAsALineIs) {
  const struct {
    Command command;
    Refusal::Reason reason;
  } cases[] = {
      {straight(2, 0, 0), Refusal::Reason::PoseBits},
      {straight(0, 0.1, 0, 4.4), Refusal::Reason::JointSpeed},
      {straight(0, 0.1, 0, 0.0), Refusal::Reason::BadParameter},
      {straight(0, 0.1, 0, 4.6), Refusal::Reason::BadParameter},
      {straight(0, NAN, 0), Refusal::Reason::NotFinite},
      {PLine{degrees(0, NAN, 0, 0, 0, 0), TcpSpeed{0.1}, milliseconds(100)}, Refusal::Reason::NotFinite},
      {PLine{arm::Pose::Identity(), TcpSpeed{0.1}, milliseconds(-1)}, Refusal::Reason::BadParameter},
  };
  for (const auto& wrong : cases) {
    const auto result = plan(model(), workingPosture(), wrong.command, Setting{});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().reason, wrong.reason) << result.error().message;
  }
}

}  // namespace
}  // namespace cobot_command::motion
