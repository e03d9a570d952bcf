#include "cobot_command/rapid/source/token.h"

#include <array>

namespace cobot_command::rapid {

namespace {

/// In the order of TokenKind.
constexpr std::array<std::string_view, static_cast<std::size_t>(TokenKind::End) + 1> kTexts{
    // Reserved words
    "ALIAS", "AND", "BACKWARD", "CASE", "CONNECT", "CONST", "DEFAULT", "DIV", "DO", "ELSE", "ELSEIF",
    "ENDFOR", "ENDFUNC", "ENDIF", "ENDMODULE", "ENDPROC", "ENDRECORD", "ENDTEST", "ENDTRAP", "ENDWHILE",
    "ERROR", "EXIT", "FALSE", "FOR", "FROM", "FUNC", "GOTO", "IF", "INOUT", "LOCAL", "MOD", "MODULE",
    "NOSTEPIN", "NOT", "NOVIEW", "OR", "PERS", "PROC", "RAISE", "READONLY", "RECORD", "RETRY", "RETURN",
    "STEP", "SYSMODULE", "TEST", "THEN", "TO", "TRAP", "TRUE", "TRYNEXT", "VAR", "VIEWONLY", "WHILE", "WITH",
    "XOR", "TASK", "UNDO",
    // Name to Unknown
    "", "", "", "", "%%%", "", "",
    // Signs
    ";", ":", ",", ".", ":=", "=", "<>", "<", "<=", ">", ">=", "+", "-", "*", "/", "\\", "|", "?", "%", "(",
    ")", "[", "]", "{", "}",
    // End
    ""};

}  // namespace

std::string_view toString(TokenKind kind) {
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace cobot_command::rapid
