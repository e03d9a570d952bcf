#include "finding_text.h"

#include <algorithm>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/utf8.h"

namespace cobot_command::tools {

namespace {

// Of a long line [bytes]
constexpr std::size_t kShownBefore = 60;
constexpr std::size_t kShownAfter = 60;

/// The start of a character, at `at` or before it.
std::size_t atCharacter(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && !beginsCharacter(text[at])) --at;
  return std::min(at, text.size());
}

}  // namespace

std::vector<std::string> findingLines(const rapid::Source& source, const rapid::Finding& finding,
                                      std::string_view file) {
  const std::string_view line = source.lineAround(finding.span.begin);
  if (line.empty()) return {describe(source, finding, file)};
  const auto place = static_cast<std::size_t>(source.text().data() + finding.span.begin - line.data());
  const std::size_t first = place > kShownBefore ? atCharacter(line, place - kShownBefore) : 0;
  const std::size_t end = std::max(place, atCharacter(line, place + kShownAfter));
  const std::string before = (first > 0 ? "..." : "") + escaped(line.substr(first, place - first));
  const std::string after = escaped(line.substr(place, end - place)) + (end < line.size() ? "..." : "");
  return {describe(source, finding, file), before + after, std::string(countCharacters(before), ' ') + '^'};
}

}  // namespace cobot_command::tools
