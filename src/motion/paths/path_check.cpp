#include "paths/path_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "paths/path_refusals.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;

struct Sample {
  double time = 0.0;
  double progress = 0.0;
  arm::JointVector joints;
};

bool isSingular(const PathPostures& postures, const arm::JointVector& joints) {
  const arm::SingularityDistance distance = postures.singularityDistance(joints);
  return std::min({distance.shoulder, distance.elbow, distance.wrist}) < kSingular;
}

class PathCheck {
 public:
  explicit PathCheck(const TimedPath& timed) : timed_(timed), arm_(timed.postures.arm()) {}

  Result<FollowedPath, Refusal> follow(const arm::JointVector& start);

 private:
  [[nodiscard]] std::optional<Refusal> checkPosture(const Sample& sample) const;
  void checkSpeed(const Sample& from, const Sample& to);
  [[nodiscard]] bool isJump(const Sample& from, const Sample& to) const {
    return (to.joints - from.joints).cwiseAbs().maxCoeff() > kJump;
  }
  [[nodiscard]] double way(const Sample& from, const Sample& to) const {
    return (to.progress - from.progress) * (timed_.postures.length() + timed_.postures.turn());
  }
  [[nodiscard]] double samplePeriod() const;
  [[nodiscard]] Result<Sample, Refusal> sampleAt(double time, const Sample& previous) const;
  /// From one good sample to the next one, looking closer where a joint jumps.
  Result<Sample, Refusal> advance(const Sample& from, double time);

  TimedPath timed_;
  const arm::ArmModel& arm_;
  std::optional<SpeedOffence> offence_;
};

std::optional<Refusal> PathCheck::checkPosture(const Sample& sample) const {
  if (const int joint = arm_.firstJointOutsideLimits(sample.joints); joint >= 0) {
    return jointLimitRefusal(timed_, sample.progress, joint, sample.joints[joint]);
  }
  if (isSingular(timed_.postures, sample.joints)) {
    return singularRefusal(timed_, sample.progress, sample.joints);
  }
  return std::nullopt;
}

void PathCheck::checkSpeed(const Sample& from, const Sample& to) {
  const double period = to.time - from.time;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    const double needed = std::abs(to.joints[joint] - from.joints[joint]) / period;
    const double excess = needed / arm_.limits()[i].max_velocity;
    if (excess <= 1.0 + kSpeedTolerance) {
      continue;
    }
    if (!offence_) {
      offence_ = SpeedOffence{to.progress, static_cast<int>(i), needed, 1.0};
    }
    offence_->usable_share =
        std::min(offence_->usable_share, timed_.profile.usableShare(0.5 * (from.time + to.time), excess));
  }
}

Result<Sample, Refusal> PathCheck::sampleAt(double time, const Sample& previous) const {
  Sample sample;
  sample.time = time;
  sample.progress = timed_.profile.progress(time);
  auto joints = timed_.postures.at(sample.progress, previous.joints);
  if (!joints) {
    return refuse(reachRefusal(timed_, sample.progress, joints.error()));
  }
  sample.joints = *joints;
  return sample;
}

Result<Sample, Refusal> PathCheck::advance(const Sample& from, double time) {
  auto to = sampleAt(time, from);
  if (!to) {
    return to;
  }
  if (isJump(from, *to)) {
    if (way(from, *to) < kJumpWay) {
      return refuse(singularRefusal(timed_, from.progress, from.joints));
    }
    auto middle = advance(from, 0.5 * (from.time + time));
    return middle ? advance(*middle, time) : middle;
  }
  if (auto refusal = checkPosture(*to)) {
    return refuse(std::move(*refusal));
  }
  checkSpeed(from, *to);
  return to;
}

/// [s]
double PathCheck::samplePeriod() const {
  const double top_speed = (timed_.postures.length() + timed_.postures.turn()) / timed_.profile.travel();
  return std::clamp(kSampleWay / top_speed, kSamplePeriod, kLongestSamplePeriod);
}

Result<FollowedPath, Refusal> PathCheck::follow(const arm::JointVector& start) {
  constexpr double kKeepPeriod = 64e-3;  // [s], a joint turns less than half a turn meanwhile
  const double duration = timed_.profile.duration();
  const auto steps = static_cast<std::size_t>(std::ceil(duration / samplePeriod()));
  const double period = duration / static_cast<double>(steps);
  const auto keep_every = static_cast<std::size_t>(std::max(1.0, std::floor(kKeepPeriod / period)));

  Sample sample{0.0, 0.0, start};
  if (auto refusal = checkPosture(sample)) {
    return refuse(std::move(*refusal));
  }
  FollowedPath followed;
  followed.period = period * static_cast<double>(keep_every);
  followed.postures.reserve(steps / keep_every + 1);
  followed.postures.push_back(start);
  for (std::size_t i = 1; i <= steps; ++i) {
    auto next = advance(sample, i == steps ? duration : static_cast<double>(i) * period);
    if (!next) {
      return refuse(std::move(next.error()));
    }
    sample = *next;
    if (i % keep_every == 0) {
      followed.postures.push_back(sample.joints);
    }
  }
  if (offence_) {
    return refuse(jointSpeedRefusal(timed_, *offence_));
  }
  followed.end = sample.joints;
  return followed;
}

}  // namespace

Result<FollowedPath, Refusal> checkPath(const TimedPath& timed, const arm::JointVector& start) {
  return PathCheck(timed).follow(start);
}

}  // namespace cobot_command::motion
