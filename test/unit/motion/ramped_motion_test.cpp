// Moves with rates and ramps of their own, and how they pass into each other, by the figures of the path
// contract.
#include <algorithm>
#include <array>
#include <cmath>

#include "motion_support.h"
#include <gmock/gmock.h>

#include "cobot_command/motion/blend.h"

namespace cobot_command::motion {
namespace {

using ::testing::HasSubstr;
using Figures = std::array<double, 4>;

constexpr std::array<SpeedLaw, 4> kLaws{SpeedLaw::SCurve, SpeedLaw::ModSine, SpeedLaw::Poly5,
                                        SpeedLaw::SineSquared};
constexpr double kGrid = 3e-3;  // [s] a move is at most so much longer than its closed form

Rates ofJoints(double speed, double acceleration) {
  return {degToRad(speed), degToRad(acceleration), degToRad(acceleration)};
}
Rates ofWay(double speed, double acceleration) {
  return {mmToM(speed), mmToM(acceleration), mmToM(acceleration)};
}
/// A turn that never rules.
const Rates kAnyTurn{1e3, 1e6, 1e6};

class RampedMoves : public ::testing::Test {
 protected:
  [[nodiscard]] TrajectoryPtr make(const Command& command) const { return make(start, command); }
  [[nodiscard]] TrajectoryPtr make(const arm::JointVector& from, const Command& command) const {
    return planned(plan(arm, from, command, setting));
  }
  [[nodiscard]] arm::Pose tcp(const TrajectoryPtr& motion, Duration time) const {
    return tcpAt(arm, motion->at(time).position, setting);
  }
  /// From where `from` has the TCP, in the base [mm].
  [[nodiscard]] StraightMove straight(const arm::JointVector& from, double x, double y, double z,
                                      const PathRates& rates) const {
    return {moved(tcpAt(arm, from, setting), mmToM(x), mmToM(y), mmToM(z)), rates};
  }

  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(0, 0, 90, 0, 90, 0);
  Setting setting;
};

TEST_F(RampedMoves, ofJointsTakeTheTimeOfTheirRatesAndStayInStep) {
  const auto motion = make(JointMove{degrees(60, 30, 90, 0, 90, 15), ofJoints(90, 180), {}});
  EXPECT_NEAR(toSeconds(motion->duration()), 60.0 / 90 + 0.5, kGrid);
  EXPECT_EQ(motion->duration() % milliseconds(1), Duration::zero());
  double fastest = 0.0;
  for (Duration time{}; time <= motion->duration(); time += milliseconds(1)) {
    const arm::JointVector way = motion->at(time).position - start;
    ASSERT_NEAR(way[1], way[0] / 2, 1e-12);
    ASSERT_NEAR(way[5], way[0] / 4, 1e-12);
    fastest = std::max(fastest, motion->at(time).velocity[0]);
  }
  EXPECT_NEAR(radToDeg(fastest), 90.0, 0.3);
  EXPECT_LE(radToDeg(fastest), 90.0 + 1e-9);
}

TEST_F(RampedMoves, ofJointsAboveTheirRatedSpeedAreRefusedAndToldWhatWouldDo) {
  const auto refused =
      plan(arm, start, JointMove{degrees(150, 0, 90, 0, 90, 0), ofJoints(200, 400), {}}, setting);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Refusal::Reason::JointSpeed);
  EXPECT_EQ(refused.error().joint, 0);
  EXPECT_THAT(refused.error().message, HasSubstr("at most 180.0 deg/s"));
}

TEST_F(RampedMoves, ofJointsAreRatedToTheLastDigit) {
  const auto at = [&](double speed) {
    return plan(model(), start,
                JointMove{start + degrees(150, 0, 0, 0, 0, 0), ofJoints(speed, 20 * speed), {}}, {});
  };
  EXPECT_TRUE(at(180));
  const auto refused = at(180.1);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("180.07 deg/s, rated 180.0 deg/s; at most 180.0 deg/s"));
}

TEST_F(RampedMoves, thatAreTooShortForTheirSpeedMayAskForAnySpeed) {
  EXPECT_TRUE(make(JointMove{degrees(5, 0, 90, 0, 90, 0), ofJoints(400, 100), {}}));
}

TEST_F(RampedMoves, toWhereTheArmIsTakeNoTime) {
  EXPECT_EQ(make(JointMove{start, ofJoints(90, 180), {}})->duration(), Duration::zero());
  EXPECT_EQ(make(straight(start, 0, 0, 0, {ofWay(100, 400), kAnyTurn, {}}))->duration(), Duration::zero());
}

TEST_F(RampedMoves, areSlowedDownByTheProjectSpeedAsTimeIs) {
  setting.speed_override = 0.5;
  const auto motion = make(JointMove{degrees(90, 0, 90, 0, 90, 0), ofJoints(90, 180), {}});
  EXPECT_NEAR(toSeconds(motion->duration()), 3.0, kGrid);
}

TEST_F(RampedMoves, onTheirWayKeepTheLimitsOfWayAndTurnAtOnce) {
  // 200 mm and 90 degrees: the turn, at 30 deg/s, takes 3 s; with ramps 3.75 s.
  StraightMove move = straight(start, 0, 200, 0, {});
  move.target.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()) * move.target.linear();
  move.rates = {ofWay(100, 400), ofJoints(30, 60), {SpeedLaw::SCurve, 1.0, 1.0}};
  const auto motion = make(move);
  EXPECT_NEAR(toSeconds(motion->duration()), 3.75, kGrid);
  const Duration middle = motion->duration() / 2;
  const double step = 1e-3;
  const double speed = distance(tcp(motion, middle), tcp(motion, middle + milliseconds(1))) / step;
  EXPECT_NEAR(mToMm(speed), 66.67, 0.1);
}

TEST_F(RampedMoves, onTheirWayStayOnTheStraightLine) {
  const auto motion =
      make(straight(start, 0, 300, 50, {ofWay(250, 1000), kAnyTurn, {SpeedLaw::Poly5, 1, 1}}));
  const Eigen::Vector3d from = tcp(motion, {}).translation();
  const Eigen::Vector3d way = tcp(motion, motion->duration()).translation() - from;
  for (Duration time{}; time <= motion->duration(); time += milliseconds(7)) {
    const Eigen::Vector3d gone = tcp(motion, time).translation() - from;
    ASSERT_LT(gone.cross(way).norm() / way.norm(), 1e-9);
    ASSERT_NEAR(gone.norm() / way.norm(), motion->progress(time), 1e-9);
  }
}

TEST_F(RampedMoves, onTheirWayAreAcceptedAtTheSpeedThatARefusalAdvises) {
  int advised = 0;
  for (int i = 0; i < 60; ++i) {
    const double way = 20.0 + 10.0 * i;
    const double x = i % 3 == 0 ? -0.7 * way : 0.1 * way;
    StraightMove move = straight(start, x, 0.3 * way, i % 2 == 0 ? -0.5 * way : 0.2 * way,
                                 {ofWay(4500, 1000.0 * (1 + i % 40)), kAnyTurn, {}});
    auto made = plan(arm, start, move, setting);
    if (made || made.error().reason != Refusal::Reason::JointSpeed) continue;
    const std::string& text = made.error().message;
    const std::size_t at = text.find("at most ");
    ASSERT_NE(at, std::string::npos) << text;
    move.rates.way.speed = mmToM(std::stod(text.substr(at + 8)));
    made = plan(arm, start, move, setting);
    EXPECT_TRUE(made) << text << " / " << made.error().message;
    ++advised;
  }
  EXPECT_GT(advised, 10);
}

TEST_F(RampedMoves, alongAnArcPassTheArcPoint) {
  const arm::Pose from = tcpAt(arm, start, setting);
  const ArcMove arc{moved(from, 0.05, 0.05, 0), moved(from, 0, 0.1, 0), {ofWay(100, 500), kAnyTurn, {}}};
  const auto motion = make(arc);
  EXPECT_NEAR(toSeconds(motion->duration()), kPi * 50 / 100 + 0.2, kGrid);
  EXPECT_LT(distance(tcp(motion, motion->duration() / 2), arc.via), 1e-4);
  EXPECT_LT(distance(tcp(motion, motion->duration()), arc.target), 1e-9);
}

/// J4..J6 in step with the straight way of the flange.
class WristMoves : public RampedMoves {
 protected:
  [[nodiscard]] Result<TrajectoryPtr, Refusal> plan(const arm::JointVector& from,
                                                    const arm::JointVector& to) const {
    return motion::plan(arm, from, WristMove{to, {ofWay(100, 400), ofJoints(60, 240), {}}}, setting);
  }
  void expectStraight(const TrajectoryPtr& motion) const {
    const Eigen::Vector3d from = tcp(motion, {}).translation();
    const Eigen::Vector3d way = tcp(motion, motion->duration()).translation() - from;
    const arm::JointVector start_joints = motion->at({}).position;
    const Eigen::Vector3d turn = (motion->end().position - start_joints).tail<3>();
    for (Duration time{}; time <= motion->duration(); time += milliseconds(7)) {
      const JointState state = motion->at(time);
      const Eigen::Vector3d on_line = from + motion->progress(time) * way;
      ASSERT_LT((tcpAt(arm, state.position, setting).translation() - on_line).norm(), 1e-9);
      const Eigen::Vector3d wrist = start_joints.tail<3>() + motion->progress(time) * turn;
      ASSERT_LT((state.position.tail<3>() - wrist).norm(), 1e-12);
      const Duration step = std::chrono::microseconds(10);
      if (time <= step || time + step >= motion->duration()) continue;
      const arm::JointVector slope =
          (motion->at(time + step).position - motion->at(time - step).position) / (2 * toSeconds(step));
      ASSERT_LT((slope - state.velocity).cwiseAbs().maxCoeff(), 1e-3) << toSeconds(time);
    }
  }
};

TEST_F(WristMoves, passTheStretchedWristAndChangeItsFlip) {
  const auto motion =
      planned(plan(degrees(0, 0, 90, 0, 30, 0), degrees(22.9278, -6.5706, 108.7367, 0, -30, 0)));
  expectStraight(motion);
  const arm::JointVector middle = motion->at(motion->duration() / 2).position;
  EXPECT_LT((middle - degrees(13.2200, -5.1230, 101.2085, 0, 0, 0)).cwiseAbs().maxCoeff(), degToRad(1e-3));
}

TEST_F(WristMoves, turnMoreThanOnce) {
  const auto motion = planned(plan(degrees(0, 0, 90, 0, 90, -180), degrees(0, -1.6118, 80.6824, 0, 90, 180)));
  expectStraight(motion);
  const arm::JointVector middle = motion->at(motion->duration() / 2).position;
  EXPECT_LT((middle - degrees(0, -1.1297, 85.6338, 0, 90, 0)).cwiseAbs().maxCoeff(), degToRad(1e-3));
}

TEST_F(WristMoves, goWithAnyTool) {
  setting = displacedSetting();
  expectStraight(planned(plan(workingPosture(), workingPosture() + degrees(8, -5, 10, 40, -90, 70))));
}

TEST_F(WristMoves, toAnotherBranchAreRefused) {
  const auto refused = plan(degrees(0, 0, 90, 0, 30, 0), degrees(22.9278, 109.6312, -96.2587, 0, -30, 0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Refusal::Reason::PoseBits);
}

TEST_F(WristMoves, throughTheStretchedElbowAreRefused) {
  const auto refused = plan(degrees(0, 0, 60, 0, 30, 0), degrees(0, 0, -60, 0, 30, 0));
  ASSERT_FALSE(refused);
  EXPECT_THAT(toString(refused.error().reason),
              ::testing::AnyOf(HasSubstr("POSE_BITS"), HasSubstr("SINGULAR")));
}

TEST_F(RampedMoves, withoutUsableRatesAreRefused) {
  const JointMove good{degrees(10, 0, 90, 0, 90, 0), ofJoints(90, 180), {}};
  JointMove bad = good;
  bad.rates.deceleration = 0.0;
  EXPECT_THAT(plan(arm, start, bad, setting).error().message, HasSubstr("must be above 0"));
  bad = good;
  bad.rates.speed = std::nan("");
  EXPECT_EQ(plan(arm, start, bad, setting).error().reason, Refusal::Reason::NotFinite);
  bad = good;
  bad.ramps.up = 1.01;
  EXPECT_THAT(plan(arm, start, bad, setting).error().message, HasSubstr("allowed 0..100 %"));
}

// --- How they pass into each other.

struct Passed {
  TrajectoryPtr before;
  TrajectoryPtr next;
  Duration overlap{};
  TrajectoryPtr path;

  [[nodiscard]] Duration duration() const { return before->duration() - overlap + next->duration(); }
};

class RampedCorners : public RampedMoves {
 protected:
  static constexpr OverlapLimits kWholeMilliseconds{Duration::max(), std::chrono::milliseconds(1),
                                                    std::chrono::milliseconds(25)};

  [[nodiscard]] Passed pass(const Command& first,
                            const std::function<Command(const arm::JointVector&)>& second,
                            const BlendWay& blend) const {
    Passed passed;
    passed.before = make(first);
    const arm::JointVector corner = passed.before->end().position;
    passed.next = make(corner, second(corner));
    passed.overlap = overlapAt(arm, {*passed.before, *passed.next, setting.tcp}, blend, kWholeMilliseconds);
    passed.path = blended(passed.before, passed.next, passed.overlap);
    return passed;
  }
  /// Two perpendicular straight moves of 100 mm at 100 mm/s with 500 mm/s^2; `tolerance` [mm].
  [[nodiscard]] Passed passPerpendicular(const RampShape& ramps, double tolerance) const {
    const PathRates rates{ofWay(100, 500), kAnyTurn, ramps};
    const double share = tolerance / 100;
    return pass(straight(start, 0, 100, 0, rates),
                [&](const arm::JointVector& corner) { return straight(corner, 0, 0, 100, rates); },
                {share, share});
  }
  /// [mm]
  [[nodiscard]] double nearestToTheCorner(const Passed& passed) const {
    const arm::Pose corner = tcp(passed.before, passed.before->duration());
    double nearest = 1e3;
    for (Duration time{}; time <= passed.overlap; time += std::chrono::microseconds(100)) {
      nearest = std::min(nearest, mToMm(distance(tcp(passed.path, time), corner)));
    }
    return nearest;
  }
};

TEST_F(RampedCorners, leaveOutNoMoreOfTheWayThanTheTolerance) {
  const Passed passed = passPerpendicular({}, 5);
  EXPECT_NEAR(toSeconds(passed.overlap), 0.1414, 1e-3);
  EXPECT_NEAR(toSeconds(passed.duration()), 2.2586, 2 * kGrid);
  EXPECT_NEAR(nearestToTheCorner(passed), 1.768, 0.03);  // an overlap of whole milliseconds
  const arm::Pose leaves = tcp(passed.before, passed.before->duration() - passed.overlap);
  EXPECT_LE(mToMm(distance(leaves, tcp(passed.before, passed.before->duration()))), 5.0);
}

TEST_F(RampedCorners, areNeverLongerThanTheRamps) {
  const Passed passed = passPerpendicular({}, 100);
  EXPECT_EQ(passed.overlap, milliseconds(200));
  EXPECT_NEAR(toSeconds(passed.duration()), 2.2, 2 * kGrid);
  EXPECT_NEAR(nearestToTheCorner(passed), 3.536, 0.01);
}

TEST_F(RampedCorners, dependOnTheLaw) {
  const Figures overlaps{0.1870, 0.2119, 0.2228, 0.2346};
  const Figures nearest{1.084, 0.790, 0.701, 0.615};
  for (std::size_t i = 0; i < kLaws.size(); ++i) {
    const Passed passed = passPerpendicular({kLaws[i], 1.0, 1.0}, 5);
    EXPECT_NEAR(toSeconds(passed.overlap), overlaps[i], 1.1e-3) << i;
    EXPECT_NEAR(nearestToTheCorner(passed), nearest[i], 0.02) << i;
  }
}

TEST_F(RampedCorners, ofJointsLeaveOutAShareOfTheWay) {
  const auto total = [&](double tolerance) {
    return pass(JointMove{degrees(60, 0, 90, 0, 90, 0), ofJoints(60, 120), {}},
                [&](const arm::JointVector&) {
                  return JointMove{degrees(60, 0, 90, 0, 90, 60), ofJoints(60, 120), {}};
                },
                {tolerance, 1.0});
  };
  const Passed tenth = total(0.1);
  EXPECT_NEAR(toSeconds(tenth.overlap), 0.3162, 1e-3);
  EXPECT_NEAR(toSeconds(tenth.duration()), 2.6838, 2 * kGrid);
  const double leaves = tenth.before->at(tenth.before->duration() - tenth.overlap).position[0];
  EXPECT_LE(radToDeg(tenth.before->end().position[0] - leaves), 6.0);
  EXPECT_NEAR(toSeconds(total(0.25).duration()), 2.5, 2 * kGrid);
  EXPECT_NEAR(toSeconds(total(1.0).duration()), 2.5, 2 * kGrid);
  EXPECT_EQ(total(0.0).overlap, Duration::zero());
}

TEST_F(RampedCorners, shorterThanASegmentAreStops) {
  EXPECT_EQ(passPerpendicular({}, 0.1).overlap, Duration::zero());  // 20 ms
}

}  // namespace
}  // namespace cobot_command::motion
