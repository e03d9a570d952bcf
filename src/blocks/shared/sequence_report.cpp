#include "cobot_command/blocks/shared/sequence_report.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {

SequenceReport blaming(std::size_t step, int error_id, std::string error_description) {
  SequenceReport report;
  report.failed_step = static_cast<int>(step);
  report.steps.resize(step + 1);
  report.steps.back().error_id = error_id;
  report.steps.back().error_description = forPeople(std::move(error_description));
  return report;
}

Failure stepRefused(std::size_t step, std::size_t count, const Outcome& own) {
  return {
      own_error::kStepRefused,
      fmt::format("step {} of {}: {} {}", step + 1, count, errorNumber(own.error_id), own.error_description),
      own.remedy, Detail(blaming(step, own.error_id, own.error_description + ". " + own.remedy))};
}

std::string foundSteps(std::size_t count, std::size_t most) {
  return fmt::format("{} steps; allowed: 1 to {}", count, most);
}

}  // namespace cobot_command::blocks
