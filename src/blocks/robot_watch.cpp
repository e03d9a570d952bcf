#include "robot_watch.h"

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

void RobotWatch::update(const link::RobotStatus& status) {
  const bool same = status_ && status.error.value_or(false) && status.error_code == status_->error_code;
  error_acknowledged_ = error_acknowledged_ && same;
  status_ = status;
  standstill_.see(status);
}

void RobotWatch::forget() {
  status_.reset();
  standstill_.forget();
}

bool RobotWatch::held() const {
  return status_ && (status_->project_paused.value_or(false) || status_->safeguard.value_or(false));
}

std::string RobotWatch::errorText() const {
  if (!status_) return "";
  std::string text = fmt::format("error 0x{:X}", static_cast<unsigned>(status_->error_code.value_or(0)));
  if (status_->error_text && !status_->error_text->empty()) text += ": " + *status_->error_text;
  if (too_much_) text += "; " + too_much_->text;
  return text;
}

std::optional<arm::JointVector> RobotWatch::joints() const {
  return status_ ? status_->joints : std::nullopt;
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

void tellStoppedProject(const RobotWatch& robot, Failure& loss) {
  if (!robot.projectStopped()) return;
  loss.found = "the project was stopped: " + loss.found;
  loss.remedy = "Start the project on the controller, then connect again";
}

Failure robotError(const RobotWatch& robot) {
  const std::string way_out =
      !robot.tooMuch()
          ? ""
          : fmt::format(
                "Execute stop, then change_tcp with the tool that is there, and at most {} kg of tool "
                "and load (ChangeLoad of run_script) together: the next motion then clears the error. "
                "If it does not, clear it on the controller",
                robot.tooMuch()->payload);
  return {own_error::kRobotError, robot.errorText(), way_out};
}

}  // namespace cobot_command::blocks
