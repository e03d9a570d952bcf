#include "cobot_command/automata/formats.h"

#include <fstream>
#include <random>
#include <sstream>

#include "cell_problems.h"
#include "source_tree.h"
#include "synthesized.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/canonical.h"

namespace cobot_command::automata {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string dataFile() {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("test/data/cell-oracles.json")).rdbuf();
  return text.str();
}

std::string fingerprintOf(const Problem& problem) {
  const Synthesized synthesized(problem);
  if (synthesized.synthesis.empty()) return "empty";
  return canonicalFormOf(automatonOf(synthesized.synthesis, problem), problem.events)
      .fingerprint(problem.events);
}

TEST(Json, bringsAllProblemsBack) {
  const auto problems = problemsFromJson(dataFile());
  ASSERT_TRUE(problems) << problems.error();
  ASSERT_EQ(problems->size(), 15U);
  const auto again = problemsFromJson(toJson(*problems));
  ASSERT_TRUE(again) << again.error();
  for (std::size_t index = 0; index < problems->size(); ++index) {
    EXPECT_EQ(fingerprintOf((*problems)[index]), fingerprintOf((*again)[index]));
  }
  EXPECT_EQ(toJson(*problems), toJson(*again));
}

TEST(Wmod, bringsAllProblemsBack) {
  const auto problems = problemsFromJson(dataFile());
  ASSERT_TRUE(problems) << problems.error();
  for (const Problem& problem : *problems) {
    const auto again = problemFromWmod(toWmod(problem));
    ASSERT_TRUE(again) << problem.name << ": " << again.error();
    EXPECT_EQ(fingerprintOf(problem), fingerprintOf(*again)) << problem.name;
  }
}

TEST(Json, saysWhereWhatIsWrong) {
  const auto fault = [](const std::string& text) { return problemsFromJson(text).error(); };
  EXPECT_THAT(fault("{"), HasSubstr("not JSON"));
  EXPECT_THAT(fault("[]"), HasSubstr("the file is not an object"));
  EXPECT_THAT(fault("{}"), HasSubstr("the file has no \"problems\""));
  EXPECT_THAT(fault(R"({"problems": [7]})"), HasSubstr("problems[0] is not an object"));
  EXPECT_THAT(fault(R"({"problems": [{"events": 7}]})"),
              HasSubstr("problems[0].events is number, not array"));
  EXPECT_THAT(fault(R"({"problems": [{"events": [{"name": "a"}]}]})"),
              HasSubstr("problems[0].events[0] has no \"controllable\""));
  std::string text = toJson({test_support::a1()});
  text.replace(text.find("\"plant\""), 7, "\"plane\"");
  EXPECT_THAT(fault(text),
              HasSubstr("problems[0].automata[0].kind is \"plane\": allowed are plant and spec"));
}

TEST(Json, neverPassesWhatIsNoProblem) {
  const std::string whole = toJson({test_support::a1()});
  std::mt19937 chance(1);
  for (int run = 0; run < 2000; ++run) {
    std::string text = whole;
    text[chance() % text.size()] = static_cast<char>(chance() % 256);
    if (run % 2 == 0) text.resize(chance() % text.size());
    const auto problems = problemsFromJson(text);
    if (!problems) continue;
    for (const Problem& problem : *problems) EXPECT_THAT(faultsOf(problem), ::testing::IsEmpty());
  }
}

TEST(Wmod, neverPassesWhatIsNoProblem) {
  const std::string whole = toWmod(test_support::a1());
  std::mt19937 chance(1);
  for (int run = 0; run < 2000; ++run) {
    std::string text = whole;
    text[chance() % text.size()] = static_cast<char>(chance() % 256);
    if (run % 2 == 0) text.resize(chance() % text.size());
    const auto problem = problemFromWmod(text);
    if (problem) {
      EXPECT_THAT(faultsOf(*problem), ::testing::IsEmpty());
    }
  }
}

/// As Supremica writes them: with places of nodes and labels, and no :accepting where all states are marked.
constexpr const char* kOfSupremica = R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<Module Name="drill" xmlns="http://waters.sourceforge.net/xsd/module" xmlns:ns2="http://waters.sourceforge.net/xsd/base">
  <ns2:Comment>by hand</ns2:Comment>
  <EventDeclList>
    <EventDecl Kind="CONTROLLABLE" Name="go"/><EventDecl Kind="UNCONTROLLABLE" Name="done"/>
    <EventDecl Kind="PROPOSITION" Name=":accepting"/>
  </EventDeclList>
  <ComponentList>
    <SimpleComponent Kind="PLANT" Name="drill"><Graph>
      <NodeList>
        <SimpleNode Initial="true" Name="rests"><PointGeometry><Point X="1" Y="2"/></PointGeometry></SimpleNode>
        <SimpleNode Name="works"/>
      </NodeList>
      <EdgeList>
        <Edge Source="rests" Target="works"><LabelBlock><SimpleIdentifier Name="go"/>
          <LabelGeometry Anchor="NW"><Point X="1" Y="1"/></LabelGeometry></LabelBlock></Edge>
        <Edge Source="works" Target="rests"><LabelBlock><SimpleIdentifier Name="done"/></LabelBlock>
          <SplineGeometry><Point X="1" Y="1"/></SplineGeometry></Edge>
      </EdgeList>
    </Graph></SimpleComponent>
    %s
  </ComponentList>
</Module>)";

std::string ofSupremica(const std::string& more) {
  std::string text = kOfSupremica;
  return text.replace(text.find("%s"), 2, more);
}

TEST(Wmod, readsWhatSupremicaWrites) {
  const auto problem = problemFromWmod(ofSupremica(""));
  ASSERT_TRUE(problem) << problem.error();
  EXPECT_EQ(problem->name, "drill");
  ASSERT_EQ(problem->automata.size(), 1U);
  EXPECT_THAT(problem->automata[0].marked, ::testing::ElementsAre(0, 1));
  EXPECT_FALSE(problem->events[1].controllable);
}

TEST(Wmod, refusesByNameWhatIsMoreThanPlainAutomata) {
  const auto fault = [](const std::string& more) { return problemFromWmod(ofSupremica(more)).error(); };
  EXPECT_THAT(fault("<VariableComponent Name=\"v\"/>"), HasSubstr("<VariableComponent>"));
  EXPECT_THAT(fault("<Instance Name=\"v\"/>"), HasSubstr("<Instance>"));
  EXPECT_THAT(
      fault("<SimpleComponent Kind=\"PLANT\" Name=\"p\"><Graph><NodeList><SimpleNode Initial=\"true\" "
            "Name=\"n\"/>"
            "</NodeList><EdgeList><Edge Source=\"n\" Target=\"n\"><GuardActionBlock/></Edge></EdgeList>"
            "</Graph></SimpleComponent>"),
      HasSubstr("<GuardActionBlock>"));
  EXPECT_THAT(problemFromWmod("<Model/>").error(), HasSubstr("<Module>"));
  EXPECT_THAT(problemFromWmod("drill").error(), HasSubstr("not XML"));
}

Problem withOddNames() {
  Problem problem = test_support::a1();
  problem.events[0].name = "end";
  problem.events[1].name = "a-b";
  problem.events[2].name = "a b";
  problem.automata[0].name = "1st robot -- the left one";
  return problem;
}

TEST(NamesThatAFormatDoesNotAllow, areMappedOneToOneWithATable) {
  const std::string cif = toCif(withOddNames());
  EXPECT_THAT(cif, HasSubstr("// end_2 = end\n"));
  EXPECT_THAT(cif, HasSubstr("// a_b = a-b\n"));
  EXPECT_THAT(cif, HasSubstr("// a_b_2 = a b\n"));
  EXPECT_THAT(cif, HasSubstr("controllable end_2;\n"));
  const std::string wmod = toWmod(withOddNames());
  EXPECT_THAT(wmod, HasSubstr("a_b_2 = a b"));
  const auto again = problemFromWmod(wmod);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->automata[0].name, "1st robot -- the left one");
  EXPECT_EQ(fingerprintOf(*again), fingerprintOf(withOddNames()));
}

TEST(Cif, hasPlantsAndRequirements) {
  const std::string cif = toCif(test_support::a1());
  EXPECT_THAT(cif, HasSubstr("plant RA:\n  alphabet RA_g_T1, RA_b_Z"));
  EXPECT_THAT(cif, HasSubstr("requirement Z:\n"));
  EXPECT_THAT(cif, HasSubstr("uncontrollable RA_u_Z;\n"));
  EXPECT_THAT(cif, HasSubstr("  location RA_0:\n    initial;\n    marked;\n    edge RA_g_T1 goto RA_1;\n"));
}

TEST(Dot, hasAGraphOfEachAutomaton) {
  const std::string dot = toDot(withOddNames());
  EXPECT_THAT(dot, HasSubstr("digraph \"1st robot -- the left one\" {"));
  EXPECT_THAT(dot, HasSubstr("shape=doublecircle"));
  EXPECT_THAT(dot, HasSubstr("style=dashed"));
  EXPECT_THAT(dot, Not(HasSubstr("\"\"\"")));
}

}  // namespace
}  // namespace cobot_command::automata
