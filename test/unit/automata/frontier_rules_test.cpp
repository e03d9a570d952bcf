// The frontier as rules for people: they refuse exactly what it refuses (cell.md, S4).
#include "cobot_command/automata/frontier_rules.h"

#include <fstream>
#include <sstream>

#include "cell_problems.h"
#include "source_tree.h"
#include "synthesized.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/compression.h"
#include "cobot_command/automata/formats.h"

namespace cobot_command::automata {
namespace {

using test_support::a1;
using test_support::a2a;
using test_support::ring;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kStates = 1000000;

struct Ruled {
  explicit Ruled(const Problem& problem) {
    const Synthesized synthesized(problem);
    if (synthesized.synthesis.empty()) return;
    supervisor = compile(synthesized.synthesis, problem);
    refused_beyond_spec = synthesized.synthesis.counts().refused_beyond_spec;
    states = synthesized.synthesis.counts().states;
    rules = *frontierRulesOf(supervisor, kStates);
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> texts;
    for (const FrontierRule& rule : rules) texts.push_back(toString(rule, supervisor.problem));
    return texts;
  }

  CompiledSupervisor supervisor;
  std::vector<FrontierRule> rules;
  std::size_t refused_beyond_spec = 0;
  std::size_t states = 0;
};

void expectTheSameLoop(const Ruled& ruled, const std::string& name) {
  const RuleComparison found = compareRules(ruled.supervisor, ruled.rules, kStates);
  EXPECT_THAT(found.faults, IsEmpty()) << name;
  EXPECT_EQ(found.states, ruled.states) << name;
  EXPECT_EQ(found.refused, ruled.refused_beyond_spec) << name;
  EXPECT_LE(ruled.rules.size(), ruled.supervisor.frontier.size()) << name;
}

std::vector<Problem> problemsOfTheDataFile() {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("test/data/cell-oracles.json")).rdbuf();
  return *problemsFromJson(text.str());
}

TEST(FrontierRules, refuseWhatTheFrontierRefusesAndNothingElse) {
  for (const Problem& problem : {a1(), a2a(), ring(3), ring(4), ring(5)}) {
    expectTheSameLoop(Ruled(problem), problem.name);
    expectTheSameLoop(Ruled(compress(problem).problem), problem.name + ", compressed");
  }
}

TEST(FrontierRules, refuseNothingElseInAllProblemsOfTheDataFile) {
  std::size_t with_rules = 0;
  for (const Problem& problem : problemsOfTheDataFile()) {
    const Ruled ruled(problem);
    if (ruled.states == 0) continue;
    expectTheSameLoop(ruled, problem.name);
    if (!ruled.rules.empty()) ++with_rules;
  }
  EXPECT_GE(with_rules, 8U) << "else this says little";
}

TEST(FrontierRules, nameTheRobotsAndTheirPlaces) {
  EXPECT_THAT(Ruled(a1()).texts(), IsEmpty());
  EXPECT_THAT(Ruled(a2a()).texts(), ElementsAre("not RA at RA.2 while RB at RB.2"));
  EXPECT_THAT(Ruled(ring(3)).texts(), ElementsAre("not R1 at R1.2 while R2 at R2.2 and R3 at R3.2"));
}

TEST(FrontierRules, leaveOutRobotsThatHaveNothingToDoWithIt) {
  Problem problem = a2a();
  // A third robot that goes round and round beside them.
  const Problem other = test_support::problemOf("", {{"RC", {"g W", "r W"}}});
  Automaton plant = other.automata.front();
  const auto first = static_cast<EventIndex>(problem.events.size());
  problem.events.insert(problem.events.end(), other.events.begin(), other.events.end());
  for (EventIndex& event : plant.alphabet) event += first;
  for (Transition& transition : plant.transitions) transition.event += first;
  problem.automata.push_back(std::move(plant));
  const Ruled ruled(problem);
  EXPECT_EQ(ruled.supervisor.frontier.size(), 2U);
  EXPECT_THAT(ruled.texts(), ElementsAre("not RA at RA.2 while RB at RB.2"));
  expectTheSameLoop(ruled, "two robots and one beside them");
}

TEST(FrontierRules, areNotFoundForMoreStatesThanAllowed) {
  const Ruled ruled(ring(3));
  const auto refused = frontierRulesOf(ruled.supervisor, 10);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().limit, 10U);
  EXPECT_THAT(compareRules(ruled.supervisor, ruled.rules, 10).faults,
              ElementsAre(HasSubstr("there are more than 10 states")));
}

/// The teeth: any rule that is left out, or has a place or robot more or less, is found.
TEST(ComparedRules, areFoundTooNarrowWhereARuleIsMissing) {
  for (const Problem& problem : {a2a(), ring(3), ring(4)}) {
    const Ruled ruled(problem);
    ASSERT_FALSE(ruled.rules.empty());
    for (std::size_t index = 0; index < ruled.rules.size(); ++index) {
      auto rules = ruled.rules;
      rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(index));
      EXPECT_THAT(compareRules(ruled.supervisor, rules, kStates).faults,
                  Contains(HasSubstr("the rules are too narrow: none refuses")))
          << problem.name << ", rule " << index;
    }
  }
}

TEST(ComparedRules, areFoundTooNarrowWhereAPlaceIsMissing) {
  for (const Problem& problem : {a2a(), ring(4)}) {
    const Ruled ruled(problem);
    for (std::size_t index = 0; index < ruled.rules.size(); ++index) {
      for (std::size_t condition = 0; condition < ruled.rules[index].conditions.size(); ++condition) {
        auto rules = ruled.rules;
        rules[index].conditions[condition].states.pop_back();
        EXPECT_THAT(compareRules(ruled.supervisor, rules, kStates).faults, Contains(HasSubstr("too narrow")))
            << problem.name << ", rule " << index;
      }
    }
  }
}

TEST(ComparedRules, areFoundTooWideWhereARobotIsMissing) {
  for (const Problem& problem : {a2a(), ring(3), ring(4), ring(5)}) {
    const Ruled ruled(problem);
    for (std::size_t index = 0; index < ruled.rules.size(); ++index) {
      for (std::size_t condition = 0; condition < ruled.rules[index].conditions.size(); ++condition) {
        auto rules = ruled.rules;
        auto& conditions = rules[index].conditions;
        conditions.erase(conditions.begin() + static_cast<std::ptrdiff_t>(condition));
        EXPECT_THAT(compareRules(ruled.supervisor, rules, kStates).faults,
                    Contains(HasSubstr("a rule is too wide: \"not ")))
            << problem.name << ", rule " << index;
      }
    }
  }
}

TEST(ComparedRules, areToldWithTheEventsThatLeadThere) {
  const Ruled ruled(a2a());
  auto rules = ruled.rules;
  // RB at its place behind its second booking: nothing is wrong with RA at home.
  rules.push_back({{{0, {0}}, {1, {3}}}});
  EXPECT_THAT(compareRules(ruled.supervisor, rules, kStates).faults,
              Contains("a rule is too wide: \"not RA at RA.0 while RB at RB.3\" refuses RB_b_Z1 after RB_g_W "
                       "RB_b_Z2, which the supervisor grants"));
  EXPECT_THAT(
      compareRules(ruled.supervisor, {}, kStates).faults,
      Contains("the rules are too narrow: none refuses RB_b_Z2 after RA_g_W RA_b_Z1 RB_g_W, which the "
               "supervisor refuses"));
}

}  // namespace
}  // namespace cobot_command::automata
