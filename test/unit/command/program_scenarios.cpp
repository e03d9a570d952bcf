// How the program of a robot in a cell is refused, and fails; and what else may not move that robot.

#include <functional>
#include <string>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/waits/wait_for_input.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

Row row(int id) {
  return {kBlock<RunProgramGoal>, id};
}

/// The end of a goal before which the rig, and the program in it, were changed.
Scenario prepared(const std::function<void(CoreRig&)>& prepare, const RunProgramGoal& goal = {}) {
  return [=] {
    CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    prepare(rig);
    return endOf(rig, rig.submit(goal));
  };
}

/// Of a frame that has left.
Scenario sent(const std::function<void(CoreRig&, const std::string& id)>& then) {
  return [=] {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    const GoalId goal = rig.submit(RunProgramGoal{});
    then(rig, rig.takeScript().id);
    return endOf(rig, goal);
  };
}

Failure because(int id) {
  return {id, "that is how it is", ""};
}

void closeGate(CoreRig& rig, int id) {
  rig.gate = [id](const command::Departure& /*departure*/, Instant /*now*/) { return because(id); };
}

Scenarios permitScenarios() {
  Scenarios all;
  for (const int id : {own_error::kNotPermitted, own_error::kNotInArtifact, own_error::kNotAtStepStart,
                       own_error::kSettingDiffers}) {
    all[row(id)] = prepared([id](CoreRig& rig) { closeGate(rig, id); });
  }
  for (const int id : {own_error::kPermitLate, own_error::kSupervisorSilent, own_error::kOffPath}) {
    all[row(id)] = prepared([id](CoreRig& rig) {
      rig.program->is_permitted = false;
      rig.program->failed = because(id);
    });
  }
  all[row(own_error::kRecoveryNeeded)] =
      prepared([](CoreRig& rig) { rig.program->refusal = because(own_error::kRecoveryNeeded); });
  return all;
}

Outcome withoutOutput() {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  rig.program->frame.output = good<SetOutputGoal>();
  const GoalId goal = rig.submit(RunProgramGoal{});
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0));
  rig.stream(StatusFrames());
  rig.reply(rig.takeScript().id, false, {1});
  return endOf(rig, goal);
}

Outcome planningTooLong() {
  CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, command::Planning::Beside);
  rig.connect();
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(RunProgramGoal{});
  rig.pass(10s);
  return endOf(rig, goal);
}

Scenarios frameScenarios() {
  return {
      {row(own_error::kStepRefused), prepared([](CoreRig& rig) {
         rig.program->frame.lines = {"PTP(\"JPP\",0,0,170,0,90,0,30,200,0,false)"};
       })},
      {row(own_error::kStepFailed),
       sent([](CoreRig& rig, const std::string& id) { rig.reply(id, false, {1}); })},
      {row(own_error::kOutputFailed), withoutOutput},
      {row(motion_error::kLinkDropped), sent(lose)},
      {row(own_error::kPlanningBudget), planningTooLong},
      {row(own_error::kCycleRange),
       prepared([](CoreRig&) {}, with<RunProgramGoal>([](auto& g) { g.cycles = -1; }))},
      {row(own_error::kProgramUnknown),
       prepared([](CoreRig& rig) { rig.program->unknown = because(own_error::kProgramUnknown); })},
  };
}

}  // namespace

Scenarios programScenarios() {
  const Goal goal = RunProgramGoal{};
  Scenarios all = permitScenarios();
  all.merge(frameScenarios());
  all.merge(linkScenarios(goal));
  all.merge(interfaceScenarios(goal));
  Scenarios turn = turnScenarios(goal);
  turn.erase(row(own_error::kQueueFull));  // it does not wait
  turn.erase(row(own_error::kStopNotConfirmed));
  all.merge(turn);
  return all;
}

Scenarios cellScenarios(const Goal& goal) {
  return {{{blockOf(goal), ownErrorId(blockOf(goal), own_error::kOnlyPrograms)}, [=] {
             CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
             rig.connect();
             rig.status(StatusFrames().with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0})));
             if (std::holds_alternative<RetraceGoal>(goal)) driveAPath(rig);
             closeGate(rig, own_error::kOnlyPrograms);
             return endOf(rig, rig.submit(goal));
           }}};
}

}  // namespace cobot_command::testing
