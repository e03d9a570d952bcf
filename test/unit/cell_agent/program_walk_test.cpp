// The walk through a program that a robot and its supervisor agree on, event by event.
#include "agent/program_walk.h"

#include "cell_programs.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using Kind = NumberedEvent::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

class ProgramWalkTest : public testing::Test {
 protected:
  [[nodiscard]] std::string nameOf(automata::EventIndex event) const {
    return model.problem.events[event].name;
  }
  /// "1 wanted RA_g_T1", ...
  [[nodiscard]] std::vector<std::string> untold() const {
    constexpr const char* kKinds[] = {"wanted", "happened", "withdrawn"};
    std::vector<std::string> texts;
    for (const NumberedEvent& event : walk.untold()) {
      texts.push_back(std::to_string(event.number) + " " + kKinds[static_cast<std::size_t>(event.kind)] +
                      " " + nameOf(event.event));
    }
    return texts;
  }
  /// Its go is granted: it is before its booking.
  void setOut() {
    walk.want(walk.goOf(0));
    walk.acknowledge(1);
  }

  CellModel model = *modelOf(test_support::handover());
  ProgramWalk walk{model, 0};
};

TEST_F(ProgramWalkTest, staysWhereItIsUntilWhatItWantsIsGranted) {
  EXPECT_EQ(nameOf(walk.goOf(0)), "RA_g_T1");
  walk.want(walk.goOf(0));
  EXPECT_TRUE(walk.waits());
  EXPECT_EQ(walk.place().name, "HOME");
  EXPECT_THAT(untold(), ElementsAre("1 wanted RA_g_T1"));
  walk.acknowledge(0);
  EXPECT_TRUE(walk.waits());
  walk.acknowledge(1);
  EXPECT_FALSE(walk.waits());
  EXPECT_EQ(walk.place().name, "T1>");
  EXPECT_THAT(untold(), IsEmpty());
  ASSERT_TRUE(walk.unused());
  EXPECT_EQ(nameOf(*walk.unused()), "RA_g_T1");
}

TEST_F(ProgramWalkTest, goesOnAtOnceBehindWhatHappened) {
  setOut();
  walk.want(walk.next());
  walk.acknowledge(2);
  EXPECT_EQ(walk.place().name, "T1>1");
  walk.happened(walk.next());
  EXPECT_EQ(walk.place().name, "T1");
  EXPECT_EQ(walk.unused(), std::nullopt) << "what was done cannot be taken back";
  EXPECT_THAT(untold(), ElementsAre("3 happened RA_r_T1"));
}

TEST_F(ProgramWalkTest, takesBackWhatItWaitsFor) {
  setOut();
  walk.want(walk.next());
  walk.withdraw();
  EXPECT_FALSE(walk.waits());
  EXPECT_EQ(walk.place().name, "T1>");
  EXPECT_THAT(untold(), ElementsAre("2 wanted RA_b_Z", "3 withdrawn RA_b_Z"));
  // The booking was granted while the withdrawal was under way: it counts as never granted.
  walk.acknowledge(2);
  EXPECT_EQ(walk.place().name, "T1>");
  EXPECT_THAT(untold(), ElementsAre("3 withdrawn RA_b_Z"));
  walk.acknowledge(3);
  EXPECT_EQ(walk.place().name, "T1>");
  EXPECT_THAT(untold(), IsEmpty());
}

TEST_F(ProgramWalkTest, takesBackWhatWasGrantedUntilItIsUsed) {
  setOut();
  walk.want(walk.next());
  walk.acknowledge(2);
  ASSERT_TRUE(walk.unused());
  EXPECT_EQ(nameOf(*walk.unused()), "RA_b_Z");
  walk.withdraw();
  EXPECT_EQ(walk.place().name, "T1>");
  EXPECT_THAT(untold(), ElementsAre("3 withdrawn RA_b_Z"));
  walk.acknowledge(3);

  walk.want(walk.next());
  walk.acknowledge(4);
  walk.use();
  EXPECT_EQ(walk.unused(), std::nullopt);
  walk.withdraw();
  EXPECT_EQ(walk.place().name, "T1>1") << "a frame has left with it";
  EXPECT_THAT(untold(), IsEmpty());
}

TEST_F(ProgramWalkTest, wantsAnewBehindAWithdrawalThatNobodyHasHeardOf) {
  setOut();
  walk.want(walk.next());
  walk.withdraw();
  walk.want(walk.next());
  EXPECT_THAT(untold(), ElementsAre("2 wanted RA_b_Z", "3 withdrawn RA_b_Z", "4 wanted RA_b_Z"));
  walk.acknowledge(2);
  EXPECT_TRUE(walk.waits()) << "that was the one that was taken back";
  walk.acknowledge(4);
  EXPECT_EQ(walk.place().name, "T1>1");
}

TEST_F(ProgramWalkTest, goesOnFromWhereAPersonSaysThatItIs) {
  setOut();
  walk.want(walk.next());
  EXPECT_TRUE(walk.restart("HOME>", 17));
  EXPECT_EQ(walk.place().name, "HOME>");
  EXPECT_FALSE(walk.waits());
  EXPECT_THAT(untold(), IsEmpty());
  walk.happened(walk.next());
  EXPECT_THAT(untold(), ElementsAre("18 happened RA_u_Z"));
  EXPECT_FALSE(walk.restart("NOWHERE", 1));
  EXPECT_EQ(walk.place().name, "HOME>1");
}

}  // namespace
}  // namespace cobot_command::cell
