// Promises tried on random programs, random bytes and damaged fixtures. A failure prints the seed:
// RC_PARAMS="seed=..." repeats it.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "source_tree.h"
#include "tree_text.h"
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/source/limits.h"
#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

using Text = std::string;

/// One of several, by chance.
template <class... Texts>
Text oneOf(const Texts&... texts) {
  return *rc::gen::element<Text>(texts...);
}

/// Blanks, line ends and comments, as they may be between any two tokens.
Text gap() {
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return " ! note\n";
    case 1:
      return "\n! own line\n  ";
    case 2:
      return "\n\n\n";
    case 3:
      return "\t \n";
    default:
      return " ";
  }
}

Text anyName() {
  return oneOf("a", "Total", "TOTAL", "p1", "tool0", "V100", "wobj0", "x", "reg1",
               "gr\xC3\xB6\xC3\x9F"
               "e");
}

Text anyExpression(int depth);

Text anyList(int depth, const Text& separator) {
  Text text = anyExpression(depth);
  for (int more = *rc::gen::inRange(0, 3); more > 0; --more) text += separator + gap() + anyExpression(depth);
  return text;
}

Text anyOperand(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 11 : 5);
  switch (kind) {
    case 0:
      return oneOf("1", "2.5E-1", ".5", "5.", "0x1F", "9E9");
    case 1:
      return oneOf("\"\"", "\"a \"\"b\"\" \\\\ \\07\"", "\"! no comment\"");
    case 2:
      return oneOf("TRUE", "false");
    case 3:
      return anyName();
    case 4:
      return anyName() + ".Trans" + gap() + "." + gap() + "X";
    case 5:
      return anyName() + gap() + "{" + anyList(depth - 1, ",") + "}";
    case 6:
      return anyName() + gap() + "(" + gap() + ")";
    case 7:
      return "OFFS" + gap() + "(" + anyList(depth - 1, ",") + "\\X:=" + anyExpression(depth - 1) + ")";
    case 8:
      return "[" + gap() + anyList(depth - 1, ",") + "]";
    case 9:
      return "(" + anyExpression(depth - 1) + gap() + ")";
    default:
      return oneOf("-", "+") + gap() + anyOperand(depth - 1);
  }
}

Text anyExpression(int depth) {
  Text text = anyOperand(depth);
  for (int more = *rc::gen::inRange(0, depth > 0 ? 3 : 1); more > 0; --more) {
    text +=
        gap() + oneOf("+", "-", "*", "/", "div", "MOD", "and", "OR", "XOR") + gap() + anyOperand(depth - 1);
  }
  return text;
}

Text anyInstructions(int depth);

Text anyInstruction(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 12 : 7);
  const auto value = [depth] { return gap() + anyExpression(depth) + gap(); };
  switch (kind) {
    case 0:
      return anyName() + gap() + ":=" + value() + ";";
    case 1:
      return oneOf("movel", "MoveJ") + "\\CONC," + anyList(depth, ",") + "\\wobj:=" + anyName() + gap() + ";";
    case 2:
      return "f" + gap() + oneOf("-", "[1]*", "") + anyName() + ";";
    case 3:
      return "lab" + gap() + ":";
    case 4:
      return "GOTO" + gap() + "LAB;";
    case 5:
      return oneOf("RETURN;", "raise;", "EXIT;", "<smt>", "CONNECT a WITH b;");
    case 6:
      return "%" + value() + "%" + value() + ";";
    case 7:
      return "IF" + value() + "THEN" + gap() + anyInstructions(depth - 1) +
             oneOf("", "ELSE ", "elseif a THEN ") + anyInstructions(depth - 1) + "ENDIF";
    case 8:
      return "FOR" + gap() + "A from" + value() + "TO" + value() + oneOf("", "STEP -1 ") + "do" + gap() +
             anyInstructions(depth - 1) + "ENDFOR";
    case 9:
      return "WHILE" + value() + "DO" + gap() + anyInstructions(depth - 1) + "ENDWHILE";
    case 10:
      return "TEST" + value() + gap() + "CASE " + anyList(depth - 1, ",") + ":" + gap() +
             anyInstructions(depth - 1) + "DEFAULT" + gap() + ":" + anyInstructions(depth - 1) + "ENDTEST";
    default:
      return "IF a " + anyInstruction(depth - 1);
  }
}

Text anyInstructions(int depth) {
  Text text = gap();
  for (int more = *rc::gen::inRange(0, 4); more > 0; --more) text += anyInstruction(depth) + gap();
  return text;
}

Text anyProgram() {
  constexpr int kDepth = 3;
  return oneOf("", "%%% VERSION:1 LANGUAGE:ENGLISH %%%") + gap() + "MODULE" + gap() + "m" +
         oneOf("", "(SYSMODULE)") + gap() + "var num Total:=" + anyExpression(1) + ";" + gap() +
         "record part pos At; endrecord" + gap() + "PROC" + gap() + "p(num A\\switch On|switch Off)" + gap() +
         "VAR part local1;" + gap() + anyInstructions(kDepth) + oneOf("", "ERROR ") + anyInstructions(1) +
         "endproc" + gap() + "TRAP t" + gap() + anyInstructions(2) + "ENDTRAP" + gap() + "ENDMODULE" + gap();
}

/// What is promised of any bytes.
void checkAnyBytes(const Text& bytes) {
  for (const Dialect dialect : {Dialect::Irc5, Dialect::S4c}) {
    const Source source = readSource(bytes, {dialect});
    RC_ASSERT(source.findings().size() <= kMostFindings + 1);
    RC_ASSERT(source.steps() <= 4 * source.tokens().size());
    for (const Finding& finding : source.findings()) {
      RC_ASSERT(finding.span.begin <= finding.span.end);
      RC_ASSERT(finding.span.end <= source.text().size());
      RC_ASSERT(finding.text == escaped(finding.text));
    }
    if (source.isBroken()) continue;
    const Text once = print(source, predefinedNames());
    const Source again = readSource(once, {dialect});
    RC_ASSERT(!again.isBroken());
    RC_ASSERT(tokenTexts(again) == tokenTexts(source));
    RC_ASSERT(print(again, predefinedNames()) == once);
  }
}

RC_GTEST_PROP(RapidProperties, programsOfTheGrammarHaveNoSyntaxErrorAndAreFormattedOnce, ()) {
  const Text program = anyProgram();
  const Source source = readSource(program);
  for (const Finding& finding : source.findings()) {
    if (finding.severity() == Severity::Error) RC_FAIL(describe(source, finding, "program") + "\n" + program);
  }
  checkAnyBytes(program);
}

RC_GTEST_PROP(RapidProperties, anyBytesEndInFindings, (const Text& bytes)) {
  checkAnyBytes(bytes);
}

RC_GTEST_PROP(RapidProperties, anyTokensEndInFindings, ()) {
  Text text = oneOf("", "MODULE m ", "MODULE m PROC p() ");
  for (int more = *rc::gen::inRange(0, 60); more > 0; --more) {
    const int kind = *rc::gen::inRange(0, static_cast<int>(TokenKind::End));
    const std::string_view sign = toString(static_cast<TokenKind>(kind));
    text += (sign.empty() ? oneOf("a", "1", "\"x\"", "<SMT>", "$", "! x\n", "1x") : Text(sign)) +
            oneOf(" ", "\n", "");
  }
  checkAnyBytes(text);
}

std::vector<Text> fixtureModules() {
  std::vector<Text> texts;
  for (const auto& entry :
       std::filesystem::directory_iterator(test_support::inSourceTree("test/data/rapid"))) {
    if (entry.path().extension() != ".mod") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

RC_GTEST_PROP(RapidProperties, damagedFixturesEndInFindings, ()) {
  static const std::vector<Text> modules = fixtureModules();
  Text text = *rc::gen::elementOf(modules);
  for (int more = *rc::gen::inRange(1, 6); more > 0; --more) {
    const auto at = static_cast<std::size_t>(*rc::gen::inRange<std::size_t>(0, text.size() + 1));
    const auto size = static_cast<std::size_t>(*rc::gen::inRange(0, 12));
    const Text other =
        oneOf(";", "(", ")", "]", "{", "\"", "!", "\n", "ENDIF", " IF ", ":=", "%", "\\", "$", "\xFF", "");
    text.replace(at, size, other);
  }
  checkAnyBytes(text);
}

}  // namespace
}  // namespace cobot_command::rapid
