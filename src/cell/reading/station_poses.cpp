#include "reading/station_poses.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

arm::ControllerPose poseOf(const arm::ArmModel& arm, const Station& station, const ActiveFrames& frames) {
  const arm::Pose tcp = arm::forwardKinematics(arm, station.joints) * arm::toPose(frames.tcp);
  arm::ControllerPose pose = arm::asWritten(arm::toControllerPose(arm::toPose(frames.base).inverse() * tcp));
  for (std::size_t turn = 3; turn < pose.size(); ++turn) {
    if (pose[turn] == -180) pose[turn] = 180;  // rounded to it
  }
  return pose;
}

}  // namespace

void takeStationPoses(Robot& robot, const std::map<std::string, ActiveFrames>& at_stations) {
  const arm::ArmModel arm = arm::ArmModel::named(robot.model).value();
  for (Path& path : robot.program) {
    ActiveFrames frames = at_stations.at(path.from);
    for (Step& step : path.steps) {
      takeFrames(step, frames);
      if (step.at.empty()) continue;
      const arm::ControllerPose pose = poseOf(arm, *find(robot.stations, step.at), frames);
      if (auto* move = std::get_if<blocks::MoveAbsoluteGoal>(&step.goal)) move->target = pose;
      if (auto* circle = std::get_if<blocks::MoveCircleGoal>(&step.goal)) circle->end_point = pose;
    }
  }
}

}  // namespace cobot_command::cell
