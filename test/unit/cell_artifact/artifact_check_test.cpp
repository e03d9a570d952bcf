// That an artifact is what is made of its cell is found out anew, whatever its checksum says (cell.md, M17
// and M23).
#include "cobot_command/cell/artifact/artifact_check.h"

#include <functional>
#include <map>

#include "../cell_zones/zoned_cell.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/common/sha256.h"

namespace cobot_command::cell {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::string withText(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("there is no " + from);
  return text.replace(at, from.size(), to);
}

std::string textOf(const std::string& name) {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("config/cells/" + name + ".yaml")).rdbuf();
  return text.str();
}

std::string bytesOf(const std::string& text, Policy policy = Policy::Supervisor) {
  CellBuild build(readCell(text), policy, 1);
  for (const BuildStage stage : kBuildStages) EXPECT_THAT(build.run(stage), IsEmpty()) << toString(stage);
  return build.bytes();
}

/// Coarse, so that it is built quickly; with all that an artifact can have.
const std::string& pallet() {
  static const std::string bytes = [] {
    std::string text = withText(textOf("pallet"), "cell: pallet",
                                "cell: pallet\nparameters: {voxel: 60, step_bound: 40, split: never}");
    text = withText(text, "dwell: 0.5",
                    "dwell: 0.5\n          output: {module: ControlBox, output: 1, value: true}\n"
                    "          input: {module: ControlBox, input: 2, value: true, timeout: 5}");
    return bytesOf(text);
  }();
  return bytes;
}

const std::string& handover() {
  static const std::string bytes =
      bytesOf(withText(textOf("handover"), "voxel: 20, step_bound: 10", "voxel: 60, step_bound: 40"));
  return bytes;
}

/// As somebody would write it who knows how the checksum is made.
std::string repaired(const json& made, const json& source) {
  const std::string text = made.dump() + "\n" + source.dump() + "\n";
  return text + sha256Hex(text) + "\n";
}

std::vector<std::string> faultsOf(const std::string& bytes) {
  const auto artifact = fromBytes(bytes);
  if (!artifact) return {artifact.error()};
  return checkArtifact(*artifact, 1).faults;
}

std::vector<std::string> faultsOf(const std::function<void(Artifact&)>& change,
                                  const std::string& bytes = handover()) {
  Artifact artifact = *fromBytes(bytes);
  change(artifact);
  return faultsOf(toBytes(artifact));
}

struct TwoLines {
  explicit TwoLines(const std::string& bytes) {
    const std::size_t first = bytes.find('\n') + 1;
    made = json::parse(bytes.substr(0, first));
    source = json::parse(bytes.substr(first, bytes.find('\n', first) - first));
  }
  json made;
  json source;
};

/// One place of each kind: "/robots/*/paths/*/holds/*/zone" is a kind, whatever the numbers.
void findKinds(const json& value, const std::string& where, const std::string& kind,
               std::map<std::string, std::string>& kinds) {
  if (!kind.empty()) kinds.emplace(kind, where);
  if (value.is_array()) {
    // Of a list the last but one: at its end there is often what is nothing any more.
    for (std::size_t index = value.size(); index-- > 0;) {
      findKinds(value[index], where + "/" + std::to_string(index), kind + "/*", kinds);
    }
  } else if (value.is_object()) {
    for (const auto& item : value.items()) {
      findKinds(item.value(), where + "/" + item.key(), kind + "/" + item.key(), kinds);
    }
  }
}

/// By so much that it means something else.
json changed(const json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number_float()) return value.get<double>() + 0.001;
  if (value.is_number()) return value.get<std::int64_t>() + 1;
  if (value.is_string()) return value.get<std::string>() + "0";
  json shorter = value;
  if (shorter.is_array() && !shorter.empty()) shorter.erase(shorter.size() - 1);
  if (shorter.is_object() && !shorter.empty()) shorter.erase(shorter.begin());
  return shorter;
}

TEST(TheCheckOfAnArtifact, findsNothingInWhatWasBuilt) {
  EXPECT_THAT(faultsOf(pallet()), IsEmpty());
  EXPECT_THAT(faultsOf(handover()), IsEmpty());
  EXPECT_THAT(faultsOf(bytesOf(textOf("iris"))), IsEmpty()) << "motions are cut in it";
  EXPECT_THAT(faultsOf(bytesOf(textOf("head_on"), Policy::SafeOrder)), IsEmpty());
}

TEST(TheCheckOfAnArtifact, refusesAChangeOfEachKindOfValueInIt) {
  const TwoLines whole(pallet());
  std::map<std::string, std::string> kinds;
  findKinds(whole.made, "", "", kinds);
  EXPECT_GT(kinds.size(), 80U);
  for (const auto& [kind, where] : kinds) {
    // What a synthesis counted is for people.
    if (kind.find("/counts") != std::string::npos) continue;
    json made = whole.made;
    json& value = made[json::json_pointer(where)];
    const json other = changed(value);
    if (other == value) continue;  // an empty list
    value = other;
    EXPECT_FALSE(faultsOf(repaired(made, whole.source)).empty()) << where;
  }
}

TEST(TheCheckOfAnArtifact, namesThePlaceAndBothValues) {
  EXPECT_THAT(faultsOf([](Artifact& artifact) { artifact.robots[0].paths[0].holds[0].last_piece = 3; }),
              Contains(HasSubstr("/robots/0/paths/0/holds/0/last_piece is 3, but its cell results in null")));
  EXPECT_THAT(faultsOf([](Artifact& artifact) { artifact.parameters.margin = 0.005; }),
              Contains("/parameters/margin is 0.005, but its cell results in 0.02"));
  EXPECT_THAT(faultsOf([](Artifact& artifact) { artifact.robots[1].tool[0].capsules[0].radius = 0.01; }),
              Contains(HasSubstr("/robots/1/tool/0/capsules/0/6 is 0.01")));
  EXPECT_THAT(
      faultsOf([](Artifact& artifact) { artifact.robots[0].paths[0].frames[0].lines[0] = "PTP(\"JPP\")"; }),
      Contains(HasSubstr("/robots/0/paths/0/frames/0/lines/0")));
  EXPECT_THAT(faultsOf([](Artifact& artifact) { artifact.robots[0].base.translation().x() += 0.05; }),
              Contains(HasSubstr("/robots/0/base/3 is")));
}

TEST(TheCheckOfAnArtifact, passesOverTheLastDigitsOfNumbers) {
  EXPECT_THAT(faultsOf([](Artifact& artifact) { artifact.robots[0].base.translation().x() += 1e-13; }),
              IsEmpty());
}

TEST(TheCheckOfAnArtifact, refusesAnotherCellInIt) {
  const TwoLines whole(handover());
  json source = whole.source;
  source["cell"] = withText(source["cell"], "margin: 20", "margin: 5");
  EXPECT_THAT(faultsOf(repaired(whole.made, source)), Contains(HasSubstr("its hash is")));
  // With the hash of that one, too: then what it has is not what that makes.
  json made = whole.made;
  made["hash"] = TwoLines(bytesOf(source["cell"])).made["hash"];
  EXPECT_THAT(faultsOf(repaired(made, source)), Contains(HasSubstr("/parameters/margin")));
  source["cell"] = "cell: none";
  EXPECT_THAT(faultsOf(repaired(whole.made, source)), Contains(HasSubstr("the cell in it")));
}

TEST(TheCheckOfAnArtifact, readsTheFilesThatTheCellNamesInIt) {
  const std::string steps =
      "  RA:\n    - {path: T1, from: HOME, to: T1, steps_file: picks.yaml}\n"
      "    - {path: BACK, from: T1, to: HOME, steps: [{movement_command: PTP, data_format: JPP, "
      "target_position: HOME, speed: 30, accel_time: 300}]}\n  RB: ";
  std::string text = withText(textOf("handover"), "voxel: 20, step_bound: 10", "voxel: 60, step_bound: 40");
  const auto programs = text.find("programs:");
  const auto paths = text.substr(text.find("&program"), text.find("  RB: *program") - text.find("&program"));
  text = text.substr(0, programs) + "programs:\n" + steps + paths;
  const std::string picks =
      "steps:\n  - {movement_command: PTP, data_format: JPP, target_position: [0, 45, 60, -15, 90, 0], "
      "speed: 30, accel_time: 300}\n";
  const auto cell = parseCell(text, "cell.yaml",
                              [&](const std::string&) { return Result<std::string, std::string>(picks); });
  ASSERT_TRUE(cell) << describe(cell.error().front());
  CellBuild build(*cell, Policy::Supervisor, 1);
  for (const BuildStage stage : kBuildStages) ASSERT_THAT(build.run(stage), IsEmpty()) << toString(stage);
  EXPECT_THAT(faultsOf(build.bytes()), IsEmpty());
  TwoLines lines(build.bytes());
  lines.source["files"] = json::object();
  EXPECT_THAT(faultsOf(repaired(lines.made, lines.source)), Contains(HasSubstr("does not contain it")));
}

TEST(TheCheckOfAnArtifact, refusesAPolicyThatNothingProves) {
  for (const Policy policy : {Policy::None, Policy::MutualExclusion, Policy::SafeOrder}) {
    EXPECT_THAT(faultsOf([policy](Artifact& artifact) { artifact.policy = policy; }),
                Contains(HasSubstr("its policy is")));
  }
}

TEST(TheDigestOfAnArtifact, isThatOfAllButTheTextsThatItIsMadeOf) {
  const std::string text =
      withText(textOf("handover"), "voxel: 20, step_bound: 10", "voxel: 60, step_bound: 40");
  const std::string commented = bytesOf(text + "# a comment\n");
  EXPECT_NE(commented, handover());
  EXPECT_EQ(digestOf(commented), digestOf(handover()));
  EXPECT_EQ(fromBytes(handover())->digest, digestOf(handover()));
  Artifact artifact = *fromBytes(handover());
  artifact.robots[0].paths[0].holds[0].last_piece = 3;
  EXPECT_NE(digestOf(toBytes(artifact)), digestOf(handover())) << "though its cell has the same hash";
}

}  // namespace
}  // namespace cobot_command::cell
