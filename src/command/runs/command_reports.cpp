#include "runs/command_reports.h"

#include <algorithm>

namespace cobot_command::command {
namespace {

/// Between two reports of the progress of a motion.
constexpr Duration kPeriod = std::chrono::milliseconds(100);
/// The end of a motion is told by its tag, not by the clock.
constexpr double kNearlyDone = 0.99;

}  // namespace

void CommandReports::tell(blocks::Phase phase, std::string text, Duration executed, Instant now) {
  phase_ = phase;
  told_at_ = now;
  blocks::Progress progress;
  progress.phase = phase;
  progress.command_id_ack = command_id_ack_;
  progress.text = std::move(text);
  if (planned_) {
    progress.planned = *planned_;
    progress.remaining = std::max(Duration::zero(), *planned_ - executed);
    if (*planned_ > Duration::zero()) {
      progress.fraction = std::clamp(toSeconds(executed) / toSeconds(*planned_), 0.0, kNearlyDone);
    }
  }
  progress_.push_back(std::move(progress));
}

bool CommandReports::due(Instant now) const {
  return phase_ == blocks::Phase::Active && now - told_at_ >= kPeriod;
}

}  // namespace cobot_command::command
