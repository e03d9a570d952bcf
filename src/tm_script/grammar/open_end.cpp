#include "cobot_command/tm_script/open_end.h"

#include <algorithm>
#include <vector>

#include "grammar/source_lines.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

constexpr std::string_view kOpening = "([{";
constexpr std::string_view kClosing = ")]}";

struct Bracket {
  char sign = '(';
  int line = 0;
};

/// Goes through the lines without their comments.
class Brackets {
 public:
  /// Is a text in quotes still open at the end of the line?
  bool leavesTextOpen(const SourceLine& line) {
    bool in_quotes = false;
    for (const char sign : line.text) {
      if (sign == '"') in_quotes = !in_quotes;
      if (!in_quotes) see({sign, line.number});
    }
    return in_quotes;
  }

  /// The outermost that nothing closed.
  [[nodiscard]] std::optional<Bracket> open() const {
    return open_.empty() ? std::nullopt : std::optional(open_.front());
  }

 private:
  void see(const Bracket& found) {
    if (kOpening.find(found.sign) != std::string_view::npos) open_.push_back(found);
    const std::size_t kind = kClosing.find(found.sign);
    const bool closes =
        kind != std::string_view::npos && !open_.empty() && open_.back().sign == kOpening[kind];
    if (closes) open_.pop_back();
  }

  std::vector<Bracket> open_;
};

}  // namespace

std::optional<std::string> openEndOf(std::string_view script) {
  const SourceLines source = splitLines(script);
  Brackets brackets;
  for (const SourceLine& line : source.lines) {
    if (brackets.leavesTextOpen(line)) {
      return fmt::format("the text that begins in line {} with \" is not closed in it", line.number);
    }
  }
  if (source.open_comment) {
    return fmt::format("the comment that begins in line {} with /* is not closed", *source.open_comment);
  }
  const auto open = brackets.open();
  if (open) return fmt::format("the bracket {} of line {} is not closed", open->sign, open->line);
  return std::nullopt;
}

}  // namespace cobot_command::tm_script
