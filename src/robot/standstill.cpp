#include "cobot_command/robot/standstill.h"

#include <algorithm>

#include "cobot_command/common/units.h"

namespace cobot_command::robot {
namespace {

/// At rest no joint moves by more in so long.
constexpr double kSamePlace = degToRad(0.05);  // [rad]
constexpr Duration kRest = std::chrono::milliseconds(300);
/// Before that the same frames may show the last of a motion.
constexpr Duration kSurelyAtRest = std::chrono::milliseconds(100);
/// Frames may come late and together: of two alone it is not known how much time is between them.
constexpr std::size_t kFramesAtRest = 3;
/// With every speed below this the arm stands: that is less than at rest in any case.
constexpr double kNextToNothing = degToRad(0.1);  // [rad/s]
/// No noise is above this: it moves, though its angles may not show it yet.
constexpr double kAboveNoise = degToRad(1.0);  // [rad/s]
/// How far above the noise that was seen a speed is no noise.
constexpr double kBeyondNoise = 1.5;

}  // namespace

void Standstill::see(const link::RobotStatus& status) {
  const auto fastest =
      status.joint_velocities ? std::optional(status.joint_velocities->cwiseAbs().maxCoeff()) : std::nullopt;
  keep(status, fastest.value_or(0));
  if (fastest && *fastest < kNextToNothing) {
    moving_ = false;
  } else if (fastest && (*fastest >= kAboveNoise || places_.empty())) {
    moving_ = true;
  } else if (fastest && moving_ == false && *fastest > kBeyondNoise * noise_) {
    // Faster than it ever was at rest. If that is noise all the same, the angles from here on tell.
    moving_ = true;
    places_ = {places_.back()};
  } else {
    judgeByAngles();
  }
}

void Standstill::keep(const link::RobotStatus& status, double fastest) {
  if (!status.joints) {
    places_.clear();
    return;
  }
  places_.push_back({status.received, *status.joints, fastest});
  while (places_.size() > kFramesAtRest && places_[1].at + kRest <= status.received) places_.pop_front();
}

void Standstill::judgeByAngles() {
  if (places_.empty()) {
    moving_.reset();
    return;
  }
  const auto moving = movingByAngles();
  if (!moving) return;
  const bool comes_to_rest = moving_ != false && !*moving;
  moving_ = moving;
  // Only then: learned from each frame at rest, the noise would rise with a motion that begins slowly.
  if (!comes_to_rest) return;
  for (const Place& place : places_) {
    if (place.at + kSurelyAtRest >= places_.back().at) noise_ = std::max(noise_, place.fastest);
  }
}

std::optional<bool> Standstill::movingByAngles() const {
  arm::JointVector least = places_.front().joints;
  arm::JointVector most = least;
  for (const Place& place : places_) {
    least = least.cwiseMin(place.joints);
    most = most.cwiseMax(place.joints);
  }
  if ((most - least).maxCoeff() > kSamePlace) return true;
  const bool is_long_enough = places_.front().at + kRest <= places_.back().at;
  return is_long_enough && places_.size() >= kFramesAtRest ? std::optional(false) : std::nullopt;
}

}  // namespace cobot_command::robot
