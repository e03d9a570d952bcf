#include "supervision/cell_builder.h"

#include <iterator>
#include <utility>

#include "supervision/supervisor_errors.h"
#include <fmt/format.h>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr double kFollowEvery = 0.05;  // [s]
constexpr const char* kMendPlace = "Set artifact to a file that can be written";
constexpr const char* kMendFile = "Fix the cell file: tm_cell check lists all errors in it";

bool isAbsolute(const std::string& name) {
  return !name.empty() && name.front() == '/';
}

std::optional<std::string> objectionTo(const cobot_command::BuildCellGoal& goal) {
  if (!isAbsolute(goal.cell_file)) {
    return fmt::format("cell_file is \"{}\": it must be an absolute path",
                       foreignText(goal.cell_file, kQuoteLimit));
  }
  if (!goal.artifact.empty() && !isAbsolute(goal.artifact)) {
    return fmt::format("artifact is \"{}\": it must be an absolute path, or empty",
                       foreignText(goal.artifact, kQuoteLimit));
  }
  if (goal.policy.empty() || goal.policy == "supervisor" || goal.policy == "safe_order") return std::nullopt;
  return fmt::format("policy is \"{}\": it must be supervisor, safe_order or empty",
                     foreignText(goal.policy, kQuoteLimit));
}

}  // namespace

CellBuilder::CellBuilder(const ros::NodeHandle& node, const ActionQueues& queues, std::string hash)
    : hash_(std::move(hash)),
      following_(ros::NodeHandle(node).createSteadyTimer(
          ros::WallDuration(kFollowEvery), [this](const ros::SteadyTimerEvent&) { follow(); }, false, false)),
      server_(
          node, "build_cell", queues, [this](const Handle& goal) { onGoal(goal); },
          [this](const Handle& goal) { onCancel(goal); }) {
  server_.start();
}

CellBuilder::~CellBuilder() {
  is_cancelled_ = true;
  if (thread_.joinable()) thread_.join();
}

void CellBuilder::onGoal(Handle goal) {
  auto objection = objectionTo(*goal.getGoal());
  if (!objection && goal_) objection = "another build_cell is running";
  if (objection) {
    cobot_command::BuildCellResult result;
    result.error_id = supervisor_error::kCellNotBuilt;
    result.error_description = forPeople(*objection);
    result.remedy = "Send allowed values; one build at a time";
    return goal.setRejected(result, result.error_description);
  }
  goal.setAccepted();
  if (thread_.joinable()) thread_.join();  // of the build before, which is over
  feedback_ = {};
  feedback_.stages = static_cast<std::uint32_t>(std::size(cell::kBuildStages));
  result_ = {};
  told_stage_.clear();
  is_over_ = false;
  is_cancelled_ = false;
  const bool by_order = goal.getGoal()->policy == "safe_order";
  thread_ = std::thread(&CellBuilder::build, this, *goal.getGoal(),
                        by_order ? cell::Policy::SafeOrder : cell::Policy::Supervisor);
  goal_ = std::move(goal);
  following_.start();
}

void CellBuilder::onCancel(const Handle& goal) {
  if (goal_ && goal == *goal_) is_cancelled_ = true;
}

void CellBuilder::build(const cobot_command::BuildCellGoal& goal, cell::Policy policy) {
  bool is_done = false;
  try {
    is_done = runStages(goal, policy);
  } catch (const std::exception& error) {
    failed({fmt::format("the build of {} was aborted: {}", foreignText(goal.cell_file), error.what())});
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.stale = static_cast<std::uint8_t>(is_done && result_.hash != hash_);
  is_over_ = true;
}

bool CellBuilder::runStages(const cobot_command::BuildCellGoal& goal, cell::Policy policy) {
  auto cell = runtime::readCellFile(goal.cell_file);
  if (!cell) {
    failed(cell.error());
    return false;
  }
  cell::CellBuild build(*std::move(cell), policy, 1);
  for (const cell::BuildStage stage : cell::kBuildStages) {
    if (is_cancelled_) return false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      feedback_.stage = toString(stage);
    }
    const auto faults = build.run(stage);
    if (!faults.empty()) {
      failed(faults);
      return false;
    }
    const auto report = build.report(stage);
    const std::lock_guard<std::mutex> lock(mutex_);
    ++feedback_.done;
    feedback_.report = report;
    result_.report.insert(result_.report.end(), report.begin(), report.end());
  }
  if (is_cancelled_) return false;
  const auto faults =
      goal.artifact.empty() ? std::vector<std::string>() : runtime::writeFile(goal.artifact, build.bytes());
  if (!faults.empty()) failed(faults);
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.hash = cell::digestOf(build.bytes());
  return faults.empty();
}

void CellBuilder::failed(const std::vector<std::string>& faults) {
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.error_id = supervisor_error::kCellNotBuilt;
  result_.error_description =
      forPeople(faults.size() == 1 ? faults.front()
                                   : fmt::format("{} (the first of {})", faults.front(), faults.size()));
  result_.remedy = feedback_.done < feedback_.stages ? kMendFile : kMendPlace;
  for (const std::string& fault : faults) result_.faults.push_back(forPeople(fault));
}

void CellBuilder::follow() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!goal_) return;
  if (feedback_.stage != told_stage_) {
    told_stage_ = feedback_.stage;
    goal_->publishFeedback(feedback_);
  }
  if (!is_over_) return;
  following_.stop();
  Handle goal = *std::exchange(goal_, std::nullopt);
  if (result_.error_id != 0) {
    goal.setAborted(result_, result_.error_description);
  } else if (is_cancelled_ && result_.hash.empty()) {
    result_.error_description = "cancelled; no file was written";
    goal.setCanceled(result_, result_.error_description);
  } else {
    goal.setSucceeded(result_);
  }
}

}  // namespace cobot_command::ros_adapter
