#include "cobot_command/cell/artifact/artifact_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "artifact/artifact_json.h"
#include <fmt/format.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

using nlohmann::json;
using Faults = std::vector<std::string>;

constexpr std::size_t kDifferencesShown = 5;
/// Of numbers in m, rad or s that are calculated anew.
constexpr double kSame = 1e-9;

std::string shown(const json& value) {
  return foreignText(value.dump(-1, ' ', false, json::error_handler_t::replace), kQuoteLimit);
}

bool areSame(const json& found, const json& made) {
  if (!found.is_number() || !made.is_number()) return found == made;
  if (!found.is_number_float() || !made.is_number_float()) return found == made;
  const double number = made.get<double>();
  return std::abs(found.get<double>() - number) <= kSame * std::max(1.0, std::abs(number));
}

/// null where there is none.
const json& memberOf(const json& object, const std::string& key) {
  static const json nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

/// Adds where the found one is another one than what was made.
void compare(const json& found, const json& made, const std::string& where, Faults& differences) {
  if (differences.size() == kDifferencesShown) return;
  if (found.is_array() && made.is_array() && found.size() == made.size()) {
    for (std::size_t index = 0; index < made.size(); ++index) {
      compare(found[index], made[index], fmt::format("{}/{}", where, index), differences);
    }
  } else if (found.is_object() && made.is_object()) {
    for (const auto& item : made.items()) {
      compare(memberOf(found, item.key()), item.value(), where + "/" + item.key(), differences);
    }
    for (const auto& item : found.items()) {
      if (!made.contains(item.key())) {
        compare(item.value(), json(), where + "/" + item.key(), differences);
      }
    }
  } else if (!areSame(found, made)) {
    differences.push_back(
        fmt::format("{} is {}, but its cell results in {}", where, shown(found), shown(made)));
  }
}

Result<Cell, Faults> cellIn(const CellText& source) {
  auto cell = parseCell(source.text, "the cell in it", [&](const std::string& name) {
    const auto found = source.files.find(name);
    if (found != source.files.end()) return Result<std::string, std::string>(found->second);
    return Result<std::string, std::string>(refuse(std::string("the artifact does not contain it")));
  });
  if (cell) return *std::move(cell);
  Faults faults;
  for (const Fault& fault : cell.error()) faults.push_back(describe(fault));
  return refuse(std::move(faults));
}

/// In what it has beside supervisors.
Faults compareGeometry(const Artifact& artifact, Cell cell, unsigned threads, Faults& report) {
  CellBuild build(std::move(cell), artifact.policy, threads);
  for (const BuildStage stage : kBuildStages) {
    if (stage == BuildStage::Synthesize) break;
    auto faults = build.run(stage);
    if (!faults.empty()) return faults;
    if (stage != BuildStage::Soundness) continue;
    const auto found = build.report(stage);
    report.insert(report.end(), found.begin(), found.end());
  }
  Artifact made = build.artifact();
  made.supervisors = artifact.supervisors;
  Faults differences;
  compare(toJson(artifact), toJson(made), "", differences);
  return differences;
}

Faults checkPolicy(const Artifact& artifact) {
  const bool is_proved = [&] {
    if (artifact.policy == Policy::Supervisor) return true;
    return artifact.policy == Policy::SafeOrder &&
           std::all_of(artifact.supervisors.begin(), artifact.supervisors.end(),
                       [](const PartSupervisor& part) { return part.policy == Policy::SafeOrder; });
  }();
  if (is_proved) return {};
  return {fmt::format("its policy is {}: its supervisors decide in another way", toString(artifact.policy))};
}

Faults checkSupervisors(const Artifact& artifact, Faults& report) {
  Faults faults = checkPolicy(artifact);
  const auto model = modelOf(artifact.program);
  if (!model) return model.error();
  for (const auto& part :
       verifyParts(*model, artifact.supervisors, static_cast<std::size_t>(artifact.parameters.max_states))) {
    faults.insert(faults.end(), part.faults.begin(), part.faults.end());
    report.push_back(
        fmt::format("{} states of plants and specs, {} dead; {} reached, {} refused by zones, {} beyond",
                    part.counts.plant_and_spec, part.counts.dead, part.counts.states,
                    part.counts.refused_by_spec, part.counts.refused_beyond_spec));
  }
  return faults;
}

}  // namespace

ArtifactCheck checkArtifact(const Artifact& artifact, unsigned threads) {
  ArtifactCheck check;
  auto cell = cellIn(artifact.source);
  if (!cell) return {cell.error(), {}};
  const std::string hash = hashOf(*cell);
  if (hash != artifact.hash) {
    return {{fmt::format("its hash is {}, but the hash of the cell in it is {}",
                         foreignText(artifact.hash, kQuoteLimit), hash)},
            {}};
  }
  check.report.push_back("hash " + hash);
  check.faults = compareGeometry(artifact, *std::move(cell), threads, check.report);
  // Of what is not made of its cell nothing more needs to be known.
  if (check.faults.empty()) check.faults = checkSupervisors(artifact, check.report);
  return check;
}

}  // namespace cobot_command::cell
