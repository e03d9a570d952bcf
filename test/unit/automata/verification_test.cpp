// The verification has teeth: what was changed in a supervisor is found, and named.
#include "cobot_command/automata/verification.h"

#include <algorithm>

#include "cell_problems.h"
#include "synthesized.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/canonical.h"

namespace cobot_command::automata {
namespace {

using test_support::a1;
using test_support::a2a;
using test_support::ring;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Made {
  CompiledSupervisor supervisor;
  std::string fingerprint;
};

Made made(const Problem& problem) {
  const Synthesized synthesized(problem);
  return {compile(synthesized.synthesis, problem),
          canonicalFormOf(automatonOf(synthesized.synthesis, problem), problem.events)
              .fingerprint(problem.events)};
}

/// What each robot of a2a() holds behind which of its events.
Holds holdsOfA2a() {
  return {
      {{}, {}, {1}, {1, 2}, {1, 2}, {1, 2}, {1}, {}}, {{}, {}, {2}, {1, 2}, {1, 2}, {1, 2}, {2}, {}}, {}, {}};
}

TEST(Verification, findsNothingInWhatWasSynthesized) {
  for (const Problem& problem : {a1(), a2a(), ring(3), ring(4)}) {
    const Made supervisor = made(problem);
    const Verification found = verify(supervisor.supervisor, supervisor.fingerprint);
    EXPECT_THAT(found.faults, IsEmpty()) << problem.name;
  }
}

TEST(Verification, countsWhatTheSynthesisCounts) {
  const Made supervisor = made(ring(3));
  const VerificationCounts counts = verify(supervisor.supervisor, supervisor.fingerprint).counts;
  EXPECT_EQ(counts.plant_and_spec, 259U);
  EXPECT_EQ(counts.dead, 1U);
  EXPECT_EQ(counts.blocking, 1U);
  EXPECT_EQ(counts.states, 258U);
  EXPECT_EQ(counts.transitions, 672U);
  EXPECT_EQ(counts.refused_by_spec, 99U);
  EXPECT_EQ(counts.refused_beyond_spec, 3U);
}

TEST(Verification, namesABookingThatCannotBeTakenBack) {
  // B may do b only while A has Z, and A never gives it back: without A's booking nobody is where both are.
  Problem problem;
  problem.name = "one way";
  problem.events = {{"A_b_Z", true}, {"B_b", true}};
  const auto plant = Automaton::Kind::Plant;
  problem.automata = {{"A", plant, {0}, {"home", "there"}, 0, {0, 1}, {{0, 0, 1}}},
                      {"B", plant, {1}, {"home", "there"}, 0, {0, 1}, {{0, 1, 1}}},
                      {"Z", Automaton::Kind::Spec, {0, 1}, {"free", "A"}, 0, {0, 1}, {{0, 0, 1}, {1, 1, 1}}}};
  const Made supervisor = made(problem);
  const Holds holds = {{{}, {0}}, {{}, {}}, {}};
  EXPECT_THAT(verify(supervisor.supervisor, supervisor.fingerprint).faults, IsEmpty())
      << "of what is no cell, nobody takes anything back";
  EXPECT_THAT(verify(supervisor.supervisor, supervisor.fingerprint, holds).faults,
              Contains(HasSubstr(
                  "withdrawn, A_b_Z leads to a state that the supervisor never reaches, after A_b_Z B_b")));
}

TEST(Verification, namesTheBlockingOfAMissingFrontierState) {
  Made supervisor = made(ring(3));
  supervisor.supervisor.frontier.clear();
  const auto faults = verify(supervisor.supervisor, "").faults;
  EXPECT_THAT(faults, Contains(HasSubstr("it blocks")));
  EXPECT_THAT(faults, Contains(HasSubstr("not all can return home")));
}

TEST(Verification, namesWhatIsRefusedWithoutNeed) {
  Made supervisor = made(a2a());
  // RA at W with both zones: nothing is wrong with it.
  supervisor.supervisor.frontier.push_back({3, 0, 1, 1});
  EXPECT_THAT(verify(supervisor.supervisor, "").faults,
              Contains(HasSubstr("not maximally permissive: it refuses RA_b_Z2")));
}

TEST(Verification, namesAnotherFingerprintBehindAnAddedTransition) {
  Made supervisor = made(a2a());
  supervisor.supervisor.problem.automata[0].transitions.push_back({1, 3, 0});
  EXPECT_THAT(verify(supervisor.supervisor, supervisor.fingerprint).faults,
              Contains(HasSubstr("not the supervisor that was synthesized")));
}

TEST(Verification, namesAnotherFingerprintBehindSwappedTargets) {
  Made supervisor = made(ring(3));
  auto& transitions = supervisor.supervisor.problem.automata[0].transitions;
  std::swap(transitions[1].to, transitions[2].to);
  EXPECT_THAT(verify(supervisor.supervisor, supervisor.fingerprint).faults,
              Contains(HasSubstr("not the supervisor that was synthesized")));
}

TEST(Verification, namesTwoHoldersOfAZone) {
  Made supervisor = made(a2a());
  EXPECT_THAT(verify(supervisor.supervisor, "", holdsOfA2a()).faults, IsEmpty());
  // A spec that forgets that RA has the zone.
  auto& zone = supervisor.supervisor.problem.automata[2];
  zone.transitions.push_back({1, zone.alphabet[2], 2});
  EXPECT_THAT(verify(supervisor.supervisor, "", holdsOfA2a()).faults,
              Contains(HasSubstr("no mutual exclusion: RA and RB both hold zone 1")));
}

TEST(Verification, namesWhatCannotBeRefused) {
  Made supervisor = made(a2a());
  for (Event& event : supervisor.supervisor.problem.events) event.controllable = false;
  EXPECT_THAT(verify(supervisor.supervisor, "").faults, Contains(HasSubstr("not controllable")));
}

TEST(Verification, refusesAFrontierOfAnotherShape) {
  Made supervisor = made(a2a());
  supervisor.supervisor.frontier.front().pop_back();
  EXPECT_THAT(verify(supervisor.supervisor, "").faults, Contains(HasSubstr("frontier")));
  supervisor.supervisor.frontier.front() = {99, 0, 0, 0};
  EXPECT_THAT(verify(supervisor.supervisor, "").faults, Contains(HasSubstr("frontier")));
}

TEST(Verification, saysThatThereAreTooManyStates) {
  const Made supervisor = made(ring(4));
  EXPECT_THAT(verify(supervisor.supervisor, "", {}, {100}).faults,
              Contains(HasSubstr("more than 100 states")));
}

TEST(Verification, findsEachStateThatIsTakenOutOfTheFrontier) {
  const Made supervisor = made(ring(4));
  for (std::size_t index = 0; index < supervisor.supervisor.frontier.size(); ++index) {
    CompiledSupervisor changed = supervisor.supervisor;
    changed.frontier.erase(changed.frontier.begin() + static_cast<std::ptrdiff_t>(index));
    EXPECT_FALSE(verify(changed, supervisor.fingerprint).faults.empty());
  }
}

}  // namespace
}  // namespace cobot_command::automata
