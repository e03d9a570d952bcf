// What supervisors of cells keep out of, in words for people (cell.md, S4).
#include "cobot_command/cell/model/part_rules.h"

#include "cell_programs.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using test_support::handover;
using test_support::headOn;
using test_support::iris;
using test_support::pallet;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<PartRules> rulesOf(const CellProgram& program, std::size_t max_states = 100000,
                               Policy policy = Policy::Supervisor) {
  const CellModel model = *modelOf(program);
  return rulesOfParts(model, *synthesizeParts(model, policy, max_states), max_states);
}

TEST(RulesOfACell, nameRobotsTheirPlacesAndWhatTheyHoldThere) {
  const auto head_on = rulesOf(headOn());
  ASSERT_EQ(head_on.size(), 1U);
  EXPECT_THAT(head_on[0].faults, IsEmpty());
  EXPECT_THAT(head_on[0].robots, ElementsAre("RA", "RB"));
  EXPECT_THAT(head_on[0].rules, ElementsAre("not RA with Z1 (W>1) while RB with Z2 (W>1)"));
  EXPECT_EQ(head_on[0].states, 41U);
  EXPECT_EQ(head_on[0].refused, 2U);
  EXPECT_THAT(rulesOf(iris())[0].rules,
              ElementsAre("not R1 with Z1 (W>1) while R2 with Z2 (W>1) and R3 with Z3 (W>1)"));
}

TEST(RulesOfACell, areNoneWhereZonesAreEnough) {
  const auto rules = rulesOf(handover());
  EXPECT_THAT(rules[0].rules, IsEmpty());
  EXPECT_THAT(rules[0].faults, IsEmpty());
  EXPECT_EQ(rules[0].states, 27U);
}

TEST(RulesOfACell, tellWhenAMechanismIsKeptBack) {
  const auto rules = rulesOf(pallet());
  EXPECT_THAT(rules[0].faults, IsEmpty());
  EXPECT_THAT(rules[0].rules, ElementsAre("not RA with Z (T1, T1>1, HOME>) while PALLET with nothing (IN>)"));
}

TEST(RulesOfACell, areOfEachPartOfItsOwn) {
  CellProgram two = headOn();
  CellProgram other = headOn();
  for (RobotProgram& robot : other.robots) {
    robot.name += "2";
    for (PathProgram& path : robot.paths) {
      for (ZoneStep& step : path.steps) step.zones[0] += 2;
    }
    two.robots.push_back(robot);
  }
  two.zones = {"Z1", "Z2", "Z3", "Z4"};
  const auto rules = rulesOf(two);
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_THAT(rules[1].rules, ElementsAre("not RA2 with Z3 (W>1) while RB2 with Z4 (W>1)"));
}

TEST(RulesOfACell, areTheSameWhereTheModelIsCompressed) {
  // 34 states of the 258 are left, so that it fits.
  const auto rules = rulesOf(iris(), 100);
  EXPECT_THAT(rules[0].faults, IsEmpty());
  EXPECT_EQ(rules[0].states, 34U);
  EXPECT_THAT(rules[0].rules,
              ElementsAre("not R1 with Z1 (W>1) while R2 with Z2 (W>1) and R3 with Z3 (W>1)"));
}

TEST(RulesOfACell, areNoneOfASafeOrder) {
  const auto rules = rulesOf(headOn(), 100000, Policy::SafeOrder);
  EXPECT_THAT(rules[0].rules, IsEmpty());
  EXPECT_EQ(rules[0].states, 0U);
}

}  // namespace
}  // namespace cobot_command::cell
