#include "node_arguments.h"

#include <cstdio>
#include <string_view>

#include "node_names.h"
#include <fmt/format.h>

#include "cobot_command/capabilities/layer_version.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::nodes {
namespace {

constexpr std::size_t kReasonLimit = 600;  // [bytes]; roscpp tells types with their sums

std::string usageOf(const NodeDescription& node) {
  return fmt::format(
      "usage: {} [name:=value...]\n{}\n"
      "  _parameter:=value  a private parameter, such as {}; doc/parameters.md lists them\n"
      "  topic:=other       another name for a topic, service or action; __name:= and __ns:= for the node\n",
      node.name, node.purpose, node.example);
}

}  // namespace

std::optional<int> answerArguments(int argc, const char* const* argv, const NodeDescription& node) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--help" || word == "-h") {
      fmt::print("{}", usageOf(node));
      return 0;
    }
    if (word == "--version") {
      fmt::print("{} (cobot_command) {}\n", node.name, capabilities::layerVersion());
      return 0;
    }
    if (word.find(":=") == std::string_view::npos) {
      fmt::print(stderr, "'{}' is not an argument of a node; allowed: name:=value, --help, --version\n{}",
                 foreignText(word), usageOf(node));
      return 2;
    }
  }
  if (const auto fault = faultInNames(argc, argv, ofProcess)) {
    fmt::print(stderr, "{}: {}\n", node.name, forPeople(*fault));
    return 2;
  }
  return std::nullopt;
}

int explain(const NodeDescription& node, const std::exception& error) {
  fmt::print(stderr,
             "{}: a name of this node cannot be used: {}. Change the remapping (name:=other, <remap>, "
             "__name, __ns)\n",
             node.name, foreignText(error.what(), kReasonLimit));
  return 2;
}

}  // namespace cobot_command::nodes
