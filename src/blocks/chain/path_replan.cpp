#include "chain/path_replan.h"

#include <vector>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

/// What became of a plan at another feedrate.
struct Reloaded {
  CommandKey key = 0;  ///< of the chain that was planned
  double feedrate = 0;
  std::vector<LoadedPathPtr> loaded;
  std::string refusal;
};

}  // namespace

void PathReplan::ask(double feedrate) {
  if (feedrate != feedrate_) refusal_.clear();
  feedrate_ = feedrate;
}

/// Nobody is driven faster than was asked for: what cannot be slower waits.
bool PathReplan::isServed() const {
  if (chain_.isRewound()) return false;
  const auto planned = chain_.feedrates();
  if (!planned || (planned->lowest == feedrate_ && planned->highest == feedrate_)) return true;
  return !refusal_.empty() && planned->highest <= feedrate_;
}

std::optional<PathWork> PathReplan::take() {
  const bool is_refused = !refusal_.empty() && !chain_.isRewound();
  if (is_refused || isServed() || under_way_ == wanted()) return std::nullopt;
  under_way_ = wanted();
  return [rest = *chain_.rest(), wanted = wanted()]() {
    const auto [key, feedrate] = wanted;
    auto loaded = loadAgain(rest, feedrate);
    if (loaded) return Detail(Reloaded{key, feedrate, *std::move(loaded), ""});
    const path::PathRefusal& why = loaded.error();
    const std::string point = why.index < 0 ? "" : fmt::format("point {}: ", why.index);
    return Detail(Reloaded{key, feedrate, {}, point + why.found});
  };
}

std::optional<std::string> PathReplan::answered(const Detail& found) {
  const Reloaded& reloaded = found.as<Reloaded>();
  const bool is_it = found.isNone() || under_way_ == Wanted(reloaded.key, reloaded.feedrate);
  if (!under_way_ || !is_it) return std::nullopt;
  const bool is_of_now = under_way_ == wanted();
  under_way_.reset();
  if (!is_of_now) return std::nullopt;  // it is asked for once more, if it is not yet
  if (!reloaded.loaded.empty()) {
    chain_.reload(reloaded.loaded);
    return std::nullopt;
  }
  refusal_ = fmt::format(
      "at a feedrate of {:.6g} % {}", 100 * feedrate_,
      reloaded.refusal.empty() ? "it could not be planned in the available time" : reloaded.refusal);
  if (chain_.isRewound()) {
    failure_ = Failure{own_error::kRestNotPlanned, refusal_, ""};
    return std::nullopt;
  }
  return refusal_ + (isServed() ? "; the path keeps its feedrate" : "; the path waits for another feedrate");
}

std::string PathReplan::text() const {
  return refusal_.empty() ? "is planned at another feedrate" : refusal_ + ": waits for another feedrate";
}

}  // namespace cobot_command::blocks
