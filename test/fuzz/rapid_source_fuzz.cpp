// Any bytes as a RAPID file, in both dialects: findings within the limits, a tree whose nodes are within the
// text, and work in proportion to the tokens.
#include <cstdint>
#include <string_view>

#include "require.h"

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/source/limits.h"
#include "cobot_command/rapid/source/source.h"

using namespace cobot_command;
using namespace cobot_command::rapid;

namespace {

void checkFindings(const Source& source) {
  REQUIRE(source.findings().size() <= kMostFindings + 1);
  for (const Finding& finding : source.findings()) {
    REQUIRE(finding.span.begin <= finding.span.end && finding.span.end <= source.text().size());
    const std::string line = describe(source, finding, "a.mod");
    REQUIRE(line.size() < 500 && line == escaped(line));
  }
}

/// The depth is bounded, so this recursion is.
void checkNode(const Source& source, NodeIndex node, int depth) {
  REQUIRE(depth < 5 * kMostNesting);
  const Span span = source.spanOf(node);
  REQUIRE(span.begin <= span.end && span.end <= source.text().size());
  static_cast<void>(source.nameOf(node));
  for (const NodeIndex child : source.tree().children(node)) checkNode(source, child, depth + 1);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const Dialect dialect : {Dialect::Irc5, Dialect::S4c}) {
    const Source source = readSource(bytes, {dialect});
    checkFindings(source);
    checkNode(source, Tree::kRoot, 0);
    REQUIRE(source.steps() <= 4 * source.tokens().size());
    REQUIRE(source.tree().size() <= 2 * source.tokens().size() + 1);
  }
  static_cast<void>(readSource(bytes, {Dialect::Irc5, false}));
  return 0;
}
