#include "cobot_command/blocks/programs/cycle_waits.h"

#include <chrono>

#include <gmock/gmock.h>

namespace cobot_command::blocks {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(CycleWaits, areThoseOfEachCycleInTheirOrder) {
  CycleWaits waits;
  waits.beginCycle();
  waits.add(2s);
  waits.add(1s);
  waits.beginCycle();
  waits.beginCycle();
  waits.add(5s);
  EXPECT_THAT(waits.take(), ElementsAre(3s, 0s, 5s));
  EXPECT_THAT(waits.take(), IsEmpty()) << "of the next goal";
}

TEST(CycleWaits, areThoseOfTheLastCyclesWhereThereWereVeryMany) {
  CycleWaits waits;
  for (std::size_t cycle = 0; cycle <= CycleWaits::kMost; ++cycle) {
    waits.beginCycle();
    waits.add(std::chrono::seconds(cycle));
  }
  const auto taken = waits.take();
  ASSERT_EQ(taken.size(), CycleWaits::kMost);
  EXPECT_EQ(taken.front(), 1s);
  EXPECT_EQ(taken.back(), std::chrono::seconds(CycleWaits::kMost));
}

}  // namespace
}  // namespace cobot_command::blocks
