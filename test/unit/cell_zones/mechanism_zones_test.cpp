// Mechanisms, from their claims to what they hold: the pallet of the demo, and others made here.
#include "zoned_cell.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/zones/soundness.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr RobotIndex kRobot = 0;
constexpr RobotIndex kPallet = 1;

/// The pallet as a turntable about the z axis of its frame, that carries its load past the robot.
Cell turntable() {
  Cell cell = cellOf("pallet");
  Mechanism& table = cell.mechanisms.front();
  table.axis = Mechanism::Axis::Revolute;
  table.direction = Eigen::Vector3d::UnitZ();
  table.at.translation() = Eigen::Vector3d(0.5, 0.0, 0.15);
  table.shapes.front().at.translation() = Eigen::Vector3d(-0.5, 0.0, 0.0);
  for (MechanismPosition& position : table.positions) {
    position.value = degToRad(position.name == "IN" ? 0.0 : 180.0);
  }
  return cell;
}

/// Every corner of the load, at any value of the axis between its positions, is in the claim of a piece
/// there.
void expectClaimed(const Cell& cell) {
  const auto claims = orThrow(claimCell(cell, orThrow(planCell(cell))));
  const Mechanism& mechanism = cell.mechanisms.front();
  const Eigen::Vector3d half = 0.5 * std::get<BoxShape>(mechanism.shapes.front().kind).size;
  for (const Piece& piece : claims[kPallet].paths.front().pieces) {
    const auto& axis = std::get<AxisPosture>(piece.posture);
    EXPECT_LE(piece.displacement, cell.parameters.step_bound);
    for (const double share : {0.0, 0.3, 1.0}) {
      const double value = axis.from + share * (axis.to - axis.from);
      arm::Pose frame = mechanism.at;
      if (mechanism.axis == Mechanism::Axis::Revolute) {
        frame = frame * Eigen::AngleAxisd(value, mechanism.direction);
      } else {
        frame = frame * Eigen::Translation3d(value * mechanism.direction);
      }
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d signs((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                    (corner & 4) != 0 ? 1 : -1);
        const Eigen::Vector3d point = frame * mechanism.shapes.front().at * half.cwiseProduct(signs);
        EXPECT_TRUE(piece.claim.contains(voxelAt(point, cell.parameters.voxel))) << value;
      }
    }
  }
}

TEST(TheClaimOfAMechanism, hasItsBodiesWhereverItIsOnItsWay) {
  Cell pallet = cellOf("pallet");
  pallet.parameters.margin = 0.0;
  expectClaimed(pallet);
  Cell table = turntable();
  table.parameters.margin = 0.0;
  expectClaimed(table);
}

TEST(TheClaimOfAMechanism, goesFromPositionToPositionWithoutAGap) {
  for (const Cell& cell : {cellOf("pallet"), turntable()}) {
    const auto claims = orThrow(claimCell(cell, orThrow(planCell(cell))));
    ASSERT_EQ(claims.size(), 2U);
    EXPECT_EQ(claims[kPallet].name, "PALLET");
    EXPECT_EQ(claims[kPallet].stations.size(), 2U);
    double at = find(cell.mechanisms.front().positions, "OUT")->value;
    for (const Piece& piece : claims[kPallet].paths.front().pieces) {
      const auto& axis = std::get<AxisPosture>(piece.posture);
      EXPECT_EQ(axis.from, at);
      at = axis.to;
    }
    EXPECT_EQ(at, find(cell.mechanisms.front().positions, "IN")->value);
    EXPECT_EQ(claims[kPallet].paths.front().pieces.back().kind, Piece::Kind::Rest);
  }
}

TEST(ThePallet, sharesOneZoneWithTheRobotAndEntersItByItself) {
  const ZonedCell cell(cellOf("pallet"));
  ASSERT_EQ(cell.zones.size(), 1U);
  EXPECT_THAT(cell.zones[0].users, ElementsAre(kRobot, kPallet));
  const RobotProgram& program = cell.held.program.robots[kPallet];
  EXPECT_EQ(program.name, "PALLET");
  EXPECT_EQ(program.stations[program.home], "OUT");
  ASSERT_EQ(program.paths[0].steps.size(), 1U);
  EXPECT_TRUE(program.paths[0].steps[0].books);
  EXPECT_TRUE(program.paths[0].steps[0].uncontrollable);
  EXPECT_FALSE(program.paths[0].uncontrollable_go);
  ASSERT_EQ(program.paths[1].steps.size(), 1U);
  EXPECT_FALSE(program.paths[1].steps[0].books);
}

TEST(ThePallet, givesTheZoneBackBeforeItIsOut) {
  const ZonedCell cell(cellOf("pallet"));
  const auto& pieces = cell.claims[kPallet].paths[1].pieces;
  const ZonePlace& release = cell.held.robots[kPallet].paths[1].places.front();
  const double value = std::get<AxisPosture>(pieces[release.piece].posture).to;
  EXPECT_GT(value, 0.3);
  EXPECT_LT(value, 0.5);
}

TEST(AMechanismThatAsks, isModelledAsARobotIs) {
  Cell cell = cellOf("pallet");
  cell.mechanisms.front().program.front().controllable_book = true;
  const CellModel model = orThrow(modelOf(ZonedCell(cell).held.program));
  const auto parts = orThrow(synthesizeParts(model, Policy::Supervisor, 100000));
  EXPECT_EQ(parts.front().counts.states, 27U) << "as the handover";
  EXPECT_EQ(parts.front().counts.transitions, 48U);
}

TEST(AMechanismThatBeginsByItself, isModelledSo) {
  Cell cell = cellOf("pallet");
  cell.mechanisms.front().program.front().controllable_go = false;
  cell.mechanisms.front().program.front().controllable_book = true;
  const RobotProgram program = ZonedCell(cell).held.program.robots[kPallet];
  EXPECT_TRUE(program.paths[0].uncontrollable_go);
  EXPECT_FALSE(program.paths[0].steps[0].uncontrollable);
}

std::vector<std::string> faultsOf(const Cell& cell) {
  const auto planned = orThrow(planCell(cell));
  const auto claims = orThrow(claimCell(cell, planned));
  const auto held = holdZones(cell, planned, claims, orThrow(findZones(claims, cell.parameters)));
  return held ? std::vector<std::string>() : held.error();
}

TEST(AMechanism, isRefusedByNameWhereItsHomeIsInAZone) {
  Cell cell = cellOf("pallet");
  cell.mechanisms.front().home = "IN";
  EXPECT_THAT(faultsOf(cell), ElementsAre(HasSubstr("PALLET is in Z1 at its home IN, which RA and PALLET")));
  cell.mechanisms.front().holds = true;
  EXPECT_THAT(faultsOf(cell), IsEmpty());
}

TEST(AMechanism, isRefusedByNameWhereItNeverLeavesAZone) {
  Cell cell = cellOf("pallet");
  for (MechanismPosition& position : cell.mechanisms.front().positions) {
    if (position.name == "OUT") position.value = 0.8;
  }
  cell.mechanisms.front().holds = true;
  EXPECT_THAT(faultsOf(cell), Contains(HasSubstr("PALLET never leaves Z1, which RA and PALLET share")));
}

TEST(TheSoundnessOfThePallet, isThatOfRobots) {
  const ZonedCell cell(cellOf("pallet"));
  const Soundness found = checkSoundness(cell.cell, cell.claims, cell.held);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_GE(found.least, cell.cell.parameters.margin);
}

TEST(TheSoundnessOfThePallet, isLostWithoutItsZone) {
  const ZonedCell cell(cellOf("pallet"));
  HeldCell held = cell.held;
  for (HeldRobot& robot : held.robots) {
    for (HeldPath& path : robot.paths) path.holds.clear();
    for (auto& zones : robot.at_stations) zones.clear();
  }
  const Soundness found = checkSoundness(cell.cell, cell.claims, held);
  EXPECT_THAT(found.faults, Contains(HasSubstr("RA on FETCH, step 1; PALLET on FEED: ")));
  EXPECT_THAT(found.faults, Contains(HasSubstr("RA at T1; PALLET at IN: ")));
}

TEST(TheSoundnessOfThePallet, isLostWhereItReleasesAPieceTooEarly) {
  const ZonedCell cell(cellOf("pallet"));
  HeldCell held = cell.held;
  // Far enough: claims are larger than bodies, so that some pieces at the end of a hold could do without it.
  Hold& hold = held.robots[kPallet].paths[1].holds.front();
  *hold.last_piece -= 8;
  const Soundness found = checkSoundness(cell.cell, cell.claims, held);
  EXPECT_THAT(found.faults, Contains(HasSubstr("PALLET on CLEAR")));
}

TEST(TheSoundnessOfThePallet, countsObstaclesToo) {
  Cell cell = cellOf("pallet");
  cell.obstacles.push_back(
      {"post", {{BoxShape{{0.1, 0.1, 0.5}}, arm::Pose(Eigen::Translation3d(0.24, -0.5, 0.25))}}, {}});
  const ZonedCell zoned(cell);
  const Soundness found = checkSoundness(zoned.cell, zoned.claims, zoned.held);
  EXPECT_THAT(found.faults, Contains(HasSubstr("PALLET on FEED; the obstacle post")));
  EXPECT_THAT(found.faults, Each(HasSubstr("PALLET")));
}

/// A table whose top is so far above the bases.
Cell handoverOnATable(double top) {
  Cell cell = cellOf("handover");
  cell.obstacles.push_back(
      {"table", {{BoxShape{{2.0, 2.0, 0.1}}, arm::Pose(Eigen::Translation3d(0.0, 0.0, top - 0.05))}}, {}});
  return cell;
}

TEST(TheSoundnessOfRobotsOnATable, countsAllBodiesButTheirBases) {
  const ZonedCell on_it(handoverOnATable(0.0));
  const Soundness found = checkSoundness(on_it.cell, on_it.claims, on_it.held);
  EXPECT_THAT(found.faults, IsEmpty()) << "the bases stand on it";
  const ZonedCell in_it(handoverOnATable(0.3));
  EXPECT_THAT(checkSoundness(in_it.cell, in_it.claims, in_it.held).faults,
              Contains(HasSubstr("RA at HOME; the obstacle table: ")));
}

TEST(TheSoundnessOfRobotsOnATable, tellsTheLeastThatIsLeftAndOfWhichBody) {
  const ZonedCell zoned(handoverOnATable(0.3));
  const Soundness found = checkSoundness(zoned.cell, zoned.claims, zoned.held);
  EXPECT_LT(found.least, 0.0);
  EXPECT_THAT(found.faults,
              Contains(AllOf(HasSubstr("RA at HOME"), HasSubstr(" mm remain between them (link_2)"))));
  const std::string least = fmt::format("{:.1f} mm remain", 1000.0 * found.least);
  EXPECT_THAT(found.faults, Contains(HasSubstr(least))) << "the worst of the path, and not the first";
}

}  // namespace
}  // namespace cobot_command::cell
