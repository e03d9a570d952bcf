// The result of an operator action.
#pragma once

#include <string>
#include <utility>

namespace cobot_command::simulator {

struct OperatorReply {
  bool done = true;
  std::string text;  ///< the new state; or why the action was not done, and what to do
};

/// `text`: why the action was not done, and what to do.
[[nodiscard]] inline OperatorReply notDone(std::string text) {
  return {false, std::move(text)};
}

}  // namespace cobot_command::simulator
