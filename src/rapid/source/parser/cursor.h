// The tokens as the grammar sees them, one after the other, and what is reported at them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lexer/lexer.h"
#include "reporting.h"

#include "cobot_command/rapid/source/dialect.h"
#include "cobot_command/rapid/source/finding.h"
#include "cobot_command/rapid/source/token.h"

namespace cobot_command::rapid {

class Cursor {
 public:
  /// All must live as long as the cursor. At the first token then.
  Cursor(std::string_view text, const Lexed& lexed, Dialect dialect, Findings& findings);

  [[nodiscard]] TokenKind kind() const { return token().kind; }
  [[nodiscard]] bool is(TokenKind kind) const { return token().kind == kind; }
  [[nodiscard]] bool startsLine() const { return token().startsLine(); }
  [[nodiscard]] TokenIndex index() const { return at_; }
  /// The token before; kNoToken at the beginning.
  [[nodiscard]] TokenIndex previous() const { return previous_; }
  /// The index of a Name here.
  [[nodiscard]] NameIndex name() const { return token().name; }
  /// The token after this one; after the last one End.
  [[nodiscard]] const Token& next() const;
  [[nodiscard]] TokenKind nextKind() const { return next().kind; }
  /// The kind of any token, also of one that advance() passes over.
  [[nodiscard]] TokenKind kindAt(TokenIndex token) const {
    ++steps_;
    return tokens_[token].kind;
  }
  /// The text of the token here.
  [[nodiscard]] std::string_view text() const;
  [[nodiscard]] std::string_view textOf(TokenIndex token) const;
  [[nodiscard]] Dialect dialect() const { return dialect_; }

  /// To the next token, over comments and unknown characters; not beyond End.
  void advance();
  /// Advances if the token is of this kind.
  bool take(TokenKind kind);

  // Findings. The place is a token; none is added as an echo of a lexical error, see FaultyLine.
  template <class... Values>
  void report(const FindingKind& kind, TokenIndex token, const Values&... values) {
    reportAt(kind, spanOf(token), values...);
  }
  /// E201, at the token here. `what`: "an expression", "THEN".
  void reportExpected(std::string_view what);
  /// E202, after the token before.
  void reportNoSemicolon();
  /// E109, at the token here: as lexical errors, it silences the rest of its line.
  void reportReservedWord();
  /// A finding that leaves its instruction usable (E203, E205).
  template <class... Values>
  void reportHarmless(const FindingKind& kind, TokenIndex token, const Values&... values) {
    const bool was_faulty = is_faulty_;
    report(kind, token, values...);
    is_faulty_ = was_faulty;
  }

  /// Whether an error was reported or passed since the last call.
  [[nodiscard]] bool takeFaulty();
  /// How many tokens were looked at; see Source::steps().
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  [[nodiscard]] const Token& token() const { return tokens_[at_]; }
  [[nodiscard]] Span spanOf(TokenIndex token) const { return {tokens_[token].begin, tokens_[token].end}; }
  [[nodiscard]] bool isEcho(std::uint32_t offset) const;

  template <class... Values>
  void reportAt(const FindingKind& kind, Span span, const Values&... values) {
    is_faulty_ = is_faulty_ || kind.id.front() == 'E';
    if (!isEcho(span.begin)) findings_.add(finding(kind, span, values...));
  }

  std::string_view text_;
  const Lexed& lexed_;
  const Token* tokens_;
  Dialect dialect_;
  Findings& findings_;
  TokenIndex at_ = 0;
  TokenIndex previous_ = kNoToken;
  TokenIndex reserved_word_ = kNoToken;  ///< the last one that was reported
  bool is_faulty_ = false;
  mutable std::uint64_t steps_ = 0;
};

}  // namespace cobot_command::rapid
