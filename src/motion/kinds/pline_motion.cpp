#include "kinds/pline_motion.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "curves/half_turn.h"
#include "curves/twist_path.h"
#include "paths/path_refusals.h"
#include "paths/path_trajectory.h"
#include "profiles/ramp_time.h"
#include "profiles/trapezoid.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

/// What a PLine needs to know to be passed into the next one.
struct Chain {
  TwistPath path;  ///< with that of the PLines before it, as far as they are still to be made
  Trapezoid profile;
  PathRate velocity;       ///< of the last line at top speed
  double line_time = 0.0;  ///< of the last line at top speed [s]
  double ramp = 0.0;       ///< [s]
  AskedSpeed speed;
  Setting setting;
};

class PLineTrajectory final : public Trajectory {
 public:
  PLineTrajectory(TrajectoryPtr made, Chain chain) : made_(std::move(made)), chain_(std::move(chain)) {}

  [[nodiscard]] Duration duration() const override { return made_->duration(); }
  [[nodiscard]] JointState at(Duration time) const override { return made_->at(time); }
  [[nodiscard]] Duration timeUp() const override { return made_->timeUp(); }
  [[nodiscard]] Duration timeDown() const override { return made_->timeDown(); }
  [[nodiscard]] double progress(Duration time) const override { return made_->progress(time); }
  [[nodiscard]] double tcpWay() const override { return made_->tcpWay(); }
  [[nodiscard]] const Chain& chain() const { return chain_; }

 private:
  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    return made_->jointRange(from, to);
  }

  TrajectoryPtr made_;
  Chain chain_;
};

Result<TrajectoryPtr, Refusal> make(const arm::ArmModel& arm, const arm::JointVector& start, Chain chain) {
  auto made = follow(arm, start,
                     {std::make_shared<const TwistPath>(chain.path),
                      std::make_shared<const Trapezoid>(chain.profile), "line", chain.speed},
                     chain.setting);
  if (!made) return made;
  return TrajectoryPtr(std::make_shared<PLineTrajectory>(std::move(*made), std::move(chain)));
}

arm::Pose poseOf(const PLine& line, const arm::ArmModel& arm, const Setting& setting) {
  if (const auto* pose = std::get_if<arm::Pose>(&line.target)) return setting.base * *pose;
  return tcpInRobotBase(arm, std::get<arm::JointVector>(line.target), setting);
}

/// The corner is rounded over this much of the time before it, and as much behind it [s at top speed].
double halfOfCorner(const Chain& before, const Chain& next, BlendShare share) {
  return 0.5 * std::clamp(share.value, 0.0, 1.0) * std::min(before.line_time, next.line_time);
}

}  // namespace

Result<TrajectoryPtr, Refusal> planPLine(const arm::ArmModel& arm, const arm::JointVector& start,
                                         const PLine& line, const Setting& setting) {
  const arm::Pose from = tcpInRobotBase(arm, start, setting);
  const arm::Pose to = poseOf(line, arm, setting);
  PathRate way;
  way << to.translation() - from.translation(), turnBetween(from.linear(), to.linear());
  if (auto ambiguous = ambiguousTurn(way.tail<3>().norm(), to, "line", setting)) {
    return refuse(std::move(*ambiguous));
  }
  const double time =
      timeAtTopSpeed(arm, way.head<3>().norm(), way.tail<3>().norm(), line.speed, setting.speed_override);
  const double share = shareOfFullSpeed(arm, way.head<3>().norm(), way.tail<3>().norm(), line.speed);
  const double ramp = rampTime(line.time_to_top_speed, share);
  Chain chain{TwistPath(from),
              Trapezoid(time, ramp),
              PathRate::Zero(),
              time,
              ramp,
              askedSpeed(line.speed, way.head<3>().norm(), time * setting.speed_override),
              setting};
  if (time > 0.0) chain.velocity = way / time;
  chain.path.append(time, chain.velocity);
  auto made = make(arm, start, std::move(chain));
  const auto* target = std::get_if<arm::JointVector>(&line.target);
  if (!made || target == nullptr) return made;
  if (auto other = otherPosture((*made)->end().position, *target, setting.base.inverse() * to)) {
    return refuse(std::move(*other));
  }
  return made;
}

std::optional<Passage> passOn(const arm::ArmModel& arm, const Trajectory& before, const Trajectory& next,
                              BlendShare share, Duration left) {
  const auto* first = dynamic_cast<const PLineTrajectory*>(&before);
  const auto* second = dynamic_cast<const PLineTrajectory*>(&next);
  if (first == nullptr || second == nullptr) return std::nullopt;
  const Chain& a = first->chain();
  const Chain& b = second->chain();
  const double wanted = halfOfCorner(a, b, share);
  if (wanted <= Trapezoid::kNoTravel || !a.setting.tcp.isApprox(b.setting.tcp, 0.0)) return std::nullopt;

  const double whole = a.path.duration();
  const Duration begin = std::max(fromSeconds(a.profile.timeBeforeBraking(1.0 - wanted / whole)),
                                  before.duration() - std::min(left, before.duration()));
  const double time = std::min(toSeconds(begin), a.profile.duration());
  const double passed = whole * a.profile.progress(time);
  const double half = std::min(wanted, whole - passed);
  if (half <= Trapezoid::kNoTravel) return std::nullopt;

  Chain joined = b;
  joined.path = a.path.part(passed, half);
  joined.path.append(2.0 * half, a.velocity, b.velocity);
  joined.path.append(b.line_time - half, b.velocity);
  joined.profile = Trapezoid(joined.path.duration(), b.ramp, a.profile.shareOfTopSpeed(time));
  const auto made = make(arm, before.at(begin).position, std::move(joined));
  if (!made) return std::nullopt;
  return Passage{before.duration() - begin, *made, *made};
}

}  // namespace cobot_command::motion
