#include "table_scanner.h"

#include <charconv>

#include <fmt/format.h>

namespace cobot_command::tables {
namespace {

/// They mean something in an entry, so a name with one of them stands in quotes.
constexpr std::string_view kMarks = ":,@#=\"";
/// Numbers begin so, and names without quotes do not: six numbers of which one is missing are no name.
constexpr std::string_view kBeginOfNumber = "+-.0123456789";

bool isOneOf(char c, std::string_view characters) {
  return characters.find(c) != std::string_view::npos;
}

class Scanner {
 public:
  Scanner(std::string_view text, EntryEnd end, std::size_t before)
      : text_(text), end_(end), before_(before) {}

  Result<EntryText, std::string> entry();

 private:
  bool parts(EntryText& entry);
  bool value(EntryText& entry);
  bool number(double& value);
  bool whole(int& value, const char* what);
  bool name(std::string& name);
  bool quoted(std::string& name);

  bool fails(std::string reason) {
    reason_ = fmt::format("at character {}: {}", before_ + at_ + 1, reason);
    return false;
  }
  [[nodiscard]] bool ends() const {
    return at_ == text_.size() || (end_ == EntryEnd::TextOrComment && text_[at_] == '#');
  }
  void skipBlanks() {
    while (at_ < text_.size() && isOneOf(text_[at_], " \t")) ++at_;
  }
  /// That character, and the blanks around it.
  bool takes(char c) {
    skipBlanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skipBlanks();
    return true;
  }

  std::string_view text_;
  EntryEnd end_;
  std::size_t before_;
  std::size_t at_ = 0;
  std::string reason_;
};

bool Scanner::whole(int& value, const char* what) {
  const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (read.ec != std::errc()) return fails(fmt::format("expected {}, a whole number", what));
  at_ = static_cast<std::size_t>(read.ptr - text_.data());
  return true;
}

bool Scanner::number(double& value) {
  if (at_ < text_.size() && text_[at_] == '+') ++at_;
  const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (read.ec != std::errc()) return fails("expected a number");
  at_ = static_cast<std::size_t>(read.ptr - text_.data());
  skipBlanks();
  return true;
}

bool Scanner::quoted(std::string& name) {
  for (++at_; at_ < text_.size(); ++at_) {
    if (text_[at_] == '"') {
      ++at_;
      if (at_ == text_.size() || text_[at_] != '"') return true;
    }
    name += text_[at_];
  }
  return fails("the quotes of the name are not closed");
}

bool Scanner::name(std::string& name) {
  if (text_[at_] == '"') return quoted(name);
  const std::size_t begin = at_;
  while (at_ < text_.size() && !isOneOf(text_[at_], kMarks)) ++at_;
  std::size_t last = at_;
  while (last > begin && isOneOf(text_[last - 1], " \t")) --last;
  name = text_.substr(begin, last - begin);
  return !name.empty() || fails("expected a name or a number");
}

bool Scanner::value(EntryText& entry) {
  if (ends()) return fails("expected a name, numbers, or both with : between them");
  if (!isOneOf(text_[at_], kBeginOfNumber)) {
    entry.name.emplace();
    if (!name(*entry.name)) return false;
    if (!takes(':')) return true;
  }
  do {
    if (!number(entry.numbers.emplace_back())) return false;
  } while (takes(','));
  return true;
}

bool Scanner::parts(EntryText& entry) {
  skipBlanks();
  if (!whole(entry.index, "the number of the entry")) return false;
  if (!takes('=')) return fails("expected = after the number of the entry");
  if (!value(entry)) return false;
  if (takes('@') && !whole(entry.refers_to.emplace(), "the number after @")) return false;
  skipBlanks();
  if (ends()) return true;
  return fails(entry.name && entry.numbers.empty()
                   ? "expected : or @ or nothing after a name; a name that has one of :,@#= in it, or that "
                     "begins like a number, must be in \""
                   : "expected the end of the entry");
}

Result<EntryText, std::string> Scanner::entry() {
  EntryText entry;
  if (!parts(entry)) return refuse(reason_);
  return entry;
}

}  // namespace

Result<EntryText, std::string> scanEntry(std::string_view text, EntryEnd end, std::size_t before) {
  return Scanner(text, end, before).entry();
}

bool isBareName(std::string_view name) {
  return !name.empty() && name.front() != ' ' && name.back() != ' ' &&
         !isOneOf(name.front(), kBeginOfNumber) && name.find_first_of(kMarks) == std::string_view::npos;
}

}  // namespace cobot_command::tables
