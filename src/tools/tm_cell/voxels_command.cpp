#include "voxels_command.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/sweep/voxel_files.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {
namespace {

using Clock = std::chrono::steady_clock;

struct NamedVoxels {
  std::string name;
  std::string about;
  const cell::VoxelSet* voxels = nullptr;
};

std::vector<NamedVoxels> voxelsOf(const cell::CellBuild& build) {
  std::vector<NamedVoxels> all;
  for (const cell::Zone& zone : build.zones()) {
    std::vector<std::string> users;
    for (const auto user : zone.users) users.push_back(build.claims()[user].name);
    all.push_back(
        {"zone_" + zone.name,
         fmt::format("zone {} of {}, cell {}", zone.name, fmt::join(users, " and "), build.cell().name),
         &zone.voxels});
  }
  for (const cell::RobotClaim& claim : build.claims()) {
    all.push_back({"claim_" + claim.name, fmt::format("claim of {}, cell {}", claim.name, build.cell().name),
                   &claim.all});
  }
  return all;
}

void write(const NamedVoxels& named, double edge, const VoxelsOptions& options, AnswerStage& stage) {
  const std::string file =
      (std::filesystem::path(options.folder) / (named.name + "." + options.format)).string();
  const bool is_cloud = options.format == "ply";
  const Result<std::string, std::string> bytes = is_cloud ? cell::toPly(*named.voxels, edge, named.about)
                                                          : cell::toOctomap(*named.voxels, edge, named.about);
  if (!bytes) {
    stage.faults.push_back(fmt::format("{}: {}", named.about, bytes.error()));
    return;
  }
  auto faults = runtime::writeFile(file, *bytes);
  if (faults.empty()) {
    stage.report.push_back(fmt::format("{}: {}, {} voxels, {} bytes", foreignText(file), named.about,
                                       named.voxels->count(), bytes->size()));
  }
  stage.faults.insert(stage.faults.end(), faults.begin(), faults.end());
}

}  // namespace

Answer writeVoxels(const VoxelsOptions& options) {
  auto begin = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  auto cell = runtime::readCellFile(options.cell_file);
  if (!cell) return {{{"check", seconds(), {}, cell.error()}}};
  Answer answer;
  cell::CellBuild build(std::move(*cell), cell::Policy::Supervisor, options.threads);
  for (const cell::BuildStage stage : cell::kBuildStages) {
    if (stage == cell::BuildStage::Soundness) break;
    begin = Clock::now();
    auto faults = build.run(stage);
    if (!faults.empty()) return {{{toString(stage), seconds(), {}, std::move(faults)}}};
  }
  AnswerStage stage{"voxels", 0.0, {}, {}};
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error) {
    return wrong("voxels", fmt::format("the folder {} cannot be created: {}. Name another one",
                                       foreignText(options.folder), error.message()));
  }
  for (const NamedVoxels& named : voxelsOf(build)) {
    write(named, build.cell().parameters.voxel, options, stage);
  }
  stage.seconds = seconds();
  return {{std::move(stage)}};
}

}  // namespace cobot_command::tools
