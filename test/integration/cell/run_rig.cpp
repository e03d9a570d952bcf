#include "run_rig.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "source_tree.h"
#include <fmt/format.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::trial {
namespace {

/// Between two looks at the bodies, in invented time.
constexpr Duration kLookEvery = 50ms;

std::shared_ptr<const cell::Artifact> built(cell::Cell cell, cell::Policy policy) {
  cell::CellBuild build(std::move(cell), policy, 1);
  for (const cell::BuildStage stage : cell::kBuildStages) {
    const auto faults = build.run(stage);
    if (!faults.empty()) throw std::runtime_error(faults.front());
  }
  auto artifact = cell::fromBytes(build.bytes());
  if (!artifact) throw std::runtime_error(artifact.error());
  return std::make_shared<const cell::Artifact>(std::move(*artifact));
}

}  // namespace

std::shared_ptr<const cell::Artifact> artifactOf(const std::string& name, const Change& change) {
  auto cell = runtime::readCellFile(test_support::inSourceTree("config/cells/" + name + ".yaml"));
  if (!cell) throw std::runtime_error(cell.error().front());
  cell->parameters.voxel = 0.04;
  cell->parameters.step_bound = 0.02;
  if (change) change(cell->parameters);
  return built(std::move(*cell), cell::Policy::Supervisor);
}

std::shared_ptr<const cell::Artifact> artifactOfText(const std::string& text, const Change& change,
                                                     cell::Policy policy) {
  auto cell = cell::parseCell(text, "cell.yaml", [](const std::string& name) {
    return Result<std::string, std::string>(refuse("there is no file " + name));
  });
  if (!cell) throw std::runtime_error(describe(cell.error().front()));
  if (change) change(cell->parameters);
  return built(std::move(*cell), policy);
}

RunRig::RunRig(std::shared_ptr<const cell::Artifact> made, const TrialSettings& settings)
    : artifact(std::move(made)), model_(*cell::modelOf(artifact->program)), places_(artifact->robots.size()) {
  auto of = CellTrial::of(artifact, settings);
  if (!of) throw std::runtime_error(of.error());
  trial = std::move(*of);
  for (cell::RobotIndex robot = 0; robot < trial->robots(); ++robot) {
    watches_.push_back(*cell::ZoneWatch::of(*artifact, robot));
  }
}

void RunRig::begin(int cycles) {
  ASSERT_TRUE(trial->start()) << trial->status().diagnosis;
  trial->runAll(cycles);
}

void RunRig::pass(Duration duration) {
  static_cast<void>(passUntil([] { return false; }, duration));
}

bool RunRig::passUntil(const std::function<bool()>& done, Duration most) {
  bool is_done = false;
  static_cast<void>(trial->passUntil(
      [&] {
        look();
        is_done = !::testing::Test::HasFatalFailure() && done();
        return is_done || ::testing::Test::HasFatalFailure();
      },
      most));
  return is_done;
}

bool RunRig::endsAll(Duration most) {
  const auto all_ended = [this] {
    for (cell::RobotIndex robot = 0; robot < trial->robots(); ++robot) {
      if (!this->robot(robot).hasEnded()) return false;
    }
    return true;
  };
  bool is_well = passUntil(all_ended, most);
  EXPECT_TRUE(is_well) << "they do not come to an end";
  for (cell::RobotIndex robot = 0; robot < trial->robots(); ++robot) {
    is_well = ends(robot, 0s) && is_well;
  }
  return is_well;
}

bool RunRig::ends(cell::RobotIndex robot, Duration most) {
  static_cast<void>(passUntil([&] { return this->robot(robot).hasEnded(); }, most));
  const blocks::Outcome* const outcome = this->robot(robot).lastOutcome();
  EXPECT_NE(outcome, nullptr) << this->robot(robot).name() << " is at " << placeOf(robot) << " "
                              << this->robot(robot).agent().stand(trial->now()).text;
  if (outcome == nullptr) return false;
  EXPECT_EQ(outcome->ending, blocks::Ending::Done)
      << this->robot(robot).name() << ": " << outcome->error_description;
  return outcome->ending == blocks::Ending::Done;
}

void RunRig::order(cell::RobotIndex robot, int cycles, std::vector<std::string> paths) {
  blocks::RunProgramGoal goal;
  goal.cycles = cycles;
  goal.paths = std::move(paths);
  static_cast<void>(this->robot(robot).submit(goal));
}

void RunRig::commandByOther(cell::RobotIndex robot, const std::vector<std::string>& lines) {
  const protocol::ScriptRequest script{"other", fmt::format("{}", fmt::join(lines, "\r\n"))};
  this->robot(robot).receiveOfOther(protocol::encode(protocol::ClientMessage(script)));
}

bool RunRig::isIn(cell::RobotIndex index, cell::ZoneIndex zone) {
  watches_[index].see(robot(index).state().joints, {}, cell::ZoneWatch::Of::Everyone);
  return watches_[index].touches(zone);
}

std::string RunRig::placeOf(cell::RobotIndex index) {
  return robot(index).agent().stand(trial->now()).place;
}

bool RunRig::goesInto(cell::RobotIndex index, cell::ZoneIndex zone) {
  return passUntil([&] { return isMoving(index) && isIn(index, zone); });
}

int RunRig::errorOf(cell::RobotIndex index) {
  const blocks::Outcome* const outcome = robot(index).lastOutcome();
  return outcome == nullptr ? 0 : outcome->error_id;
}

void RunRig::look() {
  lookAtBeliefs();
  if (trial->now() < looked_at_ + kLookEvery) return;
  looked_at_ = trial->now();
  lookAtBodies();
  ASSERT_GE(trial->least().distance, artifact->parameters.margin)
      << trial->least().robot << " and " << trial->least().other;
}

void RunRig::lookAtBeliefs() {
  std::map<cell::ZoneIndex, cell::RobotIndex> holders;
  for (cell::RobotIndex robot = 0; robot < trial->robots(); ++robot) {
    const std::string name = placeOf(robot);
    const auto& places = model_.places[robot];
    const auto place =
        std::find_if(places.begin(), places.end(), [&](const auto& one) { return one.name == name; });
    ASSERT_NE(place, places.end()) << name;
    if (!this->robot(robot).isLetIn() || dead.count(robot) != 0) continue;
    for (const cell::ZoneIndex zone : place->holds) {
      const auto holder = holders.emplace(zone, robot);
      ASSERT_TRUE(holder.second) << artifact->program.zones[zone] << " is held by "
                                 << this->robot(holder.first->second).name() << " and "
                                 << this->robot(robot).name();
    }
  }
}

void RunRig::lookAtBodies() {
  if (!looks_at_zones || !trial->hasSupervisor()) return;
  // Not by the state that is told: there, who stands in a free zone owns it.
  const automata::Tuple& tuple = trial->supervision().tuple();
  for (cell::RobotIndex robot = 0; robot < trial->robots(); ++robot) {
    watches_[robot].see(this->robot(robot).state().joints, {}, cell::ZoneWatch::Of::Users);
    for (const cell::ZoneIndex zone : watches_[robot].touched()) {
      const auto holder = model_.holder(zone, tuple[model_.automatonOf(zone)]);
      ASSERT_TRUE(holder && *holder == robot) << this->robot(robot).name() << " is in "
                                              << artifact->program.zones[zone] << " at " << placeOf(robot);
    }
  }
}

}  // namespace cobot_command::trial
