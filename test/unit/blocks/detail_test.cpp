// What only one block tells: carried by who does not know it.

#include "cobot_command/blocks/shared/detail.h"

#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/failure.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

struct Points {
  std::vector<double> values;
  int failed = -1;
};
struct Place {
  int point = -1;
};

static_assert(std::is_nothrow_move_constructible_v<Detail> && std::is_nothrow_move_assignable_v<Detail>);
static_assert(std::is_nothrow_copy_constructible_v<Detail>, "it is handed from one to the other, not copied");

TEST(Detail, isFoundByItsKindAndByNoOther) {
  const Detail detail(Points{{1, 2, 3}, 1});
  EXPECT_FALSE(detail.isNone());
  ASSERT_NE(detail.find<Points>(), nullptr);
  EXPECT_EQ(detail.find<Points>()->values.size(), 3U);
  EXPECT_EQ(detail.as<Points>().failed, 1);
  EXPECT_EQ(detail.find<Place>(), nullptr);
}

TEST(Detail, isWhatItsKindIsByDefaultWhenThereIsNone) {
  const Detail none;
  EXPECT_TRUE(none.isNone());
  EXPECT_EQ(none.find<Points>(), nullptr);
  EXPECT_EQ(none.as<Points>().failed, -1);
  EXPECT_EQ(none.as<Place>().point, -1);
}

TEST(Detail, isSharedByItsCopiesHoweverLargeItIs) {
  Detail detail(Points{std::vector<double>(10000), 0});
  const Points* const value = detail.find<Points>();
  const Detail copy = detail;
  EXPECT_EQ(copy.find<Points>(), value);
  const Detail moved = std::move(detail);
  EXPECT_EQ(moved.find<Points>(), value);
  detail = Detail();
  EXPECT_EQ(copy.as<Points>().values.size(), 10000U) << "it lives as long as one of them";
}

TEST(Detail, ofAFailureBecomesThatOfTheOutcome) {
  const Failure failure{own_error::kStepRefused, "", "", Detail(Place{3})};
  const Failure other{own_error::kCycleRange, "", "", Detail(Place{4})};
  EXPECT_EQ(toOutcome(kBlock<PickAndPlaceGoal>, Ending::Aborted, failure).detail.as<Place>().point, 3);
  EXPECT_EQ(toRejection(kBlock<PickAndPlaceGoal>, {failure, other}).detail.as<Place>().point, 3)
      << "the first one decides";
}

}  // namespace
}  // namespace cobot_command::testing
