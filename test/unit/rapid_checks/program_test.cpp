// What a checked program has: symbols, and the meaning of each node.
#include "cobot_command/rapid/types/program.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "checked_text.h"
#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsNull;
using ::testing::NotNull;

constexpr FileIndex kFile = kPredefinedFiles;

std::shared_ptr<const Program> programOf(const std::string& lines, const std::string& declarations = "") {
  const CheckedProgram checked = checkedText(withMain(lines, declarations));
  EXPECT_THAT(checked.program, NotNull())
      << ::testing::PrintToString(idsAndPlaces(checked.draft->source(kFile), checked.findings.front()));
  return checked.program;
}

/// The n-th node of a kind, in the order of the text.
NodeIndex nodeOf(const Program& program, NodeKind kind, int n = 0) {
  const Tree& tree = program.source(kFile).tree();
  for (NodeIndex node = 0; node < tree.size(); ++node) {
    if (tree[node].kind == kind && n-- == 0) return node;
  }
  return kNoNode;
}

const Symbol& symbolNamed(const Program& program, std::string_view name) {
  const SymbolIndex module = program.at(kFile, nodeOf(program, NodeKind::Module)).symbol;
  const SymbolIndex found = program.find(module, name);
  EXPECT_NE(found, kNoSymbol) << name;
  return program.symbol(found);
}

std::vector<Cell> cellsOf(const Program& program, std::string_view name) {
  const Symbol& symbol = symbolNamed(program, name);
  const Cell* const value = program.valueOf(symbol);
  return value == nullptr ? std::vector<Cell>{}
                          : std::vector<Cell>(value, value + program.types()[symbol.type].cells);
}

TEST(RapidProgram, hasTheValuesOfConstantsAsCells) {
  const auto program = programOf(
      "",
      "CONST num n:=2+3*4;\nCONST robtarget t:=[[1,-2,n],[1,0,0,0],[0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
      "CONST num grid{2,2}:=[[1,2],[3,4]];\nVAR num corner:=grid{2,1};\nVAR pos at:=t.trans;\n"
      "CONST bool both:=n=14 AND NOT FALSE;\nCONST pos twice:=2*at2;\nCONST pos at2:=[1,2,3];\n");
  EXPECT_THAT(cellsOf(*program, "n"), ElementsAre(14));
  EXPECT_THAT(cellsOf(*program, "t"),
              ElementsAre(1, -2, 14, 1, 0, 0, 0, 0, 0, 0, 0, 9E9F, 9E9F, 9E9F, 9E9F, 9E9F, 9E9F));
  EXPECT_THAT(cellsOf(*program, "corner"), ElementsAre(3));
  EXPECT_THAT(cellsOf(*program, "at"), ElementsAre(1, -2, 14));
  EXPECT_THAT(cellsOf(*program, "both"), ElementsAre(1));
  EXPECT_THAT(cellsOf(*program, "twice"), ElementsAre(2, 4, 6));
}

TEST(RapidProgram, foldsInSinglePrecision) {
  const auto program =
      programOf("",
                "CONST bool sum:=0.1+0.2=0.3;\nCONST num exact:=8388607+1;\nCONST num rest:=-7 MOD 4;\n"
                "CONST pos cross:=[1,0,0]*y;\nCONST pos y:=[0,1,0];\nCONST string s:=\"a\"+\"b\";\nCONST num "
                "left:=100/10/2;\n");
  EXPECT_THAT(cellsOf(*program, "sum"), ElementsAre(1));
  EXPECT_THAT(cellsOf(*program, "exact"), ElementsAre(8388608));
  EXPECT_THAT(cellsOf(*program, "rest"), ElementsAre(-3));
  EXPECT_THAT(cellsOf(*program, "cross"), ElementsAre(0, 0, 1));
  EXPECT_THAT(cellsOf(*program, "left"), ElementsAre(5));
  EXPECT_EQ(stringIn(program->valueOf(symbolNamed(*program, "s"))), "ab");
}

TEST(RapidProgram, leavesValuesOpenThatOnlyARunCanCalculate) {
  const auto program = programOf("", "CONST num root:=Sqrt(2);\nCONST num more:=root+1;\nVAR num zero;\n");
  EXPECT_THAT(program->valueOf(symbolNamed(*program, "root")), IsNull());
  EXPECT_THAT(program->valueOf(symbolNamed(*program, "more")), IsNull());
  EXPECT_THAT(program->valueOf(symbolNamed(*program, "zero")), IsNull());
}

TEST(RapidProgram, bindsEachArgumentToItsParameter) {
  const auto checked = checkedText(
      "MODULE m PROC main() q\\Note:=\"n\",1,limit:=2\\Fast; ENDPROC "
      "PROC q(\\string Note,num n,num limit\\switch Slow|switch Fast) ENDPROC ENDMODULE");
  ASSERT_THAT(checked.program, NotNull());
  const Program& program = *checked.program;
  const std::vector<NodeIndex> arguments = program.argumentsOf(kFile, nodeOf(program, NodeKind::Call));
  std::vector<std::string> texts;
  for (const NodeIndex argument : arguments) {
    const Span span = argument == kNoNode ? Span{} : program.source(kFile).spanOf(argument);
    texts.emplace_back(program.source(kFile).text().substr(span.begin, span.end - span.begin));
  }
  EXPECT_THAT(texts, ElementsAre("\\Note:=\"n\"", "1", "limit:=2", "", "\\Fast"));
}

TEST(RapidProgram, typesChainsFromTheLeft) {
  const auto program = programOf("b:=2*at=at;", "VAR bool b;\nVAR pos at;\n");
  const TypeIndex pos = symbolNamed(*program, "at").type;
  EXPECT_EQ(program->at(kFile, nodeOf(*program, NodeKind::Operation, 0)).type, pos);
  EXPECT_EQ(program->at(kFile, nodeOf(*program, NodeKind::Operation, 1)).type, kBool);
}

TEST(RapidProgram, bindsNamesByTheScopeOfTheirModule) {
  const auto source = [](const char* text) { return std::make_shared<const Source>(readSource(text)); };
  const CheckedProgram checked =
      check({{"a.mod", source("MODULE a LOCAL VAR num n; PROC main() n:=1; b_n; ENDPROC ENDMODULE")},
             {"b.mod", source("MODULE b LOCAL VAR string n; PROC b_n() n:=\"x\"; ENDPROC ENDMODULE")}},
            {});
  ASSERT_THAT(checked.program, NotNull());
  const Program& program = *checked.program;
  const auto module_of = [&](FileIndex file) {
    const Tree& tree = program.source(file).tree();
    return program.at(file, tree.childOf(Tree::kRoot, NodeKind::Module)).symbol;
  };
  EXPECT_EQ(program.symbol(program.find(module_of(kFile), "n")).type, kNum);
  EXPECT_EQ(program.symbol(program.find(module_of(kFile + 1), "n")).type, kString);
  EXPECT_EQ(program.symbol(program.main()).name, "main");
}

/// Nodes whose name a program needs.
bool needsSymbol(const Node& node) {
  switch (node.kind) {
    case NodeKind::Reference:
    case NodeKind::Function:
    case NodeKind::Call:
    case NodeKind::Goto:
    case NodeKind::Label:
    case NodeKind::Connect:
    case NodeKind::For:
    case NodeKind::Data:
    case NodeKind::Parameter:
    case NodeKind::Routine:
    case NodeKind::Module:
    case NodeKind::Part:
      return true;
    default:
      return false;
  }
}

TEST(RapidProgram, leavesNoNameOfAProgramUnbound) {
  for (const char* name : {"01_lexical", "02_flow", "03_values", "04_parameters", "05_errors", "09_pallet",
                           "10_frames", "15_generated"}) {
    std::ifstream file(test_support::inSourceTree(std::string("test/data/rapid/") + name + ".mod"));
    CheckOptions options;
    Signal grip;
    grip.name = grip.folded = "do_grip";
    grip.type = SignalType::Do;
    options.signals = {grip};
    const CheckedProgram checked =
        checkedText({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}, options);
    ASSERT_THAT(checked.program, NotNull()) << name;
    const Program& program = *checked.program;
    const Tree& tree = program.source(kFile).tree();
    for (NodeIndex node = 0; node < tree.size(); ++node) {
      const Meaning& meaning = program.at(kFile, node);
      if (needsSymbol(tree[node])) {
        EXPECT_NE(meaning.symbol, kNoSymbol) << name << ' ' << node;
      }
      // `*` is of the dimensions of a parameter.
      if (isExpression(tree[node].kind) && tree[node].kind != NodeKind::Star) {
        EXPECT_NE(meaning.type, kNoType) << name << ' ' << node;
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::rapid
