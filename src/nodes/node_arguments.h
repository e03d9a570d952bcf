// What a node is started with beside ROS's own `name:=value`.
#pragma once

#include <optional>
#include <string>

namespace cobot_command::nodes {

struct NodeDescription {
  std::string name;     ///< of the program
  std::string purpose;  ///< one sentence
  std::string example;  ///< a private parameter as it is written on the command line
};

/// Nothing: go on. Else the exit status to end with: 0 when --help was printed, 2 when standard error says
/// which word no node understands, what is allowed, and what to do. To be asked before ros::init(), which
/// takes away what is its own, and lets everything else pass in silence.
[[nodiscard]] std::optional<int> answerArguments(int argc, const char* const* argv,
                                                 const NodeDescription& node);

}  // namespace cobot_command::nodes
