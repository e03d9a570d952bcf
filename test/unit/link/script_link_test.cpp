// What the script link makes of answers, of those that are missing, and of exits. Its table:
// script_link_rows_test.cpp.

#include <functional>
#include <map>

#include "script_link_fixture.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using State = ScriptLinkState;
using Event = ScriptLinkEvent;

TEST_F(ScriptLinkTest, asksForTheListenNodeAsSoonAsItIsConnected) {
  bringTo(State::Probing);
  ASSERT_EQ(wire.sent.size(), 1u);
  EXPECT_EQ(wire.sent[0], "$TMSTA,2,00,*41\r\n");
  EXPECT_EQ(wire.opened, std::vector<std::string>{"robot:5890"});
}

TEST_F(ScriptLinkTest, matchesScriptRepliesById) {
  bringTo(State::Ready);
  const std::string first = link.sendScript("PTP(...)", now);
  const std::string second = link.sendScript("PTP(...)", now);
  EXPECT_NE(first, second);
  say(protocol::ScriptReply{second, true, {}});
  say(protocol::ScriptReply{first, false, {1}});
  const auto answers = all<ScriptAnswered>();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0].id, second);
  EXPECT_EQ(answers[1].id, first);
  say(protocol::ScriptReply{first, true, {}});
  EXPECT_EQ(all<ScriptAnswered>().size(), 2u);
  EXPECT_EQ(link.requests().late(), 1u);
}

TEST_F(ScriptLinkTest, givesACommunicationErrorToTheOldestFrame) {
  bringTo(State::Ready);
  const std::string first = link.sendScript("A()", now);
  link.queryTag(3, now);
  say(CommunicationError{CommunicationErrorCode::Checksum});
  ASSERT_EQ(all<ScriptAnswered>().size(), 1u);
  EXPECT_EQ(all<ScriptAnswered>()[0].id, first);
  say(CommunicationError{CommunicationErrorCode::Data});
  ASSERT_EQ(all<TagQueryFailed>().size(), 1u);
  EXPECT_EQ(all<TagQueryFailed>()[0].tag, 3);
  say(CommunicationError{CommunicationErrorCode::Data});
  EXPECT_EQ(link.requests().late(), 1u);
}

TEST_F(ScriptLinkTest, givesF1ToTheOldestScript) {
  bringTo(State::Ready);
  link.queryTag(3, now);
  const std::string script = link.sendScript("A()", now);
  say(CommunicationError{CommunicationErrorCode::NotListening});
  ASSERT_EQ(all<ScriptAnswered>().size(), 1u);
  EXPECT_EQ(all<ScriptAnswered>()[0].id, script);
  EXPECT_EQ(link.state(), State::NotListening);
  EXPECT_TRUE(all<TagQueryFailed>().empty());
}

TEST_F(ScriptLinkTest, tellsTagReportsFromAnswers) {
  bringTo(State::Ready);
  say(protocol::TagReport{2, protocol::TagState::Complete});
  link.queryTag(2, now);
  say(protocol::TagReport{3, protocol::TagState::Complete});
  say(protocol::TagReport{2, protocol::TagState::Incomplete});
  const auto reports = all<TagReported>();
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_FALSE(reports[0].asked);
  EXPECT_FALSE(reports[1].asked);
  EXPECT_TRUE(reports[2].asked);
  EXPECT_EQ(reports[2].state, protocol::TagState::Incomplete);
}

TEST_F(ScriptLinkTest, tellsOfMissingReplies) {
  bringTo(State::Ready);
  const std::string id = link.sendScript("A()", now);
  link.queryTag(4, now);
  advanceToDeadline();  // the frames are out: their time begins
  now += settings.reply_timeout;
  link.advance(now);
  drain();
  ASSERT_EQ(all<ScriptAnswered>().size(), 1u);
  EXPECT_EQ(all<ScriptAnswered>()[0].id, id);
  EXPECT_TRUE(std::holds_alternative<NoReply>(all<ScriptAnswered>()[0].answer));
  ASSERT_EQ(all<TagQueryFailed>().size(), 1u);
  say(protocol::ScriptReply{id, true, {}});
  EXPECT_EQ(link.requests().late(), 1u);
}

TEST_F(ScriptLinkTest, stopsBeingInterestedInTheMiddleOfASegment) {
  bringTo(State::Ready);
  const std::string id = link.sendScript("A()", now);
  link.received(protocol::encode(protocol::ScriptReply{id, true, {}}) +
                protocol::encode(ListenNodeEntered{"Listen9"}));
  EXPECT_TRUE(std::holds_alternative<ScriptAnswered>(*link.next(now)));
  link.stop(now);
  drain();
  EXPECT_EQ(link.state(), State::Disconnected);
  EXPECT_EQ(link.listenNode(), "");
}

TEST_F(ScriptLinkTest, takesBackTheAnswersOfAnOldConnection) {
  bringTo(State::Ready);
  const std::string id = link.sendScript("A()", now);
  link.received("$TMSCT,4,1");
  link.closed("gone", now);
  drain();
  advanceToDeadline();
  link.opened(now);
  say(ListenNodeState{true, "Listen1"});
  EXPECT_EQ(link.state(), State::Ready) << "the half frame of before is forgotten";
  say(protocol::ScriptReply{id, true, {}});
  EXPECT_EQ(link.requests().late(), 1u);
  EXPECT_TRUE(all<ScriptAnswered>().empty());
}

TEST_F(ScriptLinkTest, saysWhatComesInPlaceOfAnAnswer) {
  bringTo(State::Probing);
  say(CommunicationError{CommunicationErrorCode::Data});
  advanceToDeadline();
  EXPECT_THAT(link.diagnosis(), HasSubstr("received: CPERR (controller: data error)"));
  EXPECT_EQ(link.trouble(), Trouble::OtherAnswers);
  say(protocol::TagReport{3, protocol::TagState::Complete});
  advanceToDeadline();
  EXPECT_THAT(link.diagnosis(), HasSubstr("received: TMSTA (tag 3 complete)"));
  while (link.state() == State::Probing) advanceToDeadline();
  advanceToDeadline();
  link.opened(now);
  advanceToDeadline();
  EXPECT_EQ(link.trouble(), Trouble::Silent) << "of this connection";
}

/// Whoever drives the link may be long busy, with planning say, before its bytes go out.
TEST_F(ScriptLinkTest, countsTheTimeForAnAnswerFromTheFirstLookAtTheClockBehindTheFrame) {
  bringTo(State::Ready);
  const std::string id = link.sendScript("PTP", now);
  link.queryTag(3, now);
  EXPECT_EQ(link.nextDeadline(), now) << "to be looked at at once";
  now += 20s;
  link.advance(now);
  drain();
  EXPECT_TRUE(all<ScriptAnswered>().empty());
  EXPECT_TRUE(all<TagQueryFailed>().empty());
  now += settings.reply_timeout - 1ns;
  link.advance(now);
  drain();
  EXPECT_TRUE(all<ScriptAnswered>().empty());
  now += 1ns;
  link.advance(now);
  drain();
  ASSERT_EQ(all<ScriptAnswered>().size(), 1u);
  EXPECT_EQ(all<ScriptAnswered>()[0].id, id);
  EXPECT_EQ(all<TagQueryFailed>().size(), 1u);
}

TEST_F(ScriptLinkTest, isReadyAgainWhenTheEntryMessageBehindAScriptExitWasLost) {
  bringTo(State::Leaving);
  before = State::Leaving;
  make(Event::AnsweredTrue);
  make(Event::AnsweredTrue);
  EXPECT_EQ(link.state(), State::Leaving) << "a controller that is still leaving may say so";
  make(Event::AnsweredTrue);
  EXPECT_EQ(link.state(), State::Ready);
  EXPECT_EQ(link.listenNode(), "Listen2");
  EXPECT_EQ(link.trouble(), Trouble::None);
}

TEST_F(ScriptLinkTest, countsTheAnswersBehindEachScriptExitAnew) {
  bringTo(State::Leaving);
  before = State::Leaving;
  make(Event::AnsweredTrue);
  make(Event::AnsweredTrue);
  make(Event::NodeEntered);
  link.exitAccepted(now);
  make(Event::AnsweredTrue);
  make(Event::AnsweredTrue);
  EXPECT_EQ(link.state(), State::Leaving);
}

TEST_F(ScriptLinkTest, sendsScriptsInEveryStateWithAConnection) {
  for (const State state : {State::Probing, State::NotListening, State::Leaving, State::Ready}) {
    testing::RecordingWire fresh_wire;
    ScriptLink fresh(settings, fresh_wire);
    fresh.start("robot", 5890, now);
    EXPECT_FALSE(fresh.connected());
    fresh.opened(now);
    if (state != State::Probing) {
      fresh.received(
          protocol::encode(protocol::ControllerMessage(ListenNodeState{state != State::NotListening, "L"})));
      while (fresh.next(now)) {
      }
    }
    if (state == State::Leaving) fresh.exitAccepted(now);
    ASSERT_EQ(fresh.state(), state);
    EXPECT_TRUE(fresh.connected());
    const std::string id = fresh.sendScript("StopAndClearBuffer()", now);
    EXPECT_THAT(fresh_wire.sent.back(), HasSubstr(id + ",StopAndClearBuffer()"));
  }
}

TEST_F(ScriptLinkTest, passesOnWhatAScriptSendsAndChangesNothing) {
  bringTo(State::Ready);
  const std::string payload("$,*\r\n\0", 6);
  say(protocol::ListenData{90, payload});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(all<protocol::ListenData>().at(0).channel, 90);
  EXPECT_EQ(all<protocol::ListenData>().at(0).payload, payload);
  EXPECT_EQ(link.state(), State::Ready);
  EXPECT_EQ(link.decodeFaults(), 0u);
  EXPECT_THAT(wire.traced.back(), HasSubstr("$TMSTA,"));
}

// Which script it is of, only the order tells.
TEST_F(ScriptLinkTest, passesOnWhatScriptsSendInTheOrderOfTheWire) {
  bringTo(State::Ready);
  const std::string first = link.sendScript("ListenSend(90,1)", now);
  const std::string second = link.sendScript("ListenSend(91,2)", now);
  receive(protocol::encode(protocol::ControllerMessage(protocol::ListenData{90, "1"})) +
          protocol::encode(protocol::ControllerMessage(protocol::ScriptReply{first, true, {}})) +
          protocol::encode(protocol::ControllerMessage(protocol::ListenData{91, "2"})) +
          protocol::encode(protocol::ControllerMessage(protocol::ScriptReply{second, true, {}})));
  std::string order;
  for (const auto& output : outputs) {
    if (const auto* data = std::get_if<protocol::ListenData>(&output)) order += data->payload + ' ';
    if (const auto* answer = std::get_if<ScriptAnswered>(&output)) {
      order += (answer->id == first ? "first " : "second ");
    }
  }
  EXPECT_EQ(order, "1 first 2 second ");
}

}  // namespace
}  // namespace cobot_command::link
