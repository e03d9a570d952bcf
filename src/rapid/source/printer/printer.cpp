#include "cobot_command/rapid/source/printer.h"

#include <utility>

#include "printer/layout.h"
#include "printer/speller.h"

namespace cobot_command::rapid {

namespace {

using Mark = MarkedToken::Mark;

bool endsOperand(TokenKind kind) {
  switch (kind) {
    case TokenKind::Name:
    case TokenKind::Number:
    case TokenKind::Text:
    case TokenKind::Placeholder:
    case TokenKind::True:
    case TokenKind::False:
    case TokenKind::RightParenthesis:
    case TokenKind::RightBracket:
    case TokenKind::RightBrace:
      return true;
    default:
      return false;
  }
}

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
}

/// No blank before it.
bool joinsLeft(TokenKind kind) {
  switch (kind) {
    case TokenKind::Semicolon:
    case TokenKind::Comma:
    case TokenKind::RightParenthesis:
    case TokenKind::RightBracket:
    case TokenKind::RightBrace:
    case TokenKind::LeftBrace:
    case TokenKind::Dot:
    case TokenKind::Colon:
    case TokenKind::Bar:
    case TokenKind::Question:
    case TokenKind::Assign:
    case TokenKind::Backslash:
      return true;
    default:
      return false;
  }
}

/// No blank after it.
bool joinsRight(TokenKind kind) {
  switch (kind) {
    case TokenKind::LeftParenthesis:
    case TokenKind::LeftBracket:
    case TokenKind::LeftBrace:
    case TokenKind::Comma:
    case TokenKind::Dot:
    case TokenKind::Colon:
    case TokenKind::Bar:
    case TokenKind::Question:
    case TokenKind::Assign:
    case TokenKind::Backslash:
      return true;
    default:
      return false;
  }
}

/// Takes the elements of a list one after the other, as the walk over the tokens reaches them.
template <class Element>
class InOrder {
 public:
  explicit InOrder(std::vector<Element> elements) : elements_(std::move(elements)) {}

  /// The one of this token; nullptr if there is none.
  const Element* take(TokenIndex token) {
    const bool is_here = next_ < elements_.size() && elements_[next_].token == token;
    return is_here ? &elements_[next_++] : nullptr;
  }

 private:
  std::vector<Element> elements_;
  std::size_t next_ = 0;
};

class Printer {
 public:
  Printer(const Source& source, const PredefinedNames& predefined)
      : source_(source),
        tokens_(source.tokens()),
        line_end_(toString(source.lineEnd())),
        spellings_(spellingsOf(source, predefined)) {
    Layout layout = layoutOf(source);
    lines_ = InOrder(std::move(layout.lines));
    marked_ = InOrder(std::move(layout.marked));
    printed_.reserve(source.text().size() + source.text().size() / 4);
  }

  std::string run() {
    TokenIndex at = 0;
    while (true) {
      const TokenIndex comments = at;
      while (tokens_[at].kind == TokenKind::Comment) ++at;
      const LineStart* const line = lines_.take(at);
      const TokenIndex raised =
          line != nullptr && line->kind == LineStart::Kind::Routine ? aboveRoutine(comments, at) : kNoToken;
      for (TokenIndex token = comments; token < at; ++token) comment(token, line, token == raised);
      if (tokens_[at].kind == TokenKind::End) break;
      code(at, line, at == raised);
      ++at;
    }
    if (!printed_.empty()) printed_ += line_end_;
    return std::move(printed_);
  }

 private:
  /// The first of the comments directly above a routine, or the routine itself.
  [[nodiscard]] TokenIndex aboveRoutine(TokenIndex comments, TokenIndex routine) const {
    TokenIndex first = routine;
    while (first > comments && tokens_[first].lines_before == 1 && tokens_[first - 1].startsLine()) --first;
    return first;
  }

  void startLine(int level, bool has_blank_line) {
    if (!printed_.empty()) {
      printed_ += line_end_;
      if (has_blank_line) printed_ += line_end_;
    }
    printed_.append(2 * static_cast<std::size_t>(level), ' ');
  }

  [[nodiscard]] bool hasBlankLine(TokenIndex token) const { return tokens_[token].lines_before > 1; }

  /// `line`: the one that the next code begins; nullptr if it is within a line.
  void comment(TokenIndex token, const LineStart* line, bool is_raised) {
    if (tokens_[token].startsLine()) {
      const int deeper = line != nullptr && line->kind == LineStart::Kind::Closing ? 1 : 0;
      startLine(line != nullptr ? line->level + deeper : level_ + 1, is_raised || hasBlankLine(token));
    } else {
      printed_ += ' ';
    }
    printed_ += source_.textOf(token);
    is_after_comment_ = true;
  }

  void code(TokenIndex token, const LineStart* line, bool is_raised) {
    const MarkedToken* const marked = marked_.take(token);
    const bool is_sign = isSign(token);
    if (line != nullptr) {
      // The blank line of a routine is above its comments.
      const bool is_routine = line->kind == LineStart::Kind::Routine;
      level_ = line->level;
      startLine(level_, is_raised || (!is_routine && hasBlankLine(token)));
    } else if (is_after_comment_) {
      startLine(level_ + 1, false);
    } else if (hasBlank(token, marked)) {
      printed_ += ' ';
    }
    append(token);
    is_after_comment_ = false;
    before_ = token;
    mark_before_ = marked;
    is_sign_before_ = is_sign;
  }

  [[nodiscard]] bool isAfter(Mark mark) const {
    return mark_before_ != nullptr && mark_before_->mark == mark;
  }

  /// Plus or minus before an operand, not between two.
  [[nodiscard]] bool isSign(TokenIndex token) const {
    const bool is_one = tokens_[token].kind == TokenKind::Plus || tokens_[token].kind == TokenKind::Minus;
    return is_one && (isAfter(Mark::Procedure) || !endsOperand(tokens_[before_].kind));
  }

  /// Between the token before and this one, in a line.
  [[nodiscard]] bool hasBlank(TokenIndex token, const MarkedToken* marked) const {
    const TokenKind before = tokens_[before_].kind;
    const TokenKind kind = tokens_[token].kind;
    const bool is_joined_before = joinsRight(before) || is_sign_before_ || isAfter(Mark::OpeningPercent);
    const bool is_closing = marked != nullptr && marked->mark == Mark::ClosingPercent;
    const bool is_list =
        kind == TokenKind::LeftParenthesis && before == TokenKind::Name && !isAfter(Mark::Procedure);
    return !is_joined_before && !is_closing && !is_list && !joinsLeft(kind);
  }

  void append(TokenIndex token) {
    const TokenKind kind = tokens_[token].kind;
    if (const Spelling* const spelling = spellings_.take(token)) {
      printed_ += spelling->text;
    } else if (isReservedWord(kind)) {
      printed_ += toString(kind);
    } else if (kind == TokenKind::Placeholder) {
      for (const char c : source_.textOf(token)) printed_ += capital(c);
    } else {
      printed_ += source_.textOf(token);
    }
  }

  const Source& source_;
  const std::vector<Token>& tokens_;
  std::string_view line_end_;
  InOrder<Spelling> spellings_;
  InOrder<LineStart> lines_{std::vector<LineStart>()};
  InOrder<MarkedToken> marked_{std::vector<MarkedToken>()};
  std::string printed_;
  int level_ = 0;
  bool is_after_comment_ = false;
  TokenIndex before_ = 0;
  const MarkedToken* mark_before_ = nullptr;
  bool is_sign_before_ = false;
};

}  // namespace

std::string print(const Source& source, const PredefinedNames& predefined) {
  return Printer(source, predefined).run();
}

}  // namespace cobot_command::rapid
