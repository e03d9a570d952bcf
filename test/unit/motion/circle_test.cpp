#include <cmath>

#include "curves/circle_path.h"
#include "motion_support.h"
#include <kdl/path_circle.hpp>
#include <kdl/rotational_interpolation_sa.hpp>

namespace cobot_command::motion {
namespace {

using Eigen::Vector3d;

arm::Pose at(const Vector3d& position) {
  return moved(arm::Pose::Identity(), position.x(), position.y(), position.z());
}

Circle through(const Vector3d& via, const Vector3d& end, std::optional<double> angle = std::nullopt) {
  return {at(via), at(end), angle, SpeedRatio{0.1}, milliseconds(100)};
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(CirclePath, runsThroughThePointOnTheArcToTheEnd) {
  // The unit circle shifted to x = 2, in the plane y = 3.
  auto path = circlePath(at({3, 3, 0}), through({2, 3, 1}, {2, 3, -1}));
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length(), 1.5 * kPi, 1e-12);
  EXPECT_LT((path->at(0.0).translation() - Vector3d(3, 3, 0)).norm(), 1e-15);
  EXPECT_LT((path->at(1.0 / 3.0).translation() - Vector3d(2, 3, 1)).norm(), 1e-14);
  EXPECT_LT((path->at(2.0 / 3.0).translation() - Vector3d(1, 3, 0)).norm(), 1e-14);
  EXPECT_LT((path->at(1.0).translation() - Vector3d(2, 3, -1)).norm(), 1e-14);
}

TEST(CirclePath, takesTheShortArcWhenThePointLiesOnIt) {
  auto path = circlePath(at({1, 0, 0}), through({std::cos(-0.3), std::sin(-0.3), 0}, {0, -1, 0}));
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length(), 0.5 * kPi, 1e-12);
}

TEST(CirclePath, keepsRadiusAndPlaneForAnyThreePoints) {
  const Vector3d start(0.41, -0.12, 0.34);
  const Vector3d via(0.38, 0.21, 0.30);
  const Vector3d end(-0.1, 0.4, 0.5);
  auto path = circlePath(at(start), through(via, end));
  ASSERT_TRUE(path);
  const Vector3d normal = (via - start).cross(end - start).normalized();
  const double radius = (via - start).norm() / (2.0 * std::sin(angleBetween(via - end, start - end)));
  double closest_to_via = 1.0;
  for (int i = 0; i <= 10000; ++i) {
    const Vector3d point = path->at(i / 10000.0).translation();
    ASSERT_LT(std::abs(normal.dot(point - start)), 1e-12);
    ASSERT_NEAR((point - start).norm(),
                2.0 * radius * std::abs(std::sin(0.5 * path->length() / radius * i / 1e4)), 1e-12);
    closest_to_via = std::min(closest_to_via, (point - via).norm());
  }
  EXPECT_LT(closest_to_via, path->length() / 10000.0);
  EXPECT_LT((path->at(1.0).translation() - end).norm(), 1e-12);
}

TEST(CirclePath, turnsToTheEndOrientationWithoutAnAngleAndHoldsTheStartWithOne) {
  const arm::Pose start = moved(at({1, 0, 0}), 0, 0, 0, 0.3, {1, 1, 0});
  Circle circle = through({0, 1, 0}, {-1, 0, 0});
  circle.end = moved(circle.end, 0, 0, 0, 1.2, {0, 1, 1});
  auto turning = circlePath(start, circle);
  ASSERT_TRUE(turning);
  EXPECT_LT(turnError(turning->at(1.0), circle.end), 1e-14);
  const Eigen::AngleAxisd whole(circle.end.linear() * start.linear().transpose());
  const Eigen::AngleAxisd half(turning->at(0.5).linear() * start.linear().transpose());
  EXPECT_NEAR(half.angle(), 0.5 * whole.angle(), 1e-12);
  EXPECT_LT((half.axis() - whole.axis()).norm(), 1e-12);

  circle.arc_angle = 1.0;
  auto holding = circlePath(start, circle);
  ASSERT_TRUE(holding);
  EXPECT_LT(turnError(holding->at(1.0), start), 1e-15);
}

TEST(CirclePath, travelsTheArcAngleBeyondTheEndOrBackwards) {
  const Circle circle = through({std::cos(0.2), std::sin(0.2), 0}, {std::cos(0.4), std::sin(0.4), 0});
  for (const double angle : {1.5 * kPi, 2.0 * kPi, 0.1, -0.5 * kPi}) {
    Circle with_angle = circle;
    with_angle.arc_angle = angle;
    auto path = circlePath(at({1, 0, 0}), with_angle);
    ASSERT_TRUE(path);
    EXPECT_LT((path->at(1.0).translation() - Vector3d(std::cos(angle), std::sin(angle), 0)).norm(), 1e-12);
    EXPECT_NEAR(path->length(), std::abs(angle), 1e-12);
  }
}

TEST(CirclePath, agreesWithKdlsCircle) {
  auto path = circlePath(at({0.5, 0.1, 0.2}), through({0.4, 0.3, 0.25}, {0.2, 0.2, 0.3}));
  ASSERT_TRUE(path);
  // The centre as the crossing of three planes: two bisectors and the plane of the points.
  const Vector3d a(0.5, 0.1, 0.2);
  const Vector3d b(0.4, 0.3, 0.25);
  const Vector3d c(0.2, 0.2, 0.3);
  Eigen::Matrix3d planes;
  planes << (b - a).transpose(), (c - a).transpose(), (b - a).cross(c - a).transpose();
  const Vector3d right(0.5 * (b - a).dot(a + b), 0.5 * (c - a).dot(a + c), (b - a).cross(c - a).dot(a));
  const Vector3d centre = planes.inverse() * right;
  const double radius = (a - centre).norm();
  const auto kdl = [](const Vector3d& v) { return KDL::Vector(v.x(), v.y(), v.z()); };
  KDL::Path_Circle circle(KDL::Frame(kdl(a)), kdl(centre), kdl(b), KDL::Rotation::Identity(),
                          path->length() / radius, new KDL::RotationalInterpolation_SingleAxis(), 1.0, true);
  ASSERT_NEAR(circle.PathLength(), path->length(), 1e-12);
  for (int i = 0; i <= 100; ++i) {
    const KDL::Vector expected = circle.Pos(circle.PathLength() * i / 100.0).p;
    EXPECT_LT((kdl(path->at(i / 100.0).translation()) - expected).Norm(), 1e-10);
  }
}

struct Degenerate {
  const char* what;
  Vector3d start, via, end;
  const char* says;
};

class CircleWithout : public ::testing::TestWithParam<Degenerate> {};

TEST_P(CircleWithout, threeDistinctPointsOffALineIsRefusedWithTheReason) {
  const Degenerate& given = GetParam();
  for (const std::optional<double> angle : {std::optional<double>{}, std::optional<double>{1.0}}) {
    auto path = circlePath(at(given.start), through(given.via, given.end, angle));
    ASSERT_FALSE(path) << given.what;
    EXPECT_NE(path.error().message.find(given.says), std::string::npos) << path.error().message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    CirclePath, CircleWithout,
    ::testing::Values(
        Degenerate{"all one", {0.4, 0, 0.3}, {0.4, 0, 0.3}, {0.4, 0, 0.3}, "the start and the arc point"},
        Degenerate{
            "start is via", {0.4, 0, 0.3}, {0.4, 0, 0.3}, {0.4, 0.2, 0.3}, "the start and the arc point"},
        Degenerate{
            "via is end", {0.4, 0, 0.3}, {0.4, 0.2, 0.3}, {0.4, 0.2, 0.3}, "the arc point and the end"},
        Degenerate{"start is end", {0.4, 0, 0.3}, {0.4, 0.2, 0.3}, {0.4, 0, 0.3}, "the start and the end"},
        Degenerate{"nearly one", {0.4, 0, 0.3}, {0.4, 0.2, 0.3}, {0.4, 9e-5, 0.3}, "0.0900 mm apart"},
        Degenerate{"collinear", {0.4, 0, 0.3}, {0.4, 0.1, 0.3}, {0.4, 0.3, 0.3}, "of one line"},
        Degenerate{"collinear back", {0.4, 0, 0.3}, {0.4, 0.3, 0.3}, {0.4, 0.1, 0.3}, "of one line"},
        Degenerate{"off by 1e-9", {0.4, 0, 0.3}, {0.4 + 1e-9, 0.1, 0.3}, {0.4, 0.3, 0.3}, "of one line"},
        Degenerate{"off by 9e-5", {0.4, 0, 0.3}, {0.4 + 9e-5, 0.1, 0.3}, {0.4, 0.3, 0.3}, "of one line"},
        Degenerate{
            "almost flat", {0.4, 0, 0.3}, {0.4 + 1.1e-4, 0.2, 0.3}, {0.4, 0.4, 0.3}, "radius 181.8 m"}));

TEST(CirclePath, acceptsPointsJustFarEnoughOffALine) {
  EXPECT_TRUE(circlePath(at({0.4, 0, 0.3}), through({0.4 + 1.1e-4, 0.05, 0.3}, {0.4, 0.1, 0.3})));
  EXPECT_TRUE(circlePath(at({0.4, 0, 0.3}), through({0.4 + 1e-3, 0.2, 0.3}, {0.4, 0.4, 0.3})));
}

TEST(Circle, keepsTheTcpOnTheCircleThroughBaseAndTcp) {
  const arm::ArmModel arm = model();
  const Setting setting = displacedSetting();
  const arm::JointVector start = workingPosture();
  const arm::Pose from = tcpAt(arm, start, setting);
  const Circle circle{moved(from, 0.05, 0.05, 0.01), moved(from, 0.0, 0.1, 0.02, 0.2, {1, 0, 2}),
                      std::nullopt, TcpSpeed{0.1}, milliseconds(200)};
  const auto motion = planned(plan(arm, start, circle, setting));
  auto path = circlePath(from, circle);
  ASSERT_TRUE(path);
  const double duration = toSeconds(motion->duration());
  EXPECT_NEAR(duration, path->length() / 0.1 + 0.2, 1e-6);
  for (Duration time = milliseconds(200); toSeconds(time) < duration - 0.2; time += milliseconds(1)) {
    const arm::Pose expected = path->at((toSeconds(time) - 0.1) / (duration - 0.2));
    const arm::Pose tcp = tcpAt(arm, motion->at(time).position, setting);
    ASSERT_LT(distance(tcp, expected), 1e-9);
    ASSERT_LT(turnError(tcp, expected), 1e-9);
  }
  EXPECT_LT(distance(tcpAt(arm, motion->end().position, setting), circle.end), 1e-9);
  EXPECT_LT(turnError(tcpAt(arm, motion->end().position, setting), circle.end), 1e-9);
}

TEST(Circle, comesBackToItsStartAfterAFullTurn) {
  const arm::ArmModel arm = model();
  const arm::JointVector start = workingPosture();
  const arm::Pose from = arm::forwardKinematics(arm, start);
  const Circle circle{moved(from, 0.03, 0.03, 0), moved(from, 0.06, 0, 0), 2.0 * kPi, SpeedRatio{0.1},
                      milliseconds(200)};
  const auto motion = planned(plan(arm, start, circle, Setting{}));
  EXPECT_LT((motion->end().position - start).cwiseAbs().maxCoeff(), 1e-9);
  const arm::Pose half_way = arm::forwardKinematics(arm, motion->at(motion->duration() / 2).position);
  EXPECT_LT(distance(half_way, moved(from, 0.06, 0, 0)), 1e-6);
}

TEST(Circle, carriesItsJointsFurtherThanHalfATurn) {
  // Around the first axis with the orientation held: J1 and J6 turn by the whole arc.
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(-120, 0, 90, 0, 90, 0);
  const auto around = [&](double angle) {
    arm::Pose pose = arm::forwardKinematics(arm, start);
    pose.translation() = Eigen::AngleAxisd(degToRad(angle), Vector3d::UnitZ()) * pose.translation();
    return pose;
  };
  const Circle circle{around(60), around(120), degToRad(240), SpeedRatio{0.2}, milliseconds(200)};
  const auto motion = planned(plan(arm, start, circle, Setting{}));
  EXPECT_NEAR(motion->end().position[0], degToRad(120), 1e-9);
  EXPECT_NEAR(std::abs(motion->end().position[5]), degToRad(240), 1e-9);
  arm::JointVector previous = start;
  for (Duration time{}; time <= motion->duration(); time += milliseconds(1)) {
    const arm::JointVector joints = motion->at(time).position;
    ASSERT_LT((joints - previous).cwiseAbs().maxCoeff(), 0.01) << toSeconds(time);
    previous = joints;
  }
}

TEST(Circle, reportsADegenerateSetAtItsStart) {
  const arm::ArmModel arm = model();
  const Setting setting = displacedSetting();
  const arm::Pose from = tcpAt(arm, workingPosture(), setting);
  const Circle circle{moved(from, 0.1, 0, 0), from, 1.5 * kPi, SpeedRatio{0.1}, milliseconds(200)};
  auto result = plan(arm, workingPosture(), circle, setting);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Refusal::Reason::DegenerateCircle);
  EXPECT_LT(distance(result.error().point, from), 1e-12);
}

}  // namespace
}  // namespace cobot_command::motion
