// A path as PVTs: segments of whole milliseconds, which miss the plan by less than anybody could measure.
#include "cobot_command/path/pvt_block.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "path_support.h"
#include "way_distance.h"
#include <gmock/gmock.h>

#include "cobot_command/motion/planner.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Duration kSegment = milliseconds(25);

class PvtBlocks : public Paths {
 protected:
  [[nodiscard]] static PvtBlock wholeOf(const PathPlan& plan) {
    return sampleBlock(plan, 0, plan.points().size() - 1, kSegment);
  }
  /// As the controller makes it: cubics between its points.
  [[nodiscard]] motion::TrajectoryPtr made(const PvtBlock& block) const {
    auto trajectory = motion::plan(scene.arm, scene.start, motion::Pvt{block.points}, {});
    EXPECT_TRUE(trajectory) << trajectory.error().message;
    return trajectory ? *trajectory : nullptr;
  }
  [[nodiscard]] PathPoint fastLine(double y, ProfileType profile) const {
    PathPoint point = incremental(toPose({0, y, 0, 0, 0, 0}));
    point.speed = 500;
    point.acceleration = point.deceleration = 2000;
    point.profile_type = number(profile);
    point.acceleration_jerk = point.deceleration_jerk = 100;
    return point;
  }
  [[nodiscard]] Eigen::Vector3d place(const arm::JointVector& joints) const {
    return arm::forwardKinematics(scene.arm, joints).translation();
  }
  /// How far that place is from the way that the plan has about that time.
  [[nodiscard]] double offTheWay(const PathPlan& plan, Duration time, const Eigen::Vector3d& there) const {
    std::vector<Eigen::Vector3d> way;
    for (Duration at = time - milliseconds(6); at <= time + milliseconds(6); at += milliseconds(1)) {
      way.push_back(place(plan.at(at).position));
    }
    return testing::mostOff({there}, way);
  }
};

TEST_F(PvtBlocks, missThePlanByLessThanTwoMicrometresAndTheWayByAFifthOfOne) {
  for (const ProfileType profile :
       {ProfileType::SCurve, ProfileType::Poly5, ProfileType::ModSine, ProfileType::SineSquared}) {
    const PathPlan plan = planned({fastLine(300, profile)});
    const motion::TrajectoryPtr pvt = made(wholeOf(plan));
    ASSERT_NEAR(toSeconds(pvt->duration()), toSeconds(plan.duration()), 1e-8);
    for (Duration time{}; time <= plan.duration(); time += milliseconds(1)) {
      const Eigen::Vector3d there = place(pvt->at(time).position);
      ASSERT_LT(mToMm((there - place(plan.at(time).position)).norm()), 2e-3) << toSeconds(time);
      ASSERT_LT(mToMm(offTheWay(plan, time, there)), 2e-4) << toSeconds(time);
    }
  }
}

TEST_F(PvtBlocks, leaveTheWayByLessThanATenthOfAMillimetreWhereRampsAndOverlapsEndCloseTogether) {
  std::mt19937 engine(20270311);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  double most = 0.0;
  double most_off = 0.0;
  for (int run = 0; run < 150; ++run) {
    std::vector<PathPoint> points;
    for (int i = 0; i < 6; ++i) {
      PathPoint point = incremental(toPose({uniform(-30, 30), uniform(-30, 30), uniform(-30, 30), 0, 0, 0}));
      point.speed = uniform(50, 500);
      point.acceleration = uniform(1000, 2000);
      point.deceleration = uniform(1000, 2000);
      points.push_back(blending(point, uniform(0.5, 30)));
    }
    PathPlanner planner(scene);
    if (planner.append(sectionOf(points))) continue;
    const PathPlan& plan = planner.plan();
    for (std::size_t first = 0; first < points.size(); first = endOfBlock(plan, first) + 1) {
      const std::size_t last = endOfBlock(plan, first);
      const auto pvt = motion::plan(scene.arm, plan.at(plan.points()[first].start).position,
                                    motion::Pvt{sampleBlock(plan, first, last).points}, {});
      ASSERT_TRUE(pvt) << pvt.error().message;
      const Duration begin = plan.points()[first].start;
      for (Duration time{}; time <= (*pvt)->duration(); time += milliseconds(1)) {
        const Eigen::Vector3d there = place((*pvt)->at(time).position);
        const double miss = (there - place(plan.at(begin + time).position)).norm();
        most = std::max(most, miss);
        if (miss > most_off) most_off = std::max(most_off, offTheWay(plan, begin + time, there));
      }
    }
  }
  EXPECT_LT(mToMm(most_off), 0.06);
  EXPECT_GT(mToMm(most_off), 0.001) << "no such place was found";
  EXPECT_LT(mToMm(most), 0.07) << "with what it is ahead of its time";
}

TEST_F(PvtBlocks, haveSegmentsOfWholeMillisecondsNoneShorterThanAsked) {
  std::vector<PathPoint> points;
  points.reserve(10);
  for (int i = 0; i < 10; ++i) points.push_back(blending(fastLine(i % 2 ? 11 : 13, ProfileType::Poly5), 2));
  const PvtBlock block = wholeOf(planned(points));
  for (const motion::PvtJointPoint& point : block.points) {
    EXPECT_GE(point.duration, 0.025 - 1e-12);
    EXPECT_NEAR(point.duration * 1e3, std::round(point.duration * 1e3), 1e-9);
  }
}

TEST_F(PvtBlocks, endAtRestExactlyWhereThePlanDoes) {
  const PathPlan plan =
      planned({blending(fastLine(40, ProfileType::SCurve), 5), fastLine(30, ProfileType::SCurve)});
  const PvtBlock block = wholeOf(plan);
  EXPECT_EQ(block.points.back().velocity, arm::JointVector::Zero());
  EXPECT_LT((block.points.back().position - endOf(plan)).cwiseAbs().maxCoeff(), degToRad(5.1e-6));
}

TEST_F(PvtBlocks, goFromRestToRest) {
  const PathPoint stop = fastLine(10, ProfileType::SCurve);
  const PathPlan plan = planned({blending(stop, 2), stop, blending(stop, 2), blending(stop, 2), stop});
  EXPECT_EQ(endOfBlock(plan, 0), 1U);
  EXPECT_EQ(endOfBlock(plan, 2), 4U);
  const PvtBlock second = sampleBlock(plan, 2, 4, kSegment);
  EXPECT_EQ(second.start, plan.points()[2].start);
  EXPECT_EQ(second.ends.at(4), second.points.size());
}

TEST_F(PvtBlocks, withoutAWayHaveNoPointsAndOnlyTheirTags) {
  const PvtBlock block = wholeOf(planned({toJoints({0, 0, 90, 0, 90, 0})}));
  EXPECT_TRUE(block.points.empty());
  EXPECT_EQ(script::toText(scriptOf(block, {{0, 4}})), "QueueTag(4,0)");
}

TEST_F(PvtBlocks, atTheRatedSpeedAreTakenByWhoMakesThem) {
  for (int i = 4; i < 120; ++i) {
    const double way = 0.5 * i;
    PathPoint point = toJoints({way, 0, 90, 0, 90, 0});
    point.speed = 180;
    point.acceleration = point.deceleration = 2000;
    EXPECT_TRUE(made(wholeOf(planned({point})))) << way;
  }
}

TEST_F(PvtBlocks, toAJointLimitAreTakenByWhoMakesThem) {
  PathPoint point = toJoints({270, 0, 90, 0, 90, 0});
  point.profile_type = number(ProfileType::SineSquared);
  point.acceleration_jerk = point.deceleration_jerk = 20;
  EXPECT_TRUE(made(wholeOf(planned({point}))));
}

TEST_F(PvtBlocks, haveATagForEachPointOrForEverySoMany) {
  EXPECT_THAT(taggedPoints(3, 6, 7), ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(taggedPoints(0, 19, 7), ElementsAre(2, 5, 8, 11, 14, 17, 19));
  EXPECT_THAT(taggedPoints(0, 999, 7), ElementsAre(142, 285, 428, 571, 714, 857, 999));
}

TEST_F(PvtBlocks, areMarkedWhereGoalsEndAndEvenlyBetween) {
  const auto marks = [this](const std::vector<int>& points_of_goals) {
    PathPlanner planner(scene);
    int goal = 0;
    for (const int count : points_of_goals) {
      PathSection section = sectionOf({});
      section.goal = ++goal;
      section.points.assign(static_cast<std::size_t>(count), toJoints({0, 0, 90, 0, 90, 0}));
      section.number_of_moves = count;
      EXPECT_FALSE(planner.append(section));
    }
    return markedPoints(planner.plan(), 6);
  };
  EXPECT_THAT(marks({1}), IsEmpty());
  EXPECT_THAT(marks({4}), ElementsAre(0, 1, 2));
  EXPECT_THAT(marks({20}), ElementsAre(2, 5, 8, 11, 14, 17));
  EXPECT_THAT(marks({40, 30}), ElementsAre(9, 19, 29, 39, 49, 59));
  EXPECT_THAT(marks({1, 1, 1, 60}), ElementsAre(0, 1, 2, 17, 32, 47)) << "not one by one behind the ends";
  EXPECT_THAT(marks({2, 2, 2, 2, 2, 2, 2, 2}), ElementsAre(1, 3, 5, 7, 9, 11)) << "of more ends the first";
}

TEST_F(PvtBlocks, tellTheirTagsBehindTheSegmentInWhichAPointEnds) {
  const PathPlan plan =
      planned({blending(fastLine(40, ProfileType::SCurve), 5), fastLine(30, ProfileType::SCurve)});
  const PvtBlock block = wholeOf(plan);
  const auto lines = scriptOf(block, {{0, 4}, {1, 5}});
  EXPECT_EQ(lines.size(), block.points.size() + 4);
  EXPECT_EQ(script::toText(lines.front()), "PVTEnter(0)");
  EXPECT_EQ(script::toText(lines.back()), "PVTExit()");
  EXPECT_EQ(script::toText(lines[block.ends.at(0) + 1]), "QueueTag(4,0)");
  EXPECT_EQ(script::toText(lines[lines.size() - 2]), "QueueTag(5,0)");
}

TEST_F(PvtBlocks, sayJointsAndSpeedsToFiveDecimalsAndTimesToThree) {
  const auto lines = scriptOf(wholeOf(planned({fastLine(40, ProfileType::SCurve)})), {});
  const std::string line = script::toText(lines[2]);
  std::size_t longest = 0;
  for (std::size_t at = line.find('.'); at != std::string::npos; at = line.find('.', at + 1)) {
    longest = std::max(longest, line.find_first_of(",)", at) - at - 1);
  }
  EXPECT_LE(longest, 5U) << line;
  EXPECT_THAT(line, ::testing::MatchesRegex(".*,0\\.0[0-9][0-9]\\)"));
}

TEST_F(PvtBlocks, areTheSameLinesForOneGoalAndForSeveral) {
  std::vector<PathPoint> points;
  points.reserve(10);
  for (int i = 0; i < 10; ++i) points.push_back(blending(fastLine(10, ProfileType::ModSine), 2));
  const PathPlan whole = planned(points);
  PathPlanner planner(scene);
  for (const PathPoint& point : points) ASSERT_FALSE(planner.append(sectionOf({point})));
  EXPECT_EQ(script::toText(scriptOf(wholeOf(whole), {})),
            script::toText(scriptOf(wholeOf(planner.plan()), {})));
}

}  // namespace
}  // namespace cobot_command::path
