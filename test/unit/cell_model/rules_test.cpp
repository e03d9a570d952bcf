#include "cobot_command/cell/model/rules.h"

#include <set>

#include "cell_programs.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using automata::Decision;
using automata::EventIndex;
using automata::Tuple;
using test_support::book;
using test_support::handover;
using test_support::headOn;
using test_support::iris;
using test_support::pallet;
using test_support::release;
using test_support::thereAndBack;
using testing::ElementsAre;
using testing::IsEmpty;
using Verdict = Decision::Verdict;

Rules rulesOf(const CellProgram& program, Policy policy = Policy::Supervisor,
              std::size_t max_states = 100000) {
  CellModel model = *modelOf(program);
  const auto parts = synthesizeParts(model, policy, max_states);
  EXPECT_TRUE(parts) << parts.error();
  return Rules(std::move(model), *parts, policy);
}

EventIndex eventOf(const Rules& rules, const std::string& name) {
  const auto& events = rules.model().problem.events;
  for (EventIndex event = 0; event < events.size(); ++event) {
    if (events[event].name == name) return event;
  }
  ADD_FAILURE() << "no event " << name;
  return 0;
}

Tuple stateBehind(const Rules& rules, std::initializer_list<const char*> names) {
  Tuple state = rules.initial();
  for (const char* name : names) {
    Decision decision = rules.decide(state, eventOf(rules, name));
    EXPECT_EQ(decision.verdict, Verdict::Granted) << name;
    if (decision.verdict == Verdict::Granted) state = std::move(decision.next);
  }
  return state;
}

/// States and granted events of all that can happen.
std::pair<std::size_t, std::size_t> sizeOf(const Rules& rules) {
  std::set<Tuple> reached = {rules.initial()};
  std::vector<Tuple> open = {rules.initial()};
  std::size_t granted = 0;
  while (!open.empty()) {
    const Tuple state = open.back();
    open.pop_back();
    for (EventIndex event = 0; event < rules.model().events.size(); ++event) {
      Decision decision = rules.decide(state, event);
      EXPECT_NE(decision.verdict, Verdict::BreaksSpec);
      if (decision.verdict != Verdict::Granted) continue;
      ++granted;
      if (reached.insert(decision.next).second) open.push_back(std::move(decision.next));
    }
  }
  return {reached.size(), granted};
}

using Size = std::pair<std::size_t, std::size_t>;

TEST(Rules, allowTheSupervisor) {
  EXPECT_EQ(sizeOf(rulesOf(handover())), Size(27, 48));
  EXPECT_EQ(sizeOf(rulesOf(headOn())), Size(41, 72));
  EXPECT_EQ(sizeOf(rulesOf(iris())), Size(258, 672));
}

TEST(Rules, allowTheSameWhereTheModelHasToBeCompressed) {
  CellModel model = *modelOf(iris());
  const auto parts = synthesizeParts(model, Policy::Supervisor, 100);
  ASSERT_TRUE(parts);
  EXPECT_TRUE(parts->front().is_compressed);
  EXPECT_EQ(sizeOf(Rules(model, *parts, Policy::Supervisor)), Size(258, 672));
}

TEST(Rules, fallBackOnSafeOrdersWhereEvenThatIsTooLarge) {
  CellModel model = *modelOf(iris());
  const auto parts = synthesizeParts(model, Policy::Supervisor, 10);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->front().policy, Policy::SafeOrder);
  EXPECT_EQ(sizeOf(Rules(model, *parts, Policy::Supervisor)), Size(258, 672));
}

TEST(Rules, allowWhatBlocksByMutualExclusionAlone) {
  EXPECT_EQ(sizeOf(rulesOf(headOn(), Policy::MutualExclusion)), Size(42, 74));
  EXPECT_EQ(sizeOf(rulesOf(iris(), Policy::MutualExclusion)), Size(259, 675));
}

TEST(Rules, allowEverythingWithoutAPolicy) {
  EXPECT_EQ(sizeOf(rulesOf(headOn(), Policy::None)), Size(64, 128));
}

TEST(Rules, areOfEachPartByItself) {
  CellProgram program = headOn();
  const CellProgram other = handover();
  program.zones.push_back("Z");
  program.robots.push_back(thereAndBack("RC", "T1", {book({2})}, {release(2)}));
  program.robots.push_back(thereAndBack("RD", "T1", {book({2})}, {release(2)}));
  const Rules rules = rulesOf(program);
  EXPECT_EQ(sizeOf(rules).first, 41U * 27U);
  EXPECT_EQ(synthesizeParts(rules.model(), Policy::Supervisor, 1000)->size(), 2U);
}

TEST(Rules, nameTheZoneThatIsHeld) {
  const Rules rules = rulesOf(headOn());
  const Tuple state = stateBehind(rules, {"RA_g_W", "RA_b_Z1", "RA_b_Z2", "RB_g_W"});
  const Decision decision = rules.decide(state, eventOf(rules, "RB_b_Z2"));
  ASSERT_EQ(decision.verdict, Verdict::SpecBlocks);
  EXPECT_EQ(*decision.automaton, rules.model().automatonOf(1));
  EXPECT_EQ(rules.model().holder(1, state[*decision.automaton]), RobotIndex{0});
}

TEST(Rules, nameThoseThatCouldNotComeHome) {
  const Rules rules = rulesOf(iris(), Policy::MutualExclusion);
  const Tuple dead = stateBehind(rules, {"R1_g_W", "R1_b_Z1", "R2_g_W", "R2_b_Z2", "R3_g_W", "R3_b_Z3"});
  EXPECT_THAT(rules.stuckIn(dead), ElementsAre(0, 1, 2));
  EXPECT_THAT(rules.stuckIn(rules.initial()), IsEmpty());
}

TEST(Rules, nameThoseWhoHaveToGoOnFirst) {
  const Rules rules = rulesOf(iris());
  const Tuple state = stateBehind(rules, {"R1_g_W", "R1_b_Z1", "R2_g_W", "R2_b_Z2", "R3_g_W"});
  EXPECT_THAT(rules.aheadOf(state, 0), ElementsAre(1));
  EXPECT_THAT(rules.aheadOf(state, 1), IsEmpty());
}

/// Pairs of a state and a booking that can be undone there; each of them leads back to where the booking is
/// granted again.
std::size_t undoesOf(const Rules& rules) {
  std::set<Tuple> reached = {rules.initial()};
  std::vector<Tuple> open = {rules.initial()};
  std::vector<Tuple> all;
  while (!open.empty()) {
    all.push_back(open.back());
    open.pop_back();
    for (EventIndex event = 0; event < rules.model().events.size(); ++event) {
      Decision decision = rules.decide(all.back(), event);
      if (decision.verdict == Verdict::Granted && reached.insert(decision.next).second) {
        open.push_back(decision.next);
      }
    }
  }
  std::size_t cases = 0;
  for (const Tuple& state : all) {
    for (EventIndex event = 0; event < rules.model().events.size(); ++event) {
      const auto before = rules.undone(state, event);
      if (!before) continue;
      if (rules.model().events[event].kind == CellEvent::Kind::Book) ++cases;
      EXPECT_EQ(reached.count(*before), 1U);
      EXPECT_EQ(rules.decide(*before, event).next, state);
    }
  }
  return cases;
}

TEST(UndoOfABooking, staysInsideOfTheSupervisor) {
  EXPECT_EQ(undoesOf(rulesOf(handover())), 6U);
  EXPECT_EQ(undoesOf(rulesOf(headOn())), 14U);
  EXPECT_EQ(undoesOf(rulesOf(iris())), 144U);
  EXPECT_EQ(undoesOf(rulesOf(iris(4))), 1264U);
  EXPECT_EQ(undoesOf(rulesOf(pallet())), 2U) << "of the robot alone: the pallet asks for nothing";
}

TEST(Supervisors, areRefusedWithTheWayIntoAConflictThatCannotBeRefused) {
  CellProgram program = headOn();
  for (RobotProgram& robot : program.robots) {
    for (ZoneStep& step : robot.paths[0].steps) step.uncontrollable = true;
  }
  const auto parts = synthesizeParts(*modelOf(program), Policy::Supervisor, 1000);
  ASSERT_TRUE(parts) << "who has not set out waits until the other is home";
  EXPECT_FALSE(parts->front().frontier.empty());
  program.robots[1].held_at_home = {1};
  program.robots[1].paths = {{"W", 0, 1, {book({0})}}, {"HOME", 1, 0, {release(0)}}};
  const auto none = synthesizeParts(*modelOf(program), Policy::SafeOrder, 1000);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), testing::HasSubstr("cannot be made to wait"));
}

}  // namespace
}  // namespace cobot_command::cell
