// The canonical form (section 18 of the contract of RAPID).
#include "cobot_command/rapid/source/printer.h"

#include "tree_text.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

/// Printed once; the test fails if a second time changes it.
std::string printed(const std::string& text) {
  const Source source = readSource(text);
  EXPECT_FALSE(source.isBroken()) << text;
  std::string once = print(source, predefinedNames());
  EXPECT_EQ(print(readSource(once), predefinedNames()), once);
  return once;
}

/// The lines of a routine, without its own.
std::string printedLines(const std::string& lines, const std::string& declarations = "") {
  const std::string text = printed(inRoutine(lines, declarations));
  const std::size_t begin = text.find('\n', text.find("PROC")) + 1;
  return text.substr(begin, text.find("  ENDPROC") - begin);
}

TEST(RapidPrinter, writesOneInstructionOnALineWithTwoBlanksForEachLevel) {
  EXPECT_EQ(printed("module m local var num a;proc p()a:=1;while a<3 do a:=a+1;endwhile endproc endmodule"),
            "MODULE m\n"
            "  LOCAL VAR num a;\n"
            "\n"
            "  PROC p()\n"
            "    a:=1;\n"
            "    WHILE a < 3 DO\n"
            "      a:=a + 1;\n"
            "    ENDWHILE\n"
            "  ENDPROC\n"
            "ENDMODULE\n");
}

TEST(RapidPrinter, indentsAllBlocks) {
  EXPECT_EQ(printedLines("if a then b; elseif c then d; else e; endif for i from 1 to 2 do f; endfor "
                         "test a case 1,2:b; default:c; endtest"),
            "    IF a THEN\n      b;\n    ELSEIF c THEN\n      d;\n    ELSE\n      e;\n    ENDIF\n"
            "    FOR i FROM 1 TO 2 DO\n      f;\n    ENDFOR\n"
            "    TEST a\n    CASE 1,2:\n      b;\n    DEFAULT:\n      c;\n    ENDTEST\n");
}

TEST(RapidPrinter, writesHandlersOnTheLevelOfTheirRoutine) {
  EXPECT_EQ(
      printed("MODULE m PROC p() a; BACKWARD b; ERROR (1,2) c; UNDO d; ENDPROC ENDMODULE"),
      "MODULE m\n\n  PROC p()\n    a;\n  BACKWARD\n    b;\n  ERROR (1,2)\n    c;\n  UNDO\n    d;\n  ENDPROC\n"
      "ENDMODULE\n");
}

TEST(RapidPrinter, writesLabelsOneLevelFurtherOut) {
  EXPECT_EQ(printedLines("IF a THEN\nx: b;\nENDIF\nGOTO X;"),
            "    IF a THEN\n    x:\n      b;\n    ENDIF\n    GOTO x;\n");
}

TEST(RapidPrinter, writesACompactIfOnOneLine) {
  EXPECT_EQ(printedLines("IF a\n  GOTO x;\nx:"), "    IF a GOTO x;\n  x:\n");
  EXPECT_EQ(printedLines("IF a FOR i FROM 1 TO 2 DO b; ENDFOR"),
            "    IF a FOR i FROM 1 TO 2 DO\n      b;\n    ENDFOR\n");
}

TEST(RapidPrinter, putsBlanksAroundBinaryOperatorsOnly) {
  EXPECT_EQ(printedLines("a:=- 1+b*-c-d{ 1 , i+1 }.x/( 2 DIV 3 );"),
            "    a:=-1 + b * -c - d{1,i + 1}.x / (2 DIV 3);\n");
  EXPECT_EQ(printedLines("a:=NOT b AND ( c<>d ) OR e>=- 1;"), "    a:=NOT b AND (c <> d) OR e >= -1;\n");
  EXPECT_EQ(printedLines("f - 1 , [ - 1 ] \\ X := + 2 \\ Y ? z;"), "    f -1,[-1]\\X:=+2\\Y?z;\n");
  EXPECT_EQ(printedLines("f( a );g [1];h \"x\" ;"), "    f (a);\n    g [1];\n    h \"x\";\n");
  EXPECT_EQ(printedLines("% \"s\"+a % - i , 2;%\"t\"%;%\"u\"%\\X;"),
            "    %\"s\" + a% -i,2;\n    %\"t\"%;\n    %\"u\"%\\X;\n");
}

TEST(RapidPrinter, writesParametersWithoutBlanks) {
  EXPECT_EQ(printed("MODULE m FUNC num f ( \\ switch on | switch off , INOUT num a { * , * } \\ PERS pos p ) "
                    "RETURN 1; ENDFUNC ENDMODULE"),
            "MODULE m\n\n  FUNC num f(\\switch on|switch off,INOUT num a{*,*}\\PERS pos p)\n    RETURN 1;\n  "
            "ENDFUNC\n"
            "ENDMODULE\n");
}

TEST(RapidPrinter, writesTypesAndAttributes) {
  EXPECT_EQ(printed("module m ( sysmodule , noview ) record r num a; ENDRECORD; alias R s; task pers S "
                    "t:=[1]; endmodule"),
            "MODULE m(SYSMODULE,NOVIEW)\n  RECORD r\n    num a;\n  ENDRECORD;\n  ALIAS r s;\n  TASK PERS s "
            "t:=[1];\n"
            "ENDMODULE\n");
}

TEST(RapidPrinter, writesTheHeaderInFourLines) {
  EXPECT_EQ(printed("%%% version : 1 language : german %%% MODULE m ENDMODULE"),
            "%%%\n  VERSION:1\n  LANGUAGE:GERMAN\n%%%\nMODULE m\nENDMODULE\n");
}

TEST(RapidPrinter, writesLiteralsAsTheyAre) {
  EXPECT_EQ(printedLines("a:=1E+05;b:=.5;c:=0x1f;d:=\"\\0a\"\"\";e:=true;"),
            "    a:=1E+05;\n    b:=.5;\n    c:=0x1f;\n    d:=\"\\0a\"\"\";\n    e:=TRUE;\n");
}

TEST(RapidPrinter, writesNamesAsTheyAreDeclared) {
  EXPECT_EQ(
      printedLines("TOTAL:=TWICE(Total);MYTOOL.TFRAME.TRANS.X:=1;unKnown;",
                   "VAR num Total; PERS tooldata MyTool:=[1]; FUNC num twice(num v) RETURN V; ENDFUNC\n"),
      printedLines("Total:=twice(Total);MyTool.tframe.trans.x:=1;unKnown;",
                   "VAR num Total; PERS tooldata MyTool:=[1]; FUNC num twice(num v) RETURN v; ENDFUNC\n"));
  EXPECT_EQ(printedLines("VAR num Own;OWN2:=OWN;"), "    VAR num Own;\n    OWN2:=Own;\n");
}

TEST(RapidPrinter, writesPredefinedNamesAsTheCatalogueDoes) {
  EXPECT_EQ(
      printedLines("VAR ROBTARGET p;movel P,V100\\t:=5,FINE,TOOL0\\wobj:=WOBJ0;p.TRANS:=[1,2,3];settdo DO1;"),
      "    VAR robtarget p;\n    MoveL p,v100\\T:=5,fine,tool0\\WObj:=wobj0;\n    p.trans:=[1,2,3];\n    "
      "settdo DO1;\n");
  EXPECT_EQ(printedLines("VAR TRIGGDATA t;actunit x;"), "    VAR triggdata t;\n    ActUnit x;\n");
}

TEST(RapidPrinter, followsTheScopesOfNames) {
  EXPECT_EQ(printedLines("VAR num V;v:=1;for V from 1 to 2 do V:=v; endfor", "VAR num v;\n"),
            "    VAR num V;\n    V:=1;\n    FOR V FROM 1 TO 2 DO\n      V:=V;\n    ENDFOR\n");
  EXPECT_EQ(printedLines("FOR I FROM 1 TO i DO a:=i; ENDFOR a:=I;"),
            "    FOR I FROM 1 TO i DO\n      a:=I;\n    ENDFOR\n    a:=I;\n");
  EXPECT_EQ(printed("MODULE a LOCAL VAR num Own; VAR num Shared; ENDMODULE MODULE b VAR num x:=own; VAR num "
                    "y:=shared; ENDMODULE"),
            "MODULE a\n  LOCAL VAR num Own;\n  VAR num Shared;\nENDMODULE\nMODULE b\n  VAR num x:=own;\n  "
            "VAR num y:=Shared;\nENDMODULE\n");
}

TEST(RapidPrinter, writesPartsOfOwnRecordsAsTheyAreDeclared) {
  EXPECT_EQ(printed("MODULE m RECORD Part pos At; ENDRECORD ALIAS part Piece; VAR piece a{2}; PROC p() "
                    "A{1}.AT.X:=1; ENDPROC ENDMODULE"),
            "MODULE m\n  RECORD Part\n    pos At;\n  ENDRECORD\n  ALIAS Part Piece;\n  VAR Piece a{2};\n\n  "
            "PROC p()\n"
            "    a{1}.At.x:=1;\n  ENDPROC\nENDMODULE\n");
}

TEST(RapidPrinter, survivesAnAliasOfItself) {
  EXPECT_EQ(printedLines("A.X:=1;", "ALIAS b c; ALIAS c b; VAR b a;\n"), "    a.X:=1;\n");
}

TEST(RapidPrinter, keepsCommentsWhereTheyAre) {
  EXPECT_EQ(printedLines("! own line\na;   ! after it\n\n\n! before ELSE\nIF b THEN\n! in it\nc;\n! at its "
                         "end\nELSE ! x\nENDIF\n! last"),
            "    ! own line\n    a; ! after it\n\n    ! before ELSE\n    IF b THEN\n      ! in it\n      "
            "c;\n      ! at its end\n"
            "    ELSE ! x\n    ENDIF\n    ! last\n");
}

TEST(RapidPrinter, continuesALineAfterACommentWithinIt) {
  EXPECT_EQ(printedLines("MoveL p, ! why\n v,\n ! own\n z,t;"),
            "    MoveL p, ! why\n      v,\n      ! own\n      z,t;\n");
  EXPECT_EQ(printedLines("IF a ! x\nTHEN ENDIF"), "    IF a ! x\n      THEN\n    ENDIF\n");
}

TEST(RapidPrinter, writesOneBlankLineBeforeRoutinesAndTheirComments) {
  EXPECT_EQ(printed("MODULE m\nVAR num a; ! x\n! of p\n! more\nPROC p()\nENDPROC\n\n\n\n! alone\n\nTRAP "
                    "t\nENDTRAP\nENDMODULE"),
            "MODULE m\n  VAR num a; ! x\n\n  ! of p\n  ! more\n  PROC p()\n  ENDPROC\n\n  ! alone\n\n  TRAP "
            "t\n  ENDTRAP\n"
            "ENDMODULE\n");
}

TEST(RapidPrinter, keepsAtMostOneBlankLineElsewhere) {
  EXPECT_EQ(
      printed("\n\n! head\n\n\nMODULE m\n\n\nVAR num a;\n\n\n\nVAR num b;\n\nENDMODULE\n\n\n! tail\n\n\n"),
      "! head\n\nMODULE m\n\n  VAR num a;\n\n  VAR num b;\n\nENDMODULE\n\n! tail\n");
}

TEST(RapidPrinter, keepsTheLineEndsOfTheText) {
  EXPECT_EQ(printed("MODULE m\r\nVAR num a; ! x\r\nENDMODULE"),
            "MODULE m\r\n  VAR num a; ! x\r\nENDMODULE\r\n");
  EXPECT_EQ(printed("MODULE m\rENDMODULE"), "MODULE m\rENDMODULE\r");
}

TEST(RapidPrinter, writesPlaceholdersInCapitals) {
  EXPECT_EQ(
      printed(
          "MODULE m <ddn> PROC p(<par>) <smt>; a:=<exp>; TEST <exp> <cse> CASE 1: ENDTEST ENDPROC ENDMODULE"),
      "MODULE m\n  <DDN>\n\n  PROC p(<PAR>)\n    <SMT>;\n    a:=<EXP>;\n    TEST <EXP>\n    <CSE>\n    CASE "
      "1:\n    ENDTEST\n"
      "  ENDPROC\nENDMODULE\n");
}

TEST(RapidPrinter, printsNothingForNothing) {
  EXPECT_EQ(printed(""), "");
  EXPECT_EQ(printed("  \n \n"), "");
  EXPECT_EQ(printed("! x"), "! x\n");
}

}  // namespace
}  // namespace cobot_command::rapid
