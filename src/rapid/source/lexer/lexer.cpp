#include "lexer/lexer.h"

#include <algorithm>
#include <array>

#include "lexer/character_class.h"
#include "lexer/number_scan.h"
#include "lexer/text_scan.h"
#include "reporting.h"

#include "cobot_command/common/utf8.h"
#include "cobot_command/rapid/source/limits.h"
#include "cobot_command/rapid/source/literals.h"

namespace cobot_command::rapid {

namespace {

/// The signs of one character.
constexpr std::array<TokenKind, 256> kSigns = [] {
  std::array<TokenKind, 256> signs{};
  const auto set = [&signs](char c, TokenKind kind) { signs[static_cast<unsigned char>(c)] = kind; };
  set(';', TokenKind::Semicolon);
  set(',', TokenKind::Comma);
  set('=', TokenKind::Equal);
  set('+', TokenKind::Plus);
  set('-', TokenKind::Minus);
  set('*', TokenKind::Star);
  set('/', TokenKind::Slash);
  set('\\', TokenKind::Backslash);
  set('|', TokenKind::Bar);
  set('?', TokenKind::Question);
  set('(', TokenKind::LeftParenthesis);
  set(')', TokenKind::RightParenthesis);
  set('[', TokenKind::LeftBracket);
  set(']', TokenKind::RightBracket);
  set('{', TokenKind::LeftBrace);
  set('}', TokenKind::RightBrace);
  return signs;
}();

class Lexer {
 public:
  Lexer(std::string_view text, Dialect dialect, NameTable& names, Findings& findings)
      : text_(text), dialect_(dialect), names_(names), findings_(findings) {
    lexed_.tokens.reserve(text.size() / 2 + 1);  // dense ones have 2.3 bytes a token
    lexed_.line_starts.push_back(0);
  }

  Lexed run() {
    while (at_ < text_.size()) step();
    push(TokenKind::End, at_);
    return std::move(lexed_);
  }

 private:
  void step() {
    switch (classOf(text_[at_])) {
      case CharacterClass::Blank:
        ++at_;
        return;
      case CharacterClass::LineEnd:
        return lineEnd();
      case CharacterClass::Letter:
        return name();
      case CharacterClass::Latin:
        return isLatinLetter(peek(1)) ? name() : unknown();
      case CharacterClass::Digit:
        return number();
      case CharacterClass::Dot:
        return classOf(peek(1)) == CharacterClass::Digit ? number() : push(TokenKind::Dot, at_ + 1);
      case CharacterClass::Quote:
        return text();
      case CharacterClass::Comment:
        return comment();
      case CharacterClass::Sign:
        return sign();
      case CharacterClass::Underscore:
      case CharacterClass::Unknown:
        return unknown();
    }
  }

  [[nodiscard]] char peek(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  /// Up to `end`, and goes there.
  void push(TokenKind kind, std::size_t end, bool is_bad = false, NameIndex name_index = 0) {
    lexed_.tokens.push_back({static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end), name_index,
                             kind, lines_before_, is_bad});
    lines_before_ = 0;
    at_ = end;
  }

  template <class... Values>
  void report(const FindingKind& kind, std::size_t begin, std::size_t end, const Values&... values) {
    const Span span{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    findings_.add(finding(kind, span, values...));
    const auto line = static_cast<std::uint32_t>(lexed_.line_starts.size() - 1);
    std::vector<FaultyLine>& lines = lexed_.faulty_lines;
    if (!lines.empty() && lines.back().line == line) {
      lines.back().first_error = std::min(lines.back().first_error, span.begin);
    } else if (lines.size() <= kMostFindings) {
      lines.push_back({line, span.begin});
    }
  }

  void lineEnd() {
    at_ += text_[at_] == '\r' && peek(1) == '\n' ? 2 : 1;
    lexed_.line_starts.push_back(static_cast<std::uint32_t>(at_));
    if (lines_before_ < 2) ++lines_before_;
  }

  void name() {
    std::size_t end = at_;
    while (end < text_.size()) {
      const CharacterClass next = classOf(text_[end]);
      const bool is_latin =
          next == CharacterClass::Latin && end + 1 < text_.size() && isLatinLetter(text_[end + 1]);
      if (is_latin) {
        end += 2;
      } else if (next == CharacterClass::Letter || next == CharacterClass::Digit ||
                 next == CharacterClass::Underscore) {
        ++end;
      } else {
        break;
      }
    }
    const std::string_view written = text_.substr(at_, end - at_);
    const NameIndex index = names_.add(written);
    if (isWord(index)) return push(static_cast<TokenKind>(index), end);
    const std::size_t allowed = lettersAllowedBy(dialect_);
    if (written.size() > allowed && countCharacters(written) > allowed) {
      report(kinds::kLongName, at_, end, quoted(written), countCharacters(written), toString(dialect_),
             allowed);
    }
    push(TokenKind::Name, end, false, index);
  }

  [[nodiscard]] bool isWord(NameIndex index) const {
    constexpr auto kTask = static_cast<NameIndex>(TokenKind::Task);
    return index < (dialect_ == Dialect::S4c ? kTask : static_cast<NameIndex>(kReservedWords));
  }

  void number() {
    const NumberScan scan = scanNumber(text_.substr(at_), dialect_);
    const std::string_view written = text_.substr(at_, scan.size);
    if (!scan.is_number) {
      report(kinds::kNoNumber, at_, at_ + scan.size, quoted(written));
    } else if (scan.can_overflow && !numberValue(written)) {
      report(kinds::kLargeNumber, at_, at_ + scan.size, quoted(written));
    }
    push(TokenKind::Number, at_ + scan.size, !scan.is_number);
  }

  void text() {
    const TextScan scan = scanText(text_.substr(at_));
    const bool is_long = scan.is_closed && scan.characters > kMostTextCharacters;
    if (!scan.is_closed) report(kinds::kOpenText, at_, at_ + scan.size);
    if (is_long) {
      report(kinds::kLongText, at_, at_ + scan.size, scan.characters, kMostTextCharacters);
    }
    for (const Span& code : scan.bad_codes) {
      const std::string_view written = text_.substr(at_ + code.begin, code.end - code.begin);
      report(kinds::kCharacterCode, at_ + code.begin, at_ + code.end, quoted(written));
    }
    push(TokenKind::Text, at_ + scan.size, is_long || !scan.is_closed);
  }

  void comment() {
    const std::size_t line_end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::size_t end = text_.find_last_not_of(" \t\f", line_end - 1) + 1;
    push(TokenKind::Comment, end);
    at_ = line_end;
  }

  /// Adjacent ones are one finding: one for each character of a word in Greek would hide all others.
  void unknown() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && !beginsCharacter(text_[end])) ++end;
    std::vector<Token>& tokens = lexed_.tokens;
    if (!tokens.empty() && tokens.back().kind == TokenKind::Unknown && tokens.back().end == at_) {
      tokens.back().end = static_cast<std::uint32_t>(end);
      at_ = end;
      return;
    }
    report(kinds::kUnknownCharacter, at_, end, quoted(text_.substr(at_, end - at_)));
    push(TokenKind::Unknown, end);
  }

  void sign() {
    const char next = peek(1);
    switch (text_[at_]) {
      case ':':
        return next == '=' ? push(TokenKind::Assign, at_ + 2) : push(TokenKind::Colon, at_ + 1);
      case '<':
        if (const std::size_t size = placeholderSize()) return push(TokenKind::Placeholder, at_ + size);
        if (next == '>') return push(TokenKind::NotEqual, at_ + 2);
        return next == '=' ? push(TokenKind::LessEqual, at_ + 2) : push(TokenKind::Less, at_ + 1);
      case '>':
        return next == '=' ? push(TokenKind::GreaterEqual, at_ + 2) : push(TokenKind::Greater, at_ + 1);
      case '%':
        return next == '%' && peek(2) == '%' ? push(TokenKind::HeaderMark, at_ + 3)
                                             : push(TokenKind::Percent, at_ + 1);
      default:
        return push(kSigns[static_cast<unsigned char>(text_[at_])], at_ + 1);
    }
  }

  /// 0 if there is none.
  [[nodiscard]] std::size_t placeholderSize() const {
    static constexpr std::array<std::string_view, 13> kWords{"tdn", "ddn", "rdn", "par", "alt", "dim", "smt",
                                                             "var", "eit", "cse", "exp", "arg", "id"};
    const std::size_t close = text_.substr(at_, 5).find('>');
    if (close == std::string_view::npos) return 0;
    const std::string word = folded(text_.substr(at_ + 1, close - 1));
    return std::find(kWords.begin(), kWords.end(), word) == kWords.end() ? 0 : close + 1;
  }

  std::string_view text_;
  Dialect dialect_;
  NameTable& names_;
  Findings& findings_;
  Lexed lexed_;
  std::size_t at_ = 0;
  std::uint8_t lines_before_ = 1;
};

}  // namespace

Lexed lex(std::string_view text, Dialect dialect, NameTable& names, Findings& findings) {
  return Lexer(text, dialect, names, findings).run();
}

std::uint32_t lineAt(const std::vector<std::uint32_t>& line_starts, std::uint32_t offset) {
  const auto after = std::upper_bound(line_starts.begin(), line_starts.end(), offset);
  return static_cast<std::uint32_t>(after - line_starts.begin() - 1);
}

}  // namespace cobot_command::rapid
