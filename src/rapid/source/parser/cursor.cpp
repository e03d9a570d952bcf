#include "parser/cursor.h"

#include <algorithm>
#include <utility>

namespace cobot_command::rapid {

Cursor::Cursor(std::string_view text, const Lexed& lexed, Dialect dialect, Findings& findings)
    : text_(text), lexed_(lexed), tokens_(lexed.tokens.data()), dialect_(dialect), findings_(findings) {
  if (!isTrivia(kind())) return;
  advance();
  previous_ = kNoToken;
}

const Token& Cursor::next() const {
  if (is(TokenKind::End)) return token();
  TokenIndex next = at_ + 1;
  while (isTrivia(tokens_[next].kind)) ++next;
  steps_ += next - at_;
  return tokens_[next];
}

std::string_view Cursor::text() const {
  return textOf(at_);
}

std::string_view Cursor::textOf(TokenIndex token) const {
  return text_.substr(tokens_[token].begin, tokens_[token].end - tokens_[token].begin);
}

void Cursor::advance() {
  if (is(TokenKind::End)) return;
  is_faulty_ = is_faulty_ || token().is_bad;
  previous_ = at_;
  ++at_;
  while (isTrivia(kind())) {
    is_faulty_ = is_faulty_ || is(TokenKind::Unknown);
    ++at_;
  }
  steps_ += at_ - previous_;
}

bool Cursor::take(TokenKind kind) {
  if (!is(kind)) return false;
  advance();
  return true;
}

void Cursor::reportExpected(std::string_view what) {
  if (is(TokenKind::End)) return report(kinds::kExpected, at_, what, "the end of the file");
  if (isReservedWord(kind())) return report(kinds::kExpected, at_, what, toString(kind()));
  report(kinds::kExpected, at_, what, "'" + quoted(text()) + "'");
}

void Cursor::reportNoSemicolon() {
  const std::uint32_t end = previous_ == kNoToken ? 0 : tokens_[previous_].end;
  reportAt(kinds::kNoSemicolon, {end, end});
}

void Cursor::reportReservedWord() {
  report(kinds::kReservedWord, at_, toString(kind()));
  reserved_word_ = at_;
}

bool Cursor::takeFaulty() {
  return std::exchange(is_faulty_, false);
}

bool Cursor::isEcho(std::uint32_t offset) const {
  const std::vector<FaultyLine>& lines = lexed_.faulty_lines;
  if (lines.empty() && reserved_word_ == kNoToken) return false;
  const std::uint32_t line = lineAt(lexed_.line_starts, offset);
  const auto found =
      std::lower_bound(lines.begin(), lines.end(), line,
                       [](const FaultyLine& left, std::uint32_t right) { return left.line < right; });
  if (found != lines.end() && found->line == line && found->first_error <= offset) return true;
  if (reserved_word_ == kNoToken) return false;
  const std::uint32_t word = tokens_[reserved_word_].begin;
  return word <= offset && word >= lexed_.line_starts[line];
}

}  // namespace cobot_command::rapid
