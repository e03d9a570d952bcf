// The program tm_cell refuses cells of which nothing can be proved: with exit status 1, by name, and with
// what helps (oracle 32).
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tm_cell_program.h"
#include <gmock/gmock.h>

namespace cobot_command::test_support {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

using Changes = std::vector<std::pair<std::string, std::string>>;

/// Builds cells of config/cells in which texts are replaced by others.
class TmCellRefuses : public TmCell {
 protected:
  [[nodiscard]] Outcome buildOf(const std::string& name, const Changes& changes) const {
    std::string text = textIn(cellFile(name));
    for (const auto& [from, to] : changes) {
      const auto at = text.find(from);
      if (at == std::string::npos) {
        throw std::runtime_error(std::string(name).append(" has no ").append(from));
      }
      text.replace(at, from.size(), to);
    }
    std::ofstream(in("changed.yaml")) << text;
    return tmCell("build " + in("changed.yaml") + " -o " + artifact());
  }
  [[nodiscard]] std::string artifact() const { return in("changed.artifact"); }
  [[nodiscard]] bool isBuilt() const { return static_cast<bool>(std::ifstream(artifact())); }

  static constexpr const char* kParameters = "parameters: {voxel: 20, step_bound: 10, margin: 20}";
};

TEST_F(TmCellRefuses, optionsThatAreNoNumberOrAnEmptyName) {
  for (const std::string arguments :
       {"simulate x --loss nan", "schedule x --seconds nan", "cover x --cell nan", "cover x --scale -nan"}) {
    const Outcome outcome = tmCell(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("nan is not a number")) << arguments;
  }
  for (const std::string arguments : {"build x -o ''", "verify x --cell ''"}) {
    const Outcome outcome = tmCell(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("the name is empty")) << arguments;
  }
}

TEST_F(TmCellRefuses, aMarginSoLargeThatHomeIsInsideAZone) {
  const Outcome outcome = buildOf("handover", {{"margin: 20}", "margin: 150}"}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("RA is in Z1 at its home HOME, which RA and RB share"));
  EXPECT_THAT(outcome.output, HasSubstr("choose another home"));
  EXPECT_THAT(
      outcome.output,
      ContainsRegex("RB on T1, step 1, comes within [0-9.]+ mm of it: [0-9.]+ mm more distance is enough"));
  EXPECT_FALSE(isBuilt());
  EXPECT_EQ(buildOf("handover", {}).exit_code, 0) << "it is the margin";
}

TEST_F(TmCellRefuses, aBaseInsideTheClaimOfAnother) {
  const Outcome outcome = buildOf("handover", {{"base: [720, -122.3", "base: [-100, 122.3"}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("RB never leaves Z"));
  EXPECT_THAT(outcome.output, ContainsRegex("at its home RA .*comes within -?[0-9.]+ mm of it"));
  EXPECT_FALSE(isBuilt());
}

TEST_F(TmCellRefuses, aRobotThatNeverLeavesThoughItsHomeMayBeThere) {
  // RA stays at the place where RB has to come by, and holds it from the start.
  const Outcome outcome = buildOf(
      "handover", {{"RA: &stations {HOME: [0, -30, 120, 0, 90, 0]", "RA: {HOME: [0, 40, 60, -15, 90, 0]"},
                   {"RB: *stations", "RB: {HOME: [0, -30, 120, 0, 90, 0], T1: [0, 45, 60, -15, 90, 0]}"},
                   {"home: HOME, tool: &gripper", "home: HOME, holds: true, tool: &gripper"}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("RA never leaves Z1"));
  EXPECT_FALSE(isBuilt());
}

TEST_F(TmCellRefuses, claimsThatWouldTakeTooMuchMemoryBeforeTheyAreMade) {
  const Outcome outcome = buildOf(
      "handover", {{kParameters, "parameters: {voxel: 5, step_bound: 1, margin: 200, body_tolerance: 50}"}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, ContainsRegex("parameters make claims of [0-9]+ MiB: [0-9]+ pieces with "
                                            "step_bound 1 mm, in voxels of 5 mm; allowed: 1024 MiB"));
  EXPECT_THAT(outcome.output, ContainsRegex("step_bound [0-9]+ mm or voxel [0-9]+ mm is sufficient"));
  EXPECT_FALSE(isBuilt());
}

TEST_F(TmCellRefuses, moreZonesThanAllowed) {
  const Outcome outcome = buildOf(
      "handover",
      {{kParameters, "parameters: {voxel: 20, step_bound: 10, margin: 20, zone_size: 50, zone_overlap: 1}"}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("at most max_zones = 256 are allowed"));
  EXPECT_FALSE(isBuilt());
}

/// The 257th zone, where 256 are allowed: of two the second, where one is.
TEST_F(TmCellRefuses, oneZoneMoreThanAllowedAndNotThatMany) {
  const auto most = [](int zones) {
    return Changes{{"parameters:", "parameters:\n  max_zones: " + std::to_string(zones)}};
  };
  const Outcome one = buildOf("corridor", most(3));
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_THAT(one.output, HasSubstr("there are 4 zones, but at most max_zones = 3 are allowed"));
  EXPECT_FALSE(isBuilt());
  EXPECT_EQ(buildOf("corridor", most(4)).exit_code, 0);
}

TEST_F(TmCellRefuses, moreStatesThanAllowedWhereSafeOrdersCannotDecide) {
  const Changes few = {{"cell: pallet", "cell: pallet\nparameters: {max_states: 3}"}};
  const Outcome outcome = buildOf("pallet", few);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("so that safe_order cannot decide"),
                    HasSubstr("a supervisor has more than max_states = 3 states. Raise max_states")));
  EXPECT_FALSE(isBuilt());
}

/// Robots alone are not refused: safe orders decide, and that is told (cell.md, M26).
TEST_F(TmCellRefuses, noRobotsForTheirStatesAsSafeOrdersDecide) {
  const auto most = [](const char* states) {
    return Changes{{"margin: 20}", std::string("margin: 20, max_states: ") + states + "}"}};
  };
  const Outcome outcome = buildOf("handover", most("2"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              HasSubstr("RA, RB: safe_order decides without a table, and refuses slightly more than a "
                        "supervisor: a supervisor has more than max_states = 2 states"));
  EXPECT_EQ(tmCell("verify " + artifact()).exit_code, 0);
  // Compressed, it has three.
  const Outcome compressed = buildOf("handover", most("3"));
  EXPECT_EQ(compressed.exit_code, 0) << compressed.output;
  EXPECT_THAT(compressed.output,
              AllOf(HasSubstr("3 states, 4 transitions (compressed)"), Not(HasSubstr("safe_order"))));
}

}  // namespace
}  // namespace cobot_command::test_support
