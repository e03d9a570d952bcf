#include "queue/motion_planner.h"

#include <type_traits>
#include <utility>
#include <vector>

#include "drive/pvt_following.h"

#include "cobot_command/common/overloaded.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/motion/velocity.h"

namespace cobot_command::simulator {
namespace {

/// What comes to where a line or an arc ends, but on any way.
std::optional<motion::Command> toTheSameEnd(const motion::Command& command) {
  using Wanted = std::optional<motion::Command>;
  return std::visit(
      Overloaded{[](const motion::Line& line) -> Wanted {
                   return motion::Ptp{motion::PoseTarget{line.target, {}}, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::Circle& circle) -> Wanted {
                   return motion::Ptp{motion::PoseTarget{circle.end, {}}, 1.0, circle.time_to_top_speed};
                 },
                 [](const motion::MoveLine& line) -> Wanted {
                   return motion::MovePtp{line.offset, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::PLine& line) -> Wanted {
                   const auto* pose = std::get_if<arm::Pose>(&line.target);
                   if (pose == nullptr) return std::nullopt;
                   return motion::Ptp{motion::PoseTarget{*pose, {}}, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::MovePLine& line) -> Wanted {
                   return motion::MovePtp{line.offset, 1.0, line.time_to_top_speed};
                 },
                 [](const auto&) -> Wanted { return std::nullopt; }},
      command);
}

motion::Setting motionSetting(const ToolAndBase& setting, double speed_override) {
  return {setting.base, setting.tcp, speed_override};
}

template <class Kind, class = void>
struct HasRamp : std::false_type {};
template <class Kind>
struct HasRamp<Kind, std::void_t<decltype(Kind::time_to_top_speed)>> : std::true_type {};

bool hasZeroRamp(const motion::Command& command) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (HasRamp<std::decay_t<decltype(kind)>>::value) {
          return kind.time_to_top_speed == Duration::zero();
        } else {
          return false;
        }
      },
      command);
}

/// As of any number that the controller does not take.
RobotError zeroRamp() {
  motion::Refusal refusal;
  refusal.reason = motion::Refusal::Reason::BadParameter;
  refusal.message =
      "the time to top speed is 0 ms, which this controller does not take: give a longer one, or set "
      "accept_zero_ramp";
  return robotErrorFor(refusal, false);
}

bool isUnreachable(const Result<motion::TrajectoryPtr, motion::Refusal>& planned) {
  return !planned && planned.error().reason == motion::Refusal::Reason::Unreachable;
}

}  // namespace

Result<ArmMotion, RobotError> MotionPlanner::plan(const arm::JointVector& start, const MotionRequest& request,
                                                  const ToolAndBase& setting, double speed_override) const {
  if (auto too_heavy = overloadBy(setting)) return refuse(std::move(*too_heavy));
  const auto command = planning::toMotion(request);
  if (!command) return refuse(robotErrorFor(command.error(), false));
  if (!options_.accept_zero_ramp && hasZeroRamp(*command)) return refuse(zeroRamp());
  const motion::Setting with = motionSetting(setting, speed_override);
  const auto planned = motion::plan(arm_, start, *command, with);
  if (planned) {
    ArmMotion motion{*planned, *planned, planning::blendOf(request), speed_override};
    const auto* pvt = std::get_if<planning::PvtBlock>(&request);
    return pvt == nullptr ? motion : followed(std::move(motion), *pvt);
  }
  const auto other = isUnreachable(planned) ? toTheSameEnd(*command) : std::nullopt;
  const bool reaches_end = other && !isUnreachable(motion::plan(arm_, start, *other, with));
  return refuse(robotErrorFor(planned.error(), reaches_end));
}

Result<ArmMotion, RobotError> MotionPlanner::planVelocity(const motion::JointState& now,
                                                          const Velocity& velocity,
                                                          std::optional<Duration> lasting,
                                                          const ToolAndBase& setting) const {
  if (auto too_heavy = overloadBy(setting)) return refuse(std::move(*too_heavy));
  auto planned = motion::planVelocity(arm_, now, {velocity, options_.stop_time, lasting},
                                      motionSetting(setting, options_.speed_override));
  if (!planned) return refuse(robotErrorFor(planned.error(), false));
  ArmMotion motion{planned->trajectory, planned->trajectory, {}, options_.speed_override};
  if (planned->ends_at) motion.obstacle = robotErrorFor(*planned->ends_at, false);
  return motion;
}

std::optional<MotionPlanner::Blended> MotionPlanner::planBehind(const ArmMotion& before, Duration left,
                                                                const MotionRequest& request,
                                                                const ToolAndBase& setting) const {
  // What counts live counts for both: what blends is made as one motion, at one pace.
  const double speed_override = options_.live_speed ? before.speed_override : options_.speed_override;
  auto next = plan(before.planned->end().position, request, setting, speed_override);
  if (!next) return std::nullopt;
  motion::Passage passage =
      motion::passInto(arm_, before.planned, next->planned, setting.tcp, *before.blend, left);
  if (passage.overlap <= Duration::zero()) return std::nullopt;
  next->path = std::move(passage.path);
  next->planned = std::move(passage.planned);
  return Blended{std::move(*next), passage.overlap};
}

ArmMotion MotionPlanner::followed(ArmMotion motion, const planning::PvtBlock& pvt) const {
  motion.is_pvt = true;
  motion.lag = options_.pvt_lag;
  if (pvt_linear_.on) {
    std::vector<Duration> times;
    double time = 0.0;
    for (const script::PvtPoint& point : pvt.points) {
      time += point.duration / motion.speed_override;
      times.push_back(fromSeconds(time));
    }
    motion.planned = straightBetween(motion.planned, times);
  }
  motion.planned = motion.path = behind(motion.planned, motion.lag);
  return motion;
}

std::optional<RobotError> MotionPlanner::overloadBy(const ToolAndBase& setting) const {
  return options_.checks_payload ? overload(arm_, setting.tcp_mass, setting.load) : std::nullopt;
}

}  // namespace cobot_command::simulator
