#include "cell_watch/distance_messages.h"

#include <algorithm>

#include "cell_watch/pictures/watch_view.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

cobot_command::CellDistance toMessage(const cell::PairStatus& pair) {
  cobot_command::CellDistance message;
  message.robot = pair.first;
  message.other = pair.second;
  message.known = pair.known ? 1 : 0;
  if (!pair.known) return message;
  message.now = pair.distance - pair.uncertainty;
  message.uncertainty = pair.uncertainty;
  message.exact = pair.exact ? 1 : 0;
  message.robot_body = pair.first_body;
  message.other_body = pair.second_body;
  message.least = pair.least;
  message.breached = pair.breached ? 1 : 0;
  return message;
}

bool isBreached(const cell::MonitorStatus& status) {
  return std::any_of(status.pairs.begin(), status.pairs.end(),
                     [](const cell::PairStatus& pair) { return pair.breached; });
}

/// Empty: all were heard, and can be stopped.
std::string lackOf(const WatchView& view) {
  for (const WatchView::Mover& mover : view.movers) {
    if (!mover.is_heard) return fmt::format("{} has not reported yet on {}", mover.name, mover.topic);
    if (!mover.takes_stops) {
      return fmt::format("no node in {}/ accepts stop goals of {}", mover.space, mover.name);
    }
  }
  return "";
}

void addPairs(diagnostic_updater::DiagnosticStatusWrapper& status, const cell::MonitorStatus& monitor) {
  for (const cell::PairStatus& pair : monitor.pairs) {
    const std::string key = pair.first + " and " + pair.second;
    if (!pair.known) {
      status.add(key, "unknown");
      continue;
    }
    status.add(key, fmt::format("{}{:.1f} mm, minimum {:.1f} mm", pair.exact ? "" : "more than ",
                                mToMm(pair.distance), mToMm(pair.least)));
  }
}

}  // namespace

cobot_command::CellDistances toMessage(const cell::MonitorStatus& status) {
  cobot_command::CellDistances message;
  for (const cell::PairStatus& pair : status.pairs) message.pairs.push_back(toMessage(pair));
  message.alarmed = status.latched ? 1 : 0;
  message.text = forPeople(status.diagnosis);
  return message;
}

std::string sentenceOf(const cell::Breach& breach) {
  const Duration lasted = breach.end.value_or(breach.least_at) - breach.start;
  return fmt::format(
      "{} ({}) and {} ({}) were closer than the margin for {:.2f} s: minimum {:.1f} mm, {:.1f} mm if the age "
      "of the data is taken into account.",
      breach.first, breach.first_body, breach.second, breach.second_body, toSeconds(lasted),
      mToMm(breach.distance), mToMm(breach.least));
}

void describeMonitor(diagnostic_updater::DiagnosticStatusWrapper& status, const WatchView& view,
                     cell::MonitorSettings::Mode mode) {
  const std::string lack = lackOf(view);
  if (view.status.latched) {
    status.summary(Level::ERROR, forPeople(view.status.diagnosis));
  } else if (isBreached(view.status)) {
    status.summary(Level::WARN, forPeople(view.status.diagnosis));
  } else if (!lack.empty()) {
    status.summary(Level::WARN, forPeople(lack));
  } else {
    status.summary(Level::OK, forPeople(view.status.diagnosis));
  }
  status.add("mode", mode == cell::MonitorSettings::Mode::Stop ? "stop" : "warn");
  addPairs(status, view.status);
  for (const WatchView::Mover& mover : view.movers) {
    if (!mover.carries.empty()) status.add("carried by " + mover.name, mover.carries);
  }
  const cell::MonitorCounts& counts = view.status.counts;
  status.add("joint states and positions that were malformed", counts.malformed);
  status.add("joint states and positions that were old", counts.old);
  status.add("breaches that are not kept any more", counts.lost_breaches);
}

}  // namespace cobot_command::ros_adapter
