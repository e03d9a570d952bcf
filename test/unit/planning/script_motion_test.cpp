#include "cobot_command/planning/script_motion.h"

#include "planning_support.h"

#include "cobot_command/common/units.h"

namespace cobot_command::planning {
namespace {

using namespace std::chrono_literals;

template <class Motion, class Command>
Motion made(const Command& command) {
  const auto motion = toMotion(command);
  if (!motion || !std::holds_alternative<Motion>(*motion)) {
    ADD_FAILURE() << "another kind of motion";
    return {};
  }
  return std::get<Motion>(*motion);
}

template <class Motion, class Command>
Motion made(const std::string& text) {
  return made<Motion>(std::get<Command>(line(text)));
}

TEST(ScriptMotion, readsPercentDegreesAndMillisecondsOfAPtp) {
  const auto ptp = made<motion::Ptp, script::Ptp>("PTP(\"JPP\",10,20,30,40,50,60,35,250,0,false)");
  EXPECT_EQ(std::get<arm::JointVector>(ptp.target), arm::toJointVector({10, 20, 30, 40, 50, 60}));
  EXPECT_DOUBLE_EQ(ptp.speed_ratio, 0.35);
  EXPECT_EQ(ptp.time_to_top_speed, 250ms);
}

TEST(ScriptMotion, readsPoseAndBitsOfAPtp) {
  const auto without = made<motion::Ptp, script::Ptp>("PTP(\"CPP\",400,-100,300,180,0,90,35,250,0,false)");
  const auto& target = std::get<motion::PoseTarget>(without.target);
  EXPECT_TRUE(target.pose.isApprox(arm::toPose({400, -100, 300, 180, 0, 90})));
  EXPECT_FALSE(target.bits);
  const auto with = made<motion::Ptp, script::Ptp>("PTP(\"CPP\",400,-100,300,180,0,90,35,250,0,false,1,2,5)");
  EXPECT_EQ(std::get<motion::PoseTarget>(with.target).bits, arm::PoseBits::fromNumbers(1, 2, 5));
}

TEST(ScriptMotion, refusesUnknownPoseBits) {
  const auto refused =
      toMotion(std::get<script::Ptp>(line("PTP(\"CPP\",400,0,300,180,0,90,35,250,0,false,2,2,4)")));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().reason, motion::Refusal::Reason::PoseBits);
  EXPECT_NE(refused.error().message.find("2, 2, 4"), std::string::npos) << refused.error().message;
  EXPECT_TRUE(refused.error().point.isApprox(arm::toPose({400, 0, 300, 180, 0, 90})));
}

TEST(ScriptMotion, readsTheSpeedOfALineAsItsFormatSays) {
  const auto percent = made<motion::Line, script::Line>("Line(\"CPR\",400,0,300,180,0,90,35,250,5,false)");
  EXPECT_DOUBLE_EQ(std::get<motion::SpeedRatio>(percent.speed).value, 0.35);
  const auto absolute = made<motion::Line, script::Line>("Line(\"CAP\",400,0,300,180,0,90,35,250,5,false)");
  EXPECT_DOUBLE_EQ(std::get<motion::TcpSpeed>(absolute.speed).metres_per_second, 0.035);
  EXPECT_TRUE(absolute.target.isApprox(arm::toPose({400, 0, 300, 180, 0, 90})));
}

TEST(ScriptMotion, readsAnAngleOfZeroAsACircleToItsEnd) {
  const auto to_end = made<motion::Circle, script::Circle>(
      "Circle(\"CAP\",450,50,300,180,0,90,400,100,300,180,0,90,100,200,0,0,false)");
  EXPECT_FALSE(to_end.arc_angle);
  EXPECT_TRUE(to_end.via.isApprox(arm::toPose({450, 50, 300, 180, 0, 90})));
  EXPECT_TRUE(to_end.end.isApprox(arm::toPose({400, 100, 300, 180, 0, 90})));
  const auto by_angle = made<motion::Circle, script::Circle>(
      "Circle(\"CAP\",450,50,300,180,0,90,400,100,300,180,0,90,100,200,0,-270,false)");
  EXPECT_DOUBLE_EQ(by_angle.arc_angle.value_or(0), degToRad(-270));
}

TEST(ScriptMotion, readsOffsetsOfJointsBaseAndTool) {
  const auto joints = made<motion::MovePtp, script::MovePtp>("Move_PTP(\"JPP\",1,2,3,4,5,6,35,250,0,false)");
  EXPECT_EQ(std::get<arm::JointVector>(joints.offset), arm::toJointVector({1, 2, 3, 4, 5, 6}));
  const arm::Pose by = arm::toPose({1, 2, 3, 4, 5, 6});
  using Axes = motion::PoseOffset::Axes;
  for (const auto& [format, axes] : {std::pair("CPP", Axes::Base), std::pair("TPP", Axes::Tool)}) {
    const std::string rest = std::string("(\"") + format + "\",1,2,3,4,5,6,35,250,0,false)";
    const auto ptp =
        std::get<motion::PoseOffset>(made<motion::MovePtp, script::MovePtp>("Move_PTP" + rest).offset);
    const auto straight = made<motion::MoveLine, script::MoveLine>("Move_Line" + rest).offset;
    EXPECT_TRUE(ptp.by.isApprox(by) && straight.by.isApprox(by));
    EXPECT_EQ(ptp.axes, axes);
    EXPECT_EQ(straight.axes, axes);
  }
}

TEST(ScriptMotion, readsPLinesToJointsPosesAndByOffsets) {
  const auto joints = made<motion::PLine, script::PLine>("PLine(\"JAP\",1,2,3,4,5,6,35,250,50)");
  EXPECT_EQ(std::get<arm::JointVector>(joints.target), arm::toJointVector({1, 2, 3, 4, 5, 6}));
  EXPECT_DOUBLE_EQ(std::get<motion::TcpSpeed>(joints.speed).metres_per_second, 0.035);
  EXPECT_EQ(joints.time_to_top_speed, 250ms);
  const auto pose = made<motion::PLine, script::PLine>("PLine(\"CAP\",400,0,300,180,0,90,35,250,50)");
  EXPECT_TRUE(std::get<arm::Pose>(pose.target).isApprox(arm::toPose({400, 0, 300, 180, 0, 90})));
  const auto tool = made<motion::MovePLine, script::MovePLine>("Move_PLine(\"TAP\",1,2,3,4,5,6,35,250,50)");
  EXPECT_EQ(std::get<motion::PoseOffset>(tool.offset).axes, motion::PoseOffset::Axes::Tool);
  const auto by = made<motion::MovePLine, script::MovePLine>("Move_PLine(\"JAP\",1,2,3,4,5,6,35,250,50)");
  EXPECT_EQ(std::get<arm::JointVector>(by.offset), arm::toJointVector({1, 2, 3, 4, 5, 6}));
}

TEST(ScriptMotion, readsDegreesMillimetresAndSecondsOfAPvt) {
  const script::PvtPoint point{{400, -100, 300, 180, 0, 90}, {10, 20, 30, 40, 50, 60}, 0.5};
  const auto joints = made<motion::Pvt>(PvtBlock{false, {point}});
  const auto& of_joints = std::get<std::vector<motion::PvtJointPoint>>(joints.points).front();
  EXPECT_EQ(of_joints.position, arm::toJointVector(point.position));
  EXPECT_EQ(of_joints.velocity, arm::toJointVector(point.velocity));
  EXPECT_DOUBLE_EQ(of_joints.duration, 0.5);
  const auto poses = made<motion::Pvt>(PvtBlock{true, {point}});
  const auto& of_poses = std::get<std::vector<motion::PvtPosePoint>>(poses.points).front();
  EXPECT_TRUE(of_poses.pose.isApprox(arm::toPose(point.position)));
  EXPECT_TRUE(of_poses.velocity.linear.isApprox(Eigen::Vector3d(0.01, 0.02, 0.03)));
  EXPECT_TRUE(of_poses.velocity.angular.isApprox(Eigen::Vector3d(degToRad(40), degToRad(50), degToRad(60))));
  EXPECT_FALSE(blendOf(PvtBlock{true, {point}}));
}

}  // namespace
}  // namespace cobot_command::planning
