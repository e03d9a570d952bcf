// What became of what an operator did.
#pragma once

#include <string>
#include <utility>

namespace cobot_command::simulator {

struct OperatorReply {
  bool done = true;
  std::string text;  ///< how things are now; or why it was not done, and what to do
};

/// `text`: why not, and what to do.
[[nodiscard]] inline OperatorReply notDone(std::string text) {
  return {false, std::move(text)};
}

}  // namespace cobot_command::simulator
