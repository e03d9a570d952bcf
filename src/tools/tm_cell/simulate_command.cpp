#include "simulate_command.h"

#include <chrono>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/cell/artifact/cycle_times.h"
#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/trial/cell_trial.h"

namespace cobot_command::tools {

using runtime::readArtifact;
namespace {

using Clock = std::chrono::steady_clock;

void addResult(const trial::TrialResult& result, const cell::Artifact& artifact, AnswerStage& stage) {
  for (cell::RobotIndex robot = 0; robot < result.cycles.size(); ++robot) {
    stage.report.push_back(fmt::format("{}: {} cycles, waited {:.2f} s", artifact.program.robots[robot].name,
                                       result.cycles[robot], toSeconds(result.waited[robot])));
  }
  stage.report.push_back(fmt::format("{:.2f} s in all; {} and {} came closest to each other: {:.1f} mm",
                                     toSeconds(result.makespan), result.least.robot, result.least.other,
                                     1000.0 * result.least.distance));
  stage.faults = result.faults;
  if (result.is_dead) stage.faults.emplace_back("DEADLOCK: the robots wait, and no event can happen");
  if (result.least.distance < artifact.parameters.margin) {
    stage.faults.push_back(fmt::format("{}: {} and {} came as close as {:.1f} mm; the margin is {:.1f} mm",
                                       result.least.distance <= 0.0 ? "COLLISION" : "TOO CLOSE",
                                       result.least.robot, result.least.other, 1000.0 * result.least.distance,
                                       1000.0 * artifact.parameters.margin));
  }
}

/// Where all were when it ended too early.
void addStandstill(const cell::CellStatus& status, AnswerStage& stage) {
  for (const cell::RobotStatus& robot : status.robots) {
    stage.report.push_back(fmt::format("{} is {} at {}{}{}", robot.name, toString(robot.state), robot.place,
                                       robot.text.empty() ? "" : ": ", robot.text));
  }
}

}  // namespace

Answer simulateCell(const SimulateOptions& options) {
  const auto begin = Clock::now();
  auto artifact = readArtifact(options.artifact);
  if (!artifact) return {{{"simulate", 0.0, {}, artifact.error()}}};
  const auto shared = std::make_shared<const cell::Artifact>(*std::move(artifact));
  for (const cell::RobotProgram& robot : shared->program.robots) {
    if (wayHome(robot)) continue;
    return wrong("simulate", robot.name +
                                 ": the first path of each station does not lead back home, so that "
                                 "no cycle would end: list another path first");
  }
  trial::TrialSettings settings;
  settings.by_schedule = options.policy == "schedule";
  settings.policy = settings.by_schedule ? shared->policy : *cell::policyNamed(options.policy);
  settings.cycles = options.cycles;
  settings.seed = options.seed;
  settings.is_random = options.is_random;
  settings.loss = 0.01 * options.loss;
  settings.doubled = settings.loss;
  if (settings.loss > 0.0) settings.delay = std::chrono::milliseconds(200);
  auto trial = trial::CellTrial::of(shared, settings);
  if (!trial) return wrong("simulate", trial.error());
  AnswerStage stage{"simulate", 0.0, {}, {}};
  if (!options.is_quiet) {
    (*trial)->observer = [&stage, start = (*trial)->now()](const trial::TrialEvent& event) {
      stage.report.push_back(fmt::format("{:8.2f} s  {}", toSeconds(event.at - start), event.text));
    };
  }
  const trial::TrialResult result = (*trial)->run();
  if (!result.cycles.empty()) addResult(result, *shared, stage);
  if (result.cycles.empty()) stage.faults = result.faults;
  if (!result.all_done) addStandstill((*trial)->status(), stage);
  stage.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return {{std::move(stage)}};
}

}  // namespace cobot_command::tools
