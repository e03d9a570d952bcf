// Steps that name a station where their block needs a pose.
#include <algorithm>

#include "cell_texts.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;

/// To PLACE straight and along an arc, the second path with a base and a TCP of its own.
const char* const kLines = R"(cell: lines
robots:
  RA: {model: tm5-900, base: [0, 0, 0, 0, 0, 0], home: HOME, tcp: [0, 0, 120, 0, 0, 0]}
stations:
  RA: {HOME: [0, -30, 120, 0, 90, 0], PLACE: [0, 0, 110, -20, 90, 0], AGAIN: [0, 0, 110, -20, 90, 0]}
programs:
  RA:
    - path: OUT
      from: HOME
      to: PLACE
      steps: [{movement_command: LINE, data_format: CPP, target_position: PLACE, speed: 20, accel_time: 300}]
    - path: ON
      from: PLACE
      to: AGAIN
      steps:
        - {block: change_base, base: [100, 200, 300, 0, 0, 90]}
        - {block: change_tcp, tcp: [10, 0, 80, 0, 45, 0]}
        - {block: move_circle, data_format: CAP, arc_point: [300, -200, 0, 180, 0, 0], end_point: HOME, speed: 50, accel_time: 300}
        - {movement_command: LINE, data_format: CAR, target_position: AGAIN, speed: 50, accel_time: 300}
        - {block: change_base, base: [0, 0, 0, 0, 0, 0]}
        - {block: change_tcp, tcp: [0, 0, 120, 0, 0, 0]}
    - path: BACK
      from: AGAIN
      to: HOME
      steps: [{movement_command: PTP, data_format: JPP, target_position: HOME, speed: 30, accel_time: 300}]
)";

arm::Pose poseWith(const Station& station, const blocks::SixValues& base, const blocks::SixValues& tcp) {
  const auto arm = arm::ArmModel::named("tm5-900").value();
  return arm::toPose(base).inverse() * arm::forwardKinematics(arm, station.joints) * arm::toPose(tcp);
}

TEST(AStationInPlaceOfAPose, isWhereTheTcpIsWithItsJoints) {
  const Cell cell = cellOf(kLines);
  const Robot& robot = cell.robots.front();
  const auto& move = std::get<blocks::MoveAbsoluteGoal>(robot.program[0].steps[0].goal);
  const Station& place = *find(robot.stations, "PLACE");
  EXPECT_TRUE(arm::toPose(move.target).isApprox(poseWith(place, {}, robot.tcp), 1e-7));
}

TEST(AStationInPlaceOfAPose, isSeenFromTheBaseAndWithTheTcpOfItsStep) {
  const Cell cell = cellOf(kLines);
  const Robot& robot = cell.robots.front();
  const blocks::SixValues base{100, 200, 300, 0, 0, 90};
  const blocks::SixValues tcp{10, 0, 80, 0, 45, 0};
  const auto& circle = std::get<blocks::MoveCircleGoal>(robot.program[1].steps[2].goal);
  const Station& home = *find(robot.stations, "HOME");
  EXPECT_TRUE(arm::toPose(circle.end_point).isApprox(poseWith(home, base, tcp), 1e-7));
  const auto& move = std::get<blocks::MoveAbsoluteGoal>(robot.program[1].steps[3].goal);
  const Station& again = *find(robot.stations, "AGAIN");
  EXPECT_TRUE(arm::toPose(move.target).isApprox(poseWith(again, base, tcp), 1e-7));
}

TEST(AStationInPlaceOfAPose, isWrittenAsScriptsHaveIt) {
  const Cell cell = cellOf(kLines);
  const auto& move = std::get<blocks::MoveAbsoluteGoal>(cell.robots.front().program[0].steps[0].goal);
  EXPECT_EQ(move.target, arm::asWritten(move.target)) << "else other machines have other hashes";
  EXPECT_EQ(std::count(move.target.begin(), move.target.end(), -180), 0);
}

TEST(AStationInPlaceOfAPose, isNoEndOfAnArcWhoseAngleIsGiven) {
  const std::string arc =
      "steps: [{block: move_circle, data_format: CAP, arc_point: [300, -200, 0, 180, 0, 0], end_point: HOME, "
      "arc_angle: 90, speed: 50, accel_time: 300}]";
  const std::string line =
      "steps: [{movement_command: LINE, data_format: CPP, target_position: PLACE, speed: 20, accel_time: "
      "300}]";
  EXPECT_EQ(faultsOf(with(kLines, line, arc)), "none") << "where it ends the plan will tell";
}

TEST(AStationInPlaceOfAPose, isTheSameCellAsItsNumbers) {
  const Cell cell = cellOf(kLines);
  const auto& move = std::get<blocks::MoveAbsoluteGoal>(cell.robots.front().program[0].steps[0].goal);
  const auto& p = move.target;
  const std::string numbers =
      fmt::format("target_position: [{}, {}, {}, {}, {}, {}]", p[0], p[1], p[2], p[3], p[4], p[5]);
  EXPECT_EQ(hashOf(cellOf(with(kLines, "target_position: PLACE", numbers))), hashOf(cell));
  EXPECT_NE(hashOf(cellOf(with(kLines, "0, 0, 110, -20, 90, 0]", "0, 0, 110, -20, 90, 1]"))), hashOf(cell));
}

TEST(AStationInPlaceOfAPose, isRefusedWhereThereIsNoneOrThePathEndsElsewhere) {
  EXPECT_THAT(faultsOf(with(kLines, "target_position: PLACE", "target_position: PLACES")),
              HasSubstr("target_position is \"PLACES\""));
  EXPECT_THAT(faultsOf(with(kLines, "end_point: HOME", "end_point: HOMER")),
              HasSubstr("end_point is \"HOMER\""));
  EXPECT_THAT(
      faultsOf(with(kLines, "target_position: PLACE", "target_position: HOME")),
      HasSubstr("programs.RA[0].steps[0].target_position is 30 deg of J2 away from station PLACE, where "
                "the path ends"));
}

}  // namespace
}  // namespace cobot_command::cell
