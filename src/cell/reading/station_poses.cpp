#include "reading/station_poses.h"

#include <map>

#include "checks/step_checks.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

ActiveFrames behind(const Path& path, ActiveFrames frames) {
  for (const Step& step : path.steps) takeFrames(step, frames);
  return frames;
}

/// Whichever way a robot comes to a station, they are the same.
std::map<std::string, ActiveFrames> framesAtStations(const Robot& robot) {
  std::map<std::string, ActiveFrames> frames{{robot.home, {{}, robot.tcp}}};
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const Path& path : robot.program) {
      const auto from = frames.find(path.from);
      if (from == frames.end() || frames.count(path.to) != 0) continue;
      frames.emplace(path.to, behind(path, from->second));
      is_new = true;
    }
  }
  return frames;
}

arm::ControllerPose poseOf(const arm::ArmModel& arm, const Station& station, const ActiveFrames& frames) {
  const arm::Pose tcp = arm::forwardKinematics(arm, station.joints) * arm::toPose(frames.tcp);
  return arm::toControllerPose(arm::toPose(frames.base).inverse() * tcp);
}

}  // namespace

void takeStationPoses(Robot& robot) {
  const arm::ArmModel arm = arm::ArmModel::named(robot.model).value();
  const std::map<std::string, ActiveFrames> at_stations = framesAtStations(robot);
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
