#include "build_commands.h"

#include <chrono>

#include <fmt/format.h>

#include "cobot_command/cell/artifact/artifact_check.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/common/foreign_text.h"
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

Answer verifyArtifact(const std::string& artifact_file, const std::string& cell_file, unsigned threads) {
  auto begin = Clock::now();
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"verify", secondsSince(begin), {}, artifact.error()}}};
  Answer answer;
  if (!cell_file.empty()) {
    const auto objection = runtime::objectionTo(*artifact, artifact_file, cell_file);
    answer.stages.push_back({"compare", secondsSince(begin), {cell_file}, {}});
    if (objection) answer.stages.back().faults.push_back(*objection);
    begin = Clock::now();
  }
  auto check = cell::checkArtifact(*artifact, threads);
  for (std::string& fault : check.faults) fault = foreignText(artifact_file) + ": " + fault;
  if (!check.faults.empty()) {
    check.faults.push_back(
        foreignText(artifact_file) +
        " was changed, or was made by another version or on another kind of machine. Rebuild it");
  }
  answer.stages.push_back({"verify", secondsSince(begin), std::move(check.report), std::move(check.faults)});
  return answer;
}

}  // namespace cobot_command::tools
