#include "cobot_command/runtime/cell/cell_supervisor.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "cell/journal_file.h"
#include "shared/core_thread.h"
#include <Eigen/Core>
#include <fmt/format.h>

#include "cobot_command/cell/artifact/artifact_check.h"
#include "cobot_command/cell/artifact/artifact_rules.h"
#include "cobot_command/cell/artifact/artifact_schedule.h"
#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/any_id.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::runtime {
namespace {

constexpr auto kScheduleWithin = std::chrono::seconds(10);

/// Why it must not be run: of another cell, or not what is made of its own.
std::optional<std::string> faultOf(const cell::Artifact& artifact, const SupervisorFiles& files) {
  if (!files.cell_file.empty()) {
    if (auto objection = objectionTo(artifact, files.artifact, files.cell_file)) return objection;
  }
  const auto faults = cell::checkArtifact(artifact, std::max(1U, std::thread::hardware_concurrency())).faults;
  if (faults.empty()) return std::nullopt;
  const std::string more =
      faults.size() == 1 ? std::string() : fmt::format(" (the first of {})", faults.size());
  return fmt::format(
      "{} does not match its cell: {}{}. It was changed, or was made by another version or on another kind "
      "of machine: rebuild it with tm_cell build, for all nodes of the cell",
      foreignText(files.artifact), faults.front(), more);
}

cell::Policy policyOf(const cell::Artifact& artifact, Deciding deciding) {
  if (deciding == Deciding::Supervisor) return cell::Policy::Supervisor;
  return deciding == Deciding::SafeOrder ? cell::Policy::SafeOrder : artifact.policy;
}

Result<cell::ZoneOrders, std::string> turnsFor(const cell::Artifact& artifact, const cell::CellModel& model,
                                               Deciding deciding) {
  if (deciding != Deciding::Schedule) return cell::ZoneOrders();
  const auto begin = std::chrono::steady_clock::now();
  return turnsOf(artifact, model,
                 {2000000, [begin] { return std::chrono::steady_clock::now() - begin > kScheduleWithin; }});
}

}  // namespace

Result<std::unique_ptr<CellSupervisor>, std::string> CellSupervisor::open(const SupervisorFiles& files,
                                                                          Deciding deciding) {
  auto artifact = readArtifact(files.artifact);
  if (!artifact) return refuse("artifact: " + artifact.error().front());
  if (auto fault = faultOf(*artifact, files)) return refuse("artifact: " + *fault);
  auto rules = rulesOf(*artifact, policyOf(*artifact, deciding));
  if (!rules) return refuse(rules.error());
  auto turns = turnsFor(*artifact, rules->model(), deciding);
  if (!turns) return refuse("no schedule: " + turns.error());
  auto journal = JournalFile::open(files.journal);
  if (!journal) return refuse("journal: " + journal.error());
  return std::unique_ptr<CellSupervisor>(
      new CellSupervisor(*std::move(artifact), *std::move(rules), *std::move(turns), *std::move(journal)));
}

CellSupervisor::CellSupervisor(cell::Artifact artifact, cell::Rules rules, cell::ZoneOrders turns,
                               std::unique_ptr<JournalFile> journal)
    : artifact_(std::move(artifact)), journal_(std::move(journal)) {
  cell::SupervisionPorts ports;
  ports.append = [this](const std::string& line) { return journal_->append(line); };
  ports.replace = [this](const std::string& line) { return journal_->replace(line); };
  ports.fits = [this, places = rules.model().places](cell::RobotIndex robot, automata::StateIndex place,
                                                     const std::array<double, 6>& joints) {
    return cell::placeFits(artifact_, robot, places[robot][place],
                           Eigen::Map<const arm::JointVector>(joints.data()));
  };
  ports.stop = [this](const cell::StopOrder& order) {
    if (stop_) stop_(order);
  };
  cell::SupervisionSettings settings;
  settings.lease = artifact_.parameters.lease;
  settings.aging = artifact_.parameters.aging;
  settings.turns = std::move(turns);
  core_ = std::make_unique<cell::Supervision>(std::move(rules), artifact_.digest, anyId(),
                                              journal_->takeRecords(), std::move(settings), std::move(ports));
  thread_ = std::make_unique<CoreThread>();
}

CellSupervisor::~CellSupervisor() {
  finish();
}

void CellSupervisor::start(Stop stop) {
  stop_ = std::move(stop);
  thread_->start();
}

bool CellSupervisor::post(Task task) {
  return thread_->post([this, task = std::move(task)] { task(*core_); });
}

bool CellSupervisor::postUrgent(Task task) {
  return thread_->postUrgent([this, task = std::move(task)] { task(*core_); });
}

void CellSupervisor::finish() {
  thread_->finish([] {});
}

}  // namespace cobot_command::runtime
