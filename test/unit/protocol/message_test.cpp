#include "cobot_command/protocol/message.h"

#include "test_names.h"
#include <gmock/gmock.h>

#include "cobot_command/protocol/frame_decoder.h"

namespace cobot_command::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Message>
Message fromController(std::string header, std::string data) {
  const auto message = parseControllerMessage({std::move(header), std::move(data)});
  const auto* value = message ? std::get_if<Message>(&*message) : nullptr;
  EXPECT_NE(value, nullptr) << (message ? "another message" : message.error().message);
  return value == nullptr ? Message{} : *value;
}

template <class Message>
Message fromClient(std::string header, std::string data) {
  const auto message = parseClientMessage({std::move(header), std::move(data)});
  const auto* value = message ? std::get_if<Message>(&*message) : nullptr;
  EXPECT_NE(value, nullptr) << (message ? "another message" : message.error().message);
  return value == nullptr ? Message{} : *value;
}

TEST(ClientMessage, readsAScript) {
  const auto request = fromClient<ScriptRequest>("TMSCT", "a1,ChangeLoad(1),\r\nPause()");
  EXPECT_EQ(request.id, "a1");
  EXPECT_EQ(request.script, "ChangeLoad(1),\r\nPause()");
}

TEST(ClientMessage, readsAnEmptyScript) {
  EXPECT_EQ(fromClient<ScriptRequest>("TMSCT", "1,").script, "");
}

TEST(ClientMessage, readsTheListenNodeQueryInBothForms) {
  fromClient<ListenNodeQuery>("TMSTA", "00");
  fromClient<ListenNodeQuery>("TMSTA", "00,");
}

TEST(ClientMessage, readsATagQueryAlsoOfATagThatCannotBe) {
  EXPECT_EQ(fromClient<TagQuery>("TMSTA", "01,15").tag, 15);
  EXPECT_EQ(fromClient<TagQuery>("TMSTA", "01,88").tag, 88);
}

class MeaninglessClientData : public ::testing::TestWithParam<Frame> {};
INSTANTIATE_TEST_SUITE_P(
    ClientMessage, MeaninglessClientData,
    ::testing::Values(Frame{"TMSCT", ""}, Frame{"TMSCT", "Hello World"}, Frame{"TMSCT", ",Pause()"},
                      Frame{"TMSCT", "a_1,Pause()"}, Frame{"TMSCT", "a-1,Pause()"},
                      Frame{"TMSCT", " 1,Pause()"}, Frame{"TMSTA", ""}, Frame{"TMSTA", "XXXX"},
                      Frame{"TMSTA", "0"}, Frame{"TMSTA", "00,x"}, Frame{"TMSTA", "01"},
                      Frame{"TMSTA", "01,"}, Frame{"TMSTA", "01,x"}, Frame{"TMSTA", "01,-1"},
                      Frame{"TMSTA", "01,99999999999"}, Frame{"TMSTA", "01,01,true"}, Frame{"TMSTA", "02"},
                      Frame{"TMSTA", "90,x"}),
    [](const auto& test) { return testName(test.index, test.param.header + " " + test.param.data); });

TEST_P(MeaninglessClientData, isADataFault) {
  const auto message = parseClientMessage(GetParam());
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error().kind, MessageFault::Kind::Data);
  EXPECT_THAT(message.error().message, HasSubstr("expected"));
}

TEST(ClientMessage, refusesAHeaderThatNoClientSends) {
  for (const char* header : {"TMsct", "TMSVR", "CPERR", "X"}) {
    const auto message = parseClientMessage({header, "00"});
    ASSERT_FALSE(message);
    EXPECT_EQ(message.error().kind, MessageFault::Kind::UnknownHeader);
    EXPECT_THAT(message.error().message, HasSubstr(header));
  }
}

TEST(ControllerMessage, readsTheEntryMessageWhateverItsText) {
  EXPECT_EQ(fromController<ListenNodeEntered>("TMSCT", "0,Listen1").message, "Listen1");
  EXPECT_EQ(fromController<ListenNodeEntered>("TMSCT", "0,OK").message, "OK");
  EXPECT_EQ(fromController<ListenNodeEntered>("TMSCT", "0,a,b").message, "a,b");
  EXPECT_EQ(fromController<ListenNodeEntered>("TMSCT", "0,").message, "");
}

TEST(ControllerMessage, readsScriptReplies) {
  const auto accepted = fromController<ScriptReply>("TMSCT", "10,OK");
  EXPECT_EQ(accepted.id, "10");
  EXPECT_TRUE(accepted.accepted);
  EXPECT_TRUE(accepted.lines.empty());

  const auto warned = fromController<ScriptReply>("TMSCT", "diag,OK;2;13");
  EXPECT_EQ(warned.id, "diag");
  EXPECT_TRUE(warned.accepted);
  EXPECT_THAT(warned.lines, ElementsAre(2, 13));

  const auto refused = fromController<ScriptReply>("TMSCT", "3,ERROR;1;2;3");
  EXPECT_FALSE(refused.accepted);
  EXPECT_THAT(refused.lines, ElementsAre(1, 2, 3));
}

TEST(ControllerMessage, readsTheListenNodeStateInAllForms) {
  EXPECT_FALSE(fromController<ListenNodeState>("TMSTA", "00,false,").listening);
  EXPECT_FALSE(fromController<ListenNodeState>("TMSTA", "00,false").listening);
  const auto state = fromController<ListenNodeState>("TMSTA", "00,true,UltrasonicFail,-12131");
  EXPECT_TRUE(state.listening);
  EXPECT_EQ(state.message, "UltrasonicFail,-12131");
}

TEST(ControllerMessage, readsTagReports) {
  EXPECT_EQ(fromController<TagReport>("TMSTA", "01,08,true").tag, 8);
  EXPECT_EQ(fromController<TagReport>("TMSTA", "01,08,true").state, TagState::Complete);
  EXPECT_EQ(fromController<TagReport>("TMSTA", "01,01,false").state, TagState::Incomplete);
  EXPECT_EQ(fromController<TagReport>("TMSTA", "01,88,none").state, TagState::Unknown);
}

TEST(ControllerMessage, readsScriptDataOfAnyBytes) {
  const std::string payload("\0\r\n,*\xFF", 6);
  const auto data = fromController<ListenData>("TMSTA", "91," + payload);
  EXPECT_EQ(data.channel, 91);
  EXPECT_EQ(data.payload, payload);
  EXPECT_EQ(fromController<ListenData>("TMSTA", "90,").payload, "");
}

TEST(ControllerMessage, readsEveryCommunicationError) {
  using Code = CommunicationErrorCode;
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "00").code, Code::Ok);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "01").code, Code::Packet);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "02").code, Code::Checksum);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "03").code, Code::Header);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "04").code, Code::Data);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "F1").code, Code::NotListening);
  EXPECT_EQ(fromController<CommunicationError>("CPERR", "f1").code, Code::NotListening);
}

class MeaninglessControllerData : public ::testing::TestWithParam<Frame> {};
INSTANTIATE_TEST_SUITE_P(
    ControllerMessage, MeaninglessControllerData,
    ::testing::Values(Frame{"TMSCT", ""}, Frame{"TMSCT", "0"}, Frame{"TMSCT", "OK"}, Frame{"TMSCT", "1,NG"},
                      Frame{"TMSCT", "1,OK;"}, Frame{"TMSCT", "1,OK;x"}, Frame{"TMSCT", "1,OK2"},
                      Frame{"TMSCT", "1,OK;-2"}, Frame{"TMSCT", "1,ERROR; 2"},
                      Frame{"TMSCT", "1,ERROR;99999999999"}, Frame{"TMSCT", "a_b,OK"}, Frame{"TMSCT", ",OK"},
                      Frame{"TMSTA", ""}, Frame{"TMSTA", "00"}, Frame{"TMSTA", "00,maybe"},
                      Frame{"TMSTA", "01,08"}, Frame{"TMSTA", "01,x,true"}, Frame{"TMSTA", "01,08,True"},
                      Frame{"TMSTA", "01,08,true,"}, Frame{"TMSTA", "90"}, Frame{"TMSTA", "89,x"},
                      Frame{"TMSTA", "100,x"}, Frame{"TMSTA", "090,x"}, Frame{"CPERR", ""},
                      Frame{"CPERR", "05"}, Frame{"CPERR", "1"}, Frame{"CPERR", "001"}, Frame{"CPERR", "-1"}),
    [](const auto& test) { return testName(test.index, test.param.header + " " + test.param.data); });

TEST_P(MeaninglessControllerData, isADataFault) {
  const auto message = parseControllerMessage(GetParam());
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error().kind, MessageFault::Kind::Data);
}

TEST(ControllerMessage, refusesAHeaderThatNoControllerSendsOnThisPort) {
  for (const char* header : {"TMsct", "TMSVR", "X"}) {
    const auto message = parseControllerMessage({header, "00"});
    ASSERT_FALSE(message);
    EXPECT_EQ(message.error().kind, MessageFault::Kind::UnknownHeader);
  }
}

TEST(Encode, writesTheKnownFrames) {
  EXPECT_EQ(encode(ClientMessage(ListenNodeQuery{})), "$TMSTA,2,00,*41\r\n");
  EXPECT_EQ(encode(ClientMessage(TagQuery{1})), "$TMSTA,5,01,01,*6A\r\n");
  EXPECT_EQ(encode(ClientMessage(ScriptRequest{"17", "ScriptExit()"})), "$TMSCT,15,17,ScriptExit(),*51\r\n");
  EXPECT_EQ(encode(ControllerMessage(ListenNodeEntered{"Listen1"})), "$TMSCT,9,0,Listen1,*4C\r\n");
  EXPECT_EQ(encode(ControllerMessage(ScriptReply{"3", false, {1, 2, 3}})), "$TMSCT,13,3,ERROR;1;2;3,*3F\r\n");
  EXPECT_EQ(encode(ControllerMessage(ScriptReply{"2", true, {2, 3}})), "$TMSCT,8,2,OK;2;3,*52\r\n");
  EXPECT_EQ(encode(ControllerMessage(ListenNodeState{false, ""})), "$TMSTA,9,00,false,,*37\r\n");
  EXPECT_EQ(encode(ControllerMessage(ListenNodeState{true, "Listen1"})), "$TMSTA,15,00,true,Listen1,*79\r\n");
  EXPECT_EQ(encode(ControllerMessage(TagReport{8, TagState::Complete})), "$TMSTA,10,01,08,true,*6D\r\n");
  EXPECT_EQ(encode(ControllerMessage(TagReport{88, TagState::Unknown})), "$TMSTA,10,01,88,none,*79\r\n");
  EXPECT_EQ(encode(ControllerMessage(TagReport{1, TagState::Incomplete})), "$TMSTA,11,01,01,false,*0E\r\n");
  EXPECT_EQ(encode(ControllerMessage(ListenData{90, "Hello World"})), "$TMSTA,14,90,Hello World,*73\r\n");
  EXPECT_EQ(encode(ControllerMessage(CommunicationError{CommunicationErrorCode::NotListening})),
            "$CPERR,2,F1,*3F\r\n");
  EXPECT_EQ(encode(ControllerMessage(CommunicationError{})), "$CPERR,2,00,*48\r\n");
}

TEST(ScriptId, isLettersAndDigitsAndNotTheControllersOwnZero) {
  EXPECT_TRUE(isScriptId("1"));
  EXPECT_TRUE(isScriptId("00"));
  EXPECT_TRUE(isScriptId("aZ09"));
  EXPECT_FALSE(isScriptId(""));
  EXPECT_FALSE(isScriptId("0"));
  EXPECT_FALSE(isScriptId("a b"));
  EXPECT_FALSE(isScriptId("a_b"));
  EXPECT_FALSE(isScriptId("\u9054"));
}

TEST(Describe, tellsPeopleWhatAFrameSays) {
  const auto said = [](std::string header, std::string data) {
    return describe({std::move(header), std::move(data)});
  };
  EXPECT_EQ(said("TMSCT", "12,OK"), "script 12 accepted");
  EXPECT_EQ(said("TMSCT", "12,OK;2"), "script 12 accepted, warnings in line 2");
  EXPECT_EQ(said("TMSCT", "12,ERROR;1;2"), "script 12 refused, errors in lines 1 2");
  EXPECT_EQ(said("TMSCT", "0,Listen1"), "entered the Listen node: Listen1");
  EXPECT_EQ(said("TMSCT", "2,Pause()\r\nResume()\r\nPause()"), "run script 2: Pause() (and 2 more lines)");
  EXPECT_EQ(said("TMSTA", "00"), "in a Listen node?");
  EXPECT_EQ(said("TMSTA", "00,false,"), "not in a Listen node");
  EXPECT_EQ(said("TMSTA", "00,true,Listen1"), "in a Listen node: Listen1");
  EXPECT_EQ(said("TMSTA", "01,03"), "tag 3 complete?");
  EXPECT_EQ(said("TMSTA", "01,03,true"), "tag 3 complete");
  EXPECT_EQ(said("TMSTA", "01,03,false"), "tag 3 not complete");
  EXPECT_EQ(said("TMSTA", "01,88,none"), "tag 88 unknown");
  EXPECT_EQ(said("TMSTA", std::string("90,\0", 4)), "script data on 90: \\x00");
  EXPECT_EQ(said("CPERR", "02"), "controller: checksum error");
  EXPECT_EQ(said("TMSVR", "Q2,0,04,NotExist;X"), "answer to item request Q2: 04,NotExist;X");
  EXPECT_EQ(said("TMSCT", "1,\r\nPause()"), "run script 1: Pause()");
  EXPECT_EQ(said("TMSVR", "9,12,A"), "text items asked 9: A");
  EXPECT_EQ(said("TMSVR", "9,13,[]"), "JSON items asked 9: []");
  EXPECT_EQ(said("TMSVR", std::string("9,11,\x01\0A", 8)), "binary items asked 9: \\x01\\x00A");
  EXPECT_EQ(said("TMSVR", "9,2,A=1"), "text items 9: A=1");
  EXPECT_EQ(said("TMSVR", "9,3,[]"), "JSON items 9: []");
  EXPECT_EQ(said("TMSVR", std::string("0,1,\x01\0A\x01\0\x01", 10)), "binary items 0: A");
}

TEST(Describe, tellsWhyAFrameMeansNothing) {
  EXPECT_THAT(describe({"TMsct", "1,Pause()"}), HasSubstr("TMsct"));
  EXPECT_THAT(describe({"TMSTA", "XXXX"}), HasSubstr("XXXX"));
  EXPECT_THAT(describe({"CPERR", "99"}), HasSubstr("error code"));
  EXPECT_THAT(describe({"TMSVR", "S1,1,[{}]"}), HasSubstr("invalid content"));
  EXPECT_THAT(describe({"TMSVR", "S1,0,x"}), HasSubstr("invalid content"));
  EXPECT_THAT(describe({"TMSVR", "x"}), HasSubstr("expected"));
  EXPECT_THAT(describe({"TMSVR", "S1,99,x"}), HasSubstr("mode 99"));
}

}  // namespace
}  // namespace cobot_command::protocol
