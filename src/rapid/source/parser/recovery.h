// Where reading continues after a syntax error.
#pragma once

#include <string_view>

#include "parser/cursor.h"

namespace cobot_command::rapid {

/// Words that begin or end a declaration, an instruction or a part of one. At the start of a line they stop
/// what is skipped after an error.
[[nodiscard]] bool isAnchor(TokenKind kind);

/// Words at which a routine ends, whatever is open in it. LOCAL before PROC, FUNC or TRAP is one too; see
/// endsRoutine().
[[nodiscard]] bool endsRoutine(const Cursor& cursor);

/// After the next `;`, or before an anchor at the start of a line.
void recover(Cursor& cursor);

/// The same, also after `terminator` (THEN, DO, `:`). Returns the kind of the token after which the cursor
/// is; End: it is before an anchor.
TokenKind recoverHeader(Cursor& cursor, TokenKind terminator);

/// To the next line, or before an anchor.
void skipLine(Cursor& cursor);

/// Takes a name and returns its token; kNoToken after a finding. A reserved word on the same line is taken as
/// the name that was meant (E109). `what`: "a name", for E201.
[[nodiscard]] TokenIndex takeName(Cursor& cursor, std::string_view what);

/// Takes the `;` at the end of an instruction or declaration. False after E201: recover() then.
[[nodiscard]] bool takeSemicolon(Cursor& cursor);

/// True if the token here is a word that only irc5 reserves. In s4c it is a name.
[[nodiscard]] bool isIrc5Word(const Cursor& cursor, TokenKind word);

}  // namespace cobot_command::rapid
