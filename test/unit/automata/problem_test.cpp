#include "cobot_command/automata/problem.h"

#include "cell_problems.h"
#include <gmock/gmock.h>

namespace cobot_command::automata {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Problem withChange(void (*change)(Problem&)) {
  Problem problem = test_support::a1();
  change(problem);
  return problem;
}

void expectFault(void (*change)(Problem&), const char* words) {
  EXPECT_THAT(faultsOf(withChange(change)), Contains(HasSubstr(words)));
}

TEST(FaultsOfAProblem, areNoneOfACell) {
  EXPECT_THAT(faultsOf(test_support::ring(5)), ::testing::IsEmpty());
}

TEST(FaultsOfAProblem, nameWhatMakesItAmbiguous) {
  expectFault(
      [](Problem& problem) {
        problem.automata[0].transitions.push_back({0, 0, 3});
      },
      "RA: \"RA_g_T1\" leads from \"RA.0\" to \"RA.1\" and to \"RA.3\"");
  expectFault([](Problem& problem) { problem.events[1].name = problem.events[0].name; },
              "\"RA_g_T1\" appears twice");
  expectFault([](Problem& problem) { problem.automata[1].name = "RA"; }, "\"RA\" appears twice");
  expectFault([](Problem& problem) { problem.automata[0].states[1] = "RA.0"; },
              "the state \"RA.0\" appears twice");
  expectFault([](Problem& problem) { problem.automata[0].alphabet.push_back(0); }, "has \"RA_g_T1\" twice");
}

TEST(FaultsOfAProblem, nameWhatIsNotThere) {
  expectFault(
      [](Problem& problem) {
        problem.events.push_back({"nobody's", true});
      },
      "no plant has the event \"nobody's\"");
  expectFault([](Problem& problem) { problem.automata[0].marked.clear(); }, "no state is marked");
  expectFault([](Problem& problem) { problem.automata[0].marked = {6}; },
              "a marked state is not one of its states");
  expectFault([](Problem& problem) { problem.automata[0].initial = 6; },
              "its initial state is not one of its states");
  expectFault([](Problem& problem) { problem.automata[0].transitions[0].to = 6; },
              "starts or ends in a state that is not one of its states");
  expectFault([](Problem& problem) { problem.automata[0].alphabet.clear(); }, "not in its alphabet");
  expectFault([](Problem& problem) { problem.automata[0].alphabet[0] = 99; }, "the problem does not have");
  expectFault([](Problem& problem) { problem.automata[0].states.clear(); }, "it has no states");
  expectFault([](Problem& problem) { problem.automata.clear(); }, "there is no automaton");
  expectFault([](Problem& problem) { problem.events[0].name.clear(); }, "has no name");
}

}  // namespace
}  // namespace cobot_command::automata
