#include "cobot_command/blocks/run_program.h"

#include <utility>

#include "programs/program_run.h"
#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

/// Detail of its plan.
struct GuidedProgram {
  ProgramGuidePtr guide;
};

}  // namespace

ErrorTable RunProgramGoal::errors() {
  return ErrorTable()
      .shared({motion_error::kNotConnected, motion_error::kOtherBlockBusy, motion_error::kLinkDropped,
               own_error::kNotListening, own_error::kEmergencyStop, own_error::kRobotError,
               own_error::kOrphanMoves, own_error::kPlanningBudget, own_error::kShutDown})
      .underInterface()
      .row(own_error::kStepRefused, "Step refused",
           "Build the cell's artifact again, and load it on all nodes",
           "a frame of the program cannot be planned from where the robot is; see the description")
      .row(own_error::kStepFailed, "Step failed", kExecuteAgain,
           "a frame of the program failed in execution, or the input after it did not change in time; see "
           "the description for the error and the step")
      .row(own_error::kOutputFailed, "Output not set", "Check that the controller has this output",
           "the controller refused or did not answer the line that sets an output, or it could not be sent; "
           "see the description")
      .row(own_error::kCycleRange, "Cycles range: 0~1000000", kSetInRange,
           "cycles is negative or above 1000000; 0 means until cancelled")
      .row(own_error::kNotPermitted, "Not permitted", "Read cell/state: it names what blocks the robot",
           "the supervisor has not admitted the robot, or did not permit a frame")
      .row(own_error::kPermitLate, "No permit in time",
           "Find out which robot owns what this robot waits for, and let that robot continue; then execute "
           "again",
           "the wait for a permit exceeded the cell's wait_timeout; the robot is at standstill and keeps its "
           "zones")
      .row(own_error::kNotInArtifact, "Not what the artifact has",
           "Load the same artifact on all nodes of the cell",
           "the lines to be sent differ from those that the build verified")
      .row(own_error::kNotAtStepStart, "Not where the step starts",
           "Move the robot to the position that the supervisor reports, and recover it there",
           "the arm is not, or will not be, where the artifact plans the frame to start")
      .row(own_error::kSettingDiffers, "Frames, speed or mode differ",
           "Set base, TCP, project speed and mode as the cell's program has them",
           "base or TCP differ, the project speed is above the cell's speed_override, the mode is manual, "
           "the robot has an error, or its status is older than 0.2 s")
      .row(own_error::kSupervisorSilent, "Supervisor silent, or another one",
           "Start the supervisor with the same artifact",
           "the newest state of the cell is older than its lease, of another artifact, or of another "
           "supervisor")
      .row(own_error::kOffPath, "Off the path", "Find out what moved the robot; recover it",
           "the measured joints are not on the path of the frames that were sent; the robot is stopped")
      .row(own_error::kProgramUnknown, "No such program",
           "Start the node with ~cell, or name paths that follow each other",
           "the command node is in no cell, or a path is not in its program, or does not begin where the one "
           "before it ends")
      .row(own_error::kRecoveryNeeded, "Recovery needed",
           "Recover the robot with the supervisor's service recover",
           "the program was stopped where it cannot begin again, or the supervisor requires a recovery");
}

GoalTraits traitsOf(const RunProgramGoal& /*goal*/) {
  GoalTraits traits;
  traits.may_move = true;
  traits.needs_plan = true;
  return traits;
}

std::vector<Failure> check(const RunProgramGoal& goal) {
  ParameterChecks checks;
  checks.require(goal.paths_fault.empty(), own_error::kProgramUnknown, goal.paths_fault);
  checks.require(goal.cycles >= 0 && goal.cycles <= kMaxCycles, own_error::kCycleRange,
                 fmt::format("cycles is {}", goal.cycles));
  return std::move(checks).violations();
}

Outcome plan(const RunProgramGoal& goal, const PlanningScene& scene) {
  if (!scene.program) {
    return toRejection(kBlock<RunProgramGoal>,
                       {{own_error::kProgramUnknown, "the command node is in no cell", ""}});
  }
  if (auto objection = scene.program->objectionTo({goal.paths, goal.cycles})) {
    return toRejection(kBlock<RunProgramGoal>, {std::move(*objection)});
  }
  Outcome outcome;
  outcome.detail = Detail(GuidedProgram{scene.program});
  return outcome;
}

std::unique_ptr<Run> runOf(const RunProgramGoal& goal, GoalId id, const Outcome& planned, Instant now) {
  return std::make_unique<ProgramRun>(id, planned.detail.as<GuidedProgram>().guide,
                                      ProgramRequest{goal.paths, goal.cycles}, now);
}

}  // namespace cobot_command::blocks
