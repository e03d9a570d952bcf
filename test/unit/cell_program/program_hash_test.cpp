#include <random>
#include <string>

#include "cell_texts.h"
#include "thorough.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

std::string hashOfText(const std::string& text) {
  const auto cell = parsed(text);
  return cell ? hashOf(*cell) : "";
}

TEST(CellHash, doesNotDependOnHowTheFileIsWritten) {
  const std::string hash = hashOf(cellOf(kExample));
  EXPECT_EQ(hash.size(), 64U);
  const std::pair<const char*, const char*> same[] = {
      {"# demo A1; complete", "# another comment"},
      {"{voxel: 20, step_bound: 10, margin: 20}", "{margin: 20.0, step_bound: 1e1, voxel: 20}"},
      {"parameters: {voxel: 20, step_bound: 10, margin: 20}", ""},  // they are the defaults
      {"namespace: RA, ", ""},
      {"base: [-720, 122.3, 0, 0, 0, 0]", "base: {position: [-720, 122.3, 0], quaternion: [0, 0, 0, 1]}"},
      {"base: [720, -122.3, 0, 0, 0, 180]",
       "base: {position: [720, -122.3, 0], rotation: [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]}"},
      {"base: [720, -122.3, 0, 0, 0, 180]", "base: [720, -122.3, -0, 0, 0, -180]"},
      {"tool: *gripper", "tool: [{capsule: {radius: 50, to: [0,0,120], from: [0,0,0]}}]"},
      {"target_position: T1", "target_position: [0, 45, 60, -15, 90, 0]"},
      {"speed: 30", "block: move_absolute, speed: 30, blending_enable: false, exit_node: false"},
      {"HOME: [0, -30", "HOME: [0.0, -30"},
      {"speed: 30", "dwell: false, speed: 30"},
      {"cell: handover", "\"cell\": 'handover'"},
      {"stations:\n", "stations:\n\n\n"}};
  for (const auto& [from, to] : same) EXPECT_EQ(hashOfText(with(kExample, from, to)), hash) << to;
}

TEST(CellHash, dependsOnAllThatItMeans) {
  const std::string hash = hashOf(cellOf(kFull));
  const std::pair<const char*, const char*> others[] = {
      {"cell: full", "cell: ful"},
      {"voxel: 10", "voxel: 10.5"},
      {"aging: 5", "aging: 6"},
      {"line/RA", "line/RB"},
      {"-720, 122.3, 0], quat", "-720, 122.4, 0], quat"},
      {"holds: true", "holds: false"},
      {"radius: 50", "radius: 51"},
      {"at: [0, 0, 120, 0", "at: [0, 0, 120, 1"},
      {"HOME: [0, -30, 120, 0, 90, 0], T1", "HOME: [0, -30, 120, 0, 90, 0], T2: [0, 0, 0, 0, 0, 0], T1"},
      {"length: 40", "length: 41"},
      {"size: [20, 2000", "size: [20, 2001"},
      {"kind: prismatic", "kind: revolute"},
      {"along: [0, 2, 0]", "along: [0, 2, 1]"},
      {"IN: 900", "IN: 901"},
      {"duration: 4", "duration: 5"},
      {"[book]", "[go]"},
      {"path: WORK", "path: WORKS"},
      {"name: world", "name: word"},
      {"base: [1, 2, 3", "base: [1, 2, 4"},
      {"weight: 1.5", "weight: 1.6"},
      {"moment_of_inertia: [1, 2, 3]", "moment_of_inertia: [1, 2, 4]"},
      {"mass_center: [0, 0, 10", "mass_center: [0, 0, 11"},
      {"data_format: TAR", "data_format: CAR"},
      {"blending_value: 20", "blending_value: 21"},
      {"arc_angle: 90", "arc_angle: 91"},
      {"command_id: 3", "command_id: 4"},
      {"disable_precise_positioning: true", "disable_precise_positioning: false"},
      {"RIGHTY", "LEFTY"},
      {"output: 1,", "output: 2,"},
      {"timeout: 3", "timeout: 4"},
      {"dwell: 1.5", "dwell: 1.6"},
      {"dwell: 0.5", "dwell: 0.6"},
      {",30,300,0,true)", ",31,300,0,true)"},
      {"at: [0, 0, 125", "at: [0, 0, 126"}};
  for (const auto& [from, to] : others) {
    const std::string text = with(kFull, from, to);
    EXPECT_NE(hashOf(cellOf(text)), hash) << to;
  }
}

TEST(CellHash, ofAFileThatIsNamedIsOfWhatStandsInIt) {
  const auto other = [](const std::string&) -> Result<std::string, std::string> {
    return with(*readTestFile("pick.yaml"), "speed: 30", "speed: 31");
  };
  const auto cell = parseCell(kFull, "cell.yaml", other);
  ASSERT_TRUE(cell);
  EXPECT_NE(hashOf(*cell), hashOf(cellOf(kFull)));
  const auto elsewhere = parseCell(kFull, "/elsewhere/cell.yaml", readTestFile);
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ(hashOf(*elsewhere), hashOf(cellOf(kFull))) << "and not of where the files are";
}

TEST(CellHash, takesNoTextForMoreThanIt) {
  EXPECT_THAT(canonicalText(cellOf(with(kFull, "name: world", "name: world 4:then"))),
              ::testing::HasSubstr("step 12:world 4:then\n"));
  EXPECT_THAT(canonicalText(cellOf(kFull)), ::testing::HasSubstr("script 42:PTP("));
}

/// What can be told of two cells without the canonical text.
bool sameSteps(const Path& a, const Path& b) {
  if (a.name != b.name || a.from != b.from || a.to != b.to || a.steps.size() != b.steps.size()) return false;
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    const auto* one = std::get_if<blocks::MoveAbsoluteGoal>(&a.steps[i].goal);
    const auto* other = std::get_if<blocks::MoveAbsoluteGoal>(&b.steps[i].goal);
    if (one == nullptr || other == nullptr || a.steps[i].name != b.steps[i].name) return false;
    if (one->movement_command != other->movement_command || one->data_format != other->data_format ||
        one->target != other->target || one->speed != other->speed || one->accel_time != other->accel_time) {
      return false;
    }
  }
  return true;
}
bool sameRobots(const Robot& a, const Robot& b) {
  if (a.name != b.name || a.model != b.model || a.name_space != b.name_space || a.home != b.home ||
      !a.base.isApprox(b.base, 1e-12) || a.tool.size() != b.tool.size() ||
      a.stations.size() != b.stations.size() || a.program.size() != b.program.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.tool.size(); ++i) {
    const auto* one = std::get_if<CapsuleShape>(&a.tool[i].kind);
    const auto* other = std::get_if<CapsuleShape>(&b.tool[i].kind);
    if (one == nullptr || other == nullptr || one->from != other->from || one->to != other->to ||
        one->radius != other->radius) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.stations.size(); ++i) {
    if (a.stations[i].name != b.stations[i].name || a.stations[i].joints != b.stations[i].joints) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.program.size(); ++i) {
    if (!sameSteps(a.program[i], b.program[i])) return false;
  }
  return true;
}
bool sameMeaning(const Cell& a, const Cell& b) {
  bool same = a.name == b.name && describe(a.parameters) == describe(b.parameters) &&
              a.robots.size() == b.robots.size() && a.parts.size() == b.parts.size() &&
              a.obstacles.size() == b.obstacles.size() && a.mechanisms.size() == b.mechanisms.size();
  for (std::size_t i = 0; same && i < a.robots.size(); ++i) same = sameRobots(a.robots[i], b.robots[i]);
  return same;
}

/// Refused, of another hash, or the same cell.
void expectNotSilent(const std::string& text, const Cell& example, const std::string& hash) {
  const auto cell = parsed(text);
  if (!cell) {
    EXPECT_FALSE(cell.error().empty());
    for (const Fault& fault : cell.error()) {
      EXPECT_FALSE(fault.found.empty() || fault.advice.empty()) << describe(fault);
      EXPECT_LT(describe(fault).size(), 2000U);
    }
  } else {
    EXPECT_EQ(hashOf(*cell) == hash, sameMeaning(*cell, example)) << text;
  }
}

TEST(CellHash, knowsEveryTruncatedFile) {
  const Cell example = cellOf(kExample);
  const std::string text = kExample;
  for (std::size_t size = 0; size < text.size(); ++size) {
    expectNotSilent(text.substr(0, size), example, hashOf(example));
  }
}

TEST(CellHash, knowsEveryFlippedBit) {
  const Cell example = cellOf(kExample);
  const std::string hash = hashOf(example);
  std::mt19937 random(7);
  for (std::size_t at = 0; at < std::string(kExample).size(); ++at) {
    std::string text = kExample;
    text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << (random() % 8)));
    expectNotSilent(text, example, hash);
  }
}

TEST(CellHash, knowsBytesThatAreOthers) {
  const Cell example = cellOf(kExample);
  const std::string hash = hashOf(example);
  std::mt19937 random(11);
  const std::string marks = "{}[]:,&*#-?|>!%@`'\" \n\t0123456789abc~<.\x04\xff";
  for (int i = 0; i < testing::tenthWhenWatched(3000); ++i) {
    std::string text = kExample;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      text[random() % text.size()] = marks[random() % marks.size()];
    }
    expectNotSilent(text, example, hash);
  }
}

}  // namespace
}  // namespace cobot_command::cell
