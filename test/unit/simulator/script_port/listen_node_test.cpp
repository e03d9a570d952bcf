// What the script port answers, byte for byte as in TM 1.3 to 1.6.
#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

class ListenNodeTest : public ::testing::Test {
 protected:
  std::string exchange(const std::string& bytes) {
    robot.heard(client);
    robot.send(client, bytes);
    return robot.heard(client);
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(ListenNodeTest, saysWhichNodeTheFlowIsIn) {
  EXPECT_EQ(exchange("$TMSTA,2,00,*41\r\n"), "$TMSTA,15,00,true,Listen1,*79\r\n");
}

TEST_F(ListenNodeTest, takesTheQueryOfTheVendorsDriverWithItsLowerCaseChecksum) {
  EXPECT_EQ(exchange("$TMSTA,3,00,,*6c\r\n"), exchange("$TMSTA,2,00,*41\r\n"));
}

TEST_F(ListenNodeTest, saysThatTheFlowIsNotInTheNode) {
  robot.script(client, "1", "ScriptExit()");
  EXPECT_EQ(exchange("$TMSTA,2,00,*41\r\n"), "$TMSTA,9,00,false,,*37\r\n");
}

TEST_F(ListenNodeTest, doesNotRepeatTheEntryMessageToOneWhoConnectsLater) {
  EXPECT_EQ(robot.heard(robot.connect()), "");
}

TEST_F(ListenNodeTest, answersNoneForATagThatItDoesNotKnow) {
  EXPECT_EQ(exchange("$TMSTA,5,01,15,*6F\r\n"), "$TMSTA,10,01,15,none,*7D\r\n");
  EXPECT_EQ(exchange("$TMSTA,5,01,88,*6B\r\n"), "$TMSTA,10,01,88,none,*79\r\n");
}

TEST_F(ListenNodeTest, refusesANegativeLengthWith01) {
  EXPECT_EQ(exchange("$TMSTA,-2,00,*6C\r\n"), "$CPERR,2,01,*49\r\n");
}

TEST_F(ListenNodeTest, refusesALengthThatIsNoNumberOrWrongWith01) {
  EXPECT_EQ(exchange("$TMSTA,x,00,*0B\r\n"), "$CPERR,2,01,*49\r\n");
  EXPECT_EQ(exchange("$TMSTA,1,00,*42\r\n"), "$CPERR,2,01,*49\r\n");
}

TEST_F(ListenNodeTest, refusesAWrongChecksumWith02) {
  EXPECT_EQ(exchange("$TMSTA,2,00,*42\r\n"), "$CPERR,2,02,*4A\r\n");
}

TEST_F(ListenNodeTest, refusesAHeaderInTheWrongCaseOrUnknownWith03) {
  EXPECT_EQ(exchange(protocol::encodeFrame("TMsta", "00")), "$CPERR,2,03,*4B\r\n");
  EXPECT_EQ(exchange(protocol::encodeFrame("TMXYZ", "00")), "$CPERR,2,03,*4B\r\n");
  EXPECT_EQ(exchange(protocol::encodeFrame("TMSVR", "1,11,")), "$CPERR,2,03,*4B\r\n");
}

TEST_F(ListenNodeTest, refusesAnUnknownStatusCommandWith04) {
  EXPECT_EQ(exchange("$TMSTA,4,XXXX,*47\r\n"), "$CPERR,2,04,*4C\r\n");
}

TEST_F(ListenNodeTest, refusesAScriptIdThatIsMissingOrHasOtherCharactersWith04) {
  for (const char* data : {",ScriptExit()", "a_b,ScriptExit()", "-1,ScriptExit()", "1 2,ScriptExit()", "1"}) {
    EXPECT_EQ(exchange(protocol::encodeFrame("TMSCT", data)), "$CPERR,2,04,*4C\r\n") << data;
  }
}

TEST_F(ListenNodeTest, checksTheLengthBeforeTheChecksumAndTheChecksumBeforeTheHeader) {
  EXPECT_EQ(exchange("$TMsta,-2,00,*00\r\n"), "$CPERR,2,01,*49\r\n");
  EXPECT_EQ(exchange("$TMsta,2,00,*00\r\n"), "$CPERR,2,02,*4A\r\n");
  EXPECT_EQ(exchange(protocol::encodeFrame("TMsta", "XXXX")), "$CPERR,2,03,*4B\r\n");
}

TEST_F(ListenNodeTest, checksTheDataBeforeTheMode) {
  robot.script(client, "1", "ScriptExit()");
  EXPECT_EQ(exchange(protocol::encodeFrame("TMSCT", "a_b,Pause()")), "$CPERR,2,04,*4C\r\n");
  EXPECT_EQ(exchange(protocol::encodeFrame("TMSCT", "ab,Pause()")), "$CPERR,2,F1,*3F\r\n");
}

TEST_F(ListenNodeTest, passesOverGarbageInSilence) {
  EXPECT_EQ(exchange("hello\r\n$TMSTA,2,00,*41\r\n"), "$TMSTA,15,00,true,Listen1,*79\r\n");
}

TEST_F(ListenNodeTest, takesAFrameInPieces) {
  const std::string frame = "$TMSTA,2,00,*41\r\n";
  std::string answer;
  for (const char byte : frame) {
    EXPECT_EQ(answer, "");
    answer += exchange(std::string(1, byte));
  }
  EXPECT_EQ(answer, "$TMSTA,15,00,true,Listen1,*79\r\n");
}

TEST_F(ListenNodeTest, takesSeveralFramesInOnePiece) {
  const std::string query = "$TMSTA,2,00,*41\r\n", answer = "$TMSTA,15,00,true,Listen1,*79\r\n";
  EXPECT_EQ(exchange(query + query + query), answer + answer + answer);
}

TEST_F(ListenNodeTest, takesHexadecimalAndBinaryLengths) {
  for (const char* length : {"0x2", "0b10"}) {
    const std::string body = "TMSTA," + std::string(length) + ",00,";
    char checksum[3];
    std::snprintf(checksum, sizeof checksum, "%02X", protocol::checksum(body));
    EXPECT_EQ(exchange("$" + body + "*" + checksum + "\r\n"), "$TMSTA,15,00,true,Listen1,*79\r\n");
  }
}

TEST_F(ListenNodeTest, takesAnEmptyLengthOnlyWhenItIsSetToDoSo) {
  const std::string frame = "$TMSCT,,1,ScriptExit(),*62\r\n";
  EXPECT_EQ(exchange(frame), "$CPERR,2,01,*49\r\n");
  Settings settings;
  settings.accept_empty_length = true;
  SimulatedRobot tolerant(settings);
  const ClientId bridge = tolerant.connect();
  tolerant.send(bridge, frame);
  EXPECT_EQ(tolerant.heard(bridge), "$TMSCT,4,1,OK,*5C\r\n");
}

TEST_F(ListenNodeTest, answersOnlyTheSenderButTellsEverybodyOfATag) {
  const ClientId other = robot.connect();
  robot.script(client, "1", "QueueTag(8)");
  EXPECT_EQ(robot.heard(client), ok("1") + "$TMSTA,10,01,08,true,*6D\r\n");
  EXPECT_EQ(robot.heard(other), "$TMSTA,10,01,08,true,*6D\r\n");
}

TEST_F(ListenNodeTest, sendsTheConfiguredMessageOnEachEntry) {
  Settings settings;
  settings.listen_node_message = "UltrasonicFail,-12131";
  SimulatedRobot named(settings);
  const ClientId one = named.connect(), two = named.connect();
  EXPECT_EQ(named.ask(one, "00"), protocol::encodeFrame("TMSTA", "00,true,UltrasonicFail,-12131"));
  named.script(one, "1", "ScriptExit()");
  named.wait(1s);
  EXPECT_EQ(named.heard(one), ok("1") + entered("UltrasonicFail,-12131"));
  EXPECT_EQ(named.heard(two), entered("UltrasonicFail,-12131"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
