#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> runScriptErrors() {
  return ErrorTable(Block::RunScript)
      .anyCommand()
      .remedy(motion_error::kRejected,
              "Correct the lines that the description names; sent again as they are they "
              "fail again")
      .turn()
      .motion()
      .row(
          own_error::kScriptInvalid, "Script invalid",
          "Give lines of printable text, together at most 4096 bytes, without queue tags; close each text, "
          "comment "
          "and bracket; send a StopAndClearBuffer or ScriptExit with a number by itself, without "
          "await_motion",
          "script is empty, too long, or not UTF-8; or a line has control characters or the word QueueTag or "
          "WaitQueueTag; or lines follow a ScriptExit(); or a StopAndClearBuffer or ScriptExit with a "
          "number, "
          "which the controller executes alone, has lines or await_motion with it; or a text is not closed "
          "in "
          "its line, a comment or bracket "
          "not in the script: the layer's own lines behind it would be read as part of it")
      .row(own_error::kReplyTimeoutRange, "ReplyTimeout range: 0.05~3600 s, or 0", kSetInRange,
           "reply_timeout is neither 0 (that of the link) nor 0.05..3600")
      .rows();
}

}  // namespace cobot_command::blocks
