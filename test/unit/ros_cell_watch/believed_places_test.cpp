// When the monitor takes a robot for carrying less than all that it may carry, and for being kept from others
// by what it holds, and when no longer (doc/cell.md).
#include "cell_watch/believed_places.h"

#include <algorithm>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/common/units.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::ros_adapter {
namespace {

using cobot_command::CellRobot;
using cobot_command::CellState;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kSupervisor = "/cell/cell_supervisor";

Instant at(double seconds) {
  return Instant(fromSeconds(seconds));
}

using Artifact = std::shared_ptr<const cell::Artifact>;

Artifact artifactOf(const cell::Cell& cell) {
  cell::CellBuild build(cell, cell::Policy::Supervisor, 1);
  for (const cell::BuildStage stage : cell::kBuildStages) EXPECT_THAT(build.run(stage), IsEmpty());
  return std::make_shared<const cell::Artifact>(*cell::fromBytes(build.bytes()));
}

cell::Cell palletCell() {
  return *runtime::readCellFile(test_support::inSourceTree("config/cells/pallet.yaml"));
}

const Artifact& pallet() {
  static const Artifact artifact = artifactOf(palletCell());
  return artifact;
}

/// Its robot leaves the sheet two degrees from where it took it, in the same zone, and goes home without it.
Artifact palletWithTheSheetLeftThere() {
  cell::Cell cell = palletCell();
  std::vector<cell::Step>& back = cell.robots.front().program[1].steps;
  back.insert(back.begin(), back.front());
  std::get<blocks::MoveAbsoluteGoal>(back.front().goal).target = {0, 43, 60, -15, 90, 0};
  back.back().detach.clear();
  return artifactOf(cell);
}

const cell::RobotProgram& program() {
  return pallet()->program.robots.front();
}

arm::JointVector joints(const std::string& station) {
  const auto& names = program().stations;
  const auto found = std::find(names.begin(), names.end(), station);
  return pallet()->robots.front().stations[static_cast<std::size_t>(found - names.begin())].joints;
}

const arm::JointVector kHome = joints("HOME");

/// In the middle of that piece of the path back.
arm::JointVector onTheWayBack(std::size_t piece, const Artifact& artifact = pallet()) {
  return artifact->robots.front().paths[1].pieces[piece].range.centre();
}

/// The place of the path back behind its last release, and the piece at the end of which that comes.
struct LastRelease {
  cell::CellPlace place;
  std::size_t piece = 0;
};
LastRelease lastRelease(const Artifact& artifact = pallet()) {
  const cell::CellModel model = *cell::modelOf(artifact->program);
  LastRelease found;
  for (const cell::CellPlace& place : model.places[0]) {
    if (!place.station && place.path == 1 && place.behind >= found.place.behind) found.place = place;
  }
  found.piece = artifact->robots.front().paths[1].places.back().piece;
  return found;
}

class PartsOfThePallet : public ::testing::Test {
 protected:
  CellState state(const std::string& place) {
    CellState state;
    state.hash = pallet()->digest;
    state.instance = 7;
    state.epoch = 1;
    state.number = ++number;
    state.mode = CellState::RUNNING;
    state.robots.resize(1);
    state.robots[0].name = "RA";
    state.robots[0].state = CellRobot::MOVING;
    state.robots[0].place = place;
    return state;
  }
  void hear(const CellState& state, Instant now) { parts.hear(state, kSupervisor, now); }
  /// It is at home by both.
  void beAtHome(Instant now) {
    hear(state("HOME"), now);
    parts.measured("RA", kHome, now);
  }
  [[nodiscard]] bool isKnown(Instant now) const { return parts.beliefOf("RA", now).has_value(); }

  BelievedPlaces parts = *BelievedPlaces::of(pallet());
  std::uint64_t number = 0;
};

TEST_F(PartsOfThePallet, areThoseOfThePlaceThatTheStateTells) {
  beAtHome(at(1));
  ASSERT_TRUE(isKnown(at(1)));
  EXPECT_THAT(parts.beliefOf("RA", at(1))->parts, IsEmpty());
  hear(state("T1"), at(2));
  parts.measured("RA", joints("T1"), at(2));
  ASSERT_TRUE(isKnown(at(2)));
  EXPECT_THAT(parts.beliefOf("RA", at(2))->parts, ElementsAre("sheet"));
  EXPECT_TRUE(parts.mayCarry("RA"));
  EXPECT_FALSE(parts.mayCarry("PALLET"));
}

TEST_F(PartsOfThePallet, areNotKnownBeforeStateAndJointsWereHeard) {
  EXPECT_FALSE(isKnown(at(1)));
  parts.measured("RA", kHome, at(1));
  EXPECT_FALSE(isKnown(at(1)));
  parts = *BelievedPlaces::of(pallet());
  hear(state("HOME"), at(1));
  EXPECT_FALSE(isKnown(at(1)));
  EXPECT_FALSE(parts.beliefOf("RB", at(1)));
}

TEST_F(PartsOfThePallet, areNotKnownOfARobotThatIsNotMeasuredWhereTheStateHasIt) {
  beAtHome(at(1));
  parts.measured("RA", kHome + 0.02 * arm::JointVector::Unit(0), at(1.1));
  EXPECT_FALSE(isKnown(at(1.1))) << "it has set out, and may take what it likes";
  parts.measured("RA", kHome, at(1.2));
  EXPECT_TRUE(isKnown(at(1.2)));
  hear(state("T1"), at(1.3));
  EXPECT_FALSE(isKnown(at(1.3)));
}

TEST_F(PartsOfThePallet, areNotKnownOnceTheStateOrTheJointsAreOld) {
  beAtHome(at(1));
  const Instant until = parts.beliefOf("RA", at(1))->until;
  EXPECT_EQ(until, at(1.5)) << "the lease, and as long as joints count";
  EXPECT_TRUE(isKnown(until));
  EXPECT_FALSE(isKnown(until + Duration(1)));
  parts.measured("RA", kHome, at(1.4));
  EXPECT_FALSE(isKnown(at(1.6))) << "the supervisor is silent";
  hear(state("HOME"), at(1.8));
  EXPECT_TRUE(isKnown(at(1.9)));
  hear(state("HOME"), at(1.95));
  EXPECT_FALSE(isKnown(at(2.0))) << "the robot is silent";
}

TEST_F(PartsOfThePallet, areKnownOnlyWhileTheSupervisorIsSureOfAllPlaces) {
  parts.measured("RA", kHome, at(1));
  for (const std::uint8_t mode : {CellState::STARTING, CellState::READY, CellState::RUNNING,
                                  CellState::HOLDING, CellState::RECOVERY, CellState::FAULT}) {
    CellState told = state("HOME");
    told.mode = mode;
    hear(told, at(1));
    const bool is_sure = mode == CellState::READY || mode == CellState::RUNNING || mode == CellState::HOLDING;
    EXPECT_EQ(isKnown(at(1)), is_sure) << int{mode};
  }
}

TEST_F(PartsOfThePallet, areKnownOnlyOfARobotThatRunsItsProgram) {
  parts.measured("RA", kHome, at(1));
  for (std::uint8_t one = CellRobot::ABSENT; one <= CellRobot::OUT; ++one) {
    CellState told = state("HOME");
    told.robots[0].state = one;
    hear(told, at(1));
    EXPECT_EQ(isKnown(at(1)),
              one == CellRobot::READY || one == CellRobot::MOVING || one == CellRobot::WAITING)
        << int{one};
  }
}

TEST_F(PartsOfThePallet, areNotKnownWhereTheStateHasNoSuchPlaceOrRobot) {
  beAtHome(at(1));
  hear(state("NOWHERE"), at(1.1));
  EXPECT_FALSE(isKnown(at(1.1)));
  CellState nobody = state("HOME");
  nobody.robots.clear();
  hear(nobody, at(1.2));
  EXPECT_FALSE(isKnown(at(1.2)));
}

TEST_F(PartsOfThePallet, doNotChangeByStatesThatAreLateOrDoubled) {
  beAtHome(at(1));
  const CellState late = state("T1");
  hear(state("HOME"), at(1.2));
  hear(late, at(1.3));
  EXPECT_TRUE(isKnown(at(1.3)));
  const CellState doubled = state("HOME");
  hear(doubled, at(1.4));
  hear(doubled, at(1.8));
  parts.measured("RA", kHome, at(1.8));
  EXPECT_EQ(parts.beliefOf("RA", at(1.8))->until, at(1.9)) << "that it came again makes it no younger";
}

TEST_F(PartsOfThePallet, areNotKnownWhileAnotherOneTellsStatesToo) {
  CellState of_another = state("HOME");
  of_another.instance = 8;
  CellState of_other_cell = state("HOME");
  of_other_cell.hash = "other";
  for (const auto& [other, publisher] :
       {std::pair(of_another, kSupervisor), std::pair(of_other_cell, kSupervisor),
        std::pair(state("HOME"), "/forger")}) {
    parts = *BelievedPlaces::of(pallet());
    beAtHome(at(1));
    parts.hear(other, publisher, at(1.1));
    EXPECT_FALSE(isKnown(at(1.1)));
    beAtHome(at(1.6));
    EXPECT_FALSE(isKnown(at(1.6)));
    beAtHome(at(1.7));
    EXPECT_TRUE(isKnown(at(1.7))) << "the other one is silent for longer than the lease";
  }
}

TEST_F(PartsOfThePallet, areThoseOfANewSupervisorOnceTheFirstIsSilent) {
  beAtHome(at(1));
  parts.measured("RA", kHome, at(2.1));
  for (const double now : {1.4, 1.6, 2.2}) {
    CellState anew = state("HOME");
    anew.instance = 8;
    anew.epoch = 1;
    parts.hear(anew, "/cell/second", at(now));
    EXPECT_EQ(isKnown(at(now)), now == 2.2) << now;
  }
}

TEST_F(PartsOfThePallet, areKnownWhereTheStateIsAheadOfTheJointsByOneEvent) {
  const LastRelease last = lastRelease();
  ASSERT_GE(last.piece, 3U);
  hear(state(last.place.name), at(1));
  parts.measured("RA", onTheWayBack(last.piece - 3), at(1));
  ASSERT_TRUE(isKnown(at(1))) << last.place.name;
  EXPECT_THAT(parts.beliefOf("RA", at(1))->parts, ElementsAre("sheet"));
}

TEST_F(PartsOfThePallet, areThoseOfBothPlacesWhereTheStateIsAheadOfTheJoints) {
  const Artifact artifact = palletWithTheSheetLeftThere();
  const LastRelease last = lastRelease(artifact);
  parts = *BelievedPlaces::of(artifact);
  CellState ahead = state(last.place.name);
  ahead.hash = artifact->digest;
  hear(ahead, at(1));
  parts.measured("RA", onTheWayBack(last.piece + 1, artifact), at(1));
  ASSERT_TRUE(isKnown(at(1))) << last.place.name;
  EXPECT_THAT(parts.beliefOf("RA", at(1))->parts, IsEmpty()) << "it is where the state has it";
  parts.measured("RA", onTheWayBack(last.piece - 3, artifact), at(1));
  ASSERT_TRUE(isKnown(at(1))) << last.place.name;
  EXPECT_THAT(parts.beliefOf("RA", at(1))->parts, ElementsAre("sheet"));
}

class PermitsOfThePallet : public PartsOfThePallet {
 protected:
  void hearBoth(const std::string& robot, const std::string& mechanism) {
    CellState both = state(robot);
    both.robots.push_back(both.robots[0]);
    both.robots[1].name = "PALLET";
    both.robots[1].place = mechanism;
    hear(both, at(1));
  }
  [[nodiscard]] std::optional<cell::Permit> permitOf(const std::string& mover) const {
    const auto belief = parts.beliefOf(mover, at(1));
    return belief ? std::optional(belief->permit) : std::nullopt;
  }
};

TEST_F(PermitsOfThePallet, haveWhatIsHeldThere) {
  hearBoth("T1", "OUT");
  parts.measured("RA", joints("T1"), at(1));
  parts.measured("PALLET", arm::JointVector::Zero(), at(1));
  ASSERT_TRUE(permitOf("RA"));
  EXPECT_THAT(permitOf("RA")->holds, ElementsAre(0));
  ASSERT_TRUE(permitOf("PALLET"));
  EXPECT_THAT(permitOf("PALLET")->holds, IsEmpty());
}

TEST_F(PermitsOfThePallet, haveSpeedsThatNoMotionOfTheProgramPasses) {
  hearBoth("HOME", "OUT");
  parts.measured("RA", kHome, at(1));
  parts.measured("PALLET", arm::JointVector::Zero(), at(1));
  const std::vector<double> most = permitOf("RA")->most_speeds;
  ASSERT_EQ(most.size(), 6U);
  // J2 turns by 75 degrees, the farthest of all; J1 not at all.
  const Duration duration = pallet()->robots[0].paths[0].duration;
  EXPECT_GT(most[1], degToRad(75.0) / toSeconds(duration));
  EXPECT_LT(most[1], degToRad(120.0));
  EXPECT_LT(most[0], 1e-6) << "rounding";
  EXPECT_THAT(permitOf("PALLET")->most_speeds, IsEmpty()) << "nobody knows";
}

TEST_F(PermitsOfThePallet, areNotKnownOfAMechanismThatIsElsewhere) {
  hearBoth("HOME", "OUT");
  parts.measured("PALLET", 0.02 * arm::JointVector::Unit(0), at(1));
  EXPECT_FALSE(permitOf("PALLET"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
