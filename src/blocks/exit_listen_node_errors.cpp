#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> exitListenNodeErrors() {
  return ErrorTable(Block::ExitListenNode).anyCommand().turn().rows();
}

}  // namespace cobot_command::blocks
