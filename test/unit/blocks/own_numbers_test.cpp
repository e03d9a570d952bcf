// Common failures that a block tells of under numbers of its own: load_path, by its manual.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/failure.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Block kPath = kBlock<LoadPathGoal>;
constexpr Block kMove = kBlock<MoveAbsoluteGoal>;

TEST(OwnNumbers, standInTheOutcomeOfTheBlockThatHasThem) {
  const Failure lost{motion_error::kLinkDropped, "cable pulled", ""};
  const Outcome of_path = toOutcome(kPath, Ending::Aborted, lost);
  EXPECT_EQ(of_path.error_id, 1002);
  EXPECT_EQ(of_path.error_description, "Robot handler faulted: cable pulled");
  EXPECT_EQ(toOutcome(kMove, Ending::Aborted, lost).error_id, 0x99);
}

TEST(OwnNumbers, ofAnOutcomeAreToldApartByWhatTheyMean) {
  for (const int general : {motion_error::kLinkDropped, own_error::kRobotError}) {
    const Outcome outcome = toOutcome(kPath, Ending::Aborted, {general, "", ""});
    EXPECT_TRUE(isError(kPath, outcome.error_id, general));
    EXPECT_FALSE(isError(kPath, outcome.error_id, motion_error::kNotConnected));
  }
  EXPECT_TRUE(isError(kMove, 0x99, motion_error::kLinkDropped));
  EXPECT_FALSE(isError(kPath, 0x99, motion_error::kLinkDropped)) << "it tells that under another number";
}

TEST(OwnNumbers, becomeTheGeneralOnesForWhoPassesAFailureOn) {
  const Outcome outcome = toOutcome(kPath, Ending::Aborted, {motion_error::kLinkDropped, "gone", "Plug in"});
  const Failure failure = failureOf(kPath, outcome);
  EXPECT_EQ(failure.error_id, motion_error::kLinkDropped);
  EXPECT_EQ(failure.found, "gone");
  EXPECT_EQ(failure.remedy, "Plug in");
}

std::vector<int> sorted(Block block, const std::vector<int>& ids) {
  std::vector<Failure> failures;
  for (const int id : ids) failures.push_back({id, "", ""});
  sortByTable(block, failures);
  std::vector<int> found;
  for (const Failure& failure : failures) found.push_back(failure.error_id);
  return found;
}

/// 1000, 1005, 1001, 1002, 1003, 1006, then the points, then this layer's own.
TEST(OwnNumbers, decideInTheOrderOfTheManual) {
  EXPECT_THAT(sorted(kPath, {own_error::kBufferModeUnknown, motion_error::kOtherBlockBusy, 1012,
                             own_error::kManualMode, own_error::kNotListening, own_error::kRobotError,
                             motion_error::kNotConnected, own_error::kEmergencyStop, own_error::kQueueFull}),
              ElementsAre(own_error::kQueueFull, own_error::kEmergencyStop, motion_error::kNotConnected,
                          own_error::kRobotError, own_error::kNotListening, own_error::kManualMode, 1012,
                          motion_error::kOtherBlockBusy, own_error::kBufferModeUnknown));
  EXPECT_THAT(sorted(kMove, {own_error::kEmergencyStop, motion_error::kNotConnected}),
              ElementsAre(motion_error::kNotConnected, own_error::kEmergencyStop));
}

TEST(OwnNumbers, areWrittenAsInTheirBook) {
  EXPECT_EQ(errorNumber(0x10), "16#10");
  EXPECT_EQ(errorNumber(0x279), "16#279");
  EXPECT_EQ(errorNumber(1000), "1000");
  EXPECT_EQ(errorNumber(1061), "1061");
  EXPECT_EQ(errorNumber(0x8C15), "16#8C15");
  const Outcome both = toRejection(kPath, {{1010, "", ""}, {own_error::kEmergencyStop, "", ""}});
  EXPECT_THAT(both.error_description, HasSubstr("; also 1005 Robot not energised"));
}

TEST(OwnNumbers, standInPlaceOfTheGeneralRows) {
  const ErrorTable table = LoadPathGoal::errors();
  for (const OwnNumber& number : table.ownNumbers()) {
    EXPECT_EQ(findError(kPath, number.general), nullptr) << number.general;
    EXPECT_NE(findError(kPath, number.own), nullptr) << number.own;
  }
}

/// The manual has 1000..1061, without these.
TEST(LoadPathErrors, areAllOfTheManual) {
  const std::set<int> absent{1004, 1008, 1009, 1011, 1016, 1054};
  for (int id = 1000; id <= 1061; ++id) {
    EXPECT_EQ(findError(kPath, id) == nullptr, absent.count(id) != 0) << id;
  }
}

}  // namespace
}  // namespace cobot_command::testing
