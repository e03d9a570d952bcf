// Shapes, poses, parts, obstacles and mechanisms.
#include <string>

#include "cell_texts.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;

std::string faultsWith(const std::string& from, const std::string& to) {
  return faultsOf(with(kFull, from, to));
}

TEST(CellShapes, areReadInMetres) {
  const Cell cell = cellOf(kFull);
  const auto& box = std::get<BoxShape>(cell.parts.at(1).shapes.at(0).kind);
  EXPECT_TRUE(box.size.isApprox(Eigen::Vector3d(0.4, 0.3, 0.005)));
  const auto& cylinder = std::get<CylinderShape>(cell.parts.at(0).shapes.at(0).kind);
  EXPECT_EQ(cylinder.radius, 0.01);
  EXPECT_EQ(cylinder.length, 0.04);
  const Shape& sphere = cell.robots.at(0).tool.at(1);
  EXPECT_EQ(std::get<SphereShape>(sphere.kind).radius, 0.03);
  EXPECT_EQ(sphere.at.translation().z(), 0.12);
  const Shape& fence = cell.obstacles.at(0).shapes.at(0);
  EXPECT_TRUE(fence.at.linear().col(0).isApprox(Eigen::Vector3d::UnitY())) << "turned by 90 degrees";
}

TEST(CellShapes, thatAreMeshesAreRefusedWithWhatToDoInstead) {
  const std::string faults = faultsWith("sphere: {radius: 30}", "mesh: gripper.stl");
  EXPECT_THAT(faults, HasSubstr("cell.yaml:30:9: robots.RA.tool[1].mesh is a mesh"));
  EXPECT_THAT(faults, HasSubstr("cover the mesh by boxes"));
}

TEST(CellShapes, areRefusedWithTheirPlace) {
  EXPECT_THAT(faultsWith("radius: 30}", "radius: 0}"), HasSubstr("robots.RA.tool[1].sphere.radius is \"0\""));
  EXPECT_THAT(faultsWith("radius: 30}", "radius: nan}"), HasSubstr("allowed: a number"));
  EXPECT_THAT(faultsWith("sphere: {radius: 30}", "sphere: {}"), HasSubstr("sphere.radius is missing"));
  EXPECT_THAT(faultsWith("- sphere: {radius: 30}\n        at", "- at"), HasSubstr("tool[1] has no kind"));
  EXPECT_THAT(faultsWith("sphere: {radius: 30}", "sphere: {radius: 30}\n        box: {size: [1, 1, 1]}"),
              HasSubstr("is a sphere and a box"));
  EXPECT_THAT(faultsWith("size: [400, 300, 5]", "size: [400, 300, 0]"), HasSubstr("size is not above 0"));
  EXPECT_THAT(faultsWith("size: [400, 300, 5]", "size: [400, 300]"), HasSubstr("is a list of 2"));
  EXPECT_THAT(faultsWith("from: [0, 0, 0]", "from: [0, 0, 1e6]"), HasSubstr("capsule.from[2]"));
}

TEST(CellPoses, thatAreNoRotationAreRefused) {
  EXPECT_THAT(faultsWith("quaternion: [0, 0, 1, 0]", "quaternion: [0, 0, 1, 1]"),
              HasSubstr("robots.RA.base.quaternion is not a rotation: its length is 1.4"));
  EXPECT_THAT(faultsWith("quaternion: [0, 0, 1, 0]", "quaternion: [0, 0, 0, 0]"),
              HasSubstr("not a rotation"));
  const char* const turned = "rotation: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]";
  EXPECT_THAT(faultsWith(turned, "rotation: [[0, 1, 0], [1, 0, 0], [0, 0, 1]]"), HasSubstr("it mirrors"));
  EXPECT_THAT(faultsWith(turned, "rotation: [[0, -1, 0], [1, 0.1, 0], [0, 0, 1]]"),
              HasSubstr("from orthonormal"));
  EXPECT_THAT(faultsWith(turned, "rotation: [[0, -1, 0], [1, 0, 0]]"), HasSubstr("a list of 3"));
  EXPECT_THAT(faultsWith(", quaternion: [0, 0, 1, 0]", ""), HasSubstr("robots.RA.base has no rotation"));
  EXPECT_THAT(faultsWith("base: {position", "base: {rotation: [[1,0,0],[0,1,0],[0,0,1]], position"),
              HasSubstr("has quaternion and rotation"));
}

TEST(CellParts, areCarriedByAFlangeOrByOtherParts) {
  const Cell cell = cellOf(kFull);
  EXPECT_EQ(cell.parts.at(0).name, "clip");
  EXPECT_EQ(cell.parts.at(0).on, "sheet");
  EXPECT_EQ(cell.parts.at(1).on, "") << "the flange";
  EXPECT_THAT(faultsWith("on: sheet", "on: shet"),
              HasSubstr("parts.clip.on is \"shet\", which is not a part or the flange; allowed: clip, sheet, "
                        "flange; write sheet"));
  EXPECT_THAT(faultsWith("on: flange", "on: clip"), HasSubstr("parts.clip.on is mounted on itself, through"));
  EXPECT_THAT(faultsWith("on: sheet", "on: clip"), HasSubstr("is mounted on itself, through clip"));
}

TEST(CellParts, areAttachedAndDetachedInAnOrderThatCanBe) {
  EXPECT_THAT(faultsWith("attach: sheet", "attach: shet"),
              HasSubstr("steps[4].attach is \"shet\", which is not a part"));
  EXPECT_THAT(faultsWith("attach: clip", "attach: sheet"), HasSubstr("is sheet, which is attached already"));
  EXPECT_THAT(faultsWith("attach: sheet", "attach: clip"),
              HasSubstr("is clip, on sheet, which is not attached"));
  EXPECT_THAT(faultsWith("detach: clip", "detach: sheet"), HasSubstr("is sheet, which carries clip"));
  EXPECT_THAT(faultsWith("detach: sheet", "detach: clip"), HasSubstr("is clip, which is not attached"));
  EXPECT_THAT(faultsWith("detach: clip", "detach: clip, attach: clip"),
              HasSubstr("is the part that the step attaches"));
}

TEST(CellParts, areTheSameAtAStationWhicheverWayTheRobotCame) {
  EXPECT_THAT(faultsWith(", detach: sheet", ""),
              HasSubstr("programs.RA[2].to is HOME, where the robot then carries sheet, "));
  EXPECT_THAT(faultsWith("ChangeTCP(0,0,120,0,0,0)", "ChangeTCP(0,0,121,0,0,0)"),
              HasSubstr("the TCP [0, 0, 121, 0, 0, 0]; at the start it carries nothing"));
}

TEST(CellMechanisms, haveOneAxisWithPositions) {
  const Cell cell = cellOf(kFull);
  const Mechanism& pallet = cell.mechanisms.at(0);
  EXPECT_EQ(pallet.axis, Mechanism::Axis::Prismatic);
  EXPECT_TRUE(pallet.direction.isApprox(Eigen::Vector3d::UnitY())) << "of unit length";
  EXPECT_EQ(find(pallet.positions, "IN")->value, 0.9) << "[m]";
  EXPECT_EQ(pallet.home, "OUT");
  const Cell table = cellOf(with(kFull, "kind: prismatic", "kind: revolute"));
  EXPECT_NEAR(find(table.mechanisms.at(0).positions, "IN")->value, degToRad(900), 1e-12) << "[rad]";
}

TEST(CellMechanisms, haveTheSameAxisHoweverLongItIsWritten) {
  const std::string hash = hashOf(cellOf(with(kFull, "along: [0, 2, 0]", "along: [1, 2, 0.7]")));
  EXPECT_EQ(hashOf(cellOf(with(kFull, "along: [0, 2, 0]", "along: [3, 6, 2.1]"))), hash);
}

TEST(CellMechanisms, areRefusedWithTheirField) {
  const std::string field = "mechanisms.PALLET";
  EXPECT_THAT(faultsWith("kind: prismatic", "kind: linear"),
              HasSubstr(field + ".axis.kind is \"linear\"; allowed: prismatic, revolute"));
  EXPECT_THAT(faultsWith("along: [0, 2, 0]", "along: [0, 0, 0]"),
              HasSubstr(field + ".axis.along has the length 0"));
  EXPECT_THAT(faultsWith("IN: 900", "IN: far"), HasSubstr(field + ".positions.IN is \"far\""));
  EXPECT_THAT(faultsWith("home: OUT", "home: OUTT"), HasSubstr(field + ".home is \"OUTT\""));
  EXPECT_THAT(faultsWith("to: IN\n", "to: INN\n"), HasSubstr(field + ".program[0].to is \"INN\""));
  EXPECT_THAT(faultsWith("duration: 4", "duration: -1"), HasSubstr(field + ".program[0].duration is \"-1\""));
  EXPECT_THAT(faultsWith("[book]", "[release]"),
              HasSubstr(field + ".program[0].uncontrollable[0] is \"release\"; allowed: go, book"));
  EXPECT_THAT(faultsWith("[book]", "[go, go]"), HasSubstr("appears twice"));
  EXPECT_THAT(faultsWith("      - {path: CLEAR, from: IN, to: OUT}\n", ""),
              HasSubstr(field + ".program[0] has IN, from where no paths lead home, to OUT"));
  EXPECT_THAT(faultsWith("path: CLEAR", "path: FEED"), HasSubstr("is FEED, the same as the path of line 60"));
  EXPECT_THAT(faultsWith("PALLET:", "RA:"),
              HasSubstr("mechanisms.RA has the same name as the robot of line 22"));
}

}  // namespace
}  // namespace cobot_command::cell
