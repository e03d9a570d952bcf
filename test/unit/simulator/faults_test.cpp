// The faults of the world, one by one: what a client then sees, and that it ends.
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "faults_fixture.h"
#include "source_tree.h"
#include "streamed_items.h"

namespace cobot_command::simulator::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kBack = "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)\r\nQueueTag(2)";

// --- Switches.
TEST_F(FaultsTest, happenAsOftenAsTheyAreCounted) {
  fault("refuse_script", 2);
  EXPECT_EQ(run("1", "Pause()"), error("1", "1"));
  EXPECT_EQ(run("2", "Pause()"), error("2", "1"));
  EXPECT_EQ(run("3", "Pause()"), ok("3"));
}

TEST_F(FaultsTest, standWithoutACountUntilTheyAreTurnedOff) {
  fault("refuse_script");
  for (int i = 0; i < 20; ++i) EXPECT_EQ(run("1", "Pause()"), error("1", "1"));
  off("refuse_script");
  EXPECT_EQ(run("2", "Pause()"), ok("2"));
}

TEST_F(FaultsTest, areAllTurnedOffTogether) {
  fault("refuse_script");
  fault("silence");
  fault("refuse_connections");
  robot.operate(ClearFaults{});
  client = robot.connect();
  EXPECT_EQ(run("1", "Pause()"), ok("1"));
}

TEST_F(FaultsTest, areRefusedByNameWithTheListOfAll) {
  const std::string text = refusal({"refuse_scripts", true, 0, 0, ""});
  EXPECT_THAT(text, HasSubstr("unknown fault \"refuse_scripts\""));
  for (const KnownFault& known : knownFaults()) EXPECT_THAT(text, HasSubstr(" " + known.name));
}

TEST_F(FaultsTest, areRefusedWithNumbersAndTextsThatAreNotForThem) {
  EXPECT_THAT(refusal({"refuse_script", true, -1, 0, ""}), HasSubstr("-1 times"));
  EXPECT_THAT(refusal({"refuse_script", true, 0, 0, "1;x"}), HasSubstr("1;x"));
  EXPECT_THAT(refusal({"cperr_script", true, 0, 0, "05"}), HasSubstr("F1"));
  EXPECT_THAT(refusal({"delay_reply", true, 0, 0, ""}), HasSubstr("0.001 to 60"));
  EXPECT_THAT(refusal({"delay_reply", true, 0, 61, ""}), HasSubstr("0.001 to 60"));
  EXPECT_THAT(refusal({"delay_reply", true, 0, std::nan(""), ""}), HasSubstr("0.001 to 60"));
  EXPECT_THAT(refusal({"silence", true, 1, 0, ""}), HasSubstr("cannot be counted"));
  EXPECT_THAT(refusal({"hide_items", true, 0, 0, ""}), HasSubstr("names"));
  EXPECT_THAT(refusal({"hide_items", true, 0, 0, "ESTOP Bogus"}), HasSubstr("Bogus"));
  EXPECT_THAT(refusal({"hide_items", true, 0, 0, "ESTOP,Robot_Model"}), HasSubstr("with blanks"));
  EXPECT_EQ(run("1", "Pause()"), ok("1")) << "and stay off";
}

TEST_F(FaultsTest, canAllBeTurnedOnAndOff) {
  for (const KnownFault& known : knownFaults()) {
    const std::string text = known.name == "hide_items" ? "ESTOP" : "";
    EXPECT_TRUE(robot.operate(SetFault{known.name, true, 0, 1.5, text}).done) << known.name;
    off(known.name);
    EXPECT_FALSE(known.meaning.empty());
  }
}

TEST_F(FaultsTest, standInTheManual) {
  std::ifstream file(test_support::inSourceTree("doc/simulator.md"));
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::regex on_messages("^(drop|delay|duplicate|corrupt)_");  // the page names them by kind
  for (const KnownFault& known : knownFaults()) {
    EXPECT_THAT(page, HasSubstr('`' + std::regex_replace(known.name, on_messages, "") + '`'));
  }
}

TEST_F(FaultsTest, canStandFromTheStart) {
  Settings settings;
  settings.faults.refuse_connections.on = true;
  EXPECT_THAT(SimulatedRobot(settings).events(), ElementsAre("+status"));
}

// --- Scripts.
TEST_F(FaultsTest, refuseAScriptWithTheGivenLinesAndDoNotExecuteIt) {
  fault("refuse_script", 1, "2;3");
  EXPECT_EQ(run("1", kMove), error("1", "2;3"));
  EXPECT_EQ(robot.joints()[0], 0.0);
}

TEST_F(FaultsTest, refuseAPriorityCommandToo) {
  fault("refuse_script", 1);
  EXPECT_EQ(run("1", "StopAndClearBuffer(2)"), error("1", "1"));
}

TEST_F(FaultsTest, ignoreAScript) {
  fault("ignore_script", 1);
  EXPECT_EQ(run("1", kMove), "");
  EXPECT_EQ(robot.joints()[0], 0.0);
  EXPECT_EQ(run("2", kMove), ok("2") + tag("01,true"));
}

TEST_F(FaultsTest, answerAScriptWithACommunicationError) {
  for (const char* code : {"00", "01", "02", "03", "04", "F1"}) {
    fault("cperr_script", 1, code);
    EXPECT_EQ(run("1", kMove), protocol::encodeFrame("CPERR", code));
  }
  EXPECT_EQ(robot.joints()[0], 0.0);
}

TEST_F(FaultsTest, answerWithTheIdOfNoScript) {
  fault("wrong_id", 1);
  EXPECT_EQ(run("7", "Pause()"), ok("7x"));
  EXPECT_EQ(run("8", "Pause()"), ok("8"));
}

TEST_F(FaultsTest, refuseToStop) {
  fault("refuse_stop", 1);
  robot.script(client, "1", kMove);
  EXPECT_EQ(run("2", "Pause()\r\nStopAndClearBuffer()"), ok("1") + error("2", "2") + tag("01,true"));
  fault("refuse_stop", 1);
  EXPECT_EQ(run("3", "Resume()"), ok("3")) << "which is no stop";
  EXPECT_EQ(run("4", "StopAndClearBuffer(1)"), error("4", "1"));
  EXPECT_EQ(run("5", "StopAndClearBuffer(1)"), ok("5"));
}

TEST_F(FaultsTest, refuseToSendWhatScriptsKnow) {
  fault("refuse_listen_send");
  EXPECT_EQ(run("1", "Pause()\r\nListenSend(90,1)\r\nint sent = ListenSend(91,TCP[\"NOTOOL\"].Mass)"),
            error("1", "2;3"));
  EXPECT_FALSE(robot.state().project_paused) << "nothing of it is executed";
  EXPECT_EQ(run("2", "Resume()"), ok("2")) << "which sends nothing";
  off("refuse_listen_send");
  EXPECT_EQ(run("3", "ListenSend(90,\"x\")"), protocol::encodeFrame("TMSTA", "90,x") + ok("3"));
}

TEST_F(FaultsTest, countRefusedSendsByScripts) {
  fault("refuse_listen_send", 1);
  EXPECT_EQ(run("1", "Pause()"), ok("1"));
  EXPECT_EQ(run("2", "ListenSend(90,1)"), error("2", "1"));
  EXPECT_EQ(run("3", "ListenSend(90,\"x\")"), protocol::encodeFrame("TMSTA", "90,x") + ok("3"));
}

TEST_F(FaultsTest, doNotStopThoughTheySaySo) {
  for (const char* stop : {"StopAndClearBuffer()", "StopAndClearBuffer(2)"}) {
    fault("ignore_stop", 1);
    robot.script(client, "1", kMove);
    EXPECT_EQ(run("2", stop), ok("1") + ok("2") + tag("01,true"));
    EXPECT_NEAR(robot.joints()[0], 20.0, 1e-9);
    run("3", kBack);
  }
}

// --- Tags.
TEST_F(FaultsTest, reportATagFalseThoughTheMotionWasMade) {
  fault("false_tag", 1);
  EXPECT_EQ(run("1", kMove), ok("1") + tag("01,false"));
  EXPECT_NEAR(robot.joints()[0], 20.0, 1e-9);
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,false"));
  EXPECT_EQ(run("2", kBack), ok("2") + tag("02,true"));
}

TEST_F(FaultsTest, reportATagBeforeTheMotionIsMadeAndNotAgain) {
  fault("early_tag", 1);
  robot.script(client, "1", kMove);
  EXPECT_EQ(robot.heard(client), tag("01,true") + ok("1"));
  EXPECT_EQ(robot.joints()[0], 0.0);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(run("2", kBack), ok("2") + tag("02,true"));
}

TEST_F(FaultsTest, loseTheReportOfATagThatCanStillBeAskedFor) {
  fault("drop_tag", 1);
  EXPECT_EQ(run("1", kMove), ok("1"));
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,true"));
}

TEST_F(FaultsTest, reportDroppedTagsWithTheNextMotionAsOftenAsTheyAreCounted) {
  fault("stale_tag", 1);
  for (const std::string& stale : {tag("01,true"), std::string()}) {
    robot.script(client, "1", kMove);
    robot.script(client, "2", "StopAndClearBuffer()");
    robot.waitUntilIdle();
    robot.heard(client);
    EXPECT_EQ(run("3", kBack), ok("3") + stale + tag("02,true"));
  }
}

TEST_F(FaultsTest, answerTheQuestionForATagWrongly) {
  run("1", kMove);
  fault("query_none", 1);
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,none"));
  fault("query_false", 1);
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,false"));
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,true"));
}

// --- Messages on their way.
TEST_F(FaultsTest, dropTheReplyToAScriptThatIsExecuted) {
  fault("drop_reply", 1);
  EXPECT_EQ(run("1", kMove), tag("01,true"));
  EXPECT_NEAR(robot.joints()[0], 20.0, 1e-9);
}

TEST_F(FaultsTest, delayAMessageAndLetOthersOvertakeIt) {
  fault("delay_reply", 1, "", 0.25);
  robot.script(client, "1", "Resume()");
  robot.script(client, "2", "Resume()");
  EXPECT_EQ(robot.heard(client), ok("2"));
  robot.wait(250ms - 1ns);
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(robot.controller().nextEvent(), robot.now() + 1ns);
  robot.wait(1ns);
  EXPECT_EQ(robot.heard(client), ok("1"));
}

TEST_F(FaultsTest, bringTheTagBeforeTheOkByDelayingThat) {
  fault("delay_reply", 1, "", 10);
  EXPECT_EQ(run("1", kMove), tag("01,true") + ok("1"));
}

TEST_F(FaultsTest, sendAMessageTwice) {
  fault("duplicate_reply", 1);
  fault("duplicate_tag", 1);
  EXPECT_EQ(run("1", kMove), ok("1") + ok("1") + tag("01,true") + tag("01,true"));
  EXPECT_EQ(run("2", kBack), ok("2") + tag("02,true"));
}

TEST_F(FaultsTest, spoilAChecksum) {
  fault("corrupt_reply", 1);
  robot.script(client, "1", "Resume()");
  protocol::FrameDecoder decoder;
  decoder.feed(robot.heard(client));
  const auto event = decoder.next();
  ASSERT_TRUE(event && std::holds_alternative<protocol::DecodeFault>(*event));
  EXPECT_EQ(std::get<protocol::DecodeFault>(*event).kind, protocol::DecodeFault::Kind::Checksum);
}

TEST_F(FaultsTest, canBeOnOneMessageTogether) {
  fault("duplicate_state", 1);
  fault("delay_state", 1, "", 1);
  EXPECT_EQ(robot.ask(client, "00"), "");
  robot.wait(1s);
  EXPECT_EQ(robot.heard(client), kListening + kListening);
}

TEST_F(FaultsTest, actOnTheKindOfMessageThatTheyAreFor) {
  const ClientId status = robot.connect(Port::Status);
  for (const char* kind : {"entry", "state", "tag_answer", "cperr", "item_answer"}) {
    fault(std::string("drop_") + kind, 1);
  }
  EXPECT_EQ(robot.ask(client, "00"), "");
  EXPECT_EQ(robot.ask(client, "00"), kListening);
  EXPECT_EQ(robot.ask(client, "01,09"), "");
  EXPECT_EQ(robot.ask(client, "01,09"), tag("09,none"));
  EXPECT_EQ(robot.ask(client, "XXXX"), "");
  EXPECT_EQ(robot.ask(client, "XXXX"), "$CPERR,2,04,*4C\r\n");
  const auto entry = [&] {
    robot.operate(LeaveListenNode{});
    robot.operate(EnterListenNode{});
    return robot.heard(client);
  };
  EXPECT_EQ(entry(), "");
  EXPECT_EQ(entry(), entered());
  const auto request = [&] {
    robot.send(status, protocol::encode(protocol::StatusFrame{"q", 11, readRequest({"ESTOP"})}),
               Port::Status);
    return framesIn(robot.heard(status)).size();
  };
  EXPECT_EQ(request(), 0U);
  EXPECT_EQ(request(), 1U);
}

TEST_F(FaultsTest, countAMessageOnceHoweverManyClientsGetIt) {
  const ClientId other = robot.connect();
  fault("drop_tag", 1);
  robot.script(client, "1", std::string(kMove) + "\r\nQueueTag(2)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + tag("02,true"));
  EXPECT_EQ(robot.heard(other), tag("02,true"));
}

TEST_F(FaultsTest, sendNothingLateToAClientThatIsGone) {
  fault("delay_reply", 1, "", 1);
  robot.script(client, "1", "Resume()");
  robot.disconnect(client);
  robot.wait(2s);
  EXPECT_EQ(robot.heard(client), "");
}

// --- The log.
TEST_F(FaultsTest, areInTheLogOfTheTraffic) {
  fault("drop_reply", 1);
  robot.script(client, "1", "Resume()");
  EXPECT_EQ(robot.log().back().text, "fault: not sent: script 1 accepted");
}

}  // namespace
}  // namespace cobot_command::simulator::test
