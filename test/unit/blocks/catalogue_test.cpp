// The error catalogue: as in the thesis, and every row either happens here or says why it cannot.

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using protocol::CommunicationErrorCode;
using protocol::TagState;
using ::testing::HasSubstr;
using Row = std::pair<Block, int>;
using Scenario = std::function<Outcome()>;

Outcome connectWith(const std::function<void(ConnectGoal&)>& change) {
  CoreRig rig;
  ConnectGoal goal = CoreRig::robot();
  change(goal);
  return *rig.outcome(rig.submit(goal));
}

Outcome connectUntilTimeout(const std::function<void(CoreRig&)>& trouble) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const GoalId goal = rig.submit(CoreRig::robot());
  for (int i = 0; i < 100 && rig.outcome(goal) == nullptr; ++i) {
    if (rig.pendingOpen(link::Channel::Script)) trouble(rig);
    rig.pass(100ms);
  }
  rig.discardSent();
  return *rig.outcome(goal);
}

Outcome moveWith(const std::function<void(MoveAbsoluteGoal&)>& change) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = CoreRig::move();
  change(goal);
  return *rig.outcome(rig.submit(goal));
}

/// A command that was sent; `fault` gets the rig and the script id.
Outcome moveUntil(const std::function<void(CoreRig&, const std::string&)>& fault) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(CoreRig::move());
  fault(rig, rig.takeScript().id);
  rig.discardSent();
  EXPECT_NE(rig.outcome(goal), nullptr);
  return rig.outcome(goal) == nullptr ? Outcome{} : *rig.outcome(goal);
}

/// Planned on a TM arm from `joints_deg`.
Outcome plannedOn(const char* model, const std::vector<float>& joints_deg,
                  const std::function<void(MoveAbsoluteGoal&)>& change) {
  CoreRig rig(*arm::ArmModel::named(model), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames().with(protocol::item::ofFloats("Joint_Angle", joints_deg)));
  MoveAbsoluteGoal goal = CoreRig::move();
  change(goal);
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.scripts_sent, 0);
  EXPECT_NE(rig.outcome(id), nullptr);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

void line(MoveAbsoluteGoal& goal, AbsoluteFormat format, double speed) {
  goal.movement_command = static_cast<int>(Movement::Line);
  goal.data_format = static_cast<int>(format);
  goal.speed = speed;
}

std::map<Row, Scenario> connectScenarios() {
  using Kind = link::OpenFailure::Kind;
  const auto row = [](int id) { return Row{Block::Connect, id}; };
  return {
      {row(connect_error::kTimeoutRange), [] { return connectWith([](auto& g) { g.timeout = 1; }); }},
      {row(connect_error::kConnection),
       [] { return connectUntilTimeout([](auto& rig) { rig.failOpen(Kind::UnknownHost); }); }},
      {row(connect_error::kTimeOut),
       [] {
         return connectUntilTimeout([](auto& rig) {
           rig.answers_lifesigns = true;
           rig.listening = false;
           rig.open();
         });
       }},
      {row(connect_error::kNotACobot),
       [] {
         return connectUntilTimeout([](auto& rig) {
           rig.open();
           rig.receive("HTTP/1.1 400 Bad Request\r\n");
         });
       }},
      {row(connect_error::kDisconnected),
       [] {
         CoreRig rig;
         const GoalId goal = rig.connect();
         rig.close("gone");
         return *rig.outcome(goal);
       }},
      {row(own_error::kShutDown),
       [] {
         CoreRig rig;
         rig.shutDown();
         return *rig.outcome(rig.submit(CoreRig::robot()));
       }},
      {row(own_error::kHostInvalid), [] { return connectWith([](auto& g) { g.host = ""; }); }},
      {row(own_error::kPortRange), [] { return connectWith([](auto& g) { g.port = 0; }); }},
      {row(own_error::kConnectBusy),
       [] {
         CoreRig rig;
         rig.connect();
         return *rig.outcome(rig.submit(CoreRig::robot()));
       }},
  };
}

std::map<Row, Scenario> parameterScenarios() {
  const auto row = [](int id) { return Row{Block::MoveAbsolute, id}; };
  const auto posed = [](std::array<int, 3> pose) {
    return moveWith([&](auto& g) {
      g.robot_pose_enable = true;
      g.robot_pose = pose;
    });
  };
  return {
      {row(motion_error::kSpeedRangeAbsolute),
       [] { return moveWith([](auto& g) { line(g, AbsoluteFormat::Cap, 5000); }); }},
      {row(motion_error::kSpeedRangePercent), [] { return moveWith([](auto& g) { g.speed = 101; }); }},
      {row(motion_error::kAccelTimeRange), [] { return moveWith([](auto& g) { g.accel_time = 1; }); }},
      {row(motion_error::kCommandIdRange), [] { return moveWith([](auto& g) { g.command_id = 1; }); }},
      {row(motion_error::kPoseWithLine),
       [] {
         return moveWith([](auto& g) {
           line(g, AbsoluteFormat::Cpp, 10);
           g.robot_pose_enable = true;
         });
       }},
      {row(motion_error::kPose1Range),
       [=] {
         return posed({2, 2, 4});
       }},
      {row(motion_error::kPose2Range),
       [=] {
         return posed({0, 0, 4});
       }},
      {row(motion_error::kPose3Range),
       [=] {
         return posed({0, 2, 0});
       }},
      {row(motion_error::kFormatForPtp), [] { return moveWith([](auto& g) { g.data_format = 4; }); }},
      {row(motion_error::kFormatForLine),
       [] { return moveWith([](auto& g) { line(g, AbsoluteFormat::Jpp, 10); }); }},
      {row(own_error::kNotFinite), [] { return moveWith([](auto& g) { g.target[0] = std::nan(""); }); }},
      {row(own_error::kBlendingRange),
       [] {
         return moveWith([](auto& g) {
           g.blending_enable = true;
           g.blending_value = 101;
         });
       }},
      {row(own_error::kMovementUnknown), [] { return moveWith([](auto& g) { g.movement_command = 2; }); }},
      {row(own_error::kPoseWithJoints),
       [] {
         return moveWith([](auto& g) {
           g.data_format = 0;
           g.robot_pose_enable = true;
         });
       }},
      {row(own_error::kCoordinateRange), [] { return moveWith([](auto& g) { g.target[5] = 1e9; }); }},
  };
}

std::map<Row, Scenario> planningScenarios() {
  const auto row = [](int id) { return Row{Block::MoveAbsolute, id}; };
  return {
      {row(own_error::kUnreachable),
       [] {
         return plannedOn("tm5-900", {10, 15, 80, -5, 85, 20},
                          [](auto& g) { g.target = {3000, 0, 500, 180, 0, 90}; });
       }},
      {row(own_error::kPoseBits),
       [] {  // nearly stretched: with the wrist flipped the arm would have to be longer
         return plannedOn("tm5-900", {10, 15, 80, -5, 85, 20}, [](auto& g) {
           g.target = {907.1, -122.3, 145, 180, 0, 90};
           g.robot_pose_enable = true;
           g.robot_pose = {0, 2, 5};
         });
       }},
      {row(own_error::kJointLimit),
       [] {
         return plannedOn("tm5-900", {0, 0, 90, 0, 90, 0}, [](auto& g) {
           g.data_format = static_cast<int>(AbsoluteFormat::Jpp);
           g.target = {0, 0, 170, 0, 90, 0};
         });
       }},
      {row(own_error::kJointSpeed),
       [] {
         return plannedOn("tm12", {0, -40, 130, 0, 90, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 1300);
           g.target = {255.9, 143.7, 648.7, 180, 0, 90};
         });
       }},
      {row(own_error::kSingular),
       [] {
         return plannedOn("tm5-900", {0, 0, 0, 0, 0, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 10);
           g.target = {100, -200, 800, 0, 0, 90};
         });
       }},
      {row(own_error::kNotPlannable),
       [] {
         return plannedOn("tm5-900", {0, 0, 90, 0, 90, 0}, [](auto& g) {
           line(g, AbsoluteFormat::Cap, 1);
           g.target = {90000, 0, 0, 180, 0, 90};
         });
       }},
  };
}

std::map<Row, Scenario> executionScenarios() {
  const auto row = [](int id) { return Row{Block::MoveAbsolute, id}; };
  const auto overdue = [](CoreRig& rig, const std::string& id) {
    rig.reply(id);
    for (int i = 0; i < 600; ++i) {
      rig.pass(500ms);
      rig.status(StatusFrames());
    }
    rig.takeTagQuery();
  };
  return {
      {row(motion_error::kNotConnected),
       [] {
         CoreRig rig;
         return *rig.outcome(rig.submit(CoreRig::move()));
       }},
      {row(motion_error::kOtherBlockBusy),
       [] {
         CoreRig rig;
         rig.connect();
         rig.submit(CoreRig::move());
         rig.takeScript();
         return *rig.outcome(rig.submit(CoreRig::move()));
       }},
      {row(motion_error::kReceiveReply),
       [] { return moveUntil([](auto& rig, const auto&) { rig.pass(1s); }); }},
      {row(motion_error::kRejected),
       [] { return moveUntil([](auto& rig, const auto& id) { rig.reply(id, false, {1}); }); }},
      {row(motion_error::kLinkDropped),
       [] { return moveUntil([](auto& rig, const auto&) { rig.close("gone"); }); }},
      {row(motion_error::kReceiveTag),
       [=] {
         return moveUntil([&](auto& rig, const auto& id) {
           overdue(rig, id);
           rig.pass(1s);
         });
       }},
      {row(motion_error::kMotionFailed),
       [=] {
         return moveUntil([&](auto& rig, const auto& id) {
           overdue(rig, id);
           rig.tag(1, TagState::Incomplete);
         });
       }},
      {row(own_error::kNotListening),
       [] {
         return moveUntil([](auto& rig, const auto&) {
           rig.say(protocol::CommunicationError{CommunicationErrorCode::NotListening});
         });
       }},
      {row(own_error::kEmergencyStop),
       [] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames().emergencyStop());
         return *rig.outcome(rig.submit(CoreRig::move()));
       }},
      {row(own_error::kRobotError),
       [] { return moveUntil([](auto& rig, const auto&) { rig.status(StatusFrames().error(1, "IK")); }); }},
      {row(own_error::kTagLost),
       [=] {
         return moveUntil([&](auto& rig, const auto& id) {
           overdue(rig, id);
           rig.tag(1, TagState::Unknown);
         });
       }},
      {row(own_error::kCommunication),
       [] {
         return moveUntil([](auto& rig, const auto&) {
           rig.say(protocol::CommunicationError{CommunicationErrorCode::Checksum});
         });
       }},
      {row(own_error::kStopNotConfirmed),
       [] {
         CoreRig rig;
         rig.connect();
         const GoalId goal = rig.submit(CoreRig::move());
         rig.takeScript();
         rig.cancel(goal);
         rig.takeScript();
         rig.pass(1s);
         return *rig.outcome(goal);
       }},
      {row(own_error::kShutDown),
       [] {
         CoreRig rig;
         rig.shutDown();
         return *rig.outcome(rig.submit(CoreRig::move()));
       }},
  };
}

TEST(Catalogue, hasEveryRowRaisedOrExplained) {
  std::map<Row, Scenario> scenarios;
  for (const auto& some :
       {connectScenarios(), parameterScenarios(), planningScenarios(), executionScenarios()}) {
    scenarios.insert(some.begin(), some.end());
  }
  for (const ErrorEntry& entry : errorCatalogue()) {
    SCOPED_TRACE(std::string(toString(entry.block)) + " " + std::to_string(entry.id) + " " +
                 entry.description);
    const auto scenario = scenarios.find({entry.block, entry.id});
    if (scenario == scenarios.end()) {
      EXPECT_THAT(entry.raised_when, HasSubstr("cannot occur"));
      continue;
    }
    EXPECT_THAT(entry.raised_when, ::testing::Not(HasSubstr("cannot occur any more")));
    const Outcome outcome = scenario->second();
    EXPECT_EQ(outcome.error_id, entry.id) << outcome.error_description;
    EXPECT_EQ(outcome.error_description.find(entry.description), 0u) << outcome.error_description;
    EXPECT_FALSE(outcome.remedy.empty());
    scenarios.erase(scenario);
  }
  EXPECT_TRUE(scenarios.empty()) << "a scenario without a row in the catalogue";
}

TEST(Catalogue, isOrderedByBlockAndIdWithoutDoubles) {
  const auto& all = errorCatalogue();
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LT(std::make_pair(all[i - 1].block, all[i - 1].id), std::make_pair(all[i].block, all[i].id));
  }
  for (const ErrorEntry& entry : all) EXPECT_EQ(findError(entry.block, entry.id), &entry);
  EXPECT_EQ(findError(Block::Connect, 0), nullptr);
  EXPECT_EQ(findError(Block::Connect, motion_error::kNotConnected), nullptr);
}

TEST(Catalogue, hasTheTablesOfTheThesis) {
  const std::set<int> kConnect = {0x15, 0x20, 0x21, 0x30, 0x40, 0x50, 0x60, 0x70, 0x80, 0x90, 0x100};
  const std::set<int> kMoveAbsolute = {0x10, 0x11, 0x20, 0x25, 0x26, 0x27, 0x28, 0x29, 0x30, 0x31,  0x32,
                                       0x35, 0x36, 0x40, 0x50, 0x60, 0x70, 0x80, 0x90, 0x99, 0x100, 0x110};
  std::map<Block, std::set<int>> found;
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (entry.id < 0x200) found[entry.block].insert(entry.id);
    EXPECT_STRNE(entry.description, "");
    EXPECT_STRNE(entry.remedy, "");
    EXPECT_STRNE(entry.raised_when, "");
  }
  EXPECT_EQ(found[Block::Connect], kConnect);
  EXPECT_EQ(found[Block::MoveAbsolute], kMoveAbsolute);
  EXPECT_STREQ(findError(Block::Connect, 0x21)->description, "TimeOut Error");
  EXPECT_STREQ(findError(Block::Connect, 0x21)->remedy, "Cobot is not in Listen Node");
  EXPECT_STREQ(findError(Block::MoveAbsolute, 0x11)->remedy, "Wait until other FB is done");
  EXPECT_STREQ(findError(Block::MoveAbsolute, 0x110)->description, "Motion failed");
}

TEST(Catalogue, givesOwnIdsOneMeaningInAllBlocks) {
  std::map<int, std::string> meaning;
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (entry.id < 0x200) continue;
    const auto [known, added] = meaning.emplace(entry.id, entry.description);
    EXPECT_TRUE(added || known->second == entry.description) << entry.description;
  }
}

}  // namespace
}  // namespace cobot_command::testing
