// Rules that no table of findings shows: what is visible where, what is no error, and that errors have no
// echoes.
#include "checked_text.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> findingsOf(const std::string& text, Dialect dialect = Dialect::Irc5) {
  const CheckedProgram checked = checkedText(text, {}, dialect);
  return idsAndPlaces(checked.draft->source(kPredefinedFiles), checked.findings.front());
}

TEST(RapidScope, hidesNamesFromTheInsideOut) {
  EXPECT_THAT(findingsInMain("VAR string n; n:=\"x\"; FOR n FROM 1 TO 2 DO reg1:=n; ENDFOR n:=\"y\";",
                             "VAR num n;\n"),
              IsEmpty());
  EXPECT_THAT(findingsOf("MODULE m PROC main() Stop 1; ENDPROC PROC Stop(num n) ENDPROC ENDMODULE"),
              IsEmpty());
  EXPECT_THAT(findingsInMain("pos:=1;", "VAR num pos;\nVAR pos p;\n"), IsEmpty());
}

TEST(RapidScope, keepsLabelsApartFromNamesOfTheModule) {
  EXPECT_THAT(findingsInMain("n: n:=1; GOTO n;", "VAR num n;\n"), IsEmpty());
  EXPECT_THAT(findingsInMain("VAR num n; n: n:=1;"), ElementsAre("E318 3:12"));
}

TEST(RapidScope, jumpsOutOfBlocksAndWithinThem) {
  EXPECT_THAT(findingsInMain("out: WHILE reg1<3 DO in: Incr reg1; IF reg1=2 GOTO in; GOTO out; ENDWHILE"),
              IsEmpty());
  EXPECT_THAT(findingsInMain("GOTO l; ERROR l: TRYNEXT;"), ElementsAre("E602 3:6"));
}

TEST(RapidScope, jumpsWithinTheBlockOfACompactIf) {
  EXPECT_THAT(findingsInMain("IF reg1<3 WHILE reg1<3 DO in: Incr reg1; GOTO in; ENDWHILE"), IsEmpty());
  EXPECT_THAT(findingsInMain("IF reg1<3 WHILE reg1<3 DO in: Incr reg1; ENDWHILE GOTO in;"),
              ElementsAre("E602 3:56"));
}

TEST(RapidEchoes, doNotFollowAnUnknownName) {
  EXPECT_THAT(findingsInMain("reg1:=unknown.x{1}+2;"), ElementsAre("E401 3:7"));
  EXPECT_THAT(findingsInMain("unknown 1,other,[1,2];"), ElementsAre("E501 3:1"));
  EXPECT_THAT(findingsInMain("x:=1; x.y:=\"z\";", "VAR unknowntype x;\n"), ElementsAre("E310 2:5"));
  EXPECT_THAT(findingsInMain("IF unknown AND reg1=1 THEN ENDIF"), ElementsAre("E401 3:4"));
}

TEST(RapidEchoes, doNotFollowAnErrorOfReading) {
  EXPECT_THAT(findingsInMain("unknown:=1 $ other;"), ElementsAre("E101 3:12"));
  EXPECT_THAT(findingsOf("MODULE m PROC main() q 1,2; ENDPROC PROC q(num) ENDPROC ENDMODULE"),
              ElementsAre("E201 1:47"));
  // A name that is too long is one all the same.
  EXPECT_THAT(findingsInMain(std::string(33, 'a') + ":=1;", "VAR num " + std::string(33, 'a') + ";\n"),
              ElementsAre("E102 2:9", "E102 4:1"));
}

TEST(RapidEchoes, doNotMissAMainThatWasNotRead) {
  EXPECT_THAT(findingsOf("MODULE m PROC $ main() ENDPROC ENDMODULE"), ElementsAre("E101 1:15"));
}

TEST(RapidFlow, continuesBehindRaiseIfAHandlerMayAnswer) {
  EXPECT_THAT(findingsInMain("RAISE 1; Stop; ERROR TRYNEXT;"), IsEmpty());
  EXPECT_THAT(findingsInMain("RAISE 1; Stop;"), ElementsAre("W611 3:10"));
}

TEST(RapidFlow, endsInEveryBranchOfIfAndTest) {
  EXPECT_THAT(findingsInMain("IF reg1=1 THEN RETURN; ELSE EXIT; ENDIF Stop;"), ElementsAre("W611 3:41"));
  EXPECT_THAT(findingsInMain("TEST reg1 CASE 1: RETURN; DEFAULT: RETURN; ENDTEST Stop;"),
              ElementsAre("W611 3:52"));
  EXPECT_THAT(findingsInMain("TEST reg1 CASE 1: RETURN; ENDTEST Stop;"), IsEmpty());
  EXPECT_THAT(findingsInMain("WHILE TRUE DO Stop; ENDWHILE Stop; Stop;"), ElementsAre("W611 3:30"));
  EXPECT_THAT(findingsInMain("ExitCycle; Stop;"), ElementsAre("W611 3:12"));
}

TEST(RapidTypes, ofSignalsAreReadAsNumbers) {
  CheckOptions options;
  for (const SignalType type : {SignalType::Di, SignalType::Gi, SignalType::Ai}) {
    Signal signal;
    signal.name = signal.folded = std::string(toString(type)) + "1";
    signal.type = type;
    options.signals.push_back(signal);
  }
  const std::string lines =
      "reg1:=di1+gi1*ai1; IF di1=1 AND 3=gi1 THEN ENDIF TEST gi1 CASE 1: ENDTEST WaitTime ai1; TPWrite "
      "\"\"\\Num:=ai1; "
      "WaitDI di1,1;";
  EXPECT_THAT(checkedText(withMain(lines), options).findings.front(), IsEmpty());
}

TEST(RapidTypes, tellAnAggregateFromEitherSide) {
  EXPECT_THAT(
      findingsInMain("IF [1,2,3]=p THEN ENDIF IF p=([1,2,3]) THEN ENDIF p:=[1,0,0]*p+[1,1,1]; p:=-[1,2,3];",
                     "VAR pos p;\n"),
      IsEmpty());
}

TEST(RapidTypes, passArraysOfAnySizeToAParameter) {
  const std::string text =
      "MODULE m VAR num row{3}; VAR num other{4}; PROC main() q row; q other; q [1,2]; ENDPROC "
      "PROC q(num a{*}) VAR num own{3}; own:=a; a:=own; IF a=own Stop; ENDPROC ENDMODULE";
  EXPECT_THAT(findingsOf(text), IsEmpty());
}

TEST(RapidDialects, differInWhatTheyKnow) {
  const std::string text =
      "MODULE m PERS pos p:=[1,2,3]; CONST num root:=Sqrt(4); PROC main() p:=p/2; Incr p.x; ENDPROC "
      "ENDMODULE";
  EXPECT_THAT(findingsOf(text), IsEmpty());
  EXPECT_THAT(findingsOf(text, Dialect::S4c), ElementsAre("E307 1:47", "E403 1:72", "E510 1:81"));
}

TEST(RapidModules, seeTheGlobalNamesOfEachOther) {
  const auto source = [](const char* text) { return std::make_shared<const Source>(readSource(text)); };
  const auto first = source("MODULE a PROC main() q; hidden; ENDPROC VAR num twice; ENDMODULE");
  const auto second =
      source("MODULE b VAR num twice; PROC q() ENDPROC LOCAL PROC hidden() ENDPROC ENDMODULE");
  const CheckedProgram checked = check({{"a.mod", first}, {"b.mod", second}}, {});
  EXPECT_THAT(idsAndPlaces(*first, checked.findings[0]), ElementsAre("E501 1:25", "E205 1:41"));
  EXPECT_THAT(idsAndPlaces(*second, checked.findings[1]), ElementsAre("E301 1:18"));
  EXPECT_EQ(checked.findings[1].front().text, "'twice' is declared already at a.mod:1:49");
}

TEST(RapidModules, mayNamePredefinedDataInPersistentsOfASystemModule) {
  EXPECT_THAT(findingsOf("MODULE m(SYSMODULE) PERS tooldata t:=tool0; PROC main() ENDPROC ENDMODULE"),
              IsEmpty());
  EXPECT_THAT(findingsOf("MODULE m PERS tooldata t:=tool0; PROC main() ENDPROC ENDMODULE"),
              ElementsAre("E307 1:27"));
}

TEST(RapidSkip, passesOverCallsOfWhatIsNotSupportedOrNotDeclared) {
  CheckOptions options;
  options.skipped = {"ACTUNIT", "Foo", "Stop"};
  const CheckedProgram checked = checkedText(withMain("ActUnit x; Foo 1; ActUnit y; Stop; Bar;"), options);
  const Source& source = checked.draft->source(kPredefinedFiles);
  EXPECT_THAT(idsAndPlaces(source, checked.findings.front()),
              ElementsAre("W524 3:1", "W524 3:12", "E501 3:36"));
}

}  // namespace
}  // namespace cobot_command::rapid
