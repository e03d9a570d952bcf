#include "node_arguments.h"

#include <cstdio>
#include <string_view>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::nodes {
namespace {

std::string usageOf(const NodeDescription& node) {
  return fmt::format(
      "usage: {} [name:=value...]\n{}\n"
      "  _parameter:=value  a private parameter, such as {}; the README has all of them\n"
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
    if (word.find(":=") == std::string_view::npos) {
      fmt::print(stderr, "'{}' is nothing that a node is started with; allowed: name:=value, --help\n{}",
                 foreignText(word), usageOf(node));
      return 2;
    }
  }
  return std::nullopt;
}

}  // namespace cobot_command::nodes
