// The answer to a change of the settings of the enabled exchange_configuration goal.
#pragma once

#include <string>

namespace cobot_command::command {

struct ExchangeAnswer {
  bool success = false;  ///< false: the old settings still apply
  int error_id = 0;      ///< of the block, or 16#8612: nothing is enabled
  std::string message;
};

}  // namespace cobot_command::command
