#include "cobot_command/robot/standstill.h"

namespace cobot_command::robot {
namespace {

/// Below this every joint counts as standing; above the noise of a real arm's Joint_Speed.
constexpr double kSlow = degToRad(0.1);  // [rad/s]
/// In which that speed makes kSamePlace of a joint angle.
constexpr Duration kRest = std::chrono::milliseconds(100);
/// Frames may come late and together: of two alone it is not known how much time is between them.
constexpr int kFramesAtRest = 3;

}  // namespace

void Standstill::see(const link::RobotStatus& status) {
  if (status.joints) {
    follow(*status.joints, status.received);
  } else {
    rest_.reset();
  }
  if (status.joint_velocities) {
    moving_ = !(status.joint_velocities->cwiseAbs().maxCoeff() < kSlow);
  } else if (!rest_) {
    moving_.reset();
  }
}

void Standstill::follow(const arm::JointVector& joints, Instant received) {
  if (!rest_) {
    rest_ = Rest{joints, received};
    moving_.reset();
  } else if ((joints - rest_->joints).cwiseAbs().maxCoeff() > kSamePlace) {
    rest_ = Rest{joints, received};
    moving_ = true;
  } else if (++rest_->frames >= kFramesAtRest && received - rest_->since >= kRest) {
    moving_ = false;
  }
}

}  // namespace cobot_command::robot
