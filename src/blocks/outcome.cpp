#include "cobot_command/blocks/outcome.h"

#include <cassert>

#include "failure.h"
#include <fmt/format.h>

namespace cobot_command::blocks {
namespace {

std::string describe(const ErrorEntry& entry, const std::string& found) {
  return found.empty() ? std::string(entry.description) : fmt::format("{}: {}", entry.description, found);
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

Outcome toOutcome(Block block, Ending ending, const Failure& failure) {
  const ErrorEntry* entry = findError(block, failure.error_id);
  assert(entry != nullptr);
  Outcome outcome;
  outcome.ending = ending;
  outcome.error_id = failure.error_id;
  outcome.error_description = describe(*entry, failure.found);
  outcome.remedy = failure.remedy.empty() ? entry->remedy : failure.remedy;
  return outcome;
}

Outcome toRejection(Block block, const std::vector<Failure>& failures) {
  Outcome outcome = toOutcome(block, Ending::Rejected, failures.front());
  for (std::size_t i = 1; i < failures.size(); ++i) {
    const ErrorEntry* entry = findError(block, failures[i].error_id);
    assert(entry != nullptr);
    outcome.error_description +=
        fmt::format("; also 16#{:X} {}", entry->id, describe(*entry, failures[i].found));
  }
  return outcome;
}

}  // namespace cobot_command::blocks
