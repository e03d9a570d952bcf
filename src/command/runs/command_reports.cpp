#include "runs/command_reports.h"

#include <algorithm>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

/// Between two reports of the progress of a motion.
constexpr Duration kPeriod = std::chrono::milliseconds(100);
/// The end of a motion is told by its tag, not by the clock.
constexpr double kNearlyDone = 0.99;

/// "..., held by ...: what continues it".
std::string holdText(const robot::RobotWatch& robot, const CommandOrder& order, bool waits) {
  constexpr const char* kResume =
      "program_control with RESUME, or the pendant, continues it; a speed override of 0 pauses it, too, and "
      "must be raised";
  const char* in_front = waits ? "waits for the motion before it, " : "";
  if (!robot.paused()) {
    return fmt::format("{}stopped by a safeguard: it continues when that is released", in_front);
  }
  return fmt::format("{}{}: {}", in_front,
                     order.pauses ? "paused by a Pause() in the script" : "the project is paused", kResume);
}

}  // namespace

CommandReports::CommandReports(const CommandOrder& order, const robot::RobotWatch& robot, CommandClock& clock,
                               const arm::ArmModel* arm)
    : order_(order), robot_(robot), clock_(clock), arm_(arm) {}

std::optional<double> CommandReports::distance() const {
  const auto joints = robot_.joints();
  if (arm_ == nullptr || !joints || !order_.plan || order_.plan->motions.empty()) return std::nullopt;
  const auto tcp_at = [this](const arm::JointVector& at) -> Eigen::Vector3d {
    return (arm::forwardKinematics(*arm_, at) * order_.plan->tcp).translation();
  };
  return mToMm((tcp_at(order_.plan->motions.back()->end().position) - tcp_at(*joints)).norm());
}

void CommandReports::tell(blocks::Phase phase, std::string text, Instant now) {
  const Duration executed = clock_.executed(now);
  phase_ = phase;
  told_at_ = now;
  blocks::Progress progress;
  progress.phase = phase;
  progress.command_id_ack = order_.command_id_ack;
  progress.text = std::move(text);
  progress.distance_mm = distance();
  if (order_.plan) {
    const Duration planned = order_.plan->duration;
    progress.planned = planned;
    progress.remaining = std::max(Duration::zero(), planned - executed);
    if (planned > Duration::zero()) {
      progress.fraction = std::clamp(toSeconds(executed) / toSeconds(planned), 0.0, kNearlyDone);
    }
  }
  progress_.push_back(std::move(progress));
}

void CommandReports::goOn(Instant now) {
  if (!clock_.mayExecute(now)) {
    tell(blocks::Phase::Queued, "accepted, waits for the motion before it", now);
    return;
  }
  clock_.execute(now);
  const bool unseen = order_.pauses && !robot_.tellsPause();
  tell(blocks::Phase::Active,
       unseen ? "the robot executes it; the Pause() in the script, which the status stream does not show, "
                "lasts until program_control with RESUME, or the pendant, continues it"
              : "the robot executes it",
       now);
}

/// A paused robot gets the time back that the pause took.
void CommandReports::followHold(bool under_way, Instant now) {
  if (under_way && robot_.held()) {
    clock_.hold(now);
    if (phase_ == blocks::Phase::Active || phase_ == blocks::Phase::Queued) {
      tell(blocks::Phase::Held, holdText(robot_, order_, phase_ == blocks::Phase::Queued), now);
    }
  } else if (clock_.held()) {
    clock_.release(now);
    if (phase_ == blocks::Phase::Held) goOn(now);
  }
}

bool CommandReports::due(Instant now) const {
  return phase_ == blocks::Phase::Active && now - told_at_ >= kPeriod;
}

}  // namespace cobot_command::command
