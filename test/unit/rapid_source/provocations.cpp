#include "provocations.h"

#include "tree_text.h"

#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

namespace {

std::string manyErrors() {
  std::string text = "MODULE m\nPROC p()\n";
  for (std::size_t i = 0; i <= kMostFindings; ++i) text += "a:=;\n";
  return text + "ENDPROC\nENDMODULE\n";
}

constexpr Dialect kS4c = Dialect::S4c;

}  // namespace

// Columns as in section 17 of the contract: id, text, line, column, message.
const std::vector<Provocation>& provocations() {
  static const std::vector<Provocation> rows{
      {"E101", "a:=1 $ 2;", 3, 6, "'$' means nothing in RAPID"},
      {"E102", std::string(33, 'a') + ";", 3, 1,
       "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa' has 33 letters, irc5 allows 32"},
      {"E102", std::string(17, 'a') + ";", 3, 1, "'aaaaaaaaaaaaaaaaa' has 17 letters, s4c allows 16", kS4c},
      {"E103", "s:=\"x;", 3, 4, "this text is not closed on its line"},
      {"E104", "s:=\"" + std::string(81, 'x') + "\";", 3, 4, "this text has 81 characters, 80 are allowed"},
      {"E105", "s:=\"\\zz\";", 3, 5, "'\\zz' is no character code"},
      {"E106", "a:=1.2.3;", 3, 4, "'1.2.3' is no number"},
      {"E106", "a:=12ab;", 3, 4, "'12ab' is no number"},
      {"E107", "a:=1E39;", 3, 4, "1E39 is beyond single precision"},
      {"E109", "VAR num for;", 3, 9, "FOR is a reserved word"},
      {"E201", "a:=a+;", 3, 6, "expected an expression, found ';'"},
      {"E201", "WHILE a b; ENDWHILE", 3, 9, "expected DO, found 'b'"},
      {"E201", "MODULE m\nFUNC num f()\nENDPROC\nENDMODULE", 3, 1, "expected ENDFUNC, found ENDPROC"},
      {"E201", "GOTO ;", 3, 6, "expected the name of a label, found ';'"},
      {"E202", "a:=1", 3, 5, "';' is missing"},
      {"E202", "IF a THEN b ENDIF", 3, 12, "';' is missing"},
      {"E203", "IF a THEN", 3, 1, "IF is not closed by ENDIF"},
      {"E203", "FOR i FROM 1 TO 2 DO", 3, 1, "FOR is not closed by ENDFOR"},
      {"E203", "WHILE a DO", 3, 1, "WHILE is not closed by ENDWHILE"},
      {"E203", "TEST a", 3, 1, "TEST is not closed by ENDTEST"},
      {"E203", "MODULE m", 1, 1, "MODULE is not closed by ENDMODULE"},
      {"E203", "MODULE m\nLOCAL PROC p()\nENDMODULE", 2, 7, "PROC is not closed by ENDPROC"},
      {"E203", "MODULE m\nRECORD r\nENDMODULE", 2, 1, "RECORD is not closed by ENDRECORD"},
      {"E204", "ENDIF", 3, 1, "ENDIF has nothing before it that it could end"},
      {"E204", "ELSE", 3, 1, "ELSE has nothing before it that it could end"},
      {"E204", "IF a THEN ELSE ELSE ENDIF", 3, 16, "ELSE has nothing before it that it could end"},
      {"E204", "MODULE m\nENDPROC\nENDMODULE", 2, 1, "ENDPROC has nothing before it that it could end"},
      {"E205", "a:=1; VAR num b;", 3, 7, "declarations stand before routines and instructions"},
      {"E205", "RECORD r ENDRECORD", 3, 1, "declarations stand before routines and instructions"},
      {"E205", "MODULE m\nTRAP t ENDTRAP\nALIAS num n;\nENDMODULE", 3, 1,
       "declarations stand before routines and instructions"},
      {"E206", "MoveL\\Conc p,v;", 3, 12, "',' is missing before this argument"},
      {"E207", "f a,\\b;", 3, 4, "no ',' before '\\' in s4c", kS4c},
      {"E208", "MODULE m(READONLY,SYSMODULE)\nENDMODULE", 1, 19, "'SYSMODULE' is no attribute here"},
      {"E208", "MODULE m(NOVIEW,READONLY)\nENDMODULE", 1, 17, "'READONLY' is no attribute here"},
      {"E208", "MODULE m(secret)\nENDMODULE", 1, 10, "'secret' is no attribute here"},
      {"E209", "a=4;", 3, 2, "':=' is meant"},
      {"E210", "ERROR BACKWARD", 3, 7, "BACKWARD a second time or out of order (BACKWARD, ERROR, UNDO)"},
      {"E210", "ERROR ERROR", 3, 7, "ERROR a second time or out of order (BACKWARD, ERROR, UNDO)"},
      {"E211", "MODULE m\nTRAP t BACKWARD ENDTRAP\nENDMODULE", 2, 8, "only a PROC has a BACKWARD handler"},
      {"E213", "LOCAL a;", 3, 1, "LOCAL is for modules"},
      {"E214", "MODULE m ENDMODULE stray again", 1, 20, "'stray' stands outside of a module"},
      {"E215", "MoveL *,v100;", 3, 7, "'*' was a position that only the robot knew"},
      {"E216", "%%% VERSION:2 %%%\nMODULE m ENDMODULE", 1, 1,
       "the header reads %%% VERSION:1 LANGUAGE:ENGLISH %%%"},
      {"W217", "<SMT>", 3, 1, "placeholder: raises ERR_EXECPHR when reached"},
      {"E218", "a:=[];", 3, 5, "something is missing here"},
      {"E218", "a:=f(1,);", 3, 8, "something is missing here"},
      {"E219", "a:=" + std::string(201, '(') + "1" + std::string(201, ')') + ";", 3, 204,
       "nested deeper than 200"},
      {"E219", repeated(201, "IF a THEN ") + "b; " + repeated(201, "ENDIF "), 3, 2001,
       "nested deeper than 200"},
      {"E220", "go();", 3, 3, "a procedure is called without brackets"},
      {"E220", "f(a,b);", 3, 2, "a procedure is called without brackets"},
      {"E306", "MODULE m\nPERS num a;\nENDMODULE", 2, 10, "PERS 'a' has no value", kS4c},
      {"W306", "MODULE m\nPERS num a;\nENDMODULE", 2, 10, "PERS 'a' has no value"},
      {"E311", "CONST num a;", 3, 11, "CONST 'a' has no value"},
      {"E615", "TEST a DEFAULT: CASE 1: ENDTEST", 3, 17, "nothing stands behind DEFAULT"},
      {"E615", "TEST a DEFAULT: DEFAULT: ENDTEST", 3, 17, "nothing stands behind DEFAULT"},
      {"E801", "MODULE m\nTASK PERS num a:=1;\nENDMODULE", 2, 1, "TASK PERS is not in s4c", kS4c},
      {"E801", "ERROR (1) a;", 3, 1, "ERROR (n,m) is not in s4c", kS4c},
      {"E801", "a;\nUNDO\nb;", 4, 1, "UNDO is not in s4c", kS4c},
      {"E901", "\xEF\xBB\xBF\xFF", 1, 1, "cannot be read: it begins as UTF-8, and is not; save it again"},
      {"E902", std::string(1, '\0'), 1, 1, "no text (encoded module?)"},
      {"E903", manyErrors(), 103, 4, "more than 100 findings"},
      {"E904", std::string(kMostFileBytes + 1, ' '), 1, 1, "longer than 16 MiB"},
  };
  return rows;
}

}  // namespace cobot_command::rapid
