#include "cobot_command/script/project_attributes.h"

#include "script_session.h"
#include <gtest/gtest.h>

#include "cobot_command/script/robot_functions.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::script {
namespace {

using Attribute = ProjectAttribute;

TEST(ProjectAttributes, areReadByListenSendUnderAChannelEach) {
  EXPECT_EQ(toText(AttributeRead{Attribute::TcpValue, "gripper"}), "ListenSend(90,TCP[\"gripper\"].Value)");
  EXPECT_EQ(toText(AttributeRead{Attribute::TcpMass, "gripper"}), "ListenSend(91,TCP[\"gripper\"].Mass)");
  EXPECT_EQ(toText(AttributeRead{Attribute::TcpMoment, "gripper"}), "ListenSend(92,TCP[\"gripper\"].MOI)");
  EXPECT_EQ(toText(AttributeRead{Attribute::TcpMassCenter, "gripper"}),
            "ListenSend(93,TCP[\"gripper\"].MCF)");
  EXPECT_EQ(toText(AttributeRead{Attribute::BaseValue, "table"}), "ListenSend(90,Base[\"table\"].Value)");
}

TEST(ProjectAttributes, areReadInOneScriptBehindItsMark) {
  const ReadingScript script{"cobot 7", {{Attribute::TcpValue, "a"}, {Attribute::BaseValue, "b"}}};
  EXPECT_EQ(
      toText(script),
      "ListenSend(99,\"cobot 7\")\r\nListenSend(90,TCP[\"a\"].Value)\r\nListenSend(90,Base[\"b\"].Value)");
  EXPECT_EQ(kFirstReadLine, 2);
}

TEST(ProjectAttributes, areWrittenByAssignment) {
  EXPECT_EQ(toText(std::vector<AttributeWrite>{{Attribute::TcpValue, "a", {0, 0, 150.5, 0, -90, 0.0001}},
                                               {Attribute::TcpMass, "a", {2.25}},
                                               {Attribute::TcpMoment, "a", {1000, 0, 1e9}},
                                               {Attribute::TcpMassCenter, "a", {0, 0, -80, 0, 0, 0}},
                                               {Attribute::BaseValue, "b", {1, 2, 3, 4, 5, 6}}}),
            "TCP[\"a\"].Value={0,0,150.5,0,-90,0.0001}\r\nTCP[\"a\"].Mass=2.25\r\n"
            "TCP[\"a\"].MOI={1000,0,1000000000}\r\nTCP[\"a\"].MCF={0,0,-80,0,0,0}\r\n"
            "Base[\"b\"].Value={1,2,3,4,5,6}");
}

TEST(ProjectAttributes, haveTheirNumbersAndChannels) {
  EXPECT_EQ(numbersOf(Attribute::TcpValue), 6U);
  EXPECT_EQ(numbersOf(Attribute::TcpMass), 1U);
  EXPECT_EQ(numbersOf(Attribute::TcpMoment), 3U);
  EXPECT_EQ(numbersOf(Attribute::TcpMassCenter), 6U);
  EXPECT_EQ(numbersOf(Attribute::BaseValue), 6U);
  for (int channel = 89; channel <= 100; ++channel) {
    EXPECT_EQ(isAttributeChannel(channel), channel >= 90 && channel <= 93) << channel;
  }
}

// A name is text of somebody else: it must be neither the end of the text, nor of the line, nor a variable.
TEST(ProjectAttributes, takeNamesThatMeanThemselves) {
  for (const char* name :
       {"gripper", "big cup 2", "say \"hi\"", "it's", "a]b", "//", "{0}", "名前", "\\", "]."}) {
    ASSERT_TRUE(isAttributeKey(name)) << name;
    const auto parsed = tm_script::parse(toText(AttributeRead{Attribute::TcpValue, name}));
    ASSERT_TRUE(parsed.faults.empty()) << name;
    ASSERT_EQ(parsed.statements.size(), 1U) << name;
    const auto& call =
        std::get<tm_script::Call>(std::get<tm_script::Expression>(parsed.statements[0].content).node);
    const auto& attribute = std::get<tm_script::Attribute>(call.arguments.at(1).node);
    const auto& key = std::get<tm_script::Literal>(attribute.keys.at(0).node);
    EXPECT_EQ(std::get<std::string>(key.value), name);
  }
}

TEST(ProjectAttributes, refuseNamesThatMeanSomethingElse) {
  for (const char* name : {"", "a\r\nScriptExit()", "a\nb", "\t", "'var_i'", "tool 'x' of 'y'", "\xff"}) {
    EXPECT_FALSE(isAttributeKey(name)) << name;
  }
  EXPECT_FALSE(isAttributeKey(std::string(kMaxNameLength + 1, 'a')));
  EXPECT_TRUE(isAttributeKey(std::string(kMaxNameLength, 'a')));
}

TEST(ProjectAttributes, areToldInMessagesWithoutWhatSpoilsThem) {
  EXPECT_EQ(describe(AttributeRead{Attribute::BaseValue, "table"}), "Base[\"table\"].Value");
  EXPECT_EQ(describe(AttributeRead{Attribute::TcpMass, "a\nb"}).find('\n'), std::string::npos);
}

// That a version has no ListenSend() is what makes its controller refuse the first line.
TEST(ProjectAttributes, areReadByAFunctionThatComesWithThem) {
  for (const auto& [version, is_there] :
       {std::pair(tm_script::Version{1, 72}, false), std::pair(kAttributesSince, true)}) {
    tm_script::FunctionTable functions(version);
    declareRobotFunctions(functions);
    tm_script::Variables none;
    tm_script::FakeRobot robot;
    const auto findings = tm_script::check(tm_script::parse("ListenSend(99,\"mark\")"), functions,
                                           tm_script::Scope{none, none}, robot);
    EXPECT_EQ(findings.errors.empty(), is_there);
  }
}

}  // namespace
}  // namespace cobot_command::script
