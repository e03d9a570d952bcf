// From text to tokens (section 2 of the contract of RAPID).
#include "tree_text.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<TokenKind> kindsOf(const std::string& text, Dialect dialect = Dialect::Irc5) {
  const Source source = readSource(text, {dialect});
  std::vector<TokenKind> kinds;
  for (const Token& token : source.tokens()) kinds.push_back(token.kind);
  return kinds;
}

std::vector<std::string> textsOf(const std::string& text, Dialect dialect = Dialect::Irc5) {
  const Source source = readSource(text, {dialect});
  std::vector<std::string> texts;
  for (TokenIndex token = 0; token + 1 < source.tokens().size(); ++token) {
    texts.emplace_back(source.textOf(token));
  }
  return texts;
}

TEST(RapidLexer, endsEachTextWithOneEnd) {
  EXPECT_THAT(kindsOf(""), ElementsAre(TokenKind::End));
  EXPECT_THAT(kindsOf(" \t\r\n\f"), ElementsAre(TokenKind::End));
}

TEST(RapidLexer, readsReservedWordsInAnyCase) {
  EXPECT_THAT(kindsOf("endIf ENDIF endif"),
              ElementsAre(TokenKind::Endif, TokenKind::Endif, TokenKind::Endif, TokenKind::End));
  for (int word = 0; word < kReservedWords; ++word) {
    const auto kind = static_cast<TokenKind>(word);
    EXPECT_THAT(kindsOf(std::string(toString(kind))), ElementsAre(kind, TokenKind::End));
  }
}

TEST(RapidLexer, reservesTaskAndUndoInIrc5Only) {
  EXPECT_THAT(kindsOf("task undo"), ElementsAre(TokenKind::Task, TokenKind::Undo, TokenKind::End));
  EXPECT_THAT(kindsOf("task undo", Dialect::S4c),
              ElementsAre(TokenKind::Name, TokenKind::Name, TokenKind::End));
}

TEST(RapidLexer, givesNamesThatDifferInCaseOneIndex) {
  const Source source = readSource(
      "Total TOTAL total other gr\xC3\xB6\xC3\x9F"
      "e GR\xC3\x96\xC3\x9F"
      "E");
  const auto& tokens = source.tokens();
  EXPECT_EQ(tokens[0].name, tokens[1].name);
  EXPECT_EQ(tokens[0].name, tokens[2].name);
  EXPECT_NE(tokens[0].name, tokens[3].name);
  EXPECT_EQ(tokens[4].name, tokens[5].name);
}

TEST(RapidLexer, readsAllSigns) {
  EXPECT_THAT(textsOf("a:=<><=>=<>=+-*/\\|?%()[]{}.,;:"),
              ElementsAre("a", ":=", "<>", "<=", ">=", "<>", "=", "+", "-", "*", "/", "\\", "|", "?", "%",
                          "(", ")", "[", "]", "{", "}", ".", ",", ";", ":"));
}

TEST(RapidLexer, readsNumbersOfIrc5) {
  for (const char* number :
       {"1", "300", "3E2", "3e+2", "2.5E-1", ".5", "5.", "5.E3", "0x1F", "0XaB", "0b101", "0o17"}) {
    EXPECT_THAT(kindsOf(number), ElementsAre(TokenKind::Number, TokenKind::End)) << number;
    EXPECT_THAT(textsOf(number), ElementsAre(number));
  }
}

TEST(RapidLexer, readsASignAsNoPartOfANumber) {
  EXPECT_THAT(textsOf("a-1"), ElementsAre("a", "-", "1"));
  EXPECT_THAT(textsOf("1E+5-2"), ElementsAre("1E+5", "-", "2"));
}

TEST(RapidLexer, takesWhatIsGluedToANumberAsPartOfIt) {
  EXPECT_THAT(textsOf("1.2.3 12ab 3_x 0x 1E 1E+ 9\xC3\xA4"),
              ElementsAre("1.2.3", "12ab", "3_x", "0x", "1E", "1E", "+", "9\xC3\xA4"));
}

TEST(RapidLexer, keepsQuotesAndEscapesWithinATextOnItsLine) {
  EXPECT_THAT(textsOf(R"("a ""b"" \\ \07" "")"), ElementsAre(R"("a ""b"" \\ \07")", R"("")"));
  EXPECT_THAT(textsOf("\"open  \nx"), ElementsAre("\"open", "x"));
}

TEST(RapidLexer, keepsCommentsWithoutTheBlanksAtTheEndOfTheirLine) {
  EXPECT_THAT(textsOf("a ! first \t\r\n! second\nb"), ElementsAre("a", "! first", "! second", "b"));
}

TEST(RapidLexer, countsLineEndsBeforeAToken) {
  const Source source = readSource("a b\nc\r\n\r\n\r\nd\re");
  std::vector<int> lines;
  for (const Token& token : source.tokens()) lines.push_back(token.lines_before);
  EXPECT_THAT(lines, ElementsAre(1, 0, 1, 2, 1, 0));
}

TEST(RapidLexer, readsPlaceholdersInAnyCase) {
  EXPECT_THAT(textsOf("<SMT> <id>"), ElementsAre("<SMT>", "<id>"));
  EXPECT_THAT(textsOf("<SMTX> a<b"), ElementsAre("<", "SMTX", ">", "a", "<", "b"));
}

TEST(RapidLexer, distinguishesTheMarkOfAHeaderFromThePercentOfALateCall) {
  EXPECT_THAT(kindsOf("%%% %"), ElementsAre(TokenKind::HeaderMark, TokenKind::Percent, TokenKind::End));
}

TEST(RapidLexer, joinsAdjacentUnknownCharactersInOneFinding) {
  EXPECT_THAT(findingsOf("MODULE m $$@ \xCE\xB1\xCE\xB2\nENDMODULE"), ElementsAre("E101 1:10", "E101 1:14"));
}

TEST(RapidLexer, countsCharactersForColumns) {
  EXPECT_THAT(findingsOf("! gr\xC3\xBC\xC3\x9F"
                         "e\nMODULE m\n\t! x\n\t\xC3\x97"),
              ElementsAre("E203 2:1", "E101 4:2"));
}

TEST(RapidLexer, keepsTheSharpSAndYWithDiaeresisWithoutCapital) {
  EXPECT_EQ(folded("\xC3\x84\xC3\x9F\xC3\xBF\xC3\x97"), "\xC3\xA4\xC3\x9F\xC3\xBF\xC3\x97");
}

TEST(RapidLexer, allowsLongNamesAsTheDialectSays) {
  const std::string sixteen(16, 'a');
  const std::string thirty_two(32, 'b');
  EXPECT_THAT(findingsOf("MODULE " + thirty_two + "\nENDMODULE"), IsEmpty());
  EXPECT_THAT(findingsOf("MODULE " + thirty_two + "b\nENDMODULE"), ElementsAre("E102 1:8"));
  EXPECT_THAT(findingsOf("MODULE " + sixteen + "\nENDMODULE", Dialect::S4c), IsEmpty());
  EXPECT_THAT(findingsOf("MODULE " + sixteen + "a\nENDMODULE", Dialect::S4c), ElementsAre("E102 1:8"));
}

TEST(RapidLexer, countsTheLettersOfNamesNotTheirBytes) {
  std::string name;
  for (int letter = 0; letter < 32; ++letter) name += "\xC3\xA4";
  EXPECT_THAT(findingsOf("MODULE " + name + "\nENDMODULE"), IsEmpty());
}

TEST(RapidLexer, refusesNumbersOfIrc5InS4c) {
  for (const char* number : {".5", "5.", "0x1F", "0b101", "0o17", "5.E3"}) {
    EXPECT_THAT(findingsOf(inRoutine("a:=" + std::string(number) + ";"), Dialect::S4c),
                ElementsAre("E106 3:4"))
        << number;
  }
  EXPECT_THAT(findingsOf(inRoutine("a:=1.5E3;"), Dialect::S4c), IsEmpty());
}

TEST(RapidLexer, countsTheCharactersOfTheValueOfAText) {
  const std::string eighty = "\"" + std::string(77, 'x') + "\\07\\\\\"\"\"";
  EXPECT_THAT(findingsOf(inRoutine("a:=" + eighty + ";")), IsEmpty());
  EXPECT_THAT(findingsOf(inRoutine("a:=" + std::string("\"y") + eighty.substr(1) + ";")),
              ElementsAre("E104 3:4"));
}

}  // namespace
}  // namespace cobot_command::rapid
