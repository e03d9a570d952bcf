// The smallest parts of a source text.
//
// All tokens of a file are in one vector, comments included, in the order of the text. A token has no text of
// its own: Source::textOf() returns it.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace cobot_command::rapid {

enum class TokenKind : std::uint8_t {
  // The reserved words come first. A word's value is its index in the NameTable of each source.
  Alias,
  And,
  Backward,
  Case,
  Connect,
  Const,
  Default,
  Div,
  Do,
  Else,
  Elseif,
  Endfor,
  Endfunc,
  Endif,
  Endmodule,
  Endproc,
  Endrecord,
  Endtest,
  Endtrap,
  Endwhile,
  Error,
  Exit,
  False,
  For,
  From,
  Func,
  Goto,
  If,
  Inout,
  Local,
  Mod,
  Module,
  Nostepin,
  Not,
  Noview,
  Or,
  Pers,
  Proc,
  Raise,
  Readonly,
  Record,
  Retry,
  Return,
  Step,
  Sysmodule,
  Test,
  Then,
  To,
  Trap,
  True,
  Trynext,
  Var,
  Viewonly,
  While,
  With,
  Xor,
  Task,  ///< in irc5 only; in s4c it is a Name
  Undo,  ///< in irc5 only; in s4c it is a Name

  Name,
  Number,
  Text,         ///< with its quotes
  Placeholder,  ///< `<SMT>`
  HeaderMark,   ///< `%%%`
  Comment,      ///< from `!`, without the blanks at the end of its line
  Unknown,      ///< one or more characters that mean nothing in RAPID

  Semicolon,
  Colon,
  Comma,
  Dot,
  Assign,  ///< `:=`
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Plus,
  Minus,
  Star,
  Slash,
  Backslash,
  Bar,
  Question,
  Percent,
  LeftParenthesis,
  RightParenthesis,
  LeftBracket,
  RightBracket,
  LeftBrace,
  RightBrace,

  End,  ///< after the last character; the last token of each source
};

inline constexpr int kReservedWords = static_cast<int>(TokenKind::Undo) + 1;

[[nodiscard]] constexpr bool isReservedWord(TokenKind kind) {
  return static_cast<int>(kind) < kReservedWords;
}
/// Tokens that the grammar does not see.
[[nodiscard]] constexpr bool isTrivia(TokenKind kind) {
  return kind == TokenKind::Comment || kind == TokenKind::Unknown;
}

/// A reserved word in capitals, or a sign: "ENDIF", ":=". Empty for the kinds whose text differs.
[[nodiscard]] std::string_view toString(TokenKind kind);

/// Index of a name in the NameTable of its source. Names that differ only in case have one index.
using NameIndex = std::uint32_t;
/// Index of a token in Source::tokens().
using TokenIndex = std::uint32_t;
inline constexpr TokenIndex kNoToken = std::numeric_limits<TokenIndex>::max();

struct Token {
  std::uint32_t begin = 0;  ///< offset in Source::text() [bytes]
  std::uint32_t end = 0;    ///< offset after the last byte
  NameIndex name = 0;       ///< of a Name
  TokenKind kind = TokenKind::End;
  /// Line ends between the token before and this one: 0, 1, or 2 for two and more. 1 for the first token.
  std::uint8_t lines_before = 0;
  bool is_bad = false;  ///< a lexical error makes the value unusable (E103, E104, E106)

  [[nodiscard]] bool startsLine() const { return lines_before > 0; }
};
static_assert(sizeof(Token) == 16);

}  // namespace cobot_command::rapid
