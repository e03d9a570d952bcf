#include "cobot_command/tm_script/parser.h"

#include <gmock/gmock.h>

namespace cobot_command::tm_script {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The tree of one line, written with all its brackets.
std::string treeOf(std::string_view line) {
  const ParsedScript script = parse(line);
  if (!script.faults.empty()) return "fault: " + script.faults.front().reason;
  return toText(script.statements);
}

std::vector<int> faultyLines(std::string_view text) {
  std::vector<int> lines;
  for (const Fault& fault : parse(text).faults) lines.push_back(fault.line);
  return lines;
}

std::string faultOf(std::string_view line) {
  const ParsedScript script = parse(line);
  return script.faults.empty() ? "" : script.faults.front().reason;
}

ScalarType typeOfLiteral(const std::string& numeral) {
  const ParsedScript script = parse("x = " + numeral);
  const auto& assignment = std::get<Assignment>(std::get<Expression>(script.statements.at(0).content).node);
  return typeOf(std::get<Literal>(assignment.value->node).value);
}

TEST(ScriptParser, readsDeclarationsOfAllTypes) {
  EXPECT_EQ(treeOf("int i"), "int i");
  EXPECT_EQ(treeOf("byte b=0xFF"), "byte b = 255");
  EXPECT_EQ(treeOf("float[] p = {0,0,90,0,90,0}"), "float[] p = {0, 0, 90, 0, 90, 0}");
  EXPECT_EQ(treeOf("string [] s = { \"a\" , \"b\" }"), "string[] s = {\"a\", \"b\"}");
  EXPECT_EQ(treeOf("bool flag = True"), "bool flag = true");
  EXPECT_EQ(treeOf("double d = {}"), "double d = {}");
}

TEST(ScriptParser, bindsOperatorsAsTheManualsTableSays) {
  EXPECT_EQ(treeOf("x = 1 + 2 * 3"), "x = (1 + (2 * 3))");
  EXPECT_EQ(treeOf("x = (1 + 2) * 3"), "x = ((1 + 2) * 3)");
  EXPECT_EQ(treeOf("x = a - b + c"), "x = (a - b + c)");
  EXPECT_EQ(treeOf("x = a || b && c | d ^ e & f == g < h << i + j * k"),
            "x = (a || (b && (c | (d ^ (e & (f == (g < (h << (i + (j * k))))))))))");
  EXPECT_EQ(treeOf("x = a * b + c * d"), "x = ((a * b) + (c * d))");
  EXPECT_EQ(treeOf("x = -a[0] * !b"), "x = ((-a[0]) * (!b))");
  EXPECT_EQ(treeOf("x = -(int)a"), "x = (-(int)a)");
  EXPECT_EQ(treeOf("x = (a) + b"), "x = (a + b)");
}

TEST(ScriptParser, readsConditionsAndAssignmentsFromTheRight) {
  EXPECT_EQ(treeOf("x = a ? b : c ? d : e"), "x = (a ? b : c ? d : e)");
  EXPECT_EQ(treeOf("x = a ? b ? 1 : 2 : 3"), "x = (a ? (b ? 1 : 2) : 3)");
  EXPECT_EQ(treeOf("x = y = 3"), "x = y = 3");
  EXPECT_EQ(treeOf("x += 1 << 2"), "x += (1 << 2)");
  EXPECT_EQ(treeOf("x <<= y >>= 1"), "x <<= y >>= 1");
}

TEST(ScriptParser, tellsIncrementsFromSigns) {
  EXPECT_EQ(treeOf("var_i++"), "var_i++");
  EXPECT_EQ(treeOf("--i"), "--i");
  EXPECT_EQ(treeOf("x = a+++b"), "x = ((a++) + b)");
  EXPECT_EQ(treeOf("x = a - -b"), "x = (a - (-b))");
  EXPECT_EQ(treeOf("x = - -b"), "x = (- -b)");
}

TEST(ScriptParser, readsItemsCallsAndElements) {
  EXPECT_EQ(treeOf("IO[\"ControlBox\"].DO[2]=1"), "IO[\"ControlBox\"].DO[2] = 1");
  EXPECT_EQ(treeOf("ListenSend(90,GetString(Robot[0].CoordRobot))"),
            "ListenSend(90, GetString(Robot[0].CoordRobot))");
  EXPECT_EQ(treeOf("x = Base[\"vision\", 1].Value"), "x = Base[\"vision\", 1].Value");
  EXPECT_EQ(treeOf("x = GetBytes(a[i + 1])[0]"), "x = GetBytes(a[i + 1])[0]");
  EXPECT_EQ(treeOf("ScriptExit()"), "ScriptExit()");
}

TEST(ScriptParser, givesALiteralTheNarrowestTypeThatHoldsIt) {
  EXPECT_EQ(typeOfLiteral("100"), ScalarType::Byte);
  EXPECT_EQ(typeOfLiteral("1000"), ScalarType::Int);
  EXPECT_EQ(typeOfLiteral("0b11111111"), ScalarType::Byte);
  EXPECT_EQ(typeOfLiteral("0X123abc"), ScalarType::Int);
  EXPECT_EQ(typeOfLiteral("1.11"), ScalarType::Float);
  EXPECT_EQ(typeOfLiteral("417.50000"), ScalarType::Float);
  EXPECT_EQ(typeOfLiteral("3.4e5"), ScalarType::Float);
  EXPECT_EQ(typeOfLiteral("0.12345678"), ScalarType::Double);
  EXPECT_EQ(typeOfLiteral("1e300"), ScalarType::Double);
  EXPECT_EQ(typeOfLiteral("000.0012300"), ScalarType::Float);
  EXPECT_EQ(typeOfLiteral("10000001"), ScalarType::Int);
  EXPECT_EQ(typeOfLiteral("10000001.0"), ScalarType::Double);
  EXPECT_EQ(treeOf("x = -2147483648"), "x = 0x80000000");
}

TEST(ScriptParser, readsTextsWithQuotesAndTheNamedConstants) {
  EXPECT_EQ(treeOf("s = \"Hello TM\"\"5\""), "s = \"Hello TM\"\"5\"");
  EXPECT_EQ(treeOf("s = \"// no comment /* here\""), "s = \"// no comment /* here\"");
  EXPECT_EQ(treeOf("s = empty"), "s = \"\"");
  EXPECT_EQ(treeOf("b = False"), "b = false");
  EXPECT_EQ(treeOf("b = TRue"), "b = TRue");  // only the two spellings of the manual; this is a variable
  EXPECT_EQ(treeOf("s = NewLine"), "s = newline");
}

TEST(ScriptParser, countsLinesWhateverTheirEndsAndComments) {
  const auto script = parse("\r\nint i = 1 // one\n/* two\r\nlines */ i = 2\r\n\r\ni++");
  ASSERT_THAT(script.faults, IsEmpty());
  std::vector<int> lines;
  for (const Statement& statement : script.statements) lines.push_back(statement.line);
  EXPECT_THAT(lines, ElementsAre(2, 4, 6));
}

TEST(ScriptParser, findsTheFaultOfEveryLineOfItsOwn) {
  EXPECT_THAT(faultyLines("int i =\r\ni = 2\r\ni = = 3\r\n)\r\ni++"), ElementsAre(1, 3, 4));
  EXPECT_EQ(faultOf("x = 1 +"), "column 8: expected a value, found the end of the line");
  EXPECT_EQ(faultOf("PTP(\"JPP\" 1)"), "column 11: expected ')', found \"1)\"");
  EXPECT_THAT(faultOf("int 5"), HasSubstr("expected a name"));
  EXPECT_THAT(faultOf("s = \"open"), HasSubstr("found the end of the line"));
  EXPECT_THAT(faultOf("i = 1; j = 2"), HasSubstr("expected the end of the line"));
  EXPECT_THAT(faultOf("x = 0x1FFFFFFFF"), HasSubstr("at most 32 bits"));
  EXPECT_THAT(faultOf("x = 12ab"), HasSubstr("column 7"));
  EXPECT_THAT(faultOf("x = a[0][1]"), HasSubstr("one dimension"));
  EXPECT_THAT(faultOf("x = a.Value"), HasSubstr("only objects"));
}

TEST(ScriptParser, refusesTheStatementsOfProgramsByName) {
  EXPECT_THAT(faultOf("if (x > 1)"), HasSubstr("\"if\" belongs to the programs of TMflow 2"));
  EXPECT_THAT(faultOf("} else"), HasSubstr("\"else\""));
  EXPECT_EQ(treeOf("iffy = 1"), "iffy = 1");
}

TEST(ScriptParser, survivesAHundredThousandBrackets) {
  const std::string many(100000, '(');
  EXPECT_THAT(faultOf("x = " + many), HasSubstr("at most 64 levels of brackets"));
  for (const char* bracket : {"[", "{", "f(", "a[", "(int)(", "-(", "a ? ", "a = ("}) {
    std::string text = "x = ";
    for (int i = 0; i < 100000; ++i) text += bracket;
    EXPECT_NE(faultOf(text), "") << bracket;
  }
}

TEST(ScriptParser, readsLongLinesWithoutGoingDeep) {
  for (const char* link : {"1 + ", "-", "!", "(int)", "a = ", "a ? 1 : ", "a && "}) {
    std::string text = "x = ";
    for (int i = 0; i < 20000; ++i) text += link;
    EXPECT_TRUE(parse(text + " 1").faults.empty()) << link;
  }
}

}  // namespace
}  // namespace cobot_command::tm_script
