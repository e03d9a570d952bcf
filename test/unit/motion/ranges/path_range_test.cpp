// The proof of a piece of a path, and what it rests on: how much the rate of a curve changes.
#include "paths/path_range.h"

#include <cmath>
#include <limits>
#include <memory>

#include "curves/tcp_path.h"
#include "curves/twist_path.h"
#include "motion_support.h"
#include "paths/path_trajectory.h"
#include "profiles/trapezoid.h"
#include "random_motions.h"
#include <Eigen/LU>

#include "cobot_command/arm/pose_bits.h"

namespace cobot_command::motion {
namespace {

/// Along the whole of `curve` it changes no more than is said.
void expectBound(const TcpCurve& curve) {
  constexpr int kParts = 200;
  constexpr double kStep = 1e-5;
  for (int i = 0; i < kParts; ++i) {
    const double from = static_cast<double>(i) / kParts;
    const double to = from + 1.0 / kParts;
    const RateChange bound = curve.rateChange(from, to);
    for (double at = from; at + kStep < to; at += 0.1 / kParts) {
      const PathRate change = (curve.rateAt(at + kStep) - curve.rateAt(at)) / kStep;
      EXPECT_LE(change.head<3>().norm(), bound.linear + 1e-6) << at;
      EXPECT_LE(change.tail<3>().norm(), bound.angular + 1e-6) << at;
    }
  }
}

TEST(RateChange, isThatOfAnArcAndNoneOfALine) {
  const arm::Pose from = tcpAt(model(), workingPosture(), {});
  const TcpPath line = TcpPath::line(from, moved(from, 0.1, 0.2, 0.1, 0.4));
  EXPECT_EQ(line.rateChange(0.1, 0.6).linear, 0.0);
  EXPECT_EQ(line.rateChange(0.1, 0.6).angular, 0.0);
  const Eigen::Vector3d centre = from.translation() + Eigen::Vector3d(0, 0.25, 0);
  const TcpPath arc = TcpPath::arc(from, centre, Eigen::Vector3d::UnitZ(), -2.0, from.linear());
  EXPECT_NEAR(arc.rateChange(0.1, 0.6).linear, 0.25 * 4.0, 1e-12);
  expectBound(arc);
}

TEST(RateChange, isBoundedWhereOneVelocityPassesIntoAnother) {
  Dice dice(3);
  for (int i = 0; i < 20; ++i) {
    const auto rate = [&] {
      PathRate any;
      any << dice.between(0, 0.5) * dice.direction(), dice.between(0, 2.0) * dice.direction();
      return any;
    };
    const PathRate one = rate();
    const PathRate other = rate();
    TwistPath path(tcpAt(model(), workingPosture(), {}));
    path.append(0.3, one);
    path.append(0.4, one, other);
    path.append(0.2, other);
    expectBound(path.part(0.1, 0.05));
  }
}

TEST(RateChange, isInfiniteWhereAVelocityJumps) {
  TwistPath path(tcpAt(model(), workingPosture(), {}));
  path.append(0.5, PathRate::Constant(0.1));
  path.append(0.5, PathRate::Constant(0.2));
  EXPECT_EQ(path.rateChange(0.1, 0.4).linear, 0.0);
  EXPECT_EQ(path.rateChange(0.6, 0.9).linear, 0.0);
  EXPECT_TRUE(std::isinf(path.rateChange(0.4, 0.6).linear));
  EXPECT_TRUE(std::isinf(path.rateChange(0.4, 0.6).angular));
}

/// On a line that begins in `posture`.
std::optional<JointRange> aroundTheStart(const arm::JointVector& posture, double way) {
  const arm::ArmModel arm = model();
  const arm::Pose from = tcpAt(arm, posture, {});
  const auto line = std::make_shared<const TcpPath>(TcpPath::line(from, moved(from, 0.1, 0.1, 0.1)));
  const CurvePostures postures(arm, line, arm::Pose::Identity(), arm::poseBitsOf(arm, posture));
  return rangeOnPiece(postures, {0.0, 0.0, way}, posture);
}

TEST(RangeOnAPiece, needsAPieceThatIsShortWhereASingularityIsNear) {
  EXPECT_TRUE(aroundTheStart(degrees(10, 15, 80, -5, 85, 20), 0.02));
  EXPECT_FALSE(aroundTheStart(degrees(10, 15, 80, -5, 85, 20), 1.0));
  EXPECT_FALSE(aroundTheStart(degrees(10, 15, 80, -5, 0.15, 20), 0.02));
  EXPECT_TRUE(aroundTheStart(degrees(10, 15, 80, -5, 0.15, 20), 1e-7));
}

TEST(RangeOnAPiece, doesNotExistOnASingularity) {
  for (const double way : {1e-3, 1e-9, 1e-15}) {
    EXPECT_FALSE(aroundTheStart(degrees(10, 15, 80, -5, 0, 20), way));
    EXPECT_FALSE(aroundTheStart(degrees(10, 15, 0, -5, 85, 20), way));
  }
}

/// A line, an arc, or one velocity that passes into another; from where the arm is.
TcpCurvePtr anyCurve(const arm::Pose& from, Dice& dice) {
  const arm::Pose to = moved(from, dice.between(-0.2, 0.2), dice.between(-0.2, 0.2), dice.between(-0.2, 0.2),
                             dice.between(0.0, 1.0), dice.direction());
  const double kind = dice.between(0.0, 3.0);
  if (kind < 1.0) return std::make_shared<const TcpPath>(TcpPath::line(from, to));
  if (kind < 2.0) {
    const Eigen::Vector3d normal = dice.direction();
    const Eigen::Vector3d out = normal.cross(dice.direction()) * dice.between(0.02, 0.2);
    return std::make_shared<const TcpPath>(
        TcpPath::arc(from, from.translation() - out, normal, dice.between(-3.0, 3.0), to.linear()));
  }
  auto path = std::make_shared<TwistPath>(from);
  PathRate one;
  PathRate other;
  one << dice.between(0, 0.2) * dice.direction(), dice.between(0, 1.0) * dice.direction();
  other << dice.between(0, 0.2) * dice.direction(), dice.between(0, 1.0) * dice.direction();
  path->append(1.0, one, other);
  return path;
}

/// What the argument adds to the straight way is what is needed: no joint is outside of the whole, many are
/// outside of the straight way alone.
TEST(RangeOnAPiece, containsAllPosturesAndTheStraightWayDoesNot) {
  const arm::ArmModel arm = model();
  Dice dice(9);
  int pieces = 0;
  int outside_straight = 0;
  for (int i = 0; i < 3000; ++i) {
    arm::JointVector start = workingPosture() + dice.joints(0.8);
    if (i % 3 == 0) start[4] = dice.between(2.6e-3, 5e-2);
    if (i % 3 == 1) start[2] = dice.between(2.6e-3, 5e-2);
    const arm::Pose tool = moved(arm::Pose::Identity(), 0.0, 0.05, 0.15, 0.5, {1, 1, 0});
    const TcpCurvePtr curve = anyCurve(arm::forwardKinematics(arm, start) * tool, dice);
    const CurvePostures postures(arm, curve, tool, arm::poseBitsOf(arm, start));
    const PathPiece piece{0.0, 0.0, dice.ofAnySize(1e-3, 0.3)};
    const auto range = rangeOnPiece(postures, piece, start);
    if (!range) continue;
    ++pieces;
    const PathEquation equation = postures.equationAt(0.0, start);
    JointRange straight = JointRange::of(start);
    straight.include(start + piece.behind * equation.jacobian.partialPivLu().solve(equation.rate));
    for (int k = 1; k <= 20; ++k) {
      const auto joints = postures.at(piece.behind * k / 20, start);
      ASSERT_TRUE(joints);
      EXPECT_TRUE(range->contains(*joints)) << i;
      outside_straight += straight.contains(*joints) ? 0 : 1;
    }
  }
  EXPECT_GT(pieces, 500);
  EXPECT_GT(outside_straight, pieces);
}

/// A line whose rate may do anything, for all that is said of it.
class Jumping final : public TcpCurve {
 public:
  explicit Jumping(const TcpPath& line) : line_(line) {}
  [[nodiscard]] double length() const override { return line_.length(); }
  [[nodiscard]] double turn() const override { return line_.turn(); }
  [[nodiscard]] arm::Pose at(double progress) const override { return line_.at(progress); }
  [[nodiscard]] PathRate rateAt(double progress) const override { return line_.rateAt(progress); }
  [[nodiscard]] RateChange rateChange(double from, double to) const override {
    const bool jumps = from < 0.5 && to > 0.5;
    return {jumps ? std::numeric_limits<double>::infinity() : 0.0, 0.0};
  }

 private:
  TcpPath line_;
};

TEST(JointRangeOfAPath, isRefusedWhereNotEvenTheShortestPieceIsShortEnough) {
  const arm::Pose from = tcpAt(model(), workingPosture(), {});
  const auto curve = std::make_shared<const Jumping>(TcpPath::line(from, moved(from, 0.0, 0.1, 0.0)));
  const auto profile = std::make_shared<const Trapezoid>(1.0, 0.2);
  const auto motion =
      planned(follow(model(), workingPosture(), TimedCurve{curve, profile, "line", {}}, Setting{}));
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->jointRange(Duration::zero(), milliseconds(599)));
  const auto range = motion->jointRange(Duration::zero(), motion->duration());
  ASSERT_FALSE(range);
  EXPECT_NEAR(toSeconds(range.error().from), 0.6, 2e-6);
  EXPECT_NEAR(toSeconds(range.error().to), 0.6, 2e-6);
  EXPECT_LT(range.error().to - range.error().from, std::chrono::microseconds(1) + Duration(2));
  EXPECT_EQ(range.error().message.rfind("UNBOUNDED: from 0.", 0), 0U) << range.error().message;
  EXPECT_NE(range.error().message.find("choose another path, or PTP"), std::string::npos);
}

}  // namespace
}  // namespace cobot_command::motion
