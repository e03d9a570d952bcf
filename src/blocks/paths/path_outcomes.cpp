#include "paths/path_outcomes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

constexpr Block kThis = kBlock<LoadPathGoal>;

Detail blaming(const PathChain::Member& member, std::size_t point) {
  PathReport report;
  report.error_index = member.loaded->start_index + static_cast<int>(point);
  return Detail(std::move(report));
}

Outcome stopped(const PathChain& chain, const PathChain::Member& member, const PathChain::Place& place,
                const PathStop& stop) {
  const PathPlace told = chain.placeOf(member, place);
  const auto pending = static_cast<std::size_t>(told.pending_path_points);
  const bool is_loading = told.waits_for_tracking || (pending > 0 && pending < member.count());
  if (!stop.interrupted || !is_loading) return commandAborted(stop.why);
  return toOutcome(kThis, Ending::Aborted,
                   {load_path_error::kInterrupted, stop.why, "", blaming(member, member.count() - pending)});
}

}  // namespace

std::vector<Outcome> stoppedOutcomes(const PathChain& chain, const PathChain::Place& place,
                                     const PathStop& stop) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(chain.members().size());
  for (const auto& member : chain.members()) outcomes.push_back(stopped(chain, member, place, stop));
  return outcomes;
}

std::vector<Outcome> failedOutcomes(const PathChain& chain, const PathChain::Place& place, Failure failure) {
  const auto& first = chain.members().front();
  const auto number = first.loaded->method_id;
  std::vector<Outcome> outcomes(
      chain.members().size(),
      commandAborted(fmt::format("load_path {} before it failed: {}", number, failure.found)));
  failure.detail = blaming(first, std::clamp(place.done, first.first, first.behind() - 1) - first.first);
  outcomes.front() = toOutcome(kThis, Ending::Aborted, failure);
  return outcomes;
}

Outcome completed(Outcome outcome, const PathChain::Member& member, const path::Deviation& deviation,
                  Instant now) {
  const auto& to_blame = outcome.detail.as<PathReport>();
  PathReport report = member.report;
  report.error_index = to_blame.error_index;
  report.error_joint = to_blame.error_joint;
  report.max_joint_deviation = radToDeg(deviation.joint);
  report.max_path_deviation = mToMm(deviation.path);
  report.lag = fromSeconds(deviation.lag);
  outcome.detail = Detail(std::move(report));
  outcome.planned = member.loaded->planned;
  if (member.began) outcome.actual = now - *member.began;
  return outcome;
}

}  // namespace cobot_command::blocks
