#include "cobot_command/cell/model/cell_model.h"

#include "cell_programs.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::cell {
namespace {

using test_support::book;
using test_support::handover;
using test_support::headOn;
using test_support::iris;
using test_support::release;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kMaxStates = 100000;

std::string fingerprintOf(const CellProgram& program) {
  const auto parts = synthesizeParts(*modelOf(program), Policy::Supervisor, kMaxStates);
  return parts && parts->size() == 1 ? parts->front().fingerprint : "";
}

TEST(TheModelOfACell, isThatOfTheContract) {
  EXPECT_EQ(fingerprintOf(handover()), "e9bcf5c38a9e8688c3cee297d168a7e65669df69749552603be3749f73f0f863");
  EXPECT_EQ(fingerprintOf(headOn()), "dc8346327cb68e395064ca545e9a9f36cda7f1b20013c649a169ff6354da4254");
  EXPECT_EQ(fingerprintOf(iris()), "57302cf5c9f68dc89de780d6062d67c0119291d5742a61401c97090b3bf6248f");
}

TEST(TheModelOfACell, saysWhatEachEventMeans) {
  const auto model = modelOf(headOn());
  ASSERT_TRUE(model);
  ASSERT_EQ(model->events.size(), model->problem.events.size());
  EXPECT_EQ(model->problem.events[1].name, "RA_b_Z1");
  EXPECT_EQ(model->events[1].kind, CellEvent::Kind::Book);
  EXPECT_EQ(model->events[1].robot, 0U);
  EXPECT_THAT(model->events[1].zones, ElementsAre(0));
  EXPECT_TRUE(model->problem.events[1].controllable);
  EXPECT_EQ(model->problem.events[3].name, "RA_r_W");
  EXPECT_FALSE(model->problem.events[3].controllable);
}

TEST(TheModelOfACell, knowsWhatIsHeldAtEachPlace) {
  const auto model = modelOf(headOn());
  ASSERT_TRUE(model);
  const auto& places = model->places[0];
  EXPECT_EQ(places[0].name, "HOME");
  EXPECT_THAT(places[0].holds, IsEmpty());
  EXPECT_EQ(places[1].name, "W");
  EXPECT_THAT(places[1].holds, ElementsAre(0, 1));
  EXPECT_EQ(places[3].name, "W>1");
  EXPECT_THAT(places[3].holds, ElementsAre(0));
  EXPECT_EQ(model->holder(0, 0), std::nullopt);
  EXPECT_EQ(model->holder(0, 1), RobotIndex{0});
}

TEST(TheModelOfACell, isVerifiedWithWhoHoldsWhat) {
  for (const CellProgram& program : {handover(), headOn(), iris(), iris(4)}) {
    const auto model = modelOf(program);
    const auto parts = synthesizeParts(*model, Policy::Supervisor, kMaxStates);
    ASSERT_TRUE(parts) << parts.error();
    for (const auto& found : verifyParts(*model, *parts, kMaxStates)) EXPECT_THAT(found.faults, IsEmpty());
  }
}

TEST(TheModelOfACell, booksSeveralZonesByOneEvent) {
  CellProgram program = headOn();
  for (RobotProgram& robot : program.robots) robot.paths[0].steps = {book({0, 1})};
  const auto model = modelOf(program);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->problem.events[1].name, "RA_b_Z1+Z2");
  const auto parts = synthesizeParts(*model, Policy::Supervisor, kMaxStates);
  ASSERT_TRUE(parts);
  EXPECT_THAT(parts->front().frontier, IsEmpty()) << "all or nothing: no circle";
}

TEST(TheModelOfACell, holdsAtHomeWhatItIsSaidTo) {
  CellProgram program = handover();
  program.robots[0].held_at_home = {0};
  program.robots[0].paths[0].steps = {release(0)};
  program.robots[0].paths[1].steps = {book({0})};
  const auto model = modelOf(program);
  ASSERT_TRUE(model);
  const auto& zone = model->problem.automata[2];
  EXPECT_EQ(model->holder(0, zone.initial), RobotIndex{0});
  EXPECT_THAT(zone.marked, ElementsAre(zone.initial));
}

TEST(TheModelOfACell, branchesWhereAStationHasSeveralPaths) {
  CellProgram program = handover();
  program.robots[0].stations.push_back("T2");
  program.robots[0].paths.push_back({"T2", 0, 2, {}});
  program.robots[0].paths.push_back({"BACK", 2, 0, {}});
  const auto model = modelOf(program);
  ASSERT_TRUE(model);
  int from_home = 0;
  for (const auto& transition : model->problem.automata[0].transitions) {
    if (transition.from == model->problem.automata[0].initial) ++from_home;
  }
  EXPECT_EQ(from_home, 2);
}

std::vector<std::string> faultsOf(const CellProgram& program) {
  const auto model = modelOf(program);
  return model ? std::vector<std::string>() : model.error();
}

TEST(TheModelOfACell, refusesProgramsThatCannotBeMeant) {
  CellProgram twice = handover();
  twice.robots[0].paths[0].steps = {book({0}), book({0})};
  EXPECT_THAT(faultsOf(twice), ElementsAre("RA: on T1 it books Z, which it already holds"));
  CellProgram never = handover();
  never.robots[0].paths[1].steps = {release(0), release(0)};
  EXPECT_THAT(faultsOf(never), ElementsAre("RA: on HOME it releases Z, which it does not hold"));
  CellProgram kept = handover();
  kept.robots[0].paths[1].steps.clear();
  EXPECT_THAT(faultsOf(kept),
              ElementsAre("RA: at HOME it holds Z if it arrives by HOME, but nothing otherwise"));
  CellProgram away = handover();
  away.robots[1].paths.pop_back();
  EXPECT_THAT(faultsOf(away), ElementsAre(HasSubstr("RB: no paths lead home from T1")));
  CellProgram both = handover();
  for (RobotProgram& robot : both.robots) {
    robot.held_at_home = {0};
    robot.paths[0].steps = {release(0)};
    robot.paths[1].steps = {book({0})};
  }
  EXPECT_THAT(faultsOf(both), ElementsAre(HasSubstr("RA and RB both hold Z at home")));
  CellProgram nowhere = handover();
  nowhere.robots[0].paths[0].to = 7;
  EXPECT_THAT(faultsOf(nowhere), ElementsAre(HasSubstr("names a station or zone that does not exist")));
}

}  // namespace
}  // namespace cobot_command::cell
