#include "cobot_command/automata/synthesis.h"

#include <array>
#include <utility>

#include "cell_problems.h"
#include "synthesized.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/canonical.h"
#include "cobot_command/automata/compression.h"
#include "cobot_command/automata/decomposition.h"

namespace cobot_command::automata {
namespace {

using test_support::a1;
using test_support::a2a;
using test_support::problemOf;
using test_support::ring;

using Size = std::pair<std::size_t, std::size_t>;  // states and transitions

Size sizeOf(const Problem& problem) {
  const Synthesized synthesized(problem);
  const SynthesisCounts& counts = synthesized.synthesis.counts();
  return {counts.states, counts.transitions};
}

/// The table of the thesis, Appendix D: the position is 12 times the state and the event.
Automaton tableOfAppendixD() {
  constexpr std::array<StateIndex, 48> kPositions = {
      5,   9,   17,  20,  27,  35,  39,  45,  51,  56,  62,  71,  74,  81,  86,  92,
      101, 111, 118, 123, 127, 135, 138, 146, 154, 158, 163, 170, 174, 191, 192, 201,
      204, 212, 220, 225, 232, 236, 241, 249, 253, 260, 274, 283, 288, 294, 304, 313};
  constexpr std::array<StateIndex, 48> kValues = {
      3,  1,  4, 8,  5,  3,  6,  4,  7,  11, 15, 6,  16, 7,  17, 14, 11, 12, 10, 13, 2,  14, 9,  22,
      13, 23, 5, 24, 12, 16, 18, 17, 19, 24, 20, 19, 21, 25, 0,  21, 1,  26, 23, 15, 25, 22, 26, 8};
  Automaton table;
  table.states.resize(27);
  table.initial = 7;
  table.marked = {7};
  for (std::size_t entry = 0; entry < kPositions.size(); ++entry) {
    table.transitions.push_back({kPositions[entry] / 12, kPositions[entry] % 12, kValues[entry]});
  }
  return table;
}

TEST(SynthesisOfA1, isTheTableOfTheThesis) {
  Problem problem = a1();
  std::vector<Event> events;
  for (const char* robot : {"RA", "RB"}) {
    for (const char* what : {"b_Z", "g_HOME", "g_T1", "r_HOME", "r_T1", "u_Z"}) {
      events.push_back({std::string(robot) + "_" + what, false});
    }
  }
  const Synthesized synthesized(problem);
  const auto ours = canonicalFormOf(automatonOf(synthesized.synthesis, problem), problem.events);
  const auto theirs = canonicalFormOf(tableOfAppendixD(), events);
  EXPECT_EQ(ours.fingerprint(problem.events), theirs.fingerprint(events));
  EXPECT_EQ(ours.fingerprint(problem.events),
            "e9bcf5c38a9e8688c3cee297d168a7e65669df69749552603be3749f73f0f863");
}

TEST(SynthesisOfRings, hasTheStatesOfTheFormula) {
  std::size_t before = 5;
  std::size_t last = 43;
  for (int robots = 3; robots <= 6; ++robots) {
    before = std::exchange(last, 5 * last + 9 * before);
    EXPECT_EQ(sizeOf(ring(robots)).first, last - 2) << robots;
  }
  EXPECT_EQ(sizeOf(ring(4)), Size(1685, 5880));
  EXPECT_EQ(sizeOf(ring(5)), Size(10773, 46960));
  EXPECT_EQ(sizeOf(ring(6)), Size(69056, 361296));
}

TEST(SynthesisOfARing, keepsOutOfOneStateOnly) {
  for (int robots = 3; robots <= 5; ++robots) {
    EXPECT_EQ(Synthesized(ring(robots)).synthesis.frontier().size(), 1U);
  }
}

TEST(Compression, keepsTheDecisionsWithFewerStates) {
  EXPECT_EQ(sizeOf(compress(a1()).problem), Size(3, 4));
  EXPECT_EQ(sizeOf(compress(a2a()).problem), Size(9, 12));
  EXPECT_EQ(sizeOf(compress(ring(3)).problem), Size(34, 72));
  EXPECT_EQ(sizeOf(compress(ring(7)).problem), Size(4285, 21672));
}

/// In each state of the supervisor, each event that is left decides as in the state that it became.
void expectSameDecisions(const Problem& problem) {
  const Synthesized whole(problem);
  const Compressed compressed = compress(problem);
  const Synthesized smaller(compressed.problem);
  for (StateSpace::Number state = 0; state < whole.space.size(); ++state) {
    if (!whole.synthesis.contains(state)) continue;
    Tuple tuple = whole.space.states().tuple(state);
    for (std::size_t automaton = 0; automaton < tuple.size(); ++automaton) {
      tuple[automaton] = compressed.state_of[automaton][tuple[automaton]];
    }
    const auto counterpart = smaller.space.states().find(tuple.data());
    ASSERT_TRUE(counterpart && smaller.synthesis.contains(*counterpart));
    for (const auto& edge : whole.space.edges(state)) {
      for (const auto& other : smaller.space.edges(*counterpart)) {
        if (compressed.events[other.event] != edge.event) continue;
        EXPECT_EQ(whole.synthesis.contains(edge.to), smaller.synthesis.contains(other.to));
      }
    }
  }
}

TEST(Compression, refusesTheSameBookings) {
  for (const Problem& problem : {a1(), a2a(), ring(3), ring(4)}) expectSameDecisions(problem);
}

TEST(IndependentParts, areWhatSharesNoEvent) {
  Problem both = a1();
  const Problem other = problemOf("other", {{"RC", {"g W", "b Y", "r W", "g HOME", "u Y", "r HOME"}},
                                            {"RD", {"g W", "b Y", "r W", "g HOME", "u Y", "r HOME"}}});
  const auto first_event = static_cast<EventIndex>(both.events.size());
  both.events.insert(both.events.end(), other.events.begin(), other.events.end());
  for (Automaton automaton : other.automata) {
    for (EventIndex& event : automaton.alphabet) event += first_event;
    for (Transition& transition : automaton.transitions) transition.event += first_event;
    both.automata.push_back(automaton);
  }
  const auto parts = independentParts(both);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(sizeOf(parts[0].problem), Size(27, 48));
  EXPECT_EQ(sizeOf(parts[1].problem), Size(27, 48));
  EXPECT_THAT(parts[1].automata, ::testing::ElementsAre(3, 4, 5));
  EXPECT_EQ(both.events[parts[1].events[0]].name, parts[1].problem.events[0].name);
}

TEST(IndependentParts, areOneWhereAllAreConnected) {
  EXPECT_EQ(independentParts(ring(5)).size(), 1U);
}

TEST(StateSpace, isRefusedBeyondTheLimit) {
  const Problem problem = ring(4);
  const Composition composition(problem);
  EXPECT_TRUE(StateSpace::explore(composition, 1686));
  EXPECT_FALSE(StateSpace::explore(composition, 1685));
}

TEST(StateSpace, holdsTuplesOfMoreThanOneWord) {
  // 24 robots of 3 bits each and a zone of 5: of the robots only one is ever away from the beginning.
  std::vector<std::pair<std::string, test_support::Cycle>> robots;
  robots.reserve(24);
  for (int robot = 0; robot < 24; ++robot) {
    robots.push_back({fmt::format("R{:02}", robot), {"b Z", "g W", "r W", "g HOME", "u Z"}});
  }
  EXPECT_EQ(sizeOf(problemOf("wide", robots)), Size(1 + 24 * 4, 24 * 5));
}

TEST(ShortestWayIntoConflict, isTheBookingsInOppositeOrder) {
  Problem problem = a2a();
  const Synthesized synthesized(problem);
  std::vector<std::string> names;
  for (const EventIndex event : shortestWayIntoConflict(synthesized.space)) {
    names.push_back(problem.events[event].name);
  }
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("RA_g_W", "RA_b_Z1", "RB_g_W", "RB_b_Z2"));
}

TEST(Synthesis, isEmptyWhereTheConflictCannotBeRefused) {
  Problem problem = a2a();
  for (Event& event : problem.events) event.controllable = false;
  EXPECT_TRUE(Synthesized(problem).synthesis.empty());
}

}  // namespace
}  // namespace cobot_command::automata
