// Every row of the error catalogue happens here, or says why it cannot.

#include <string>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

/// Rows whose scenarios come with the arbiter over all blocks.
bool awaitsTheArbiter(const ErrorEntry& entry) {
  if (entry.block != Block::Connect && entry.block != Block::MoveAbsolute) return true;
  for (const int id : {own_error::kBlendingTooLarge, own_error::kStartUnknown, own_error::kNoModel,
                       own_error::kQueueFull, own_error::kBaseUnknown}) {
    if (entry.id == id) return true;
  }
  return false;
}

TEST(CatalogueRows, areRaisedOrExplained) {
  Scenarios scenarios;
  const Goal move = good<MoveAbsoluteGoal>();
  for (const auto& some : {connectScenarios(), parameterScenarios(), planningScenarios(),
                           readinessScenarios(move), replyScenarios(move), motionScenarios(move)}) {
    scenarios.insert(some.begin(), some.end());
  }
  for (const ErrorEntry& entry : errorCatalogue()) {
    SCOPED_TRACE(std::string(toString(entry.block)) + " " + std::to_string(entry.id) + " " +
                 entry.description);
    const auto scenario = scenarios.find({entry.block, entry.id});
    if (scenario == scenarios.end()) {
      if (!awaitsTheArbiter(entry)) {
        EXPECT_THAT(entry.raised_when, HasSubstr("cannot occur"));
      }
      continue;
    }
    EXPECT_THAT(entry.raised_when, ::testing::Not(HasSubstr("cannot occur any more")));
    const Outcome outcome = scenario->second();
    EXPECT_EQ(outcome.error_id, entry.id) << outcome.error_description;
    EXPECT_EQ(outcome.error_description.find(entry.description), 0u) << outcome.error_description;
    EXPECT_FALSE(outcome.remedy.empty());
    scenarios.erase(scenario);
  }
  for (const auto& [row, scenario] : scenarios) {
    ADD_FAILURE() << toString(row.first) << " has a scenario, but no row, for " << row.second;
  }
}

}  // namespace
}  // namespace cobot_command::testing
