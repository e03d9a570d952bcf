#include "answer.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::tools {

bool Answer::isYes() const {
  return std::all_of(stages.begin(), stages.end(),
                     [](const AnswerStage& stage) { return stage.faults.empty(); });
}

int print(const Answer& answer, bool json) {
  const int status = answer.isYes() ? kYes : kNo;
  if (json) {
    nlohmann::ordered_json line = {{"ok", answer.isYes()}, {"stages", nlohmann::ordered_json::array()}};
    for (const AnswerStage& stage : answer.stages) {
      line["stages"].push_back({{"name", stage.name},
                                {"seconds", stage.seconds},
                                {"report", stage.report},
                                {"faults", stage.faults}});
    }
    std::cout << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return status;
  }
  for (const AnswerStage& stage : answer.stages) {
    std::cout << fmt::format("{:<11} {} ({:.3f} s)\n", stage.name, stage.faults.empty() ? "ok" : "FAILED",
                             stage.seconds);
    for (const std::string& line : stage.report) std::cout << "  " << forPeople(line) << '\n';
    for (const std::string& fault : stage.faults) std::cerr << "tm_cell: " << forPeople(fault) << '\n';
  }
  return status;
}

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Answer wrong(const std::string& stage, const std::string& fault) {
  return {{{stage, 0.0, {}, {fault}}}};
}

}  // namespace cobot_command::tools
