#include "cobot_command/robot/stall_watch.h"

#include "cobot_command/common/units.h"

namespace cobot_command::robot {
namespace {

/// Of any joint, from frame to frame, is motion: it asks early, and judges nothing.
constexpr double kElsewhere = degToRad(0.01);  // [rad]
/// At different times, however long there is between them: one alone may have been on its way for long.
constexpr int kFramesStalled = 5;

}  // namespace

void StallWatch::see(const RobotWatch& robot, Instant now) {
  const auto joints = robot.joints();
  if (!joints) {
    rest_.reset();
    return;
  }
  const bool elsewhere = rest_ && (*joints - rest_->place).cwiseAbs().maxCoeff() > kElsewhere;
  const bool moves = elsewhere || robot.moving() == true;
  moved_ = moved_ || moves;
  if (!rest_ || moves || robot.held()) {
    rest_ = Rest{*joints, now, now, now};
  } else if (now > rest_->last) {
    rest_->last = now;
    ++rest_->frames;
  }
}

bool StallWatch::rests(Duration patience) const {
  return rest_ && rest_->frames >= kFramesStalled && rest_->last - rest_->since >= patience;
}

bool StallWatch::stalled(Duration patience) const {
  return moved_ && rests(patience) && rest_->last - rest_->examined >= patience;
}

void StallWatch::lookedInto() {
  if (rest_) rest_->examined = rest_->last;
}

}  // namespace cobot_command::robot
