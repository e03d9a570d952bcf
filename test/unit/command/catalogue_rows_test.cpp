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

/// All of them; where two bring about the same row, the first counts.
Scenarios allScenarios() {
  Scenarios all = connectScenarios();
  all.merge(exchangeScenarios());
  all.merge(parameterScenarios());
  all.merge(planningScenarios());
  all.merge(sequenceScenarios());
  const auto script = with<RunScriptGoal>([](auto& g) { g.await_motion = true; });
  for (const Goal& goal : {Goal(good<MoveAbsoluteGoal>()), Goal(good<MoveRelativeGoal>()),
                           Goal(good<MoveCircleGoal>()), Goal(script)}) {
    all.merge(motionScenarios(goal));
    all.merge(stopScenarios(goal));
    all.merge(interfaceScenarios(goal));
  }
  for (const Goal& goal :
       {Goal(good<MoveAbsoluteGoal>()), Goal(good<MoveRelativeGoal>()), Goal(good<MoveCircleGoal>()),
        Goal(good<ChangeBaseGoal>()), Goal(good<ChangeTcpGoal>()), Goal(good<ChangeLoadGoal>()),
        Goal(good<SetOutputGoal>()), Goal(good<ExitListenNodeGoal>()), Goal(script)}) {
    all.merge(linkScenarios(goal));
    all.merge(turnScenarios(goal));
    all.merge(replyScenarios(goal));
  }
  all.merge(movedFrameScenarios());
  all.merge(triedScenarios(good<ProgramControlGoal>()));
  all.merge(replyScenarios(good<ProgramControlGoal>()));
  all.merge(linkScenarios(good<WaitForInputGoal>()));
  all.merge(turnScenarios(good<WaitForInputGoal>()));
  all.merge(linkScenarios(good<WaitTimeGoal>()));
  all.merge(turnScenarios(good<WaitTimeGoal>()));
  all.merge(waitScenarios());
  all.merge(pathScenarios());
  all.merge(linkScenarios(good<LoadPathGoal>()));
  all.merge(turnScenarios(good<LoadPathGoal>()));
  all.merge(trajectoryScenarios());
  all.merge(jogScenarios());
  all.merge(returnScenarios());
  all.merge(retraceScenarios());
  all.merge(linkScenarios(good<FollowJointTrajectoryGoal>()));
  all.merge(turnScenarios(good<FollowJointTrajectoryGoal>()));
  all.merge(linkScenarios(good<PickAndPlaceGoal>()));
  all.merge(turnScenarios(good<PickAndPlaceGoal>()));
  for (const Goal& goal :
       {Goal(good<LoadPathGoal>()), Goal(good<FollowJointTrajectoryGoal>()), Goal(good<PickAndPlaceGoal>()),
        Goal(good<JogGoal>()), Goal(good<ReturnToPrimaryGoal>()), Goal(good<RetraceGoal>())}) {
    all.merge(interfaceScenarios(goal));
  }
  all.merge(programScenarios());
  const auto exits = [](auto& g) { g.exit_node = true; };
  for (const Goal& goal :
       {Goal(good<MoveAbsoluteGoal>()), Goal(good<MoveRelativeGoal>()), Goal(good<MoveCircleGoal>()),
        Goal(with<ChangeBaseGoal>(exits)), Goal(with<ChangeTcpGoal>(exits)), Goal(good<ExitListenNodeGoal>()),
        Goal(script), Goal(good<LoadPathGoal>()), Goal(good<FollowJointTrajectoryGoal>()),
        Goal(good<JogGoal>()), Goal(good<ReturnToPrimaryGoal>()), Goal(good<RetraceGoal>())}) {
    all.merge(cellScenarios(goal));
  }
  all.merge(resumeScenarios());
  all.merge(triedScenarios(StopGoal{}));
  all.merge(stopScenarios(StopGoal{}));
  return all;
}

TEST(CatalogueRows, areRaisedOrExplained) {
  Scenarios scenarios = allScenarios();
  for (const ErrorEntry& entry : errorCatalogue()) {
    SCOPED_TRACE(std::string(toString(entry.block)) + " " + std::to_string(entry.id) + " " +
                 entry.description);
    const auto scenario = scenarios.find({entry.block, entry.id});
    if (scenario == scenarios.end()) {
      EXPECT_THAT(entry.raised_when, HasSubstr("cannot occur"));
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
