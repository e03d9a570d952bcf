#include "parser/recovery.h"

namespace cobot_command::rapid {

bool isAnchor(TokenKind kind) {
  switch (kind) {
    case TokenKind::And:
    case TokenKind::Div:
    case TokenKind::Do:
    case TokenKind::False:
    case TokenKind::From:
    case TokenKind::Inout:
    case TokenKind::Mod:
    case TokenKind::Nostepin:
    case TokenKind::Not:
    case TokenKind::Noview:
    case TokenKind::Or:
    case TokenKind::Readonly:
    case TokenKind::Step:
    case TokenKind::Sysmodule:
    case TokenKind::Then:
    case TokenKind::To:
    case TokenKind::True:
    case TokenKind::Viewonly:
    case TokenKind::With:
    case TokenKind::Xor:
      return false;
    default:
      return isReservedWord(kind);
  }
}

bool endsRoutine(const Cursor& cursor) {
  const auto begins = [](TokenKind kind) {
    return kind == TokenKind::Proc || kind == TokenKind::Func || kind == TokenKind::Trap;
  };
  switch (cursor.kind()) {
    case TokenKind::End:
    case TokenKind::Module:
    case TokenKind::Endmodule:
    case TokenKind::Endproc:
    case TokenKind::Endfunc:
    case TokenKind::Endtrap:
      return true;
    case TokenKind::Local:
      return begins(cursor.nextKind());
    default:
      return begins(cursor.kind());
  }
}

void recover(Cursor& cursor) {
  static_cast<void>(recoverHeader(cursor, TokenKind::Semicolon));
}

TokenKind recoverHeader(Cursor& cursor, TokenKind terminator) {
  while (!cursor.is(TokenKind::End)) {
    if (cursor.startsLine() && isAnchor(cursor.kind())) return TokenKind::End;
    const TokenKind kind = cursor.kind();
    cursor.advance();
    if (kind == terminator || kind == TokenKind::Semicolon) return kind;
  }
  return TokenKind::End;
}

void skipLine(Cursor& cursor) {
  while (!cursor.is(TokenKind::End) && !cursor.startsLine() && !isAnchor(cursor.kind())) cursor.advance();
}

TokenIndex takeName(Cursor& cursor, std::string_view what) {
  const TokenIndex name = cursor.index();
  if (cursor.is(TokenKind::Placeholder)) {
    cursor.report(kinds::kPlaceholder, name);
  } else if (isReservedWord(cursor.kind()) && !cursor.startsLine()) {
    cursor.reportReservedWord();
  } else if (!cursor.is(TokenKind::Name)) {
    cursor.reportExpected(what);
    return kNoToken;
  }
  cursor.advance();
  return name;
}

bool takeSemicolon(Cursor& cursor) {
  if (cursor.take(TokenKind::Semicolon)) return true;
  if (cursor.startsLine() || cursor.is(TokenKind::End) || isAnchor(cursor.kind())) {
    cursor.reportNoSemicolon();
    return true;
  }
  cursor.reportExpected("';'");
  return false;
}

bool isIrc5Word(const Cursor& cursor, TokenKind word) {
  return cursor.is(TokenKind::Name) && cursor.name() == static_cast<NameIndex>(word);
}

}  // namespace cobot_command::rapid
