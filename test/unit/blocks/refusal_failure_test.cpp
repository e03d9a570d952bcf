#include "cobot_command/blocks/shared/refusal_failure.h"

#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

motion::Refusal refusal(std::string message) {
  motion::Refusal refused;
  refused.message = std::move(message);
  return refused;
}

TEST(RefusalFailure, hasWhatWasFoundAndOneRemedyWhichIsThatOfTheRefusal) {
  const Failure failure =
      toFailure(refusal("J3 would reach 170.00 deg, allowed -155.0..155.0 deg: choose another target"));
  EXPECT_EQ(failure.error_id, own_error::kUnreachable);
  EXPECT_EQ(failure.found, "J3 would reach 170.00 deg, allowed -155.0..155.0 deg");
  EXPECT_EQ(failure.remedy, "Choose another target");
  const Outcome outcome = toOutcome(kBlock<MoveAbsoluteGoal>, Ending::Rejected, failure);
  EXPECT_EQ(outcome.error_description, "Target unreachable: " + failure.found);
  EXPECT_EQ(outcome.remedy, failure.remedy);
}

TEST(RefusalFailure, hasTheRemedyOfTheCatalogueWhereTheRefusalHasNone) {
  const Failure failure = toFailure(refusal("no posture reaches the point"));
  EXPECT_EQ(failure.found, "no posture reaches the point");
  EXPECT_EQ(toOutcome(kBlock<MoveAbsoluteGoal>, Ending::Rejected, failure).remedy,
            "Choose a target within the reach of the arm, or check base and TCP");
}

}  // namespace
}  // namespace cobot_command::blocks
