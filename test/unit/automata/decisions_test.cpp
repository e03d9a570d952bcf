// Decisions while plants run: of the supervisor, and of the safe order.
#include <random>

#include "cell_problems.h"
#include "synthesized.h"
#include "thorough.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/safe_order.h"
#include "cobot_command/automata/supervisor.h"

namespace cobot_command::automata {
namespace {

using test_support::a1;
using test_support::a2a;
using test_support::problemOf;
using test_support::ring;
using Verdict = Decision::Verdict;

Supervisor supervisorOf(const Problem& problem) {
  const Synthesized synthesized(problem);
  return Supervisor(compile(synthesized.synthesis, problem));
}

EventIndex eventOf(const Problem& problem, const std::string& name) {
  for (EventIndex event = 0; event < problem.events.size(); ++event) {
    if (problem.events[event].name == name) return event;
  }
  ADD_FAILURE() << "no event " << name;
  return 0;
}

/// Events by name, on a supervisor or a safe order.
template <class Rule>
class Course {
 public:
  Course(const Rule& rule, const Problem& problem) : rule_(rule), problem_(problem), state_(rule.initial()) {}

  Verdict ask(const std::string& name) {
    const Decision decision = rule_.decide(state_, eventOf(problem_, name));
    if (decision.verdict == Verdict::Granted) state_ = decision.next;
    return decision.verdict;
  }
  void happen(std::initializer_list<const char*> names) {
    for (const char* name : names) EXPECT_EQ(ask(name), Verdict::Granted) << name;
  }

 private:
  const Rule& rule_;
  const Problem& problem_;
  Tuple state_;
};

template <class Rule>
void expectTheRunOfOracle8(const Rule& rule, const Problem& problem) {
  Course<Rule> run(rule, problem);
  run.happen({"R1_g_W", "R1_b_Z1", "R2_g_W", "R2_b_Z2", "R3_g_W"});
  EXPECT_EQ(run.ask("R3_b_Z3"), Verdict::WouldBlock);
  EXPECT_EQ(run.ask("R1_b_Z2"), Verdict::SpecBlocks);
  EXPECT_EQ(run.ask("R2_b_Z3"), Verdict::Granted);
  run.happen({"R2_r_W", "R2_g_HOME"});
  EXPECT_EQ(run.ask("R3_b_Z3"), Verdict::SpecBlocks);
  run.happen({"R2_u_Z3"});
  EXPECT_EQ(run.ask("R3_b_Z3"), Verdict::Granted) << "R2 still holds Z2";
}

TEST(Supervisor, decidesAsInOracle8) {
  const Problem problem = ring(3);
  expectTheRunOfOracle8(supervisorOf(problem), problem);
}

TEST(SafeOrder, decidesAsInOracle8) {
  const Problem problem = ring(3);
  expectTheRunOfOracle8(SafeOrder(problem), problem);
}

TEST(Supervisor, namesTheZoneThatBlocks) {
  const Problem problem = a1();
  const Supervisor supervisor = supervisorOf(problem);
  Tuple state = supervisor.initial();
  for (const char* name : {"RA_g_T1", "RA_b_Z", "RB_g_T1"}) {
    state = supervisor.decide(state, eventOf(problem, name)).next;
  }
  const Decision decision = supervisor.decide(state, eventOf(problem, "RB_b_Z"));
  ASSERT_EQ(decision.verdict, Verdict::SpecBlocks);
  EXPECT_EQ(problem.automata[*decision.automaton].name, "Z");
}

TEST(Supervisor, knowsNoEventBeyondItsOwn) {
  const Problem problem = a1();
  const Supervisor supervisor = supervisorOf(problem);
  EXPECT_EQ(supervisor.decide(supervisor.initial(), 12).verdict, Verdict::UnknownEvent);
  EXPECT_EQ(supervisor.decide(supervisor.initial(), ~EventIndex{0}).verdict, Verdict::UnknownEvent);
  EXPECT_EQ(supervisor.decide(supervisor.initial(), eventOf(problem, "RA_b_Z")).verdict,
            Verdict::NotInPlants);
}

struct Ends {
  int dead = 0;
  int steps = 0;
};

/// Events by chance, each that is possible as likely as the others, until nothing is, or `steps` are done.
template <class Rule>
Ends runByChance(const Rule& rule, std::size_t events, unsigned seed, int steps) {
  std::mt19937 chance(seed);
  Tuple state = rule.initial();
  for (int step = 0; step < steps; ++step) {
    std::vector<Tuple> next;
    for (EventIndex event = 0; event < events; ++event) {
      Decision decision = rule.decide(state, event);
      if (decision.verdict == Verdict::Granted) next.push_back(std::move(decision.next));
    }
    if (next.empty()) return {1, step};
    state = next[std::uniform_int_distribution<std::size_t>(0, next.size() - 1)(chance)];
  }
  return {0, steps};
}

/// How many of `runs` end dead where nobody decides but the zones.
int deadWithoutSupervisor(const Problem& problem, int runs, int steps) {
  const Supervisor nobody({problem, {}});
  int dead = 0;
  for (int run = 0; run < runs; ++run) {
    dead += runByChance(nobody, problem.events.size(), static_cast<unsigned>(run), steps).dead;
  }
  return dead;
}

TEST(MutualExclusionAlone, endsDead) {
  EXPECT_EQ(deadWithoutSupervisor(a2a(), 500, 1000), 500);
  EXPECT_GE(deadWithoutSupervisor(ring(3), 500, 400), 495);
  EXPECT_EQ(deadWithoutSupervisor(ring(3), 500, 1000), 500);
}

TEST(Supervisor, neverEndsDead) {
  for (const Problem& problem : {a2a(), ring(3)}) {
    const Supervisor supervisor = supervisorOf(problem);
    for (unsigned seed = 0; seed < testing::tenthWhenWatched(500U); ++seed) {
      EXPECT_EQ(runByChance(supervisor, problem.events.size(), seed, 1000).dead, 0);
    }
  }
}

TEST(SafeOrder, neverEndsDeadInARingThatNoTableHolds) {
  const Problem problem = ring(32);
  const SafeOrder rule(problem);
  for (unsigned seed = 0; seed < 3; ++seed) {
    EXPECT_EQ(runByChance(rule, problem.events.size(), seed, 1000).dead, 0);
  }
}

TEST(SafeOrder, bringsAllHomeInTheOrderThatItSays) {
  const Problem problem = ring(3);
  const SafeOrder rule(problem);
  Tuple state = rule.initial();
  for (const char* name : {"R1_g_W", "R1_b_Z1", "R2_g_W", "R2_b_Z2"}) {
    state = rule.decide(state, eventOf(problem, name)).next;
  }
  EXPECT_THAT(rule.orderHome(state), ::testing::ElementsAre(1, 2, 0)) << "R1 waits for R2";
  EXPECT_THAT(rule.aheadOf(state, 0), ::testing::ElementsAre(1)) << "R3 is at home";
  EXPECT_THAT(rule.aheadOf(state, 1), ::testing::IsEmpty());
}

TEST(SafeOrder, choosesAmongPathsOnlyThoseThatLeadHome) {
  Problem problem =
      problemOf("branch", {{"RA", {"g W", "b Z1", "r W", "g P", "b Z2", "u Z2", "u Z1", "r HOME"}},
                           {"RB", {"g W", "b Z2", "b Z1", "u Z1", "u Z2", "r HOME"}}});
  // At W, RA may also go home by itself, giving back what it has.
  problem.automata[0].alphabet.push_back(static_cast<EventIndex>(problem.events.size()));
  problem.automata[0].transitions.push_back({3, static_cast<EventIndex>(problem.events.size()), 6});
  problem.events.push_back({"RA_g_HOME", true});
  const SafeOrder rule(problem);
  Course<SafeOrder> run(rule, problem);
  run.happen({"RA_g_W", "RA_b_Z1", "RA_r_W", "RB_g_W", "RB_b_Z2"});
  EXPECT_EQ(run.ask("RA_g_P"), Verdict::WouldBlock);
  run.happen({"RA_g_HOME", "RA_u_Z1", "RB_b_Z1"});
}

TEST(SafeOrder, refusesProblemsWhoseBookingsCannotWait) {
  Problem problem = a1();
  EXPECT_THAT(SafeOrder::objectionsTo(problem), ::testing::IsEmpty());
  problem.events[eventOf(problem, "RB_b_Z")].controllable = false;
  EXPECT_THAT(SafeOrder::objectionsTo(problem),
              ::testing::ElementsAre(::testing::HasSubstr("\"RB_b_Z\" takes Z")));
}

}  // namespace
}  // namespace cobot_command::automata
