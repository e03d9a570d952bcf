// What became of what an operator did.
#pragma once

#include <string>

namespace cobot_command::simulator {

struct OperatorReply {
  bool done = true;
  std::string text;  ///< how things are now; or why it was not done, and what to do
};

}  // namespace cobot_command::simulator
