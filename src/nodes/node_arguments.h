// What a node is started with: words that mean nothing, and names that cannot be used, end it with status 2.
#pragma once

#include <exception>
#include <optional>
#include <string>

#include "unblocked_output.h"
#include <ros/exception.h>

namespace cobot_command::nodes {

struct NodeDescription {
  std::string name;     ///< of the program
  std::string purpose;  ///< one sentence
  std::string example;  ///< a private parameter as it is written on the command line
};

/// Nothing: go on. Else the exit status to end with: 0 when --help or --version was answered, 2 when standard
/// error says which word no node understands or which name cannot be one, what is allowed, and what to do. To
/// be asked before ros::init(), which takes away what is its own, lets everything else pass in silence, and
/// throws.
[[nodiscard]] std::optional<int> answerArguments(int argc, const char* const* argv,
                                                 const NodeDescription& node);

/// Says on standard error why a name cannot be had; the exit status to end with.
[[nodiscard]] int explain(const NodeDescription& node, const std::exception& error);

/// The whole of a node's main(): its arguments, then `serve`, which gives the exit status. What roscpp throws
/// of names there, such as of two things that were given one name, is explained.
template <class Serve>
int runNode(int argc, char** argv, const NodeDescription& node, const Serve& serve) {
  if (const auto status = answerArguments(argc, argv, node)) return *status;
  const UnblockedOutput output;
  try {
    return serve();
  } catch (const ros::Exception& error) {
    return explain(node, error);
  }
}

}  // namespace cobot_command::nodes
