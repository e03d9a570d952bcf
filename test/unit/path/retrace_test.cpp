// Driving back along a path: by the way of its plans, in another time.
#include "cobot_command/path/retrace.h"

#include <memory>
#include <random>

#include "path_support.h"
#include "way_distance.h"

#include "cobot_command/motion/planner.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

class Retraces : public Paths {
 protected:
  /// Lines with corners, and a turn; 6 points, two stops.
  void drive() {
    const PathPlan plan = planned({blending(line(0, 60), 20), blending(line(60, 0), 20), line(0, -60),
                                   toJoints({15, 0, 90, 0, 90, 0}), blending(line(-40, 0), 10), line(0, 40)});
    driven.send(std::make_shared<const PathPlan>(plan), 0);
    driven.come(6, {});
    length = plan.duration();
  }
  [[nodiscard]] static PathPoint line(double y, double z) { return incremental(toPose({0, y, z, 0, 0, 0})); }
  [[nodiscard]] Retrace whole(double rate) const {
    return {length, Duration::zero(), rate, driven.at(length).position, std::nullopt};
  }
  [[nodiscard]] motion::TrajectoryPtr made(const Retrace& retrace) const {
    auto motion = motion::plan(scene.arm, retrace.start, motion::Pvt{*pvtOf(retrace, driven, 5000)}, {});
    EXPECT_TRUE(motion) << motion.error().message;
    return *motion;
  }
  [[nodiscard]] Eigen::Vector3d flange(const arm::JointVector& joints) const {
    return mToMm(1) * arm::forwardKinematics(scene.arm, joints).translation();
  }
  /// By which the flange leaves the way [mm], at most.
  [[nodiscard]] double offTheWay(const motion::Trajectory& motion) const {
    std::vector<Eigen::Vector3d> way;
    for (Duration time{}; time <= length; time += milliseconds(1)) {
      way.push_back(flange(driven.at(time).position));
    }
    std::vector<Eigen::Vector3d> places;
    for (Duration time{}; time <= motion.duration(); time += milliseconds(13)) {
      places.push_back(flange(motion.at(time).position));
    }
    return testing::mostOff(places, way);
  }

  DrivenPath driven;
  Duration length{};
};

TEST_F(Retraces, goTheWayBackFromRestToRest) {
  drive();
  for (const double rate : {0.1, 0.25, 1.0}) {
    const auto motion = made(whole(rate));
    EXPECT_NEAR((motion->end().position - driven.at({}).position).norm(), 0, 1e-9);
    EXPECT_NEAR(motion->end().velocity.norm(), 0, 1e-9);
    EXPECT_LT(offTheWay(*motion), 0.05) << rate;
    EXPECT_NEAR(toSeconds(motion->duration()), toSeconds(length) / rate + 0.5, 1.1e-3);
  }
}

TEST_F(Retraces, areAsFastAsTheyAreToBe) {
  drive();
  double fastest = 0;
  for (Duration time{}; time < length; time += milliseconds(1)) {
    fastest = std::max(fastest, driven.at(time).velocity.cwiseAbs().maxCoeff());
  }
  const auto motion = made(whole(0.5));
  double found = 0;
  for (Duration time{}; time < motion->duration(); time += milliseconds(1)) {
    found = std::max(found, motion->at(time).velocity.cwiseAbs().maxCoeff());
  }
  EXPECT_NEAR(found, 0.5 * fastest, 0.01 * fastest);
}

TEST_F(Retraces, goForthLikewise) {
  drive();
  Retrace forth = whole(0.5);
  forth.from = milliseconds(300);
  forth.to = length - milliseconds(300);
  forth.start = driven.at(forth.from).position;
  const auto motion = made(forth);
  EXPECT_LT((motion->end().position - driven.at(forth.to).position).norm(), 1e-9);
  EXPECT_LT(offTheWay(*motion), 0.05);
}

TEST_F(Retraces, ofAShortWayAreSlow) {
  drive();
  Retrace retrace = whole(1.0);
  retrace.from = milliseconds(500);
  retrace.to = milliseconds(450);
  retrace.start = driven.at(retrace.from).position;
  EXPECT_EQ(durationOf(retrace, driven), milliseconds(1000));
  const auto motion = made(retrace);
  EXPECT_LT((motion->end().position - driven.at(retrace.to).position).norm(), 1e-9);
  retrace.to = retrace.from;
  EXPECT_EQ(durationOf(retrace, driven), milliseconds(1000)) << "also where there is nothing to go";
  EXPECT_LT((made(retrace)->end().position - retrace.start).norm(), 1e-9);
}

TEST_F(Retraces, comeOntoTheWayFromNextToIt) {
  drive();
  Retrace retrace = whole(0.25);
  const double off = degToRad(0.09);
  retrace.start[2] += off;
  retrace.end = driven.at({}).position;
  (*retrace.end)[1] -= off;
  const auto motion = made(retrace);
  EXPECT_LT((motion->end().position - *retrace.end).norm(), 1e-9);
  EXPECT_LT(offTheWay(*motion), 1.6) << "[mm], which is what 0.09 deg are";
  double fastest = 0;
  for (Duration time{}; time < milliseconds(200); time += milliseconds(1)) {
    fastest = std::max(fastest, std::abs(motion->at(time).velocity[2]));
  }
  EXPECT_LT(fastest, degToRad(2.0));
}

/// A fast turn, stopped on its way, that then goes on.
class CutRetraces : public Retraces {
 protected:
  void SetUp() override {
    const PathPlan whole = planned({fast()});
    driven.send(std::make_shared<const PathPlan>(whole), 0);
    arm::JointVector stopped = whole.at(whole.duration() / 2).position;
    stopped[3] += degToRad(0.09);
    driven.cut(stopped);
    cut = driven.end();
    scene.start = stopped;
    const PathPlan rest = planned({fast()});
    driven.send(std::make_shared<const PathPlan>(rest), 0);
    driven.come(1, {});
    length = driven.reached();
  }
  [[nodiscard]] static PathPoint fast() {
    PathPoint point = toJoints({60, 0, 90, 0, 90, 0});
    point.speed = 100;
    point.acceleration = point.deceleration = 500;
    return point;
  }
  /// Of any joint [deg/s^2], as differences of 5 ms.
  [[nodiscard]] static double accelerationOf(const motion::Trajectory& motion) {
    double most = 0;
    for (Duration time{}; time + milliseconds(5) < motion.duration(); time += milliseconds(1)) {
      const arm::JointVector change = motion.at(time + milliseconds(5)).velocity - motion.at(time).velocity;
      most = std::max(most, change.cwiseAbs().maxCoeff());
    }
    return radToDeg(most) / 0.005;
  }
  Duration cut{};
};

TEST_F(CutRetraces, restWhereThePathWasStopped) {
  for (const bool forth : {false, true}) {
    Retrace retrace = whole(1.0);
    if (forth) std::swap(retrace.from, retrace.to);
    retrace.start = driven.at(retrace.from).position;
    const auto motion = made(retrace);
    EXPECT_LT(accelerationOf(*motion), 700) << "of 500 that were planned";
    EXPECT_LT((motion->end().position - driven.at(retrace.to).position).norm(), 1e-9);
    bool rests = false;
    for (Duration time = milliseconds(100); time + milliseconds(100) < motion->duration();
         time += milliseconds(1)) {
      const motion::JointState state = motion->at(time);
      rests =
          rests || (state.velocity.norm() < 1e-6 && (state.position - driven.cuts()[0].joints).norm() < 1e-6);
    }
    EXPECT_TRUE(rests);
  }
}

TEST_F(CutRetraces, beginAndEndOnTheirSideOfIt) {
  for (const Duration from : {cut, cut + Duration(1)}) {
    for (const Duration to : {Duration::zero(), length}) {
      Retrace retrace{from, to, 1.0, driven.cuts()[0].joints, std::nullopt};
      EXPECT_LT(accelerationOf(*made(retrace)), 700);
      std::swap(retrace.from, retrace.to);
      retrace.start = driven.at(retrace.from).position;
      retrace.end = driven.cuts()[0].joints;
      EXPECT_LT(accelerationOf(*made(retrace)), 700);
    }
  }
}

TEST_F(Retraces, areNoFasterThanThePathWherever) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-100, 100);
  int made_ways = 0;
  const double rated = scene.arm.limits()[0].max_velocity;
  const auto fast = [&] {
    PathPoint point = toJoints({anywhere(random), 0, 90, 0, 90, anywhere(random)});
    point.speed = radToDeg(rated);
    point.acceleration = point.deceleration = 1000;
    return point;
  };
  for (int i = 0; i < 100; ++i) {
    PathPlanner planner(scene);
    if (planner.append(sectionOf({blending(fast(), 50), blending(fast(), 20), fast()}))) continue;
    driven = DrivenPath();
    driven.send(std::make_shared<const PathPlan>(planner.plan()), 0);
    driven.come(3, {});
    length = planner.plan().duration();
    EXPECT_TRUE(motion::plan(scene.arm, whole(1).start, motion::Pvt{*pvtOf(whole(1), driven, 5000)}, {}))
        << i;
    ++made_ways;
  }
  EXPECT_GT(made_ways, 50);
}

TEST_F(Retraces, haveAsManyPointsAsThePathAtAnySpeed) {
  drive();
  const auto count = [this](double rate) { return pvtOf(whole(rate), driven, 5000)->size(); };
  EXPECT_LT(count(kLeastRetraceRate), count(1.0) + 45);
  const Duration slowest = durationOf(whole(kLeastRetraceRate), driven);
  EXPECT_NEAR(toSeconds(slowest), toSeconds(length) / kLeastRetraceRate + 0.5, 1e-2);
  EXPECT_FALSE(pvtOf(whole(1.0), driven, 50));
}

TEST_F(Retraces, areFoundWhereverTheArmStands) {
  drive();
  std::mt19937 random(7);
  std::uniform_int_distribution<int> anywhere(0, static_cast<int>(length / milliseconds(1)));
  for (int i = 0; i < 200; ++i) {
    const Duration there = anywhere(random) * milliseconds(1);
    const auto found = placeOn(driven, driven.at(there).position);
    ASSERT_TRUE(found) << toSeconds(there);
    EXPECT_LT((driven.at(*found).position - driven.at(there).position).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST_F(Retraces, areNotFoundBesideTheWay) {
  drive();
  arm::JointVector joints = driven.at(length / 2).position;
  joints[5] += degToRad(0.2);
  EXPECT_FALSE(placeOn(driven, joints));
  EXPECT_FALSE(placeOn(DrivenPath(), joints));
}

TEST_F(Retraces, areOfTheLastPassWhereAPlaceWasPassedTwice) {
  const PathPlan plan = planned(
      {toJoints({20, 0, 90, 0, 90, 0}), toJoints({0, 0, 90, 0, 90, 0}), toJoints({20, 0, 90, 0, 90, 0})});
  driven.send(std::make_shared<const PathPlan>(plan), 0);
  driven.come(3, {});
  const auto found = placeOn(driven, degrees(10, 0, 90, 0, 90, 0));
  ASSERT_TRUE(found);
  EXPECT_GT(*found, plan.points()[2].start);
}

TEST_F(Retraces, areOfThePassThatTheRobotWasBroughtTo) {
  const PathPlan plan = planned(
      {toJoints({20, 0, 90, 0, 90, 0}), toJoints({0, 0, 90, 0, 90, 0}), toJoints({20, 0, 90, 0, 90, 0})});
  driven.send(std::make_shared<const PathPlan>(plan), 0);
  driven.come(3, {});
  driven.bringTo(plan.points()[0].end());
  const auto found = placeOn(driven, degrees(20, 0, 90, 0, 90, 0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(toSeconds(*found), toSeconds(plan.points()[0].end()), 0.05);
}

TEST_F(Retraces, areGivenUpWhenNobodyWaits) {
  drive();
  int asked = 0;
  EXPECT_FALSE(placeOn(driven, degrees(90, 0, 90, 0, 90, 0), [&] { return ++asked > 0; }));
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace cobot_command::path
