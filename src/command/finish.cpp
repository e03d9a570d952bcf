#include "cobot_command/command/finish.h"

#include <fmt/format.h>

namespace cobot_command::command {

std::string toText(const FinishReport& report) {
  std::string text = "nothing is running";
  if (report.under_way) {
    text = fmt::format("{} runs to its end; see its own result", toString(*report.under_way));
  } else if (report.moves_on) {
    text += "; motions whose goals have ended may still move the robot";
  }
  if (report.dropped == 0) return text;
  return fmt::format("{}; {} in the queue {} ended", text,
                     report.dropped == 1 ? "one goal" : fmt::format("{} goals", report.dropped),
                     report.dropped == 1 ? "has" : "have");
}

}  // namespace cobot_command::command
