// What the monitor tells people.
#include <algorithm>

#include "monitor/monitor_parts.h"
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::cell {

using monitor::Names;
using monitor::PairWatch;

MonitorStatus Monitor::Parts::status() const {
  MonitorStatus status;
  status.latched = latched();
  status.diagnosis = diagnosis();
  status.pairs.reserve(pairs_.size());
  for (const PairWatch& pair : pairs_) status.pairs.push_back(statusOf(pair));
  status.counts = counts_;
  return status;
}

PairStatus Monitor::Parts::statusOf(const PairWatch& pair) const {
  PairStatus status;
  status.first = nameOf(pair.first);
  status.second = nameOf(pair.second);
  status.known = pair.known;
  if (!pair.known) return status;
  status.distance = pair.gap.distance;
  status.uncertainty = pair.gap.uncertainty();
  status.exact = pair.gap.exact;
  status.first_body = pair.bodies.first;
  status.second_body = pair.bodies.second;
  status.least = pair.least;
  status.least_at = pair.least_at;
  status.least_first_body = pair.least_bodies.first;
  status.least_second_body = pair.least_bodies.second;
  status.breached = pair.breach.has_value();
  return status;
}

std::vector<SeenBodies> Monitor::Parts::bodies() const {
  std::vector<SeenBodies> all;
  all.reserve(movers_.size() + obstacles_.size());
  for (std::size_t thing = 0; thing < movers_.size() + obstacles_.size(); ++thing) {
    SeenBodies seen{nameOf(thing), setOf(thing).capsules, {}};
    for (std::size_t i = 0; i < seen.capsules.size(); ++i) seen.body_names.push_back(bodyName(thing, i));
    all.push_back(std::move(seen));
  }
  return all;
}

Names Monitor::Parts::bodiesOf(const PairWatch& pair) const {
  if (!pair.gap.exact) return {};
  return {bodyName(pair.first, pair.gap.first), bodyName(pair.second, pair.gap.second)};
}

std::string Monitor::Parts::bodyName(std::size_t thing, std::size_t body) const {
  return thing < movers_.size() ? movers_[thing].track->bodyName(body) : nameOf(thing);
}

std::string Monitor::Parts::sentenceOf(const PairWatch& pair, double limit, const char* limit_name) const {
  return fmt::format(
      "{} ({}) and {} ({}) are {:.1f} mm apart, less {:.1f} mm for the age of the data: below the {} of "
      "{:.1f} mm.",
      nameOf(pair.first), pair.bodies.first, nameOf(pair.second), pair.bodies.second,
      mToMm(pair.gap.distance), mToMm(pair.gap.uncertainty()), limit_name, mToMm(limit));
}

std::string Monitor::Parts::staleSentence(const Mover& mover) const {
  return fmt::format("{} moved in its last report, which was measured more than {:.3g} s ago.", mover.name,
                     toSeconds(settings_.stale_after));
}

std::vector<std::string> Monitor::Parts::causes() const {
  std::vector<std::string> causes;
  for (const Mover& mover : movers_) {
    if (mover.silent) causes.push_back(staleSentence(mover));
  }
  for (const PairWatch& pair : pairs_) {
    if (pair.stop.isBelow()) causes.push_back(sentenceOf(pair, stop_distance_, "stop distance"));
  }
  return causes;
}

std::string Monitor::Parts::diagnosis() const {
  if (latched()) {
    return "All were stopped, and must stay at standstill until the monitor is reset. " + alarm_.why();
  }
  const std::vector<std::string> reasons = causes();
  if (!reasons.empty()) return reasons.front();
  for (const PairWatch& pair : pairs_) {
    if (pair.breach) return sentenceOf(pair, settings_.margin, "margin");
  }
  for (const Mover& mover : movers_) {
    if (!mover.track->heard()) return fmt::format("{} has not reported yet.", mover.name);
  }
  return closest();
}

std::string Monitor::Parts::closest() const {
  const auto closest =
      std::min_element(pairs_.begin(), pairs_.end(),
                       [](const PairWatch& a, const PairWatch& b) { return a.gap.lowest < b.gap.lowest; });
  if (closest == pairs_.end()) return "No two objects of the cell can come close to each other.";
  if (!closest->known) return "No distance was calculated yet.";
  return fmt::format("The closest are {} and {}: {}{:.1f} mm.", nameOf(closest->first),
                     nameOf(closest->second), closest->gap.exact ? "" : "at least ",
                     mToMm(closest->gap.distance));
}

}  // namespace cobot_command::cell
