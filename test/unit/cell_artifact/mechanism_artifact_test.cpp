// The artifact of the pallet: what is proved of a mechanism, and what is kept of it.
#include "../cell_zones/zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/artifact/cycle_times.h"
#include "cobot_command/cell/model/rules.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> faultsOfBuild(CellBuild& build) {
  for (const BuildStage stage : kBuildStages) {
    auto faults = build.run(stage);
    if (!faults.empty()) return faults;
    EXPECT_FALSE(build.report(stage).empty()) << toString(stage);
  }
  return {};
}

std::string bytesOf(const Cell& cell) {
  CellBuild build(cell, Policy::Supervisor, 1);
  EXPECT_THAT(faultsOfBuild(build), IsEmpty());
  return build.bytes();
}

const std::string& palletBytes() {
  static const std::string bytes = bytesOf(cellOf("pallet"));
  return bytes;
}

TEST(TheArtifactOfThePallet, isVerifiedAndTheSameWhenItIsReadAndWritten) {
  const auto artifact = fromBytes(palletBytes());
  ASSERT_TRUE(artifact) << artifact.error();
  EXPECT_EQ(toBytes(*artifact), palletBytes());
  EXPECT_EQ(artifact->hash, hashOf(cellOf("pallet")));
  EXPECT_EQ(artifact->supervisors.front().counts.states, 24U);
  EXPECT_EQ(artifact->supervisors.front().counts.refused_beyond_spec, 4U);
}

TEST(TheArtifactOfThePallet, hasThePiecesOfItsAxisWithTheirZones) {
  const Artifact artifact = *fromBytes(palletBytes());
  EXPECT_EQ(artifact.robots.size(), 1U);
  ASSERT_EQ(artifact.mechanisms.size(), 1U);
  const ArtifactMechanism& pallet = artifact.mechanisms.front();
  EXPECT_FALSE(pallet.bodies.axis().turns);
  ASSERT_FALSE(pallet.bodies.capsules().empty());
  const Eigen::Vector3d moved = pallet.bodies.at(0.9).front().from - pallet.bodies.at(0.0).front().from;
  EXPECT_TRUE(moved.isApprox(Eigen::Vector3d(0.0, 0.9, 0.0)));
  EXPECT_EQ(artifact.program.robots[1].stations, (std::vector<std::string>{"IN", "OUT"}));
  EXPECT_EQ(pallet.stations[0].value, 0.9);
  EXPECT_THAT(pallet.stations[0].zones, ElementsAre(0));
  EXPECT_THAT(pallet.stations[1].zones, IsEmpty());
  const ArtifactMechanismPath& clear = pallet.paths[1];
  EXPECT_EQ(clear.pieces.front().from, 0.9);
  EXPECT_EQ(clear.pieces.back().to, 0.0);
  EXPECT_EQ(clear.duration, Duration(std::chrono::seconds(4)));
  // It is released behind the last piece that touches it.
  const std::size_t released_behind = clear.places.front().piece;
  EXPECT_THAT(clear.pieces[released_behind].zones, ElementsAre(0));
  for (std::size_t piece = released_behind + 1; piece < clear.pieces.size(); ++piece) {
    EXPECT_THAT(clear.pieces[piece].zones, IsEmpty()) << piece;
  }
}

TEST(TheArtifactOfThePallet, isOfThatPalletAlone) {
  Cell other = cellOf("pallet");
  other.mechanisms.front().positions.front().value += 0.001;
  EXPECT_NE(hashOf(other), fromBytes(palletBytes())->hash);
  other = cellOf("pallet");
  other.mechanisms.front().program.front().controllable_book = true;
  EXPECT_NE(hashOf(other), fromBytes(palletBytes())->hash);
}

std::string faultWith(const std::function<void(Artifact&)>& change) {
  Artifact artifact = *fromBytes(palletBytes());
  change(artifact);
  const auto read = fromBytes(toBytes(artifact));
  return read ? "none" : read.error();
}

TEST(TheArtifactOfThePallet, isRefusedWhereAnIndexLeadsNowhere) {
  EXPECT_EQ(faultWith([](Artifact&) {}), "none");
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.mechanisms.clear(); }),
              HasSubstr("zones or robots"));
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.mechanisms[0].paths.pop_back(); }),
              HasSubstr("paths or stations"));
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.mechanisms[0].paths[0].pieces[2].zones = {7}; }),
              HasSubstr("a zone is named"));
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.mechanisms[0].paths[0].places[0].frame = 1; }),
              HasSubstr("no frame or piece"));
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.mechanisms[0].paths[0].places[0].piece = 999; }),
              HasSubstr("no frame or piece"));
  EXPECT_THAT(faultWith([](Artifact& artifact) { artifact.zones[0].users = {0, 2}; }), HasSubstr("a user"));
}

std::vector<std::string> faultsOfVerification(const std::function<void(Artifact&)>& change) {
  Artifact artifact = *fromBytes(palletBytes());
  change(artifact);
  std::vector<std::string> faults;
  for (const auto& part : verifyParts(*modelOf(artifact.program), artifact.supervisors, 100000)) {
    faults.insert(faults.end(), part.faults.begin(), part.faults.end());
  }
  return faults;
}

TEST(TheVerificationOfThePallet, hasTeeth) {
  EXPECT_THAT(faultsOfVerification([](Artifact&) {}), IsEmpty());
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) { artifact.supervisors[0].frontier.clear(); }),
              Contains(HasSubstr("not controllable")));
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) {
                artifact.program.robots[1].paths[0].steps[0].uncontrollable = false;
              }),
              Contains(HasSubstr("not maximally permissive")));
}

TEST(ThePallet, cannotBeBuiltWithSafeOrders) {
  CellBuild build(cellOf("pallet"), Policy::SafeOrder, 1);
  EXPECT_THAT(faultsOfBuild(build), Contains(HasSubstr("\"PALLET_b_Z1\" takes Z1 and is uncontrollable")));
}

TEST(TheCycleOfAMechanism, takesTheDurationsOfItsPaths) {
  const Artifact artifact = *fromBytes(palletBytes());
  const CellModel model = *modelOf(artifact.program);
  const auto cycle = cycleOf(artifact, model, 1);
  ASSERT_TRUE(cycle) << cycle.error();
  std::vector<double> after;
  for (const TimedEvent& event : cycle->events) after.push_back(toSeconds(event.after));
  // Go, book, reached; go, release, reached: when it is out of its zone nobody knows before it has arrived.
  EXPECT_THAT(after, ElementsAre(0.0, 0.0, 4.0, 0.0, 4.0, 0.0));
}

TEST(TheCycleOfAMechanism, isRefusedWhereADurationIsNotKnown) {
  Cell cell = cellOf("pallet");
  cell.mechanisms.front().program.back().duration = 0.0;
  const Artifact artifact = *fromBytes(bytesOf(cell));
  const auto cycle = cycleOf(artifact, *modelOf(artifact.program), 1);
  ASSERT_FALSE(cycle);
  EXPECT_EQ(cycle.error(), "PALLET: the duration of CLEAR is unknown: set it in the cell file");
}

TEST(TheScheduleOfThePallet, letsTheRobotIntoTheZoneBeforeOrBehindIt) {
  const Artifact artifact = *fromBytes(palletBytes());
  const CellModel model = *modelOf(artifact.program);
  const std::vector<RobotCycle> cycles = {*cycleOf(artifact, model, 0), *cycleOf(artifact, model, 1)};
  const auto found =
      findSchedule(automata::Supervisor({model.problem, artifact.supervisors[0].frontier}), cycles);
  ASSERT_TRUE(found) << found.error();
  ASSERT_TRUE(found->isOptimal());
  EXPECT_GT(toSeconds(found->best->makespan), 8.0) << "the pallet alone";
  EXPECT_LE(found->best->makespan, found->one_after_the_other);
}

}  // namespace
}  // namespace cobot_command::cell
