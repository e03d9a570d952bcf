#include "grammar/source_lines.h"

#include <algorithm>

namespace cobot_command::tm_script {

namespace {

class Splitter {
 public:
  SourceLines split(std::string_view script) {
    lines_.push_back({1, ""});
    while (!script.empty()) script.remove_prefix(take(script));
    return {std::move(lines_), comment_begin_};
  }

 private:
  /// Takes what stands at the front, and gives its length.
  std::size_t take(std::string_view rest) {
    std::string& line = lines_.back().text;
    if (rest.front() == '\n') return endLine();
    if (comment_begin_) return rest.substr(0, 2) == "*/" ? leaveComment() : 1;
    if (!in_quotes_ && rest.substr(0, 2) == "//") return std::min(rest.find('\n'), rest.size());
    if (!in_quotes_ && rest.substr(0, 2) == "/*") {
      comment_begin_ = lines_.back().number;
      line += ' ';
      return 2;
    }
    if (rest.front() == '"') in_quotes_ = !in_quotes_;
    line += rest.front();
    return 1;
  }

  std::size_t endLine() {
    std::string& line = lines_.back().text;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    in_quotes_ = false;
    lines_.push_back({lines_.back().number + 1, ""});
    return 1;
  }

  std::size_t leaveComment() {
    comment_begin_.reset();
    return 2;
  }

  std::vector<SourceLine> lines_;
  bool in_quotes_ = false;
  std::optional<int> comment_begin_;  // its line, while in one
};

}  // namespace

SourceLines splitLines(std::string_view script) {
  return Splitter().split(script);
}

}  // namespace cobot_command::tm_script
