#include "cobot_command/robot/robot_watch.h"

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/link/stream_items.h"

namespace cobot_command::robot {

void RobotWatch::update(const link::RobotStatus& status) {
  const bool same = status_ && status.error.value_or(false) && status.error_code == status_->error_code;
  error_acknowledged_ = error_acknowledged_ && same;
  status_ = status;
  standstill_.see(status);
  trend_.see(status);
}

void RobotWatch::forget() {
  status_.reset();
  standstill_.forget();
  trend_.forget();
}

bool RobotWatch::held() const {
  const bool seen =
      status_ && (status_->project_paused.value_or(false) || status_->safeguard.value_or(false));
  return seen || (paused_by_us_ && !tellsPause());
}

std::string errorText(const link::RobotStatus& status) {
  std::string text = fmt::format("error 0x{:X}", static_cast<unsigned>(status.error_code.value_or(0)));
  if (status.error_text && !status.error_text->empty()) text += ": " + *status.error_text;
  return text;
}

std::string RobotWatch::errorText() const {
  if (!status_) return "";
  std::string text = robot::errorText(*status_);
  if (too_much_) text += "; " + too_much_->text;
  return text;
}

std::optional<arm::JointVector> RobotWatch::joints() const {
  return status_ ? status_->joints : std::nullopt;
}

std::string RobotWatch::whyNoJoints() const {
  if (!status_) return "no status stream shows where the robot is";
  return status_->joints ? "" : link::lackOf("Joint_Angle");
}

std::optional<arm::Pose> RobotWatch::tcp() const {
  if (!status_) return std::nullopt;
  if (status_->tcp) return status_->tcp;
  if (status_->flange && status_->tool) return status_->flange->inverse() * *status_->tool;
  return std::nullopt;
}

double RobotWatch::speedOverride() const {
  const int percent = status_ ? status_->project_speed_percent.value_or(100) : 100;
  return percent > 0 && percent <= 100 ? percent / 100.0 : 1.0;
}

std::optional<std::array<double, 6>> RobotWatch::jointsDeg() const {
  if (!joints()) return std::nullopt;
  return arm::toControllerJoints(*joints());
}

std::optional<std::array<double, 6>> RobotWatch::toolInBaseMmDeg() const {
  if (!status_ || !status_->tool) return std::nullopt;
  const arm::Pose base = status_->base.value_or(arm::Pose::Identity());
  return arm::toControllerPose(base.inverse() * *status_->tool);
}

}  // namespace cobot_command::robot
