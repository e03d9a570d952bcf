// The script link, row by row of its table, with the events that fire them.

#include "cobot_command/link/script_link.h"

#include <functional>
#include <map>

#include "recording_wire.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using State = ScriptLinkState;
using Event = ScriptLinkEvent;
using protocol::CommunicationError;
using protocol::CommunicationErrorCode;
using protocol::ListenNodeEntered;
using protocol::ListenNodeState;

class ScriptLinkTest : public ::testing::Test {
 protected:
  void say(const protocol::ControllerMessage& message) { receive(protocol::encode(message)); }
  void receive(const std::string& bytes) {
    link.received(bytes);
    drain();
  }
  void drain() {
    while (auto output = link.next(now)) outputs.push_back(*output);
  }
  template <class Output>
  std::vector<Output> all() const {
    std::vector<Output> found;
    for (const auto& output : outputs) {
      if (const auto* wanted = std::get_if<Output>(&output)) found.push_back(*wanted);
    }
    return found;
  }
  void advanceToDeadline() {
    now = std::max(now, *link.nextDeadline());
    link.advance(now);
    drain();
  }

  /// Brings a fresh link to a state, as a controller would.
  void bringTo(State state) {
    if (state == State::Disconnected) return;
    link.start("robot", 5890, now);
    if (state == State::BackingOff) link.openFailed({OpenFailure::Kind::Refused, "refused"}, now);
    if (state == State::BackingOff || state == State::Connecting) return drain();
    link.opened(now);
    if (state == State::Probing) return drain();
    say(ListenNodeState{state != State::NotListening, "Listen1"});
    if (state == State::Leaving) link.exitAccepted(now);
    drain();
    outputs.clear();
  }

  /// Makes an event happen from the outside.
  void make(Event event) {
    switch (event) {
      case Event::Start:
        link.start("robot", 5890, now);
        break;
      case Event::RetryDue:
      case Event::NoAnswer:
        for (int i = 0; i < 5 && link.nextDeadline() && link.state() == before; ++i) advanceToDeadline();
        break;
      case Event::Opened:
        link.opened(now);
        break;
      case Event::OpenFailed:
        link.openFailed({OpenFailure::Kind::TimedOut, "timed out"}, now);
        break;
      case Event::AnsweredTrue:
      case Event::AnsweredFalse:
        askedAgain();
        say(ListenNodeState{event == Event::AnsweredTrue, "Listen2"});
        break;
      case Event::NodeEntered:
        say(ListenNodeEntered{"Listen3"});
        break;
      case Event::NodeLeft:
        say(CommunicationError{CommunicationErrorCode::NotListening});
        break;
      case Event::ExitAccepted:
        link.exitAccepted(now);
        break;
      case Event::StillListening:
        for (int i = 0; i < 3; ++i) {
          askedAgain();
          say(ListenNodeState{true, "Listen2"});
        }
        break;
      case Event::ForeignPeer:
        receive(protocol::encode(protocol::StatusFrame{"0", 1, ""}));
        break;
      case Event::Closed:
        link.closed("gone", now);
        break;
      case Event::Stop:
        link.stop(now);
        break;
    }
    drain();
  }
  void askedAgain() {
    const std::size_t sent = wire.sent.size();
    if (before == State::Probing) return;
    for (int i = 0; i < 3 && link.nextDeadline() && wire.sent.size() == sent; ++i) advanceToDeadline();
  }

  testing::RecordingWire wire;
  LinkSettings settings;
  ScriptLink link{settings, wire};
  Instant now{100s};
  State before = State::Disconnected;
  std::vector<ScriptLinkOutput> outputs;
};

struct Case {
  State state;
  Event event;
};

class ScriptLinkRows : public ScriptLinkTest, public ::testing::WithParamInterface<Case> {};

TEST_P(ScriptLinkRows, isFollowed) {
  const auto row = *findTransition<ScriptLinkTable>(GetParam().state, GetParam().event);
  bringTo(row.from);
  ASSERT_EQ(link.state(), row.from);
  before = row.from;
  make(row.event);
  EXPECT_EQ(link.state(), row.to);
  EXPECT_EQ(all<LinkLost>().size(), row.action == ScriptLinkAction::Lose ? 1u : 0u);
  EXPECT_EQ(link.nextDeadline().has_value(), row.to != State::Disconnected && row.to != State::Connecting);
  EXPECT_FALSE(link.diagnosis().empty());
  const bool down = row.to == State::BackingOff || row.to == State::Disconnected;
  const bool by_peer = row.event == Event::Closed || row.event == Event::OpenFailed;
  const bool had_connection = row.from != State::BackingOff && !by_peer;
  EXPECT_EQ(wire.closed.size(), down && had_connection ? 1u : 0u);
}

std::vector<Case> listedPairs() {
  std::vector<Case> cases;
  for (const auto& row : ScriptLinkTable::kRows) cases.push_back({row.from, row.event});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Table, ScriptLinkRows, ::testing::ValuesIn(listedPairs()));

class UnlistedPairs : public ScriptLinkTest, public ::testing::WithParamInterface<Case> {};

TEST_P(UnlistedPairs, changeNothing) {
  ASSERT_FALSE(findTransition<ScriptLinkTable>(GetParam().state, GetParam().event));
  bringTo(GetParam().state);
  outputs.clear();
  const std::size_t sent = wire.sent.size();
  const std::size_t opened = wire.opened.size();
  before = GetParam().state;
  make(GetParam().event);
  EXPECT_EQ(link.state(), GetParam().state);
  EXPECT_EQ(wire.sent.size(), sent);
  EXPECT_EQ(wire.opened.size(), opened);
  EXPECT_TRUE(wire.closed.empty());
  EXPECT_TRUE(all<LinkLost>().empty());
}

// Those that can be brought about from outside; the others never come to the table.
INSTANTIATE_TEST_SUITE_P(
    Table, UnlistedPairs,
    ::testing::Values(Case{State::Disconnected, Event::Stop}, Case{State::BackingOff, Event::Start},
                      Case{State::BackingOff, Event::ExitAccepted}, Case{State::Probing, Event::Start},
                      Case{State::Probing, Event::Opened}, Case{State::Probing, Event::NodeLeft},
                      Case{State::NotListening, Event::ExitAccepted},
                      Case{State::NotListening, Event::ForeignPeer},
                      Case{State::Leaving, Event::ExitAccepted}, Case{State::Leaving, Event::ForeignPeer},
                      Case{State::Ready, Event::Start}, Case{State::Ready, Event::Opened},
                      Case{State::Ready, Event::ForeignPeer}));

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
  EXPECT_THAT(link.diagnosis(), HasSubstr("all that comes is CPERR (controller: data error)"));
  EXPECT_EQ(link.trouble(), Trouble::OtherAnswers);
  say(protocol::TagReport{3, protocol::TagState::Complete});
  advanceToDeadline();
  EXPECT_THAT(link.diagnosis(), HasSubstr("all that comes is TMSTA (tag 3 complete)"));
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
