#include "file_frame.h"

#include <charconv>

#include <fmt/format.h>

namespace cobot_command::tables {
namespace {

constexpr std::string_view kBlanks = " \t";

/// The words of the line; what is after # is a comment.
struct Words {
  std::string_view first;
  std::string_view rest;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

Words wordsOf(std::string_view line) {
  const std::string_view text = trimmed(line.substr(0, line.find('#')));
  const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
  return {text.substr(0, end), trimmed(text.substr(end))};
}

std::string cut(const std::string& found, std::size_t entries) {
  return fmt::format(
      "{}: the file is truncated. Restore it from a copy; or, if its entries ({}) are complete, make \"{} "
      "{}\" its last line",
      found, entries, kLastLine, entries);
}

}  // namespace

bool FileFrame::isPart(std::string_view line) {
  const std::string_view first = wordsOf(line).first;
  return first == kFirstLine || first == kLastLine;
}

std::optional<std::string> FileFrame::take(std::string_view line) {
  const Words words = wordsOf(line);
  if (has_end_) return fmt::format("only comments may follow the line \"{}\"", kLastLine);
  if (words.first == kLastLine) return takeEnd(words.rest);
  if (!words.rest.empty()) return fmt::format("nothing may follow \"{}\" in its line", kFirstLine);
  if (has_begin_ || entries_ > 0) {
    return fmt::format("\"{}\" must occur once, before all entries", kFirstLine);
  }
  has_begin_ = true;
  return std::nullopt;
}

std::optional<std::string> FileFrame::takeEnd(std::string_view number) {
  std::size_t count = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), count);
  if (read.ec != std::errc() || read.ptr != number.data() + number.size()) {
    return fmt::format("\"{}\" must be followed by the number of the entries, here {}", kLastLine, entries_);
  }
  if (count != entries_) {
    return cut(fmt::format("the number of entries before it is not this, but {}", entries_), entries_);
  }
  has_end_ = true;
  return std::nullopt;
}

std::optional<std::string> FileFrame::takeEntry() {
  if (has_end_) {
    return fmt::format("entries must be before the line \"{}\", which has their number", kLastLine);
  }
  ++entries_;
  return std::nullopt;
}

std::optional<std::string> FileFrame::whatIsMissing(bool last_has_end) const {
  if (has_end_) return std::nullopt;
  if (has_begin_) return cut(fmt::format("after it the line \"{} N\" is missing", kLastLine), entries_);
  if (entries_ == 0) return cut("there is no entry", entries_);
  if (!last_has_end) return cut("it ends in the middle of this line", entries_);
  return std::nullopt;
}

}  // namespace cobot_command::tables
