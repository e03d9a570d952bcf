#include "build_commands.h"

#include <chrono>

#include <fmt/format.h>

#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {

using runtime::readArtifact;
using runtime::readCellFile;
using runtime::writeFile;
namespace {

using cell::BuildStage;

AnswerStage checked(const cell::Cell& cell, Clock::time_point begin) {
  AnswerStage stage{"check", secondsSince(begin), {}, {}};
  stage.report.push_back(fmt::format("{}: {} robots, {} parts, {} obstacles, {} mechanisms", cell.name,
                                     cell.robots.size(), cell.parts.size(), cell.obstacles.size(),
                                     cell.mechanisms.size()));
  stage.report.push_back("hash " + hashOf(cell));
  std::string parameters = describe(cell.parameters);
  for (std::size_t at = 0; at < parameters.size();) {
    const auto end = std::min(parameters.find('\n', at), parameters.size());
    stage.report.push_back("  " + parameters.substr(at, end - at));
    at = end + 1;
  }
  return stage;
}

}  // namespace

Answer checkCell(const std::string& cell_file) {
  const auto begin = Clock::now();
  const auto cell = readCellFile(cell_file);
  if (!cell) return {{{"check", secondsSince(begin), {}, cell.error()}}};
  return {{checked(*cell, begin)}};
}

Answer buildCell(const BuildOptions& options, BuildStage last) {
  auto begin = Clock::now();
  auto cell = readCellFile(options.cell_file);
  if (!cell) return {{{"check", secondsSince(begin), {}, cell.error()}}};
  Answer answer{{checked(*cell, begin)}};
  cell::CellBuild build(std::move(*cell), options.policy, options.threads);
  for (const BuildStage stage : cell::kBuildStages) {
    begin = Clock::now();
    auto faults = build.run(stage);
    const bool failed = !faults.empty();
    answer.stages.push_back({toString(stage), secondsSince(begin),
                             failed ? std::vector<std::string>() : build.report(stage), std::move(faults)});
    if (failed) return answer;
    if (stage == last) break;
  }
  if (options.output.empty()) return answer;
  begin = Clock::now();
  auto faults = writeFile(options.output, build.bytes(), options.cell_file);
  answer.stages.push_back({"write", secondsSince(begin), {options.output}, std::move(faults)});
  return answer;
}

namespace {

/// Why the artifact is not what is made of that cell.
std::vector<std::string> compared(const cell::Artifact& artifact, const std::string& artifact_file,
                                  cell::Cell cell, const std::string& cell_file, unsigned threads) {
  if (hashOf(cell) != artifact.hash) {
    return {fmt::format("{} is not what the artifact was made of: its hash is {}. Build it anew", cell_file,
                        hashOf(cell))};
  }
  cell::CellBuild build(std::move(cell), artifact.policy, threads);
  for (const BuildStage stage : cell::kBuildStages) {
    if (stage == BuildStage::Verify) break;  // that is done with the bytes of the file
    auto faults = build.run(stage);
    if (!faults.empty()) return faults;
  }
  const auto bytes = runtime::readFile(artifact_file);
  if (bytes && *bytes == build.bytes()) return {};
  return {
      fmt::format("{} has the hash of {}, and is not what is made of it here: it was changed, or made by "
                  "another version or on another kind of machine. Build it anew",
                  artifact_file, cell_file)};
}

}  // namespace

Answer verifyArtifact(const std::string& artifact_file, const std::string& cell_file, unsigned threads) {
  const auto begin = Clock::now();
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"verify", secondsSince(begin), {}, artifact.error()}}};
  AnswerStage stage{"verify", 0.0, {"hash " + artifact->hash}, {}};
  if (!cell_file.empty()) {
    auto cell = readCellFile(cell_file);
    if (!cell) return {{{"check", secondsSince(begin), {}, cell.error()}}};
    stage.faults = compared(*artifact, artifact_file, *std::move(cell), cell_file, threads);
    if (stage.faults.empty()) stage.report.push_back("it is, byte by byte, what is made of " + cell_file);
  }
  const auto model = cell::modelOf(artifact->program);
  if (!model) return {{{"verify", secondsSince(begin), {}, model.error()}}};
  for (const auto& part : verifyParts(*model, artifact->supervisors,
                                      static_cast<std::size_t>(artifact->parameters.max_states))) {
    stage.faults.insert(stage.faults.end(), part.faults.begin(), part.faults.end());
    stage.report.push_back(
        fmt::format("{} states of plants and specs, {} dead; {} reached, {} refused by zones, {} beyond",
                    part.counts.plant_and_spec, part.counts.dead, part.counts.states,
                    part.counts.refused_by_spec, part.counts.refused_beyond_spec));
  }
  stage.seconds = secondsSince(begin);
  return {{std::move(stage)}};
}

}  // namespace cobot_command::tools
