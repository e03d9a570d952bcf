// What is remembered of the way that a path has driven.
#include "cobot_command/path/driven_path.h"

#include <memory>

#include "path_support.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// One degree of joint 1 [rad].
constexpr double kDegree = degToRad(1.0);

class DrivenPaths : public Paths {
 protected:
  /// Joint 1 to so many degrees; blended with what comes.
  [[nodiscard]] static PathPoint turn(double j1) { return toJoints({j1, 0, 90, 0, 90, 0}); }
  [[nodiscard]] static PathPoint blendedTurn(double j1) { return blending(turn(j1), 50); }
  /// 10, 20 (blended), 30 degrees.
  [[nodiscard]] std::shared_ptr<const PathPlan> plan(int goal = 1) const {
    PathPlanner planner(scene);
    PathSection section = sectionOf({turn(10), blendedTurn(20), turn(30)});
    section.goal = goal;
    EXPECT_FALSE(planner.append(section));
    return std::make_shared<const PathPlan>(planner.plan());
  }
  /// The first point alone, and the others.
  void sendInPieces(DrivenPath& driven, const PathPlan& whole, std::size_t first = 0) const {
    driven.send(std::make_shared<const PathPlan>(whole.part(0, 1)), first);
    driven.send(std::make_shared<const PathPlan>(whole.part(1, 3)), first + 1);
  }
  [[nodiscard]] static double joint1(const DrivenPath& driven, Duration time) {
    return radToDeg(driven.at(time).position[0]);
  }
};

TEST_F(DrivenPaths, areEmptyUntilTheRobotHasMoved) {
  DrivenPath driven;
  EXPECT_TRUE(driven.isEmpty());
  sendInPieces(driven, *plan());
  EXPECT_TRUE(driven.isEmpty());
  EXPECT_FALSE(driven.passed(1, 0));
  EXPECT_FALSE(driven.passedOf(1));
  driven.come(0, milliseconds(20));
  EXPECT_FALSE(driven.isEmpty());
  EXPECT_EQ(driven.lastGoal(), 1);
}

TEST_F(DrivenPaths, areTheWayOfTheirPieces) {
  const auto whole = plan();
  DrivenPath driven;
  sendInPieces(driven, *whole);
  EXPECT_EQ(driven.end(), whole->duration());
  for (Duration time{}; time < whole->duration(); time += milliseconds(7)) {
    EXPECT_EQ(driven.at(time).position, whole->at(time).position);
    EXPECT_EQ(driven.at(time).velocity, whole->at(time).velocity);
  }
}

TEST_F(DrivenPaths, tellWhenEachPointWasPassed) {
  const auto whole = plan();
  DrivenPath driven;
  sendInPieces(driven, *whole);
  driven.come(1, seconds(60));
  EXPECT_EQ(driven.passed(1, 0), whole->points()[0].end());
  EXPECT_EQ(driven.passed(1, 1), whole->points()[1].end() - whole->points()[1].overlap / 2);
  EXPECT_NEAR(joint1(driven, *driven.passed(1, 0)), 10, 1e-6);
  EXPECT_NEAR(joint1(driven, *driven.passed(1, 1)), 20, 0.5);
  EXPECT_FALSE(driven.passed(1, 3));
  EXPECT_FALSE(driven.passed(2, 0));
  driven.come(3, {});
  EXPECT_EQ(driven.reached(), whole->duration()) << "behind the last point is the end";
  EXPECT_EQ(driven.passed(1, 2), whole->duration());
  EXPECT_EQ(driven.passedOf(1)->first, 0);
  EXPECT_EQ(driven.passedOf(1)->last, 2);
}

TEST_F(DrivenPaths, knowTheRobotByItsJoints) {
  const auto whole = plan();
  DrivenPath driven;
  sendInPieces(driven, *whole);
  driven.come(0, milliseconds(100));
  const Duration there = milliseconds(700);
  arm::JointVector joints = whole->at(there).position;
  joints[3] += 0.05 * kDegree;
  EXPECT_TRUE(driven.stand(joints)) << "in the next piece, which nobody has seen it begin";
  EXPECT_NEAR(toSeconds(driven.reached()), toSeconds(there), 1e-3);
  EXPECT_EQ(*driven.stood(), joints);
  joints[3] += 0.1 * kDegree;
  EXPECT_FALSE(driven.stand(joints));
  EXPECT_FALSE(driven.stood()) << "where it was is not certain";
  EXPECT_NEAR(toSeconds(driven.reached()), toSeconds(there), 1e-3);
}

TEST_F(DrivenPaths, havePassedAPointThatTheRobotStandsOn) {
  const auto whole = plan();
  const Duration end = whole->points()[0].end();
  const Duration nearly = end - milliseconds(15);
  ASSERT_LT((whole->at(nearly).position - whole->at(end).position).cwiseAbs().maxCoeff(),
            DrivenPath::kSamePlace);
  for (const bool is_cut : {false, true}) {
    DrivenPath driven;
    sendInPieces(driven, *whole);
    driven.come(0, nearly);
    EXPECT_FALSE(driven.passed(1, 0)) << "it may be on its way there";
    if (is_cut) driven.cut(whole->at(nearly).position);
    EXPECT_TRUE(driven.stand(whole->at(nearly).position));
    EXPECT_EQ(driven.passed(1, 0), driven.reached());
    EXPECT_EQ(driven.passedOf(1)->last, 0);
  }
}

TEST_F(DrivenPaths, haveNotPassedAPointInFrontOfWhichTheyWereCut) {
  const auto whole = plan();
  const Duration before = whole->points()[0].end() - milliseconds(150);
  DrivenPath driven;
  sendInPieces(driven, *whole);
  driven.come(0, before);
  driven.cut(whole->at(before).position);
  EXPECT_FALSE(driven.passed(1, 0));
}

TEST_F(DrivenPaths, goBackOnlyWithTheRobot) {
  DrivenPath driven;
  sendInPieces(driven, *plan());
  driven.come(1, {});
  const Duration reached = driven.reached();
  driven.come(0, milliseconds(10));
  EXPECT_EQ(driven.reached(), reached);
  EXPECT_TRUE(driven.stand(driven.at(milliseconds(200)).position)) << "it was slower than its clock";
  EXPECT_NEAR(toSeconds(driven.reached()), 0.2, 1e-3);
  EXPECT_FALSE(driven.passed(1, 0));
}

TEST_F(DrivenPaths, haveNotMovedARobotThatStandsNextToTheirStart) {
  DrivenPath driven;
  sendInPieces(driven, *plan());
  arm::JointVector joints = scene.start;
  joints[0] += 0.09 * kDegree;
  EXPECT_TRUE(driven.stand(joints));
  EXPECT_TRUE(driven.isEmpty());
}

TEST_F(DrivenPaths, goOnWithWhatIsPlannedFromWhereTheRobotWasStopped) {
  const auto whole = plan();
  DrivenPath driven;
  driven.send(whole, 0);
  const Duration there = milliseconds(600);
  driven.cut(whole->at(there).position);
  const Duration cut = driven.end();
  EXPECT_NEAR(toSeconds(cut), toSeconds(there), 1e-3);
  // What is left: points 1 and 2, from there.
  scene.start = whole->at(there).position;
  PathPlanner rest(scene);
  PathSection section = sectionOf({turn(10), blendedTurn(20), turn(30)});
  section.goal = 1;
  section.start_index = 1;
  section.number_of_moves = 2;
  ASSERT_FALSE(rest.append(section));
  driven.send(std::make_shared<const PathPlan>(rest.plan()), 1);
  driven.come(3, {});
  EXPECT_EQ(driven.reached(), cut + Duration(1) + rest.plan().duration());
  ASSERT_EQ(driven.cuts().size(), 1U);
  EXPECT_EQ(driven.cuts()[0].end, cut);
  EXPECT_EQ(driven.cuts()[0].joints, scene.start);
  EXPECT_GT(driven.at(cut).velocity.norm(), 0.1) << "as it was planned";
  EXPECT_EQ(driven.at(cut + Duration(1)).velocity.norm(), 0) << "as it went on";
  EXPECT_NEAR(joint1(driven, *driven.passed(1, 0)), 10, 1e-6);
  EXPECT_GT(*driven.passed(1, 1), cut);
  EXPECT_NEAR(joint1(driven, *driven.passed(1, 1)), 20, 2) << "the middle of the corner, by its time";
  EXPECT_NEAR(joint1(driven, driven.reached()), 30, 1e-6);
}

TEST_F(DrivenPaths, tellTheirGoalsApart) {
  const auto first = plan(1);
  scene.start = endOf(*first);
  PathPlanner planner(scene);
  PathSection section = sectionOf({turn(40), turn(50)});
  section.goal = 2;
  ASSERT_FALSE(planner.append(section));
  DrivenPath driven;
  driven.send(first, 0);
  driven.send(std::make_shared<const PathPlan>(planner.plan()), 3);
  driven.come(3, milliseconds(30));
  EXPECT_EQ(driven.lastGoal(), 2);
  EXPECT_EQ(driven.beginOf(1), Duration::zero());
  EXPECT_EQ(driven.beginOf(2), first->duration());
  EXPECT_FALSE(driven.passed(2, 0));
  driven.come(4, milliseconds(30));
  EXPECT_EQ(driven.beginOf(2), first->duration());
  EXPECT_NEAR(joint1(driven, *driven.passed(2, 0)), 40, 1e-6);
  EXPECT_FALSE(driven.beginOf(3));
}

TEST_F(DrivenPaths, rememberAThousandPointsAtLeast) {
  const auto whole = plan();
  DrivenPath driven;
  std::size_t sent = 0;
  for (int goal = 1; goal <= 400; ++goal, sent += 3) {
    driven.send(plan(goal), sent);
    driven.come(sent + 3, {});
  }
  EXPECT_FALSE(driven.passed(1, 0));
  EXPECT_FALSE(driven.beginOf(1));
  EXPECT_TRUE(driven.passed(400, 2));
  EXPECT_TRUE(driven.passed(70, 0));
  EXPECT_EQ(driven.beginOf(70), *driven.passed(70, 0) - whole->points()[0].motion->duration());
  EXPECT_EQ(driven.reached(), 400 * whole->duration());
}

TEST_F(DrivenPaths, forgetWhatTheRobotHasLeft) {
  DrivenPath driven;
  driven.send(plan(), 0);
  driven.come(2, {});
  EXPECT_FALSE(driven.isCutShort());
  driven.cut(degrees(0, 30, 90, 0, 90, 0));
  EXPECT_TRUE(driven.isEmpty());
  EXPECT_TRUE(driven.isCutShort());
  driven.send(plan(), 0);
  driven.come(1, {});
  EXPECT_FALSE(driven.beginOf(1)) << "what was in front of it is not known";
  EXPECT_TRUE(driven.passed(1, 0));
}

}  // namespace
}  // namespace cobot_command::path
