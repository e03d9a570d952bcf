// The shape of trees (section 3 of the contract of RAPID).
#include "tree_text.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::IsEmpty;

std::string moduleText(const std::string& text, Dialect dialect = Dialect::Irc5) {
  const Source source = readSource(text, {dialect});
  return treeText(source, source.tree().childOf(Tree::kRoot, NodeKind::Module));
}

TEST(RapidTree, ranksOperatorsAsTheSourceDoes) {
  EXPECT_EQ(expressionText("1+2*3"), "Chain(Number 1, Operation +(Chain(Number 2, Operation *(Number 3))))");
  EXPECT_EQ(expressionText("a OR b AND c"),
            "Chain(Reference a, Operation OR(Chain(Reference b, Operation AND(Reference c))))");
  EXPECT_EQ(expressionText("a<b AND c<>d"),
            "Chain(Chain(Reference a, Operation <(Reference b)), Operation AND(Chain(Reference c, Operation "
            "<>(Reference d))))");
  EXPECT_EQ(expressionText("(1+2)*3"),
            "Chain(Parentheses(Chain(Number 1, Operation +(Number 2))), Operation *(Number 3))");
}

TEST(RapidTree, groupsOperatorsOfOneRankInOneNode) {
  EXPECT_EQ(expressionText("100/10/2 MOD 3"),
            "Chain(Number 100, Operation /(Number 10), Operation /(Number 2), Operation MOD(Number 3))");
}

TEST(RapidTree, letsALeadingNotStandForTheWholeChain) {
  EXPECT_EQ(expressionText("NOT a AND b"), "Not(Chain(Reference a, Operation AND(Reference b)))");
  EXPECT_EQ(expressionText("a AND NOT b=c"),
            "Chain(Reference a, Operation AND(Not(Chain(Reference b, Operation =(Reference c)))))");
  EXPECT_EQ(expressionText("NOT a OR b"), "Chain(Not(Reference a), Operation OR(Reference b))");
}

TEST(RapidTree, letsALeadingSignStandForTheWholeProduct) {
  EXPECT_EQ(expressionText("-7 MOD 4"), "Sign -(Chain(Number 7, Operation MOD(Number 4)))");
  EXPECT_EQ(expressionText("a- -1"), "Chain(Reference a, Operation -(Sign -(Number 1)))");
  EXPECT_EQ(expressionText("2*-3"), "Chain(Number 2, Operation *(Sign -(Number 3)))");
}

TEST(RapidTree, readsAllOperands) {
  EXPECT_EQ(expressionText("[1,\"x\",TRUE,[-2]]"),
            "Aggregate(Number 1, String \"x\", Bool TRUE, Aggregate(Sign -(Number 2)))");
  EXPECT_EQ(expressionText("a{1,i+1}.b.c{2}"),
            "Reference a(Index(Number 1, Chain(Reference i, Operation +(Number 1))), Part b, Part c, "
            "Index(Number 2))");
  EXPECT_EQ(expressionText("f()"), "Function f");
  EXPECT_EQ(expressionText("f(1\\X\\Y:=2,z:=3\\W?q)"),
            "Function f(Number 1, \\Argument X, \\Argument Y(Number 2), Argument z(Number 3), \\?Argument "
            "W(Reference q))");
}

TEST(RapidTree, readsCallsWithTheirArguments) {
  EXPECT_EQ(
      instructionText("MoveL\\Conc,p1,v100\\T:=5,fine,tool0\\WObj:=w;"),
      "Call MoveL(\\Argument Conc, Reference p1, Reference v100, \\Argument T(Number 5), Reference fine, "
      "Reference tool0, \\Argument WObj(Reference w))");
  EXPECT_EQ(instructionText("go;"), "Call go");
  EXPECT_EQ(instructionText("f (a);"), "Call f(Parentheses(Reference a))");
  EXPECT_EQ(instructionText("f(a)+1,2;"),
            "Call f(Chain(Parentheses(Reference a), Operation +(Number 1)), Number 2)");
  EXPECT_EQ(instructionText("classify -1;"), "Call classify(Sign -(Number 1))");
  EXPECT_EQ(instructionText("f\nDist:=1,Angle:=2;"), "!Call f");
  EXPECT_EQ(instructionText("f Dist:=1,\nAngle:=2;"),
            "Call f(Argument Dist(Number 1), Argument Angle(Number 2))");
}

TEST(RapidTree, readsCallsWhoseNameIsCalculated) {
  EXPECT_EQ(instructionText("%\"step\"+NumToStr(i,0)% i*10\\X;"),
            "LateCall(Chain(String \"step\", Operation +(Function NumToStr(Reference i, Number 0))), "
            "Chain(Reference i, Operation *(Number 10)), \\Argument X)");
}

TEST(RapidTree, readsSimpleInstructions) {
  EXPECT_EQ(instructionText("a{1}.x:=2;"), "Assignment(Reference a(Index(Number 1), Part x), Number 2)");
  EXPECT_EQ(instructionText("again:"), "Label again");
  EXPECT_EQ(instructionText("GOTO again;"), "Goto again");
  EXPECT_EQ(instructionText("RETURN;"), "Return");
  EXPECT_EQ(instructionText("RETURN\n  x;"), "Return(Reference x)");
  EXPECT_EQ(instructionText("RAISE 17;"), "Raise(Number 17)");
  EXPECT_EQ(instructionText("RETRY;"), "Retry");
  EXPECT_EQ(instructionText("TRYNEXT;"), "Trynext");
  EXPECT_EQ(instructionText("EXIT;"), "Exit");
  EXPECT_EQ(instructionText("CONNECT iv{2} WITH t;"), "Connect t(Reference iv(Index(Number 2)))");
}

TEST(RapidTree, letsThenDecideForTheBlock) {
  EXPECT_EQ(instructionText("IF a THEN b; ELSEIF c THEN d; ELSE e; ENDIF"),
            "If(Reference a, List(Call b), Elseif(Reference c, List(Call d)), Else(List(Call e)))");
  EXPECT_EQ(instructionText("IF\n a\n >1\n b;"),
            "CompactIf(Chain(Reference a, Operation >(Number 1)), Call b)");
  EXPECT_EQ(instructionText("IF a IF b GOTO c;"), "CompactIf(Reference a, CompactIf(Reference b, Goto c))");
  EXPECT_EQ(instructionText("IF a WHILE b DO c; ENDWHILE"),
            "CompactIf(Reference a, While(Reference b, List(Call c)))");
}

TEST(RapidTree, readsLoopsAndTests) {
  EXPECT_EQ(instructionText("FOR i FROM 1 TO n STEP -1 DO a; ENDFOR"),
            "For i(Number 1, Reference n, Step(Sign -(Number 1)), List(Call a))");
  EXPECT_EQ(instructionText("FOR i FROM 1 TO n DO ENDFOR"), "For i(Number 1, Reference n, List)");
  EXPECT_EQ(instructionText("WHILE TRUE DO a; ENDWHILE"), "While(Bool TRUE, List(Call a))");
  EXPECT_EQ(instructionText("TEST a CASE 1,2: b; CASE 3: DEFAULT: c; ENDTEST"),
            "Test(Reference a, Case(Number 1, Number 2, List(Call b)), Case(Number 3, List), "
            "DefaultCase(List(Call c)))");
}

TEST(RapidTree, readsModulesWithAttributes) {
  EXPECT_EQ(moduleText("MODULE m(SYSMODULE,NOSTEPIN,VIEWONLY,READONLY) ENDMODULE"),
            "Module m(Attribute SYSMODULE, Attribute NOSTEPIN, Attribute VIEWONLY, Attribute READONLY)");
  EXPECT_THAT(findingsOf("MODULE m(SYSMODULE,NOVIEW)\nENDMODULE"), IsEmpty());
  EXPECT_THAT(findingsOf("MODULE m(NOVIEW)\nENDMODULE"), IsEmpty());
}

TEST(RapidTree, readsDeclarations) {
  EXPECT_EQ(
      moduleText(
          "MODULE m LOCAL VAR num a{2,3}:=[1]; TASK PERS pos p:=[1,2,3]; CONST bool c:=TRUE; ENDMODULE"),
      "Module m(local Data VAR a(TypeName num, Dimensions(Number 2, Number 3), Aggregate(Number 1)), "
      "task Data PERS p(TypeName pos, Aggregate(Number 1, Number 2, Number 3)), "
      "Data CONST c(TypeName bool, Bool TRUE))");
  EXPECT_EQ(moduleText("MODULE m RECORD r num a; pos b; ENDRECORD LOCAL ALIAS num n; ENDMODULE"),
            "Module m(Record r(Component a(TypeName num), Component b(TypeName pos)), local Alias n(TypeName "
            "num))");
}

TEST(RapidTree, readsRoutinesWithParametersAndHandlers) {
  EXPECT_EQ(
      moduleText("MODULE m PROC p(\\switch on|switch off,num a{*,*},INOUT num b\\VAR num c) VAR num d; a; "
                 "BACKWARD b; ERROR (1,ERR_X) c; UNDO d; ENDPROC ENDMODULE"),
      "Module m(Routine PROC p(Parameters(\\Parameter on(TypeName switch), \\|Parameter off(TypeName "
      "switch), "
      "Parameter a(TypeName num, Dimensions(Star *, Star *)), Parameter INOUT b(TypeName num), "
      "\\Parameter VAR c(TypeName num)), List(Data VAR d(TypeName num), Call a), "
      "Handler BACKWARD(List(Call b)), Handler ERROR(ErrorNumbers(Number 1, Reference ERR_X), List(Call c)), "
      "Handler UNDO(List(Call d))))");
  EXPECT_EQ(moduleText("MODULE m LOCAL FUNC num f() RETURN 1; ENDFUNC TRAP t ENDTRAP ENDMODULE"),
            "Module m(local Routine FUNC f(TypeName num, Parameters, List(Return(Number 1))), Routine TRAP "
            "t(List))");
}

TEST(RapidTree, readsDeclarationsWithoutBodies) {
  const Source source =
      readSource("MODULE m(SYSMODULE) PROC a(num x) FUNC num b() PROC c() ENDMODULE", {Dialect::Irc5, false});
  EXPECT_THAT(source.findings(), IsEmpty());
  EXPECT_EQ(treeText(source, Tree::kRoot),
            "File(Module m(Attribute SYSMODULE, Routine PROC a(Parameters(Parameter x(TypeName num))), "
            "Routine FUNC b(TypeName num, Parameters), Routine PROC c(Parameters)))");
}

TEST(RapidTree, readsHeadersAndSeveralModules) {
  const Source source =
      readSource("%%%\nVERSION:1\nLANGUAGE:german\n%%%\nMODULE a ENDMODULE\n! x\nMODULE b ENDMODULE");
  EXPECT_THAT(source.findings(), IsEmpty());
  EXPECT_EQ(treeText(source, Tree::kRoot), "File(Header, Module a, Module b)");
}

TEST(RapidTree, spansEachNodeFromItsFirstTokenToItsLast) {
  const std::string text = inRoutine("  a := -(b + 1) * 2 ; ! x");
  const Source source = readSource(text);
  const NodeIndex assignment = source.tree()[bodyOf(source)].child;
  const NodeIndex target = source.tree()[assignment].child;
  const auto spanned = [&](NodeIndex node) {
    const Span span = source.spanOf(node);
    return text.substr(span.begin, span.end - span.begin);
  };
  EXPECT_EQ(spanned(assignment), "a := -(b + 1) * 2 ;");
  EXPECT_EQ(spanned(target), "a");
  EXPECT_EQ(spanned(source.tree()[target].next), "-(b + 1) * 2");
}

TEST(RapidTree, isTheSameWhereverBlanksAndCommentsAre) {
  EXPECT_EQ(instructionText("IF a THEN b:=1; ENDIF"),
            instructionText("if ! one\na then ! two\n\n ! three\nb:=! four\n1;endif"));
}

}  // namespace
}  // namespace cobot_command::rapid
