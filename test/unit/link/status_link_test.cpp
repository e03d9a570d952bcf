// The status link: reads the stream into SI, reopens it, and says in words what is wrong with it.

#include "cobot_command/link/status_link.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "recording_wire.h"
#include "status_decoding.h"
#include "whole_stream.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/link/stream_items.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {
namespace {

using namespace std::chrono_literals;
using protocol::StatusItem;
using ::testing::HasSubstr;
namespace item = protocol::item;

TEST(StatusDecoding, turnsEveryItemIntoSi) {
  const RobotStatus status = toRobotStatus(
      {item::ofByte("Robot_Link", 1), item::ofFloats("Joint_Angle", {0, 0, 90, 0, -90, 180}),
       item::ofFloats("Joint_Speed", {180, 0, 0, 0, 0, -90}),
       item::ofFloats("Joint_Torque", {1000, 0, 0, 0, 0, -250}),
       item::ofFloats("Coord_Robot_Flange", {417.5F, -122.25F, 361, 180, 0, 90}),
       item::ofFloats("Coord_Robot_Tool", {1000, 0, 0, 0, 0, 0}),
       item::ofFloats("Base_Value", {0, 500, 0, 0, 0, 0}), item::ofFloats("TCP_Value", {0, 0, 250, 0, 0, 0}),
       item::ofString("Base_Name", "RobotBase"), item::ofString("TCP_Name", "NOTOOL"),
       item::ofBool("Robot_Error", true), item::ofInt("Error_Code", 0x14058),
       item::ofString("Error_Content", "IK failed"), item::ofBool("ESTOP", false),
       item::ofBool("Safeguard_A", true), item::ofBool("Project_Run", true),
       item::ofBool("Project_Pause", false), item::ofInt("Project_Speed", 35), item::ofInt("MA_Mode", 2)},
      Instant(7s));
  EXPECT_EQ(status.received, Instant(7s));
  EXPECT_EQ(status.linked, true);
  EXPECT_NEAR((*status.joints)[2], kPi / 2, 1e-12);
  EXPECT_NEAR((*status.joint_velocities)[0], kPi, 1e-12);
  EXPECT_NEAR((*status.joint_torques)[5], -0.25, 1e-12);
  EXPECT_NEAR(status.flange->translation().x(), 0.4175, 1e-12);
  EXPECT_NEAR(status.tool->translation().x(), 1.0, 1e-12);
  EXPECT_NEAR(status.base->translation().y(), 0.5, 1e-12);
  EXPECT_NEAR(status.tcp->translation().z(), 0.25, 1e-12);
  EXPECT_EQ(status.base_name, "RobotBase");
  EXPECT_EQ(status.tcp_name, "NOTOOL");
  EXPECT_EQ(status.error, true);
  EXPECT_EQ(status.error_code, 0x14058);
  EXPECT_EQ(status.error_text, "IK failed");
  EXPECT_EQ(status.emergency_stop, false);
  EXPECT_EQ(status.safeguard, true);
  EXPECT_EQ(status.project_running, true);
  EXPECT_EQ(status.project_paused, false);
  EXPECT_EQ(status.project_speed_percent, 35);
  EXPECT_EQ(status.operating_mode, 2);
}

TEST(StatusDecoding, leavesOutWhatItDoesNotKnowOrCannotRead) {
  const RobotStatus status = toRobotStatus(
      {item::ofString("Robot_Model", "TM5-900"), item::ofFloats("Joint_Angle", {1, 2, 3}),
       item::ofFloats("Joint_Speed", {0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN()}),
       item::ofInt("ESTOP", 1), item::ofBool("Error_Code", true), StatusItem{"Coord_Robot_Flange", "abc"}},
      Instant{});
  EXPECT_FALSE(status.joints);
  EXPECT_FALSE(status.joint_velocities);
  EXPECT_FALSE(status.emergency_stop);
  EXPECT_FALSE(status.error_code);
  EXPECT_FALSE(status.flange);
  EXPECT_THAT(status.unreadable, ::testing::ElementsAre("Joint_Angle", "Joint_Speed", "ESTOP", "Error_Code",
                                                        "Coord_Robot_Flange"));
}

TEST(StatusDecoding, readsTheLimitsOfTheSafetyFunctions) {
  const RobotStatus status = toRobotStatus({item::ofFloats("Safety_Joint_Angle_Min", {-90, 0, 0, 0, 0, -180}),
                                            item::ofFloats("Safety_Joint_Angle_Max", {90, 0, 0, 0, 0, 180})},
                                           Instant{});
  ASSERT_TRUE(status.safety_lower && status.safety_upper);
  EXPECT_NEAR((*status.safety_lower)[0], -kPi / 2, 1e-12);
  EXPECT_NEAR((*status.safety_upper)[5], kPi, 1e-12);
}

TEST(StatusDecoding, readsEachDigitalInputAndOutputThatIsStreamed) {
  const RobotStatus status =
      toRobotStatus({item::ofByte("Ctrl_DI0", 1), item::ofByte("Ctrl_DI15", 0), item::ofByte("Ctrl_DO7", 1),
                     item::ofByte("End_DI3", 1), item::ofByte("End_DO0", 0), item::ofByte("End_DO3", 1)},
                    Instant{});
  DigitalLevels inputs;
  inputs.control_box[0] = true;
  inputs.control_box[15] = false;
  inputs.end_module[3] = true;
  EXPECT_EQ(status.inputs, inputs);
  DigitalLevels outputs;
  outputs.control_box[7] = true;
  outputs.end_module[0] = false;
  outputs.end_module[3] = true;
  EXPECT_EQ(status.outputs, outputs);
  EXPECT_NE(status.outputs, DigitalLevels());
  EXPECT_THAT(status.unreadable, ::testing::IsEmpty());
}

TEST(StatusDecoding, inventsNoLevelOfADigitalInputOrOutput) {
  const RobotStatus status =
      toRobotStatus({item::ofByte("Ctrl_DO2", 2), item::ofInt("End_DI0", 1), item::ofByte("Ctrl_DO16", 1),
                     item::ofByte("End_DO4", 1), item::ofByte("Ctrl_DO", 1), item::ofByte("End_DO1x", 1)},
                    Instant{});
  EXPECT_EQ(status.inputs, DigitalLevels());
  EXPECT_EQ(status.outputs, DigitalLevels());
  EXPECT_THAT(status.unreadable, ::testing::ElementsAre("Ctrl_DO2", "End_DI0"));
}

class StatusLinkTest : public ::testing::Test {
 protected:
  static std::string frame(int number, int mode = 1) {
    return protocol::encode(protocol::StatusFrame{std::to_string(number % 10), mode,
                                                  protocol::encodeBinaryItems(testing::wholeStream())});
  }
  static std::vector<StatusItem> wholeWith(const StatusItem& other) {
    auto items = testing::wholeStream();
    std::replace_if(
        items.begin(), items.end(), [&](const auto& known) { return known.name == other.name; }, other);
    return items;
  }
  static std::vector<StatusItem> wholeWithout(const std::string& name) {
    auto items = testing::wholeStream();
    items.erase(std::remove_if(items.begin(), items.end(), [&](const auto& i) { return i.name == name; }),
                items.end());
    return items;
  }
  int receive(const std::string& bytes) {
    link.received(bytes);
    int count = 0;
    while (link.next(now)) ++count;
    return count;
  }
  void stream() {
    link.start("robot", 5891, now);
    link.opened(now);
    EXPECT_EQ(receive(frame(0)), 1);
  }

  testing::RecordingWire wire;
  LinkSettings settings;
  StatusLink link{settings, wire};
  Instant now{50s};
};

TEST(StatusDecoding, saysWhatAKnownErrorMeansWhereTheControllerDoesNot) {
  const auto textOf = [](int code) {
    return toRobotStatus({item::ofInt("Error_Code", code)}, Instant{}).error_text;
  };
  EXPECT_EQ(textOf(0x1405A), "a joint outside its range");
  EXPECT_EQ(textOf(0), std::nullopt);
  EXPECT_EQ(textOf(0x7FFFFFFF), std::nullopt);
}

TEST_F(StatusLinkTest, streamsWithTheFirstFrame) {
  link.start("robot", 5891, now);
  EXPECT_EQ(wire.opened, std::vector<std::string>{"robot:5891"});
  EXPECT_FALSE(link.streaming());
  EXPECT_FALSE(link.diagnosis().empty());
  link.opened(now);
  EXPECT_FALSE(link.streaming());
  EXPECT_EQ(receive(frame(0)), 1);
  EXPECT_TRUE(link.streaming());
  EXPECT_TRUE(link.diagnosis().empty());
}

TEST_F(StatusLinkTest, takesTheCyclingIdsAndFramesInAnyPieces) {
  stream();
  std::string bytes;
  for (int i = 1; i <= 25; ++i) bytes += frame(i);
  EXPECT_EQ(receive(bytes.substr(0, 33)) + receive(bytes.substr(33)), 25);
  EXPECT_EQ(link.decodeFaults(), 0u);
}

TEST_F(StatusLinkTest, tellsEachFrameAlsoWhenItSaysTheSame) {
  stream();
  int number = 0;
  for (const bool pressed : {false, true, true, false}) {
    now += 15ms;
    link.received(protocol::encode(
        protocol::StatusFrame{std::to_string(++number), 1,
                              protocol::encodeBinaryItems(wholeWith(item::ofBool("ESTOP", pressed)))}));
    const auto status = link.next(now);
    ASSERT_TRUE(status) << number;
    EXPECT_EQ(status->received, now);
    EXPECT_EQ(status->emergency_stop, pressed) << number;
    EXPECT_TRUE(link.diagnosis().empty());
    EXPECT_EQ(receive(protocol::encode(protocol::StatusFrame{"9", 1, "no items"})), 0);
    EXPECT_THAT(link.diagnosis(), HasSubstr("cannot be read"));
  }
}

TEST_F(StatusLinkTest, reopensAStreamThatFallsSilent) {
  stream();
  EXPECT_EQ(link.nextDeadline(), now + settings.status_timeout);
  now += settings.status_timeout;
  link.advance(now);
  EXPECT_FALSE(link.streaming());
  EXPECT_THAT(link.diagnosis(), HasSubstr("has stopped"));
  EXPECT_EQ(wire.closed.size(), 1u);
  EXPECT_EQ(link.nextDeadline(), now + settings.retry_min);
  now += settings.retry_min;
  link.advance(now);
  EXPECT_EQ(wire.opened.size(), 2u);
  EXPECT_EQ(link.state(), StatusLinkState::Connecting);
}

TEST_F(StatusLinkTest, reopensWhenClosedOrRefusedWithABackOff) {
  link.start("robot", 5891, now);
  for (const Duration wait : {100ms, 200ms, 400ms, 800ms, 1000ms, 1000ms}) {
    link.openFailed({OpenFailure::Kind::Refused, "refused"}, now);
    EXPECT_THAT(link.diagnosis(), HasSubstr("Ethernet Slave"));
    EXPECT_EQ(link.nextDeadline(), now + wait);
    now += wait;
    link.advance(now);
  }
  link.opened(now);
  receive(frame(1));
  link.closed("gone", now);
  EXPECT_THAT(link.diagnosis(), HasSubstr("gone"));
  EXPECT_EQ(link.nextDeadline(), now + settings.retry_min) << "after frames the back-off starts anew";
}

TEST_F(StatusLinkTest, namesAWrongFormatAndKeepsTheConnection) {
  for (const auto& [mode, name] : {std::pair(2, "STRING"), std::pair(3, "JSON"), std::pair(9, "unknown")}) {
    testing::RecordingWire fresh_wire;
    StatusLink fresh(settings, fresh_wire);
    fresh.start("robot", 5891, now);
    fresh.opened(now);
    now += 900ms;
    fresh.received(frame(0, mode));
    EXPECT_FALSE(fresh.next(now));
    EXPECT_FALSE(fresh.streaming());
    EXPECT_THAT(fresh.diagnosis(), HasSubstr(name));
    EXPECT_THAT(fresh.diagnosis(), HasSubstr("BINARY"));
    now += 900ms;
    fresh.advance(now);
    EXPECT_TRUE(fresh_wire.closed.empty());
  }
}

TEST_F(StatusLinkTest, countsFaultsAndGoesOn) {
  stream();
  EXPECT_EQ(receive("garbage" + frame(1)), 1);
  EXPECT_EQ(receive("$TMSVR,3,0,1,*00\r\n" + frame(2)), 1);
  EXPECT_EQ(receive("$TMSTA,2,00,*41\r\n" + frame(3)), 1);
  EXPECT_EQ(receive(protocol::encode(protocol::StatusFrame{"4", 1, "\xFF\xFF"}) + frame(4)), 1);
  EXPECT_EQ(link.decodeFaults(), 4u);
  EXPECT_TRUE(link.streaming());
}

/// Whatever a wrong peer sends, the diagnosis says so instead of "not yet" for ever.
TEST_F(StatusLinkTest, namesAPeerThatSendsNoStatusStream) {
  const struct {
    const char* sent;
    const char* words;
  } kRows[] = {
      {"", "sends nothing"},
      {"SSH-2.0-OpenSSH_9.2p1\r\n", "not the status stream of a TM robot"},
      {"$TMSCT,9,0,Listen1,*4C\r\n", "is the script port"},
      {"$CPERR,2,03,*4B\r\n", "is the script port"},
      {"$TMSVR,3,0,1,*00\r\n", "not the status stream of a TM robot"},
  };
  for (const auto& row : kRows) {
    testing::RecordingWire fresh_wire;
    StatusLink fresh(settings, fresh_wire);
    fresh.start("robot", 5891, now);
    EXPECT_THAT(fresh.diagnosis(), HasSubstr("yet"));
    for (int i = 0; i < 3; ++i) {
      fresh.opened(now);
      fresh.received(row.sent);
      EXPECT_FALSE(fresh.next(now));
      now += settings.status_timeout;
      fresh.advance(now);
      EXPECT_THAT(fresh.diagnosis(), HasSubstr(row.words)) << row.sent;
      EXPECT_EQ(fresh.state(), StatusLinkState::BackingOff);
      now = *fresh.nextDeadline();
      fresh.advance(now);
      EXPECT_THAT(fresh.diagnosis(), HasSubstr(row.words)) << "also during the next try";
    }
  }
}

TEST_F(StatusLinkTest, namesGarbageWithoutEndBehindAStream) {
  stream();
  for (int i = 0; i < 20; ++i) {
    receive(std::string(1000, 'x'));
    now += settings.status_timeout / 10;
    link.advance(now);
  }
  EXPECT_FALSE(link.streaming());
  EXPECT_THAT(link.diagnosis(), HasSubstr("not its frames"));
}

TEST_F(StatusLinkTest, namesAStreamWhoseItemsCannotBeRead) {
  stream();
  const auto send = [&](std::vector<float> joints) {
    receive(protocol::encode(protocol::StatusFrame{
        "1", 1, protocol::encodeBinaryItems(wholeWith(item::ofFloats("Joint_Angle", std::move(joints))))}));
  };
  send({0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0});
  EXPECT_TRUE(link.streaming());
  EXPECT_THAT(link.diagnosis(), HasSubstr("Joint_Angle"));
  EXPECT_THAT(link.diagnosis(), HasSubstr("not finite"));
  send({0, 0, 90, 0, 90, 0});
  EXPECT_TRUE(link.diagnosis().empty()) << "it is well again";
}

TEST_F(StatusLinkTest, namesWhatADataTableShouldHaveAndWhatIsSoWithoutIt) {
  stream();
  for (const StreamItem& item : streamItems()) {
    if (item.need == ItemNeed::Choice) continue;
    const std::string name(item.name);
    receive(protocol::encode(protocol::StatusFrame{"1", 1, protocol::encodeBinaryItems(wholeWithout(name))}));
    EXPECT_TRUE(link.streaming());
    EXPECT_THAT(link.diagnosis(),
                HasSubstr("does not have " + name + " (" + std::string(item.without) + ")"));
    EXPECT_THAT(link.diagnosis(), HasSubstr("Data Table"));
    receive(frame(2));
    EXPECT_TRUE(link.diagnosis().empty()) << "it is well again";
  }
}

// --- Who the controller is.

class AskedIdentity : public StatusLinkTest {
 protected:
  static std::string frameOf(const std::string& id, int mode, const std::vector<StatusItem>& items) {
    return protocol::encode(protocol::StatusFrame{id, mode, protocol::encodeBinaryItems(items)});
  }
  static std::string refusalOf(const std::string& id) {
    using Code = protocol::StatusReply::Code;
    return protocol::encode(
        protocol::StatusFrame{id, 0, protocol::toContent({Code::NotExist, "ControlBox_SN"})});
  }
  ControllerIdentity identity() {
    link.received(frame(1));
    const auto status = link.next(now);
    return status ? status->identity : ControllerIdentity();
  }
};

TEST_F(AskedIdentity, isAskedForBehindTheFirstFrameAndOnlyOnce) {
  link.start("robot", 5891, now);
  link.opened(now);
  EXPECT_TRUE(wire.sent.empty()) << "it may be no status port";
  receive(frame(0));
  ASSERT_EQ(wire.sent.size(), 3u);
  EXPECT_EQ(wire.sent[1], protocol::encode(protocol::StatusFrame{
                              "ControlBoxSN", 11, protocol::encodeBinaryNames({"ControlBox_SN"})}));
  EXPECT_THAT(wire.traced, ::testing::Contains(HasSubstr("asks for items")));
  receive(frame(1) + frame(2));
  EXPECT_EQ(wire.sent.size(), 3u);
}

TEST_F(AskedIdentity, isToldWithEachFrameFromItsAnswerOn) {
  stream();
  EXPECT_EQ(identity(), ControllerIdentity());
  EXPECT_EQ(receive(frameOf("RobotModel", 11, {item::ofString("Robot_Model", "TM5-900")}) +
                    frameOf("TMflowVersion", 11, {item::ofString("TMflow_Version", "1.84.1200")}) +
                    refusalOf("ControlBoxSN")),
            0);
  const ControllerIdentity expected{"TM5-900", std::nullopt, "1.84.1200"};
  EXPECT_EQ(identity(), expected);
  EXPECT_EQ(identity(), expected);
  EXPECT_EQ(link.decodeFaults(), 0u);
  EXPECT_TRUE(link.diagnosis().empty());
}

TEST_F(AskedIdentity, isTakenFromTheStreamWhereThatHasIt) {
  link.start("robot", 5891, now);
  link.opened(now);
  link.received(
      frameOf("0", 1, {item::ofString("ControlBox_SN", "SN1"), item::ofString("TMflow_Version", "1.8")}));
  EXPECT_EQ(link.next(now)->identity, (ControllerIdentity{std::nullopt, "SN1", "1.8"}));
  ASSERT_EQ(wire.sent.size(), 1u);
  EXPECT_THAT(wire.sent[0], HasSubstr("Robot_Model"));
}

TEST_F(AskedIdentity, ofAnotherControllerIsAskedForAnew) {
  stream();
  receive(frameOf("RobotModel", 11, {item::ofString("Robot_Model", "TM5-900")}));
  link.closed("gone", now);
  now = *link.nextDeadline();
  link.advance(now);
  link.opened(now);
  EXPECT_EQ(identity(), ControllerIdentity()) << "though its stream says the same";
  EXPECT_EQ(wire.sent.size(), 6u);
}

TEST_F(AskedIdentity, isNotWhatAnAnswerToSomebodyElseSays) {
  stream();
  receive(frameOf("RobotModel", 11, {item::ofInt("Error_Code", 5)}));
  receive(protocol::encode(protocol::StatusFrame{"RobotModel", 11, "\xFF\xFF"}));
  EXPECT_EQ(identity(), ControllerIdentity());
  receive(frameOf("other", 11, {item::ofString("Robot_Model", "TM5-900")}));
  EXPECT_EQ(identity(), ControllerIdentity());
}

TEST_F(StatusLinkTest, endsCleanlyInEveryState) {
  for (int step = 0; step < 4; ++step) {
    testing::RecordingWire fresh_wire;
    StatusLink fresh(settings, fresh_wire);
    fresh.start("robot", 5891, now);
    if (step == 0) fresh.openFailed({}, now);
    if (step >= 2) fresh.opened(now);
    if (step == 3) {
      fresh.received(frame(0));
      EXPECT_TRUE(fresh.next(now));
    }
    fresh.stop(now);
    EXPECT_EQ(fresh.state(), StatusLinkState::Off);
    EXPECT_EQ(fresh.nextDeadline(), std::nullopt);
    EXPECT_EQ(fresh_wire.closed.size(), step == 0 ? 0u : 1u);
    fresh.stop(now);
    EXPECT_EQ(fresh.state(), StatusLinkState::Off);
  }
}

}  // namespace
}  // namespace cobot_command::link
