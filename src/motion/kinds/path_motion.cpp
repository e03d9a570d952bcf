#include "kinds/path_motion.h"

#include <memory>
#include <utility>

#include "curves/circle_path.h"
#include "curves/half_turn.h"
#include "curves/tcp_path.h"
#include "paths/path_trajectory.h"
#include "profiles/ramp_time.h"
#include "profiles/trapezoid.h"

namespace cobot_command::motion {
namespace {

struct Request {
  const char* name;
  const PathSpeed& speed;
  Duration time_to_top_speed;
};

Result<TrajectoryPtr, Refusal> planPath(const arm::ArmModel& arm, const arm::JointVector& start,
                                        const TcpPath& path, const Request& request, const Setting& setting) {
  if (auto ambiguous = ambiguousTurn(path.turn(), path.at(1.0), request.name, setting)) {
    return refuse(std::move(*ambiguous));
  }
  const double travel =
      timeAtTopSpeed(arm, path.length(), path.turn(), request.speed, setting.speed_override);
  const double share = shareOfFullSpeed(arm, path.length(), path.turn(), request.speed);
  auto profile = std::make_shared<const Trapezoid>(travel, rampTime(request.time_to_top_speed, share));
  const AskedSpeed asked = askedSpeed(request.speed, path.length(), travel * setting.speed_override);
  return follow(arm, start, {std::make_shared<const TcpPath>(path), std::move(profile), request.name, asked},
                setting);
}

}  // namespace

Result<TrajectoryPtr, Refusal> planLine(const arm::ArmModel& arm, const arm::JointVector& start,
                                        const Line& line, const Setting& setting) {
  const TcpPath path = TcpPath::line(tcpInRobotBase(arm, start, setting), setting.base * line.target);
  return planPath(arm, start, path, {"line", line.speed, line.time_to_top_speed}, setting);
}

Result<TrajectoryPtr, Refusal> planCircle(const arm::ArmModel& arm, const arm::JointVector& start,
                                          const Circle& circle, const Setting& setting) {
  Circle in_robot_base = circle;
  in_robot_base.via = setting.base * circle.via;
  in_robot_base.end = setting.base * circle.end;
  const arm::Pose from = tcpInRobotBase(arm, start, setting);
  auto path = circlePath(from, in_robot_base);
  if (!path) {
    return refuse(Refusal{Refusal::Reason::DegenerateCircle, 0.0, -1, setting.base.inverse() * from,
                          std::move(path.error().message)});
  }
  return planPath(arm, start, *path, {"circle", circle.speed, circle.time_to_top_speed}, setting);
}

}  // namespace cobot_command::motion
