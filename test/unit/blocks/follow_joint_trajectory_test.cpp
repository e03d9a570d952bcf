// What a trajectory must be, and the PVT that it becomes.

#include "block_goals.h"
#include "table_checks.h"
#include "trajectory/trajectory_follower.h"
#include "trajectory/trajectory_plan.h"
#include "trajectory/trajectory_run_states.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using Trajectory = FollowJointTrajectoryGoal;

const arm::JointVector kStart = (arm::JointVector() << 0, 0, kPi / 2, 0, kPi / 2, 0).finished();

class TrajectoryPlans : public ::testing::Test {
 protected:
  TrajectoryPlans() {
    scene.arm = &arm;
    scene.start.emplace();
    scene.start->joints = kStart;
  }
  /// Precondition: it can be planned.
  std::shared_ptr<const TrajectoryPlan> planned(const Trajectory& goal) const {
    const auto plan = planTrajectory(goal, scene);
    EXPECT_TRUE(plan) << plan.error().found;
    return *plan;
  }
  template <class Change>
  [[nodiscard]] Failure refused(const Change& change) const {
    const auto plan = planTrajectory(with<Trajectory>(change), scene);
    EXPECT_FALSE(plan);
    return plan ? Failure() : plan.error();
  }
  [[nodiscard]] static std::string pointLine(const TrajectoryPlan& plan, std::size_t i) {
    return plan.order.lines.at(i + 1);
  }
  [[nodiscard]] static std::size_t pointsOf(const TrajectoryPlan& plan) {
    return plan.order.lines.size() - 2;
  }

  arm::ArmModel arm = *arm::ArmModel::named("tm5-900");
  PlanningScene scene;
};

int indexOf(const Failure& failure) {
  return failure.detail.as<TrajectoryReport>().error_index;
}

TEST(TrajectoryTable, isSound) {
  expectSoundTable<TrajectoryTable>(TrajectoryState::Ended, TrajectoryEvent::NothingLeft,
                                    TrajectoryState::Following, {TrajectoryState::Ended});
}

TEST(TrajectoryTable, neverEndsAsDoneOnceItWasOffItsPath) {
  for (const auto& row : TrajectoryTable::kRows) {
    if (row.from == TrajectoryState::OffPath) {
      EXPECT_EQ(row.action, TrajectoryAction::EndFailed);
    }
  }
}

TEST(TrajectoryRules, takeAGoodOne) {
  EXPECT_EQ(errorOf(good<Trajectory>()), 0);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.points.clear(); }), 0) << "it stops what is under way";
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.points.resize(1); }), 0);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.path_tolerance.fill(-1); }), 0);
}

TEST(TrajectoryRules, nameThePointThatIsWrong) {
  const auto blamed = [](const auto& change) {
    const auto failures = check(with<Trajectory>(change));
    EXPECT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.at(0).error_id, own_error::kTrajectoryInvalid);
    EXPECT_THAT(failures.at(0).found, HasSubstr("allowed"));
    return indexOf(failures.at(0));
  };
  EXPECT_EQ(blamed([](auto& g) { g.points[1].positions.pop_back(); }), 1);
  EXPECT_EQ(blamed([](auto& g) { g.points[2].positions[0] = kNan; }), 2);
  EXPECT_EQ(blamed([](auto& g) { g.points[1].velocities.assign(6, 0); }), 1);
  EXPECT_EQ(blamed([](auto& g) { g.points[0].time = -1; }), 0);
  EXPECT_EQ(blamed([](auto& g) { g.points[2].time = kInf; }), 2);
  const auto all = [](auto& g) {
    for (auto& point : g.points) point.velocities.assign(6, 0);
  };
  EXPECT_EQ(blamed([&](auto& g) { all(g), g.points[2].velocities[5] = 0.1; }), 2);
  EXPECT_EQ(blamed([&](auto& g) { all(g), g.points[0].velocities[5] = 0.1; }), 0);
  EXPECT_EQ(blamed([&](auto& g) { all(g), g.points[1].velocities.resize(5); }), 1);
  EXPECT_EQ(blamed([](auto& g) {
              g.points.resize(1);
              g.points[0].time = 0.02;
            }),
            0);
}

/// A fuzzer's finding: they were all listed.
TEST(TrajectoryRules, areRefusedInFewWordsHoweverMuchIsWrong) {
  const auto goal = with<Trajectory>([](auto& g) { g.points[1].positions.assign(10000, kNan); });
  EXPECT_EQ(check(goal).at(0).found, "point 1: it has 10000 positions; allowed: 6");
}

/// As planners make them that put a trajectory together of several, or put the start in front of one.
TEST(TrajectoryRules, takeTwoPointsAtOneTimeInOnePlace) {
  const auto twice = [](std::size_t index, double off, double velocity = 0) {
    return [=](auto& g) {
      for (auto& point : g.points) point.velocities.assign(6, 0);
      g.points.insert(g.points.begin() + static_cast<std::ptrdiff_t>(index), g.points[index]);
      g.points[index + 1].positions[3] += off;
      g.points[index + 1].velocities[3] += velocity;
    };
  };
  for (const std::size_t index : {0U, 1U, 2U}) {
    EXPECT_EQ(errorWith<Trajectory>(twice(index, 0)), 0) << index;
    EXPECT_EQ(errorWith<Trajectory>(twice(index, 1e-7)), 0) << "within the rounding of who plans";
    const auto failures = check(with<Trajectory>(twice(index, 1e-5)));
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures[0].error_id, own_error::kTrajectoryInvalid);
    EXPECT_EQ(indexOf(failures[0]), static_cast<int>(index) + 1);
    EXPECT_THAT(failures[0].found,
                HasSubstr("the same time as the point before it, and J4 has another position"));
  }
  EXPECT_EQ(errorWith<Trajectory>(twice(1, 0, 0.1)), own_error::kTrajectoryInvalid)
      << "one speed at one time";
}

TEST(TrajectoryRules, lookAtTolerancesNamesAndTimes) {
  const int invalid = own_error::kTrajectoryInvalid;
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.points[2].time = 1; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.points[2].time = 0.9; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.points.resize(20001); }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.path_tolerance[3] = kNan; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.goal_tolerance[3] = kInf; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.goal_time_tolerance = -1; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.starts_in = 3601; }), invalid);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.starts_in = -0.9; }), 0)
      << "on its way it got a little old";
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.starts_in = -1.1; }), own_error::kStampOld);
  EXPECT_EQ(errorWith<Trajectory>([](auto& g) { g.names_fault = "no"; }), own_error::kJointNames);
}

TEST_F(TrajectoryPlans, areOnePvtWithoutTheStart) {
  const auto plan = planned(good<Trajectory>());
  EXPECT_EQ(pointsOf(*plan), 2U);
  EXPECT_EQ(plan->order.lines.front(), "PVTEnter(0)");
  EXPECT_EQ(pointLine(*plan, 0), "PVTPoint(5,0,90,0,90,0,5,0,0,0,0,0,1)");
  EXPECT_EQ(pointLine(*plan, 1), "PVTPoint(10,0,90,0,90,0,0,0,0,0,0,0,1)");
  EXPECT_EQ(plan->motion->duration(), 2s);
}

TEST_F(TrajectoryPlans, sendAPointOnceThatIsThereTwice) {
  const auto once = planned(good<Trajectory>());
  for (const std::size_t index : {0U, 1U, 2U}) {
    const auto twice = planned(with<Trajectory>([index](auto& g) {
      g.points.insert(g.points.begin() + static_cast<std::ptrdiff_t>(index), g.points[index]);
    }));
    EXPECT_EQ(twice->order.lines, once->order.lines) << index;
  }
  EXPECT_EQ(planned(with<Trajectory>([](auto& g) {
              g.points = {g.points[0], g.points[0]};
            }))->motion,
            nullptr);
}

TEST_F(TrajectoryPlans, goFromTheRobotToAFirstPointThatHasATime) {
  auto goal = good<Trajectory>();
  for (auto& point : goal.points) point.time += 1.5;
  goal.points[0].positions[5] = 0.5;
  EXPECT_EQ(pointsOf(*planned(goal)), 3U);
}

TEST_F(TrajectoryPlans, passPointsAtTheSlopeOfTheParabolaThroughTheirNeighbours) {
  auto goal = good<Trajectory>();
  goal.points[2].time = 4;  // 5 deg/s, then 5/3 deg/s
  EXPECT_EQ(pointLine(*planned(goal), 0), "PVTPoint(5,0,90,0,90,0,4.166667,0,0,0,0,0,1)");
}

TEST_F(TrajectoryPlans, goBeyondNoPointWhateverTheirTimes) {
  auto goal = good<Trajectory>();
  goal.points[2].time = 5000;
  goal.points.push_back({5001, {0, 0, kPi / 2, 0, kPi / 2, 0}, {}});
  const auto plan = planned(goal);
  for (Duration time = 0s; time < 5001s; time += 100ms) {
    const double joint = plan->motion->at(time).position[0];
    ASSERT_GE(joint, -1e-9);
    ASSERT_LE(joint, degToRad(10.0) + 1e-9);
  }
  EXPECT_NE(pointLine(*plan, 1).find(",0,0,0,0,0,0,4999)"), std::string::npos) << "it turns round there";
}

TEST_F(TrajectoryPlans, keepVelocitiesThatAreGiven) {
  auto goal = good<Trajectory>();
  for (auto& point : goal.points) point.velocities.assign(6, 0);
  goal.points[1].velocities[0] = degToRad(7.0);
  EXPECT_EQ(pointLine(*planned(goal), 0), "PVTPoint(5,0,90,0,90,0,7,0,0,0,0,0,1)");
}

TEST_F(TrajectoryPlans, leaveOutPointsThatAreTooNear) {
  auto goal = good<Trajectory>();
  goal.points.clear();
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.01 * i;
    const double angle = 0.1 * time * time * (3 - 2 * time);
    goal.points.push_back({time, {angle, 0, kPi / 2, 0, kPi / 2, 0}, {}});
  }
  const auto plan = planned(goal);
  EXPECT_EQ(pointsOf(*plan), 33U) << "every 30 ms, the last one 40";
  EXPECT_EQ(plan->motion->duration(), 1s);
}

TEST_F(TrajectoryPlans, refuseToLeaveOutWhatIsOffTheWay) {
  const Failure failure = refused([](auto& g) {
    g.path_tolerance.fill(0.01);
    auto near = g.points[1];
    near.time += 0.01;
    near.positions[5] = 0.02;
    g.points.insert(g.points.begin() + 2, near);
  });
  EXPECT_EQ(failure.error_id, own_error::kTrajectoryInvalid);
  EXPECT_EQ(indexOf(failure), 2);
}

TEST_F(TrajectoryPlans, refuseAStartElsewhereByItsJoint) {
  const auto elsewhere = [](double angle) { return [=](auto& g) { g.points[0].positions[3] = angle; }; };
  const Failure failure = refused(elsewhere(0.1));
  EXPECT_EQ(failure.error_id, own_error::kNotAtStart);
  EXPECT_EQ(failure.detail.as<TrajectoryReport>().error_joint, 3);
  EXPECT_THAT(failure.found, HasSubstr("J4 is at 0.000 deg, and point 0, with time 0, at 5.730 deg"));
  planned(with<Trajectory>(elsewhere(0.01)));
  planned(with<Trajectory>([&](auto& g) {
    elsewhere(0.1)(g);
    g.path_tolerance.fill(0.2);
  }));
  const Failure unlimited = refused([&](auto& g) {
    elsewhere(0.1)(g);
    g.path_tolerance.fill(-1);
  });
  EXPECT_EQ(unlimited.error_id, own_error::kNotAtStart) << "any way is not any start";
}

TEST_F(TrajectoryPlans, nameThePointThatCannotBeReachedInTime) {
  const Failure failure = refused([](auto& g) { g.points[2].time = 1.03; });
  EXPECT_EQ(failure.error_id, own_error::kJointSpeed);
  EXPECT_EQ(indexOf(failure), 2);
  EXPECT_THAT(failure.found, HasSubstr("on the path to point 2"));
}

TEST_F(TrajectoryPlans, haveNothingToMoveAtTheStart) {
  EXPECT_EQ(planned(with<Trajectory>([](auto& g) { g.points.resize(1); }))->motion, nullptr);
}

TEST_F(TrajectoryPlans, haveNoMorePointsThanAPvt) {
  scene.path.block_points = 1;
  EXPECT_EQ(refused([](auto&) {}).error_id, own_error::kTrajectoryInvalid);
}

class TrajectoryFollows : public TrajectoryPlans {
 protected:
  [[nodiscard]] TrajectoryFollower following(double rate = 1.0) const {
    return {planned(good<Trajectory>()), rate, Instant()};
  }
  /// On its way at that time of the plan, and joint 6 off.
  [[nodiscard]] arm::JointVector at(Duration time, double off = 0) const {
    arm::JointVector joints = planned(good<Trajectory>())->motion->at(time).position;
    joints[5] += off;
    return joints;
  }
  static constexpr double kOff = 0.1;  // more than 5 degrees
};

TEST_F(TrajectoryFollows, judgeTheWayAndNotTheTime) {
  auto follower = following();
  EXPECT_FALSE(follower.offence(at(0s), Instant(0s)));
  EXPECT_FALSE(follower.offence(at(600ms), Instant(1s)));
  const auto offence = follower.offence(at(1s, kOff), Instant(1s));
  ASSERT_TRUE(offence);
  EXPECT_EQ(offence->joint, 5);
  EXPECT_NEAR(offence->gap, kOff, 1e-6);
}

TEST_F(TrajectoryFollows, findTightTolerancesBetweenItsSteps) {
  auto goal = good<Trajectory>();
  goal.path_tolerance.fill(1e-5);
  TrajectoryFollower follower(planned(goal), 1.0, Instant());
  for (Duration time = 0ms; time < 2s; time += 7ms) {
    EXPECT_FALSE(follower.offence(at(time - 23ms), Instant(time))) << time.count();
  }
}

TEST_F(TrajectoryFollows, anArmThatStaysBehindForLongIsOff) {
  EXPECT_TRUE(following().offence(at(0s), Instant(1900ms)));
}

/// A simulation that is faster than the time.
TEST_F(TrajectoryFollows, anArmThatIsAheadAsLongAsItIsOnItsWay) {
  auto follower = following();
  for (Duration time = 0ms; time < 2s; time += 75ms) {
    EXPECT_FALSE(follower.offence(at(time), Instant(time / 5))) << time.count();
  }
  EXPECT_TRUE(follower.offence(at(2s, kOff), Instant(400ms)));
}

TEST_F(TrajectoryFollows, theProjectSpeed) {
  auto follower = following(0.5);
  EXPECT_EQ(follower.time(Instant(1s)), 500ms);
  EXPECT_EQ(follower.remaining(Instant(1s)), 3s);
  EXPECT_FALSE(follower.offence(at(1900ms), Instant(3900ms)));
}

TEST_F(TrajectoryFollows, standStillWhileItIsHeld) {
  auto follower = following();
  follower.hold(Instant(1s));
  EXPECT_EQ(follower.time(Instant(20s)), 1s);
  EXPECT_FALSE(follower.offence(at(1s, kOff), Instant(20s)));
  follower.letGo(Instant(20s));
  EXPECT_FALSE(follower.offence(at(1s, kOff), Instant(20500ms))) << "it gets up to its speed";
  EXPECT_TRUE(follower.offence(at(1s, kOff), Instant(21s)));
}

}  // namespace
}  // namespace cobot_command::testing
