// What the language of scripts does in the Listen node: variables, warnings, ListenSend, versions.
#include "simulated_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

constexpr const char* kMove = "PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)\r\n";

std::string sent(const std::string& payload) {
  return protocol::encodeFrame("TMSTA", "90," + payload);
}

class ScriptLanguageTest : public ::testing::Test {
 protected:
  /// What the client hears of a script, when it need not wait for the arm.
  std::string run(const std::string& script) { return run(robot, client, script); }
  static std::string run(SimulatedRobot& of, ClientId to, const std::string& script) {
    of.heard(to);
    of.script(to, "1", script);
    return of.heard(to);
  }
  std::string valueOf(const std::string& expression) {
    return run("ListenSend(90,GetString(" + expression + "))");
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(ScriptLanguageTest, keepsALocalVariableForLaterScripts) {
  EXPECT_EQ(run("int i = 100"), ok("1"));
  EXPECT_EQ(run("i = 1000\r\ni++"), ok("1"));
  EXPECT_EQ(valueOf("i"), sent("1001") + ok("1"));
  EXPECT_EQ(run("int i = 100"), error("1", "1")) << "it is declared already";
}

TEST_F(ScriptLanguageTest, forgetsLocalVariablesWhenTheNodeIsLeft) {
  EXPECT_EQ(run("int i = 100\r\nScriptExit()"), ok("1"));
  robot.wait(100ms);
  EXPECT_EQ(run("i++"), error("1", "1"));
  EXPECT_EQ(run("int i = 5"), ok("1"));
}

TEST_F(ScriptLanguageTest, keepsProjectVariablesUntilTheProjectBeginsAnew) {
  Settings settings;
  settings.variables = {"int counter = 5", "no declaration"};
  SimulatedRobot other(settings);
  ClientId to = other.connect();
  EXPECT_EQ(run(other, to, "counter++\r\nScriptExit()"), ok("1"));
  other.wait(100ms);
  EXPECT_EQ(run(other, to, "ListenSend(90,GetString(counter))"), sent("6") + ok("1"));
  other.stopProject();
  other.runProject();
  to = other.connect();
  EXPECT_EQ(run(other, to, "ListenSend(90,GetString(counter))"), sent("5") + ok("1"));
}

TEST_F(ScriptLanguageTest, tellsTheTimeOfTheController) {
  robot.wait(13h + 65s + 250ms);
  EXPECT_EQ(valueOf("GetNow()"), sent("01/01/2000 13:01:05") + ok("1"));
  EXPECT_EQ(valueOf("GetNow(\"yy-M-d h:mm:ss.ff tt\")"), sent("00-1-1 1:01:05.25 PM") + ok("1"));
  EXPECT_EQ(valueOf("GetNow(\"\")"), sent("") + ok("1"));
  robot.stopProject();
  robot.runProject();
  client = robot.connect();
  robot.wait(1500ms);
  EXPECT_EQ(valueOf("GetNowStamp()"), sent("1500") + ok("1"));
  EXPECT_EQ(valueOf("GetNowStamp(true)"), sent("1500") + ok("1"));
}

TEST_F(ScriptLanguageTest, hasTheSameRandomNumbersOnEveryRun) {
  SimulatedRobot other;
  const ClientId to = other.connect();
  for (const char* call : {"random()", "random()", "random(1,6)", "random(-2147483647,2147483647)"}) {
    const std::string first = valueOf(call);
    EXPECT_EQ(run(other, to, std::string("ListenSend(90,GetString(") + call + "))"), first);
  }
  EXPECT_NE(valueOf("random()"), valueOf("random()"));
  EXPECT_EQ(valueOf("random(3,3)"), sent("3") + ok("1"));
  EXPECT_EQ(run("int i = 0\r\ni = random(6,1)"), error("1", "2"));
}

TEST_F(ScriptLanguageTest, namesTheLinesOfWarnings) {
  EXPECT_EQ(run("int a = 300\r\nint b = 1.5\r\nbyte c = a"), warned("1", "2;3"));
  EXPECT_EQ(run("int d = 1.5\r\nBogus()"), error("1", "2")) << "errors hide warnings";
}

TEST_F(ScriptLanguageTest, namesUnknownBasesBesideOtherErrors) {
  EXPECT_EQ(run("ChangeBase(\"NoSuchBase\")\r\nBogus()\r\nChangeLoad(\r\nChangeLoad()"),
            error("1", "1;2;3;4"));
}

TEST_F(ScriptLanguageTest, takesVariablesAndExpressionsAsTargets) {
  EXPECT_EQ(run("float[] p = {5,0,90,0,90,0}\r\np[0] = p[0] * 2\r\nbool made = "
                "PTP(\"J\"+\"PP\",p,50+50,200,0,!true)"),
            ok("1"));
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 10.0, 1e-9);
}

TEST_F(ScriptLanguageTest, movesToTheDoubleThatIsWritten) {
  EXPECT_EQ(run("PTP(\"JPP\",-10.1,0.1,90,-1.234567e-2,90,0,100,200,0,false)"), ok("1"));
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], -10.1, 1e-9);
  EXPECT_NEAR(robot.joints()[1], 0.1, 1e-9);
  EXPECT_NEAR(robot.joints()[3], -1.234567e-2, 1e-9);
  EXPECT_EQ(run("PTP(\"JPP\",{10.1,0.1,90,0,90,0},100,200,0,false)"), ok("1"));
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 10.1, 1e-9);
}

TEST_F(ScriptLanguageTest, takesNoTextForANumberOfAMotion) {
  EXPECT_EQ(run("ChangeLoad(\"5\")\r\nPTP(1,0,0,90,0,90,0,100,200,0,false)"), error("1", "1;2"));
}

TEST_F(ScriptLanguageTest, endsAScriptAtTheLineThatFailsAndSaysError) {
  EXPECT_EQ(run("int zero = 0\r\nQueueTag(1)\r\nint i = 1 / zero\r\nQueueTag(2)"),
            error("1", "3") + tag("01,true"));
  EXPECT_EQ(run("string name = \"Claw\"\r\nChangeTCP(name)"), error("1", "2"));
}

TEST_F(ScriptLanguageTest, findsAWrongFormatTagOrOutputWhenItIsComputed) {
  EXPECT_EQ(run("string f = \"TPP\"\r\nPTP(f,0,0,90,0,90,0,100,200,0,false)"), error("1", "2"));
  EXPECT_EQ(run("int n = 16\r\nQueueTag(n)"), error("1", "2"));
  EXPECT_EQ(run("int v = 2\r\nIO[\"EndModule\"].DO[0] = (byte)v"), error("1", "2"));
  EXPECT_EQ(robot.state().queued_motions, 0);
}

TEST_F(ScriptLanguageTest, sendsTheBytesOfAValueToAllClients) {
  const ClientId other = robot.connect();
  EXPECT_EQ(
      run("float[] f = {1,2}\r\nListenSend(91,f)\r\nListenSend(90,\"Hello\")\r\nint r = ListenSend(100,1)"),
      protocol::encodeFrame("TMSTA", std::string("91,\x00\x00\x80\x3f\x00\x00\x00\x40", 11)) + sent("Hello") +
          ok("1"));
  EXPECT_EQ(robot.heard(other).find(sent("Hello")) != std::string::npos, true);
  EXPECT_EQ(valueOf("r"), sent("-2") + ok("1")) << "there is no channel 100";
}

TEST_F(ScriptLanguageTest, seesWhatBecameOfATag) {
  robot.script(client, "1", std::string(kMove) + "QueueTag(1)\r\nListenSend(90,GetString(WaitQueueTag(1)))");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,true") + sent("1") + ok("1"));
  EXPECT_EQ(valueOf("WaitQueueTag(9)"), sent("-1") + ok("1"));
  robot.script(client, "2",
               "Move_PTP(\"JPP\",20,0,0,0,0,0,100,200,0,false)\r\nQueueTag(2)\r\n"
               "ListenSend(90,GetString(WaitQueueTag(2,20)))");
  robot.wait(20ms);
  EXPECT_EQ(robot.heard(client), sent("0") + ok("2"));
}

TEST_F(ScriptLanguageTest, lacksTheFunctionsThatAVersionDoesNotHave) {
  const std::string script =
      "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)\r\nPause()\r\nQueueTag(1)\r\nScriptExit(0)";
  const std::map<std::string, std::string> faulty{
      {"1.68", "2;3;4"}, {"1.72", "3;4"}, {"1.76", "4"}, {"1.80", "4"}};
  for (const auto& [version, lines] : faulty) {
    Settings settings;
    settings.tmflow_version = version;
    SimulatedRobot older(settings);
    EXPECT_EQ(run(older, older.connect(), script), error("1", lines)) << version;
  }
  SimulatedRobot newer(withPriorityCommands());
  EXPECT_EQ(run(newer, newer.connect(), script), ok("1"));
}

TEST_F(ScriptLanguageTest, waitsForTheTimeAloneSince182) {
  SimulatedRobot newer(withPriorityCommands());
  const ClientId to = newer.connect();
  newer.script(to, "1", std::string(kMove) + "WaitQueueTag(0,50)");
  newer.script(to, "2", "StopAndClearBuffer(0)");
  newer.wait(49ms);
  EXPECT_EQ(newer.heard(to), ok("2")) << "a stop does not release it";
  newer.wait(1ms);
  EXPECT_EQ(newer.heard(to), ok("1"));
  newer.script(to, "3", std::string(kMove) + "QueueTag(1)\r\nWaitQueueTag(1,0)");
  EXPECT_EQ(newer.heard(to), ok("3")) << "a time of 0 looks once";
}

TEST_F(ScriptLanguageTest, refusesByNameWhatIsNotSimulated) {
  EXPECT_EQ(run("Pause()\r\nVPoint[\"v\"].Value[0]=1"), error("1", "2"));
  std::string log;
  for (const LogLine& line : robot.log()) log += line.text + '\n';
  EXPECT_THAT(log, ::testing::HasSubstr("line 2: VPoint[..].Value is known, but not simulated"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
