// What is answered to other settings for the exchange_configuration goal that is enabled.
#pragma once

#include <string>

namespace cobot_command::command {

struct ExchangeAnswer {
  bool success = false;  ///< false: the old settings rule on
  int error_id = 0;      ///< of the block, or 16#8612: nothing is enabled
  std::string message;
};

}  // namespace cobot_command::command
