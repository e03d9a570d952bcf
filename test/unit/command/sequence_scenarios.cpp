// How sequences, and cycles of them, fail.

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

arm::ArmModel model() {
  return *arm::ArmModel::named("tm5-900");
}

CheckSequenceGoal sequence() {
  CheckSequenceGoal goal;
  goal.steps = {good<MoveAbsoluteGoal>()};
  goal.start_joints = {0, 0, 90, 0, 90, 0};
  return goal;
}

Outcome checked(CoreRig rig, const Goal& goal) {
  const GoalId id = rig.submit(goal);
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

/// A cycle of one move whose script, or whose output, is `fault`ed.
Outcome cycleUntil(const PickAndPlaceGoal& goal, const std::function<void(CoreRig&)>& fault) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(goal);
  fault(rig);
  return endOf(rig, id);
}

Scenarios checkSequenceScenarios() {
  const auto row = [](int id) { return Row{kBlock<CheckSequenceGoal>, id}; };
  return {
      {row(own_error::kStartUnknown),
       [] {
         CheckSequenceGoal goal = sequence();
         goal.start_joints.clear();
         return checked(CoreRig(model()), goal);
       }},
      {row(own_error::kNoModel), [] { return checked(CoreRig(), sequence()); }},
      {row(own_error::kQueueFull),
       [] {
         CoreRig rig(model(), link::LinkSettings{}, Planning::Beside);
         for (std::size_t i = 0; i < kMostWaiting; ++i) rig.submit(sequence());
         return *rig.outcome(rig.submit(sequence()));
       }},
      {row(own_error::kShutDown),
       [] {
         CoreRig rig;
         rig.shutDown();
         return *rig.outcome(rig.submit(sequence()));
       }},
      {row(own_error::kStepCount),
       [] {
         CheckSequenceGoal goal = sequence();
         goal.steps.clear();
         return checked(CoreRig(model()), goal);
       }},
      {row(own_error::kStepsUnreadable),
       [] {
         CheckSequenceGoal goal = sequence();
         goal.steps_fault = "step 2: kind is 9";
         return checked(CoreRig(model()), goal);
       }},
      {row(own_error::kStepRefused),
       [] {
         CheckSequenceGoal goal = sequence();
         std::get<MoveAbsoluteGoal>(goal.steps[0]).speed = 0;
         return checked(CoreRig(model()), goal);
       }},
  };
}

template <class Change>
Scenario cycleWith(const Change& change) {
  return [=] { return cycleUntil(with<PickAndPlaceGoal>(change), [](CoreRig&) {}); };
}

Scenarios pickAndPlaceParameterScenarios() {
  const auto row = [](int id) { return Row{kBlock<PickAndPlaceGoal>, id}; };
  return {
      {row(own_error::kBufferModeUnknown), cycleWith([](auto& g) { g.buffer_mode = 3; })},
      {row(own_error::kStepCount), cycleWith([](auto& g) { g.steps.clear(); })},
      {row(own_error::kStepRefused), cycleWith([](auto& g) { g.steps[0].move.speed = 0; })},
      {row(own_error::kDwellRange), cycleWith([](auto& g) { g.steps[0].dwell = -1; })},
      {row(own_error::kCycleRange), cycleWith([](auto& g) { g.cycles = -1; })},
      {row(own_error::kOutputInvalid), cycleWith([](auto& g) { g.steps[0].output->output = 99; })},
      {row(own_error::kOutputValue), cycleWith([](auto& g) { g.steps[0].output->value = 2; })},
      {row(own_error::kInputInvalid), cycleWith([](auto& g) { g.steps[0].input = WaitForInputGoal{"Box"}; })},
      {row(own_error::kWaitRange), cycleWith([](auto& g) {
         g.steps[0].input = WaitForInputGoal{"ControlBox", 0, true, -1};
       })},
      {row(own_error::kStepsUnreadable), cycleWith([](auto& g) { g.steps_fault = "no such file"; })},
      {row(own_error::kBlendBeforeDwell), cycleWith([](auto& g) { g.steps[0].move.blending_enable = true; })},
      {row(own_error::kExitBeforeEnd), cycleWith([](auto& g) { g.steps[0].move.exit_node = true; })},
  };
}

Scenarios pickAndPlaceScenarios() {
  const auto row = [](int id) { return Row{kBlock<PickAndPlaceGoal>, id}; };
  const auto goal = good<PickAndPlaceGoal>();
  const auto check_only = with<PickAndPlaceGoal>([](auto& g) { g.check_only = true; });
  return {
      {row(own_error::kStartUnknown), [=] { return checked(CoreRig(model()), check_only); }},
      {row(own_error::kNoModel),
       [=] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         return *rig.outcome(rig.submit(check_only));
       }},
      {row(motion_error::kLinkDropped),
       [=] { return cycleUntil(goal, [](CoreRig& rig) { rig.close("gone"); }); }},
      {row(own_error::kStepFailed),
       [=] { return cycleUntil(goal, [](CoreRig& rig) { rig.reply(rig.takeScript().id, false, {1}); }); }},
      {row(own_error::kOutputFailed),
       [=] {
         return cycleUntil(goal, [](CoreRig& rig) {
           rig.reply(rig.takeScript().id);
           rig.tag(1);
           rig.reply(rig.takeScript().id, false, {1});
         });
       }},
  };
}

/// What is planned beside the core, by somebody who never answers.
Scenarios budgetScenarios() {
  const auto checked_only = [](auto goal) {
    goal.check_only = true;
    return Goal(goal);
  };
  Scenarios scenarios;
  for (const Goal& goal : {checked_only(good<MoveAbsoluteGoal>()), checked_only(good<MoveRelativeGoal>()),
                           checked_only(good<MoveCircleGoal>()), Goal(good<RunScriptGoal>()),
                           Goal(good<PickAndPlaceGoal>()), Goal(sequence())}) {
    scenarios[{static_cast<Block>(goal.index()), own_error::kPlanningBudget}] = [=] {
      CoreRig rig(model(), link::LinkSettings{}, command::Planning::Beside);
      rig.connect();
      rig.status(StatusFrames());
      const GoalId id = rig.submit(goal);
      rig.pass(10s);
      return *rig.outcome(id);
    };
  }
  return scenarios;
}

}  // namespace

Scenarios sequenceScenarios() {
  Scenarios all = checkSequenceScenarios();
  all.merge(pickAndPlaceParameterScenarios());
  all.merge(pickAndPlaceScenarios());
  all.merge(budgetScenarios());
  return all;
}

}  // namespace cobot_command::testing
