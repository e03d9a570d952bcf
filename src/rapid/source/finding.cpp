#include "cobot_command/rapid/source/finding.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/rapid/source/finding_kinds.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

namespace {

/// How many are collected before the ones that cannot be among the first are dropped.
constexpr std::size_t kMostUnsorted = 10 * kMostFindings;

auto placeAndId(const Finding& finding) {
  return std::tuple(finding.span.begin, finding.id);
}

}  // namespace

std::string_view toString(Severity severity) {
  return severity == Severity::Warning ? "warning" : "error";
}

void Findings::add(Finding finding) {
  found_.push_back(std::move(finding));
  if (found_.size() >= kMostUnsorted) sortAndCut();
}

std::vector<Finding> Findings::take() {
  sortAndCut();
  if (found_.size() > kMostFindings) {
    found_.back() = {kinds::kManyFindings.id, found_.back().span,
                     fmt::format(fmt::runtime(kinds::kManyFindings.text), kMostFindings)};
  }
  return std::exchange(found_, {});
}

/// Keeps one more than are allowed, so that it is known whether there are more.
void Findings::sortAndCut() {
  std::stable_sort(found_.begin(), found_.end(), [](const Finding& left, const Finding& right) {
    return placeAndId(left) < placeAndId(right);
  });
  found_.erase(std::unique(found_.begin(), found_.end(),
                           [](const Finding& left, const Finding& right) {
                             return placeAndId(left) == placeAndId(right);
                           }),
               found_.end());
  if (found_.size() > kMostFindings + 1) found_.resize(kMostFindings + 1);
}

}  // namespace cobot_command::rapid
