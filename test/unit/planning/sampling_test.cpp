#include "cobot_command/planning/sampling.h"

#include "planning_support.h"

namespace cobot_command::planning {
namespace {

using namespace std::chrono_literals;

class Sampling : public ::testing::Test {
 protected:
  ScriptPlanner planner{model(), workingPosture(), motion::Setting{}};
  PlannedStep step = append(planner, "Move_Line(\"CAP\",0,30,-40,0,0,0,100,200,0,false)");
};

TEST_F(Sampling, goesEvenlyFromTheStartToTheEnd) {
  const auto points = jointPath(*step.trajectory, 8);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_EQ(points.front().position, workingPosture());
  EXPECT_EQ(points.back().position, step.trajectory->end().position);
  EXPECT_EQ(points.back().time, step.duration);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(toSeconds(points[i].time), toSeconds(step.duration) * static_cast<double>(i) / 7.0, 1e-8);
    EXPECT_EQ(points[i].position, step.trajectory->at(points[i].time).position);
    EXPECT_EQ(points[i].velocity, step.trajectory->at(points[i].time).velocity);
  }
}

TEST_F(Sampling, endsWhereItIsTold) {
  EXPECT_EQ(jointPath(*step.trajectory, 5, 100ms).back().time, Duration(100ms));
  EXPECT_EQ(jointPath(*step.trajectory, 5, 1h).back().time, step.duration);
}

TEST_F(Sampling, givesOnePointOfAMotionThatTakesNoTime) {
  const PlannedStep stands = append(planner, "Move_PTP(\"JPP\",0,0,0,0,0,0,50,200,0,false)");
  EXPECT_EQ(jointPath(*stands.trajectory, 50).size(), 1U);
}

TEST_F(Sampling, givesAtLeastStartAndEnd) {
  EXPECT_EQ(jointPath(*step.trajectory, 0).size(), 2U);
}

TEST_F(Sampling, followsTheTool) {
  const arm::Pose tcp = arm::toPose({0, 0, 100, 0, 0, 0});
  const auto poses = toolPath(model(), *step.trajectory, tcp, 11);
  ASSERT_EQ(poses.size(), 11U);
  const auto flange = toolPath(model(), *step.trajectory, arm::Pose::Identity(), 11);
  const Eigen::Vector3d way = poses.back().translation() - poses.front().translation();
  EXPECT_LT((way - Eigen::Vector3d(0, 0.03, -0.04)).norm(), 1e-9);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_TRUE(poses[i].isApprox(flange[i] * tcp, 1e-12));
    EXPECT_LT((poses[i].translation() - poses[0].translation()).cross(way).norm(), 1e-10)
        << "a straight line";
  }
}

}  // namespace
}  // namespace cobot_command::planning
