#include "cobot_command/runtime/cell/cell_supervisor.h"

#include <chrono>
#include <utility>

#include "cell/journal_file.h"
#include <Eigen/Core>
#include <fmt/format.h>

#include "cobot_command/cell/artifact/artifact_rules.h"
#include "cobot_command/cell/artifact/artifact_schedule.h"
#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/any_id.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::runtime {
namespace {

constexpr auto kScheduleWithin = std::chrono::seconds(10);

std::optional<std::string> objectionTo(const cell::Artifact& artifact, const SupervisorFiles& files) {
  if (files.cell_file.empty()) return std::nullopt;
  const auto cell = readCellFile(files.cell_file);
  if (!cell) return fmt::format("{}", fmt::join(cell.error(), "; "));
  const std::string hash = hashOf(*cell);
  if (hash == artifact.hash) return std::nullopt;
  return fmt::format(
      "{} is not made of {}, whose hash is {}, and not {}: build it anew, by tm_cell build, for all nodes of "
      "the cell",
      foreignText(files.artifact), foreignText(files.cell_file), hash.substr(0, 8),
      artifact.hash.substr(0, 8));
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
  if (!artifact) return refuse(artifact.error().front());
  if (auto objection = objectionTo(*artifact, files)) return refuse(*std::move(objection));
  auto rules = rulesOf(*artifact, policyOf(*artifact, deciding));
  if (!rules) return refuse(rules.error());
  auto turns = turnsFor(*artifact, rules->model(), deciding);
  if (!turns) return refuse("no schedule: " + turns.error());
  auto journal = JournalFile::open(files.journal);
  if (!journal) return refuse(journal.error());
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
  cell::SupervisionSettings settings;
  settings.lease = artifact_.parameters.lease;
  settings.aging = artifact_.parameters.aging;
  settings.turns = std::move(turns);
  core_ = std::make_unique<cell::Supervision>(std::move(rules), artifact_.hash, anyId(),
                                              journal_->takeRecords(), std::move(settings), std::move(ports));
}

CellSupervisor::~CellSupervisor() = default;

}  // namespace cobot_command::runtime
