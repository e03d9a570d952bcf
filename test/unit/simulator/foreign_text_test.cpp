// Whatever clients, operator and settings say: what the controller tells people of it can be shown on a
// terminal.
#include "foreign_bytes.h"
#include "simulated_robot.h"
#include <gmock/gmock.h>

#include "cobot_command/common/setting.h"
#include "cobot_command/protocol/item_content.h"
#include "cobot_command/protocol/status_items.h"
#include "cobot_command/simulator/control_line.h"

namespace cobot_command::simulator::test {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

void expectHarmlessLog(const SimulatedRobot& robot) {
  ASSERT_FALSE(robot.log().empty());
  for (const LogLine& line : robot.log()) EXPECT_THAT(line.text, IsHarmless());
  EXPECT_THAT(robot.state().error_text, IsHarmless());
}

/// Each script is run with each text in it.
TEST(ForeignText, ofScriptsIsLoggedWithoutHarm) {
  const std::vector<std::string> scripts = {"ChangeBase(\"#\")",
                                            "ChangeTCP(\"#\")",
                                            "ChangeLoad(\"#\")",
                                            "PTP(\"#\",0,0,90,0,90,0,10,200,0,false)",
                                            "#",
                                            "#()",
                                            "int # = 1",
                                            "string s = \"#\"\r\ns",
                                            "string t = \"#\" + true * 2",
                                            "int i = \"#\"",
                                            "int j = GetNow(\"#\")",
                                            "Base[\"#\"].Value = 1",
                                            "IO[\"#\"].DO[0] = 1",
                                            "Point[#].Value",
                                            "ListenSend(90,\"#\")",
                                            "ListenSend(\"#\",1)",
                                            "if # {",
                                            "/* #",
                                            "QueueTag(\"#\")"};
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  for (const std::string& text : foreignTexts()) {
    for (std::string script : scripts) {
      script.replace(script.find('#'), 1, text);
      robot.script(client, "1", script);
    }
  }
  robot.waitUntilIdle();
  expectHarmlessLog(robot);
}

TEST(ForeignText, ofALongScriptIsLoggedShort) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  for (const char* begin : {"ChangeBase(\"", "string s = 1 + \"", "(\""}) {
    robot.script(client, "1", begin + std::string(100000, 'x') + "\")");
  }
  expectHarmlessLog(robot);
}

TEST(ForeignText, ofFramesIsLoggedWithoutHarm) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  for (const std::string& text : foreignTexts()) {
    robot.send(client, text + "\r\n");
    robot.send(client, "$TM" + text + ",3,1,x,*00\r\n");  // the header of our own frames has letters alone
    robot.send(client, protocol::encodeFrame("TMSCT", text));
    robot.send(client, protocol::encodeFrame("TMSCT", text + ",QueueTag(1)"));
    robot.send(client, protocol::encodeFrame("TMSTA", text));
    robot.send(client, protocol::encodeFrame("TMSTA", "01," + text));
    robot.send(client, protocol::encodeFrame("TMSVR", text));
    robot.send(client, "$TMSCT," + text + ",1,x,*00\r\n");
  }
  expectHarmlessLog(robot);
}

TEST(ForeignText, ofTheStatusPortIsLoggedWithoutHarm) {
  Settings settings;
  settings.variables = {"string g_text = \"\""};
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect(Port::Status);
  const auto ask = [&](const std::string& data) {
    robot.send(client, protocol::encodeFrame("TMSVR", data), Port::Status);
  };
  for (const std::string& text : foreignTexts()) {
    robot.send(client, text + "\r\n", Port::Status);
    ask(text);
    ask(text + ",12,Robot_Link");
    ask("1," + text + ",Robot_Link");
    for (const char* mode : {"1", "2", "3", "11", "12", "13"}) {
      ask(std::string("1,") + mode + ',' + text);
      ask(std::string("1,") + mode + ',' + text + "=1");
    }
    ask("1,2,Project_Name=\"" + text + "\"");
    ask("1,2,g_text=\"" + text + "\"");
    ask("1,3,[{\"Item\":\"" + text + "\",\"Value\":1}]");
    ask("1,11," + protocol::encodeBinaryNames({text}));
    ask("1,1," + protocol::encodeBinaryItems({{text, text}, {"Project_Name", text}}));
  }
  expectHarmlessLog(robot);
}

TEST(ForeignText, ofTheOperatorIsAnsweredWithoutHarm) {
  SimulatedRobot robot;
  for (const std::string& text : foreignTexts()) {
    const std::vector<OperatorAction> actions = {SetTcp{text, {}},
                                                 SetBase{text, {}},
                                                 SetLoad{text, 1, {}, {}},
                                                 RaiseError{0x13, text},
                                                 SetFault{text, true, 0, 0, ""},
                                                 SetFault{"refuse_script", true, 0, 0, text},
                                                 SetFault{"cperr_script", true, 1, 0, text},
                                                 SetFault{"hide_items", true, 0, 0, text}};
    for (const OperatorAction& action : actions) EXPECT_THAT(robot.operate(action).text, IsHarmless());
    EXPECT_THAT(robot.state().error_text, IsHarmless());
    for (std::string line : {"#", "estop #", "speed #", "error #", "error 5 #", "input # 1 1", "set_tcp #",
                             "set_tcp #=1", "set_load #=1", "fault #", "fault # off",
                             "fault delay_stream 1 #", "fault hide_items 0 #", "run #"}) {
      line.replace(line.find('#'), 1, text);
      EXPECT_THAT(control(robot.controller(), line, robot.now()).text, IsHarmless()) << line;
    }
  }
  robot.wait(1ms);
  expectHarmlessLog(robot);
}

TEST(ForeignText, ofSettingsIsRefusedWithoutHarm) {
  for (const std::string& text : foreignTexts()) {
    for (const Given& given :
         {Given{text}, Given{GivenList{Given{text}}}, Given{GivenList{Given{text + "=1,2,3,4,5,6"}}}}) {
      Settings settings;
      const SettingTable table = settingsTable(settings);
      for (const Setting& row : table) {
        if (const auto fault = take(table, {{row.name, given}})) {
          EXPECT_THAT(describe(*fault), IsHarmless()) << row.name;
        }
      }
      if (const auto fault = faultIn(settings)) {
        EXPECT_THAT(describe(*fault), IsHarmless());
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::simulator::test
