// How ways back along a path are refused, and fail.

#include <functional>
#include <string>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

Row row(int id) {
  return {kBlock<RetraceGoal>, id};
}

/// Connected to a robot that stands behind a path.
struct Behind : CoreRig {
  explicit Behind(Planning planning = Planning::AtOnce)
      : CoreRig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, planning) {
    connect();
    driveAPath(*this);
  }
};

template <class Change>
Scenario withGoal(const Change& change) {
  return [=] {
    Behind rig;
    return endOf(rig, rig.submit(with<RetraceGoal>(change)));
  };
}

/// Behind what has become of the robot since the path.
Scenario since(const std::function<void(Behind&)>& change, const RetraceGoal& goal = good<RetraceGoal>()) {
  return [=] {
    Behind rig;
    change(rig);
    return endOf(rig, rig.submit(goal));
  };
}

Scenarios goalScenarios() {
  return {
      {row(motion_error::kSpeedRangePercent), withGoal([](auto& g) { g.speed = 100.5; })},
      {row(own_error::kBufferModeUnknown), withGoal([](auto& g) { g.buffer_mode = 3; })},
      {row(own_error::kPointNotDriven), withGoal([](auto& g) { g.point = 1; })},
  };
}

/// Joint 1 may not turn back to where the path has begun.
void narrow(Behind& rig) {
  SoftwareLimits limits = rig.core.limits()->rule;
  limits.upper[0] = degToRad(5);
  EXPECT_TRUE(rig.core.writeLimits(limits, rig.now).success);
  rig.pump();
}

/// A PVT is what the controller cannot enter.
void refusePvt(Behind& rig) {
  rig.submit(with<LoadPathGoal>([](auto& g) { g.number_of_moves = 1; }));
  rig.reply(rig.takeScript().id, false, {1});
}

Scenarios planScenarios() {
  return {
      {row(own_error::kNothingDriven),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         return endOf(rig, rig.submit(good<RetraceGoal>()));
       }},
      {row(own_error::kNoModel),
       [] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         return endOf(rig, rig.submit(good<RetraceGoal>()));
       }},
      {row(own_error::kNotOnTheWay), since([](Behind& rig) {
         rig.stream(StatusFrames().at({5, 1, 90, 0, 90, 0}));
       })},
      {row(own_error::kStartUnknown),
       since([](Behind& rig) { rig.stream(StatusFrames().without("Joint_Angle")); })},
      {row(own_error::kPvtUnavailable), since(refusePvt)},
      {row(own_error::kPvtTooLong),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
         rig.connect();
         driveAPath(rig, 260, Execution::Script);
         return endOf(rig, rig.submit(good<RetraceGoal>()));
       }},
      {row(own_error::kJointLimit), since(narrow)},
      {row(own_error::kNotPlannable),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
         rig.connect();
         driveAPath(rig, 100);
         rig.core.setSpeedOverride(
             1, [](const OverrideAnswer&) {}, rig.now);
         return endOf(rig, rig.submit(with<RetraceGoal>([](auto& g) { g.speed = 1; })));
       }},
      {row(own_error::kPlanningBudget),
       [] {
         Behind rig(Planning::Beside);
         const GoalId id = rig.submit(good<RetraceGoal>());
         rig.pass(10s);
         return endOf(rig, id);
       }},
  };
}

}  // namespace

Scenarios retraceScenarios() {
  Scenarios all = goalScenarios();
  all.merge(planScenarios());
  const Goal goal = good<RetraceGoal>();
  all.merge(linkScenarios(goal));
  all.merge(turnScenarios(goal));
  all.merge(wireScenariosOfATurn(goal, 10));
  all.merge(Scenarios{{row(own_error::kNotAtTarget), scenarioOf(goal, tellTheEndTooEarly)}});
  return all;
}

}  // namespace cobot_command::testing
