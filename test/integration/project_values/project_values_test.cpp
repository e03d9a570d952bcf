// What the controller's project keeps of tools and bases, read and written as the command layer does it.
#include "linked_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace std::chrono_literals;
using script::AttributeRead;
using script::AttributeWrite;
using script::ProjectAttribute;
using simulator::SetBase;
using simulator::SetFault;
using simulator::SetLoad;
using simulator::SetTcp;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = robot::ReadFailure::Kind;

const AttributeRead kGripper{ProjectAttribute::TcpValue, "gripper"};
const AttributeRead kCup{ProjectAttribute::TcpValue, "the \"big\" cup"};
const AttributeRead kTable{ProjectAttribute::BaseValue, "table"};
/// Keeps the controller busy until a motion is done; then it sends numbers that nobody of us asked for.
constexpr const char* kOtherScript =
    "float[] other = {9,9,9,9,9,9}\r\nPTP(\"JPP\",20,0,90,0,90,0,100,200,0,false)\r\nQueueTag(1,1)\r\n"
    "ListenSend(90,other)\r\nListenSend(99,\"other\")";

simulator::Settings project(const std::string& tmflow = "1.80") {
  simulator::Settings settings;
  settings.tmflow_version = tmflow;
  settings.bases["table"] = arm::toPose({1, 2, 3, 0, 0, 0});
  settings.tcps["gripper"] = arm::toPose({0, 0, 150, 0, 0, 0});
  settings.tcps["the \"big\" cup"] = arm::toPose({0, 0, 80, 0, 0, 0});
  return settings;
}

class ProjectValuesTest : public ::testing::Test {
 protected:
  void expectNumbers(const std::optional<robot::ReadOutcome>& outcome,
                     const std::vector<std::vector<double>>& expected) {
    ASSERT_TRUE(outcome) << "still waiting";
    ASSERT_TRUE(*outcome) << outcome->error().reason;
    std::vector<std::vector<double>> numbers;
    for (const robot::ReadValue& value : **outcome) numbers.push_back(value.numbers);
    EXPECT_EQ(numbers, expected);
  }
  void expectFailure(const std::optional<robot::ReadOutcome>& outcome, Kind kind,
                     const std::vector<AttributeRead>& reads) {
    ASSERT_TRUE(outcome) << "still waiting";
    ASSERT_FALSE(*outcome);
    EXPECT_EQ(outcome->error().kind, kind) << outcome->error().reason;
    EXPECT_EQ(outcome->error().reads, reads);
    EXPECT_NE(outcome->error().reason, "");
  }

  LinkedRobot rig = LinkedRobot(project());
};

TEST_F(ProjectValuesTest, readTwoToolsAndABaseInOneScriptAsThePendantHasSetThem) {
  rig.operate(SetTcp{"gripper", {0, 0, 160.25, 0, 0, 180}});
  rig.operate(SetTcp{"the \"big\" cup", {1, 2, 3, -90, 5, 6}});
  rig.operate(SetBase{"table", {400, -0.125, 20, 0, 0, 90}});
  rig.operate(SetLoad{"gripper", 2.5, std::array<double, 3>{1000, 2000, 3000},
                      arm::ControllerPose{0, 0, -80, 0, 0, 0}});
  expectNumbers(rig.read({kGripper, kCup, kTable}),
                {{0, 0, 160.25, 0, 0, 180}, {1, 2, 3, -90, 5, 6}, {400, -0.125, 20, 0, 0, 90}});
  expectNumbers(rig.read({{ProjectAttribute::TcpMass, "gripper"},
                          {ProjectAttribute::TcpMoment, "gripper"},
                          {ProjectAttribute::TcpMassCenter, "gripper"}}),
                {{2.5}, {1000, 2000, 3000}, {0, 0, -80, 0, 0, 0}});
  EXPECT_THAT(rig.others(), IsEmpty());
}

TEST_F(ProjectValuesTest, areReadAgainAndAgain) {
  for (const double z : {160.0, 150.0005, 150.0}) {
    rig.operate(SetTcp{"gripper", {0, 0, z, 0, 0, 0}});
    expectNumbers(rig.read({kGripper}), {{0, 0, double{static_cast<float>(z)}, 0, 0, 0}});
  }
}

TEST_F(ProjectValuesTest, areWrittenByAssignment) {
  const std::vector<AttributeWrite> writes{
      {ProjectAttribute::TcpValue, kCup.name, {0.001, 0, 160, 0, -45.5, 0}},
      {ProjectAttribute::TcpMass, kCup.name, {0.75}},
      {ProjectAttribute::TcpMoment, kCup.name, {0.5, 1, 1e6}},
      {ProjectAttribute::TcpMassCenter, kCup.name, {0, 0, -1, 0, 0, 0}},
      {ProjectAttribute::BaseValue, "table", {1, 2, 3, 4, 5, 6}}};
  EXPECT_TRUE(rig.run(toText(writes)));
  expectNumbers(rig.read({kCup,
                          {ProjectAttribute::TcpMass, kCup.name},
                          {ProjectAttribute::TcpMoment, kCup.name},
                          {ProjectAttribute::TcpMassCenter, kCup.name},
                          kTable}),
                {{double{0.001F}, 0, 160, 0, -45.5, 0},
                 {0.75},
                 {0.5, 1, 1e6},
                 {0, 0, -1, 0, 0, 0},
                 {1, 2, 3, 4, 5, 6}});
}

TEST_F(ProjectValuesTest, areReadByEveryVersionThatCanSendThem) {
  for (const std::string version : {"1.76", "1.80", "1.82", "1.84"}) {
    LinkedRobot other(project(version));
    expectNumbers(other.read({kTable}), {{1, 2, 3, 0, 0, 0}});
  }
  for (const std::string version : {"1.68", "1.72"}) {
    LinkedRobot other(project(version));
    expectFailure(other.read({kTable}), Kind::NoListenSend, {});
  }
}

// --- Told apart.
TEST_F(ProjectValuesTest, areToldApartFromWhatScriptsBeforeThemSend) {
  EXPECT_FALSE(rig.run(kOtherScript)) << "it waits for its motion";
  rig.ask({kGripper});
  EXPECT_EQ(rig.takeOutcome(), std::nullopt);
  rig.wait(10s);
  EXPECT_THAT(rig.others(), SizeIs(2));
  expectNumbers(rig.takeOutcome(), {{0, 0, 150, 0, 0, 0}});
}

TEST_F(ProjectValuesTest, areToldApartFromWhatScriptsBehindThemSend) {
  EXPECT_FALSE(rig.run("PTP(\"JPP\",20,0,90,0,90,0,100,200,0,false)\r\nQueueTag(1,1)"));
  rig.ask({kGripper, kTable});
  EXPECT_FALSE(rig.run("float[] other = {9,9,9,9,9,9}\r\nListenSend(90,other)"));
  rig.wait(10s);
  EXPECT_THAT(rig.others(), SizeIs(1));
  expectNumbers(rig.takeOutcome(), {{0, 0, 150, 0, 0, 0}, {1, 2, 3, 0, 0, 0}});
}

TEST_F(ProjectValuesTest, areToldApartFromWhatScriptsOfOtherClientsSend) {
  const simulator::ClientId other = rig.robot.connect();
  rig.robot.script(other, "1", kOtherScript);
  rig.ask({kGripper});
  rig.robot.script(other, "2", "ListenSend(90,other)");
  rig.wait(10s);
  EXPECT_THAT(rig.others(), SizeIs(3));
  expectNumbers(rig.takeOutcome(), {{0, 0, 150, 0, 0, 0}});
}

TEST_F(ProjectValuesTest, areToldApartFromThoseThatAnotherLayerReadsWithTheSameMark) {
  const simulator::ClientId other = rig.robot.connect();
  rig.robot.script(other, "1", "PTP(\"JPP\",20,0,90,0,90,0,100,200,0,false)\r\nQueueTag(1,1)");
  rig.robot.script(other, "2", toText(script::ReadingScript{"us 1", {kTable}}));
  rig.ask({kGripper});
  rig.wait(10s);
  expectNumbers(rig.takeOutcome(), {{0, 0, 150, 0, 0, 0}});
}

// --- Not read.
TEST_F(ProjectValuesTest, nameTheNamesThatTheProjectDoesNotHave) {
  const AttributeRead gone{ProjectAttribute::TcpValue, "gone"};
  const AttributeRead no_base{ProjectAttribute::BaseValue, "gripper"};
  expectFailure(rig.read({kGripper, gone, kTable, no_base}), Kind::Unknown, {gone, no_base});
  expectNumbers(rig.read({kGripper, kTable}), {{0, 0, 150, 0, 0, 0}, {1, 2, 3, 0, 0, 0}});
}

TEST_F(ProjectValuesTest, areNotReadWhenTheControllerRefusesToSend) {
  rig.operate(SetFault{"refuse_listen_send", true, 1, 0, ""});
  expectFailure(rig.read({kGripper, kTable}), Kind::NoListenSend, {});
  expectNumbers(rig.read({kTable}), {{1, 2, 3, 0, 0, 0}});
}

TEST_F(ProjectValuesTest, areNotReadWhileTheFlowIsElsewhere) {
  rig.operate(simulator::LeaveListenNode{});
  expectFailure(rig.read({kGripper}), Kind::NotTaken, {});
}

TEST_F(ProjectValuesTest, areNotReadFromAControllerThatFallsSilent) {
  rig.operate(SetFault{"ignore_script", true, 1, 0, ""});
  rig.ask({kGripper});
  rig.wait(999ms);
  EXPECT_EQ(rig.takeOutcome(), std::nullopt);
  rig.wait(1ms);
  expectFailure(rig.takeOutcome(), Kind::NoAnswer, {});
}

TEST_F(ProjectValuesTest, areNotReadOverALinkThatIsLost) {
  rig.operate(SetFault{"drop_reply", true, 1, 0, ""});
  rig.ask({kGripper});
  rig.operate(simulator::DropConnections{});
  expectFailure(rig.takeOutcome(), Kind::Lost, {});
}

}  // namespace
}  // namespace cobot_command::testing
