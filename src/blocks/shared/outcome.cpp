#include "cobot_command/blocks/shared/outcome.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {
namespace {

std::string describe(const ErrorEntry& entry, const std::string& found) {
  if (found.empty()) return std::string(entry.description);
  return forPeople(fmt::format("{}: {}", entry.description, found));
}

/// A missing row is a fault of this layer; but who commands a robot has to get an answer all the same.
const ErrorEntry& entryOf(Block block, int id) {
  static constexpr ErrorEntry kUnlisted{
      {0, "Error without a row in the catalogue", "Report this to the maintainers", ""}, Block{}};
  const ErrorEntry* entry = findError(block, id);
  assert(entry != nullptr);
  return entry != nullptr ? *entry : kUnlisted;
}

/// A script may be long, and another one of a cycle be warned of in each: more than that nobody reads.
constexpr std::size_t kMostText = 2048;

void keepFirst(std::string& known, const std::string& other) {
  if (known.empty()) known = other;
}

}  // namespace

const char* toString(Phase phase) {
  switch (phase) {
    case Phase::Connecting:
      return "connecting";
    case Phase::Probing:
      return "probing";
    case Phase::Connected:
      return "connected";
    case Phase::Sent:
      return "sent";
    case Phase::Queued:
      return "queued";
    case Phase::WaitingForTracking:
      return "waiting for tracking";
    case Phase::Active:
      return "active";
    case Phase::Held:
      return "held";
    case Phase::Dwelling:
      return "dwelling";
    case Phase::Stopping:
      return "stopping";
  }
  return "unknown";
}

Failure tooManyWait(std::size_t waiting) {
  return {own_error::kQueueFull, fmt::format("{} wait", waiting), ""};
}

Outcome toOutcome(Block block, Ending ending, const Failure& failure) {
  const int id = ownErrorId(block, failure.error_id);
  const ErrorEntry& entry = entryOf(block, id);
  Outcome outcome;
  outcome.ending = ending;
  outcome.error_id = id;
  outcome.error_description = describe(entry, failure.found);
  outcome.remedy = failure.remedy.empty() ? entry.remedy : forPeople(failure.remedy);
  outcome.detail = failure.detail;
  outcome.refused_lines = failure.refused_lines;
  return outcome;
}

Failure failureOf(Block block, const Outcome& outcome) {
  const std::string& text = outcome.error_description;
  const std::string introduction = describe(entryOf(block, outcome.error_id), "") + ": ";
  const bool introduced = text.compare(0, introduction.size(), introduction) == 0;
  return {generalErrorId(block, outcome.error_id), introduced ? text.substr(introduction.size()) : "",
          outcome.remedy};
}

Outcome commandAborted(std::string why) {
  Outcome outcome;
  outcome.ending = Ending::CommandAborted;
  outcome.error_description = forPeople(std::move(why));
  return outcome;
}

void sortByTable(Block block, std::vector<Failure>& failures) {
  std::stable_sort(failures.begin(), failures.end(), [block](const Failure& a, const Failure& b) {
    return decidesBefore(block, a.error_id, b.error_id);
  });
}

Outcome toRejection(Block block, const std::vector<Failure>& failures) {
  Outcome outcome = toOutcome(block, Ending::Rejected, failures.front());
  for (std::size_t i = 1; i < failures.size(); ++i) {
    const int id = ownErrorId(block, failures[i].error_id);
    outcome.error_description +=
        fmt::format("; also {} {}", errorNumber(id), describe(entryOf(block, id), failures[i].found));
  }
  return outcome;
}

void Remarks::add(const Remarks& other) {
  for (const std::string& lines : other.warned_lines) {
    const bool is_known = std::find(warned_lines.begin(), warned_lines.end(), lines) != warned_lines.end();
    const bool has_room = warned_lines.empty() || textOfWarnings().size() + lines.size() <= kMostText;
    if (!is_known && has_room) warned_lines.push_back(lines);
  }
  keepFirst(unplanned, other.unplanned);
  keepFirst(unseen, other.unseen);
  keepFirst(pace, other.pace);
}

std::string Remarks::text() const {
  std::string text;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (!unplanned.empty()) add("sent unplanned and unchecked: " + unplanned);
  if (!unseen.empty()) add("its end position was not confirmed: " + unseen);
  if (!pace.empty()) add(pace);
  if (!warned_lines.empty()) add(textOfWarnings());
  return text;
}

std::string Remarks::textOfWarnings() const {
  if (warned_lines.empty()) return "";
  return fmt::format("the controller warns of {}", fmt::join(warned_lines, "; "));
}

}  // namespace cobot_command::blocks
