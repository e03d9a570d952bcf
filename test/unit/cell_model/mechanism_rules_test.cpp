// What a supervisor does about a mechanism that enters a zone by itself.
#include "cell_programs.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/model/rules.h"

namespace cobot_command::cell {
namespace {

using automata::Decision;
using automata::EventIndex;
using automata::Tuple;
using test_support::pallet;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using Verdict = Decision::Verdict;

class Cell {
 public:
  explicit Cell(const CellProgram& program, std::size_t max_states = 100000)
      : parts_(*synthesizeParts(*modelOf(program), Policy::Supervisor, max_states)),
        rules_(*modelOf(program), parts_, Policy::Supervisor),
        state_(rules_.initial()) {}

  [[nodiscard]] Verdict decide(const std::string& name) const {
    return rules_.decide(state_, eventOf(name)).verdict;
  }
  /// It is granted, and happens.
  void make(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      Decision decision = rules_.decide(state_, eventOf(name));
      ASSERT_EQ(decision.verdict, Verdict::Granted) << name;
      state_ = std::move(decision.next);
    }
  }
  [[nodiscard]] bool undoes(const std::string& name) const {
    return rules_.undone(state_, eventOf(name)).has_value();
  }
  [[nodiscard]] Tuple behind(const std::string& name) const {
    return rules_.decide(state_, eventOf(name)).next;
  }

  [[nodiscard]] const std::vector<PartSupervisor>& parts() const { return parts_; }
  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] const Tuple& state() const { return state_; }

 private:
  [[nodiscard]] EventIndex eventOf(const std::string& name) const {
    const auto& events = rules_.model().problem.events;
    const auto at =
        std::find_if(events.begin(), events.end(), [&](const auto& event) { return event.name == name; });
    EXPECT_NE(at, events.end()) << name;
    return static_cast<EventIndex>(at - events.begin());
  }

  std::vector<PartSupervisor> parts_;
  Rules rules_;
  Tuple state_;
};

TEST(AMechanismThatEntersByItself, isNotLetGoWhileTheRobotHoldsTheZone) {
  Cell cell(pallet());
  cell.make({"RA_g_T1", "RA_b_Z"});
  EXPECT_EQ(cell.decide("PALLET_g_IN"), Verdict::WouldBlock);
  cell.make({"RA_r_T1", "RA_g_HOME", "RA_u_Z"});
  EXPECT_EQ(cell.decide("PALLET_g_IN"), Verdict::Granted);
}

TEST(AMechanismThatEntersByItself, keepsTheRobotOutOnceItIsLetGo) {
  Cell cell(pallet());
  cell.make({"RA_g_T1", "PALLET_g_IN"});
  EXPECT_EQ(cell.decide("RA_b_Z"), Verdict::WouldBlock) << "it could come at any time";
  cell.make({"PALLET_b_Z"});
  EXPECT_EQ(cell.decide("RA_b_Z"), Verdict::SpecBlocks) << "it is there";
  cell.make({"PALLET_r_IN", "PALLET_g_HOME", "PALLET_u_Z"});
  EXPECT_EQ(cell.decide("RA_b_Z"), Verdict::Granted);
}

TEST(AMechanismThatEntersByItself, isNamedWhereTheRobotIsRefused) {
  Cell cell(pallet());
  EXPECT_FALSE(cell.rules().intrusionIn(cell.state()));
  cell.make({"RA_g_T1", "PALLET_g_IN"});
  const auto intrusion = cell.rules().intrusionIn(cell.behind("RA_b_Z"));
  ASSERT_TRUE(intrusion);
  EXPECT_EQ(intrusion->mechanism, 1U);
  EXPECT_EQ(intrusion->zone, 0U);
  EXPECT_EQ(intrusion->holder, 0U);
}

TEST(AMechanismThatEntersByItself, isVerifiedAndKeepsItsWayHome) {
  const auto model = modelOf(pallet());
  for (const std::size_t max_states : {100000U, 15U}) {
    const auto parts = synthesizeParts(*model, Policy::Supervisor, max_states);
    ASSERT_TRUE(parts) << parts.error();
    for (const auto& found : verifyParts(*model, *parts, max_states)) EXPECT_THAT(found.faults, IsEmpty());
  }
}

TEST(AMechanismThatEntersByItself, takesNoBookingBackAsItAskedForNone) {
  Cell cell(pallet());
  cell.make({"PALLET_g_IN"});
  EXPECT_TRUE(cell.undoes("PALLET_g_IN")) << "it was let go, and has not begun";
  cell.make({"PALLET_b_Z"});
  EXPECT_FALSE(cell.undoes("PALLET_b_Z"));
  Cell robot(pallet());
  robot.make({"RA_g_T1", "RA_b_Z"});
  EXPECT_TRUE(robot.undoes("RA_b_Z")) << "that of the others is withdrawn as ever";
}

TEST(AMechanismThatEntersByItself, isHeldBackAlsoWhereTheModelIsCompressed) {
  Cell cell(pallet(), 15);
  ASSERT_TRUE(cell.parts().front().is_compressed);
  cell.make({"RA_g_T1", "RA_b_Z"});
  EXPECT_EQ(cell.decide("PALLET_g_IN"), Verdict::WouldBlock);
  cell.make({"RA_r_T1", "RA_g_HOME", "RA_u_Z", "PALLET_g_IN", "RA_r_HOME", "RA_g_T1"});
  EXPECT_EQ(cell.decide("RA_b_Z"), Verdict::WouldBlock);
}

TEST(AMechanismThatEntersByItself, cannotBeDecidedOnBySafeOrders) {
  const auto parts = synthesizeParts(*modelOf(pallet()), Policy::SafeOrder, 100000);
  ASSERT_FALSE(parts);
  EXPECT_THAT(parts.error(), HasSubstr("\"PALLET_b_Z\" takes Z and is uncontrollable"));
}

TEST(AMechanismThatBeginsByItself, hasToAskForItsZonesOrNobodyElseEnters) {
  CellProgram program = pallet();
  program.robots[1].paths[0].uncontrollable_go = true;
  // It may come at any time: the robot never gets the zone, so that there is no way home once it set out.
  Cell never(program);
  EXPECT_EQ(never.decide("RA_g_T1"), Verdict::WouldBlock);
  EXPECT_THAT(never.parts().front().never, Contains("RA_g_T1")) << "which a build tells";
  program.robots[1].paths[0].steps[0].uncontrollable = false;
  Cell asks(program);
  EXPECT_THAT(asks.parts().front().never, IsEmpty());
  asks.make({"RA_g_T1", "RA_b_Z", "PALLET_g_IN"});
  EXPECT_EQ(asks.decide("PALLET_b_Z"), Verdict::SpecBlocks) << "it waits in front of the zone";
}

}  // namespace
}  // namespace cobot_command::cell
