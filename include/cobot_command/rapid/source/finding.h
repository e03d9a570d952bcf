// What is wrong with a source text, as data. A program prints it, an editor underlines it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::rapid {

enum class Severity : std::uint8_t { Warning, Error };

/// "warning", "error".
[[nodiscard]] std::string_view toString(Severity severity);

/// Bytes of a source text, as offsets in Source::text().
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;  ///< after the last byte; equal to begin where something is missing
};

struct Finding {
  std::string_view id;  ///< "E201", "W217"; a literal
  Span span;
  std::string text;  ///< one bounded line, without control characters; quotes from the file are in it

  [[nodiscard]] Severity severity() const { return id.front() == 'W' ? Severity::Warning : Severity::Error; }
};

/// The findings of one file: in the order of the text, each id once at a position, at most kMostFindings and,
/// if there are more, E903 at the first one that is left out. Its memory is bounded, whatever is added.
class Findings {
 public:
  void add(Finding finding);
  /// The list; no more can be added.
  [[nodiscard]] std::vector<Finding> take();

 private:
  void sortAndCut();

  std::vector<Finding> found_;
};

}  // namespace cobot_command::rapid
