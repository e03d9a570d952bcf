#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> programControlErrors() {
  return ErrorTable(Block::ProgramControl)
      .thesisCommand()
      .echoedCommandId()
      .anyCommand()
      .shared(
          own_error::kNotListening,
          "the controller answered CPERR F1: the flow is not in a Listen node, which is left to it to say")
      .row(own_error::kProgramCommandUnknown, "Command unknown", "Use 0 (Pause) or 1 (Resume)",
           "command is neither 0 nor 1")
      .rows();
}

}  // namespace cobot_command::blocks
