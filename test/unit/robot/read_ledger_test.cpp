#include "cobot_command/robot/read_ledger.h"

#include <limits>

#include "table_checks.h"
#include <gmock/gmock.h>

#include "cobot_command/protocol/float_payload.h"

namespace cobot_command::robot {
namespace {

using namespace std::chrono_literals;
using script::AttributeRead;
using script::ProjectAttribute;
using ::testing::ElementsAre;
using Kind = ReadFailure::Kind;

constexpr Instant kDeadline{10s};
const AttributeRead kGripper{ProjectAttribute::TcpValue, "gripper"};
const AttributeRead kMass{ProjectAttribute::TcpMass, "gripper"};
const AttributeRead kTable{ProjectAttribute::BaseValue, "table"};

class ReadLedgerTest : public ::testing::Test {
 protected:
  void ask(const std::vector<AttributeRead>& reads = {kGripper, kMass, kTable}) {
    ledger.sent({"us 1", reads}, "7", kDeadline);
  }
  bool mark(const std::string& text = "us 1") { return ledger.take(protocol::ListenData{99, text}); }
  bool send(int channel, const std::vector<float>& numbers) {
    return ledger.take(protocol::ListenData{channel, protocol::floatPayload(numbers)});
  }
  void sendAll() {
    mark();
    send(90, {0, 0, 150, 0, 0, 0});
    send(91, {2.5F});
    send(90, {1, 2, 3, 4, 5, 6});
  }
  std::optional<ReadOutcome> reply(bool accepted = true, const std::vector<int>& lines = {},
                                   const std::string& id = "7") {
    return ledger.take(link::ScriptAnswered{id, protocol::ScriptReply{id, accepted, lines}});
  }
  void expectFailure(const std::optional<ReadOutcome>& outcome, Kind kind,
                     const std::vector<AttributeRead>& reads, const std::string& reason) {
    ASSERT_TRUE(outcome);
    ASSERT_FALSE(*outcome);
    EXPECT_EQ(outcome->error().kind, kind) << outcome->error().reason;
    EXPECT_EQ(outcome->error().reads, reads);
    EXPECT_EQ(outcome->error().reason, reason);
    EXPECT_FALSE(ledger.waiting());
  }
  void expectAll(const std::optional<ReadOutcome>& outcome) {
    ASSERT_TRUE(outcome);
    ASSERT_TRUE(*outcome) << outcome->error().reason;
    ASSERT_EQ((*outcome)->size(), 3U);
    const std::vector<ReadValue>& values = **outcome;
    EXPECT_EQ(values[0].read, kGripper);
    EXPECT_THAT(values[0].numbers, ElementsAre(0, 0, 150, 0, 0, 0));
    EXPECT_EQ(values[1].read, kMass);
    EXPECT_THAT(values[1].numbers, ElementsAre(2.5));
    EXPECT_EQ(values[2].read, kTable);
    EXPECT_THAT(values[2].numbers, ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_FALSE(ledger.waiting());
  }

  ReadLedger ledger;
};

TEST(ReadTable, isSound) {
  testing::expectSoundTable<ReadTable>(ReadState::Collecting, ReadEvent::End, ReadState::Idle);
}

TEST_F(ReadLedgerTest, givesAllValuesInTheOrderOfTheLinesWithTheReply) {
  EXPECT_FALSE(ledger.waiting());
  ask();
  EXPECT_TRUE(ledger.waiting());
  EXPECT_TRUE(mark());
  EXPECT_TRUE(send(90, {0, 0, 150, 0, 0, 0}));
  EXPECT_TRUE(send(91, {2.5F}));
  EXPECT_TRUE(send(90, {1, 2, 3, 4, 5, 6}));
  expectAll(reply());
  EXPECT_EQ(reply(), std::nullopt) << "a second time";
}

TEST_F(ReadLedgerTest, leavesToOthersWhatComesWhenNobodyHasAsked) {
  EXPECT_FALSE(send(90, {1, 2, 3, 4, 5, 6}));
  EXPECT_FALSE(mark());
  EXPECT_EQ(reply(), std::nullopt);
  EXPECT_EQ(ledger.advance(kDeadline + 1h), std::nullopt);
  EXPECT_EQ(ledger.lost("closed"), std::nullopt);
  EXPECT_EQ(ledger.nextDeadline(), std::nullopt);
}

// --- Told apart from other scripts.
TEST_F(ReadLedgerTest, leavesToOthersWhatComesBeforeItsMark) {
  ask();
  EXPECT_FALSE(send(90, {9, 9, 9, 9, 9, 9})) << "of a run_script that was sent before";
  EXPECT_FALSE(mark("them 1"));
  EXPECT_EQ(reply(true, {}, "6"), std::nullopt);
  EXPECT_FALSE(send(91, {9}));
  sendAll();
  expectAll(reply());
}

TEST_F(ReadLedgerTest, leavesToOthersWhatComesBehindTheReply) {
  ask();
  sendAll();
  ASSERT_TRUE(reply());
  EXPECT_FALSE(send(90, {9, 9, 9, 9, 9, 9}));
  EXPECT_FALSE(mark());
}

TEST_F(ReadLedgerTest, leavesToOthersWhatComesUnderOtherChannels) {
  ask();
  mark();
  EXPECT_FALSE(ledger.take(protocol::ListenData{95, "hello"}));
  EXPECT_FALSE(ledger.take(protocol::ListenData{99, "hello"}));
  sendAll();
  expectAll(reply());
}

TEST_F(ReadLedgerTest, takesTheLastOfTwoMarksForItsOwn) {
  ask();
  mark();  // of a second layer with the same name: its script ran first
  send(90, {9, 9, 9, 9, 9, 9});
  send(92, {9, 9, 9});
  sendAll();
  expectAll(reply());
}

TEST_F(ReadLedgerTest, forgetsWhatCameOfAReadingBefore) {
  ask();
  mark();
  send(90, {9, 9, 9, 9, 9, 9});
  ASSERT_TRUE(ledger.advance(kDeadline));
  EXPECT_FALSE(send(91, {9})) << "late";
  ask();
  EXPECT_FALSE(send(90, {9, 9, 9, 9, 9, 9})) << "late";
  sendAll();
  expectAll(reply());
}

// --- Refused.
TEST_F(ReadLedgerTest, namesWhatTheProjectDoesNotHave) {
  ask();
  expectFailure(
      reply(false, {2, 4}), Kind::Unknown, {kGripper, kTable},
      "the controller refuses TCP[\"gripper\"].Value, Base[\"table\"].Value: its project has no such "
      "name");
}

TEST_F(ReadLedgerTest, tellsOfAControllerWithoutListenSend) {
  ask();
  expectFailure(reply(false, {1, 2, 3, 4}), Kind::NoListenSend, {},
                "the controller refuses ListenSend(), which TMflow before 1.76 does not have");
}

TEST_F(ReadLedgerTest, tellsOfAnErrorInNoLineOfIt) {
  const std::string reason = "the controller refuses the read script, but no line of it";
  for (const std::vector<int>& lines : {std::vector<int>{},
                                        {0},
                                        {5},
                                        {-1},
                                        {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}}) {
    ask();
    expectFailure(reply(false, lines), Kind::Refused, {}, reason);
  }
}

TEST_F(ReadLedgerTest, tellsOfAScriptThatIsNotTaken) {
  ask();
  const protocol::CommunicationError error{protocol::CommunicationErrorCode::NotListening};
  expectFailure(ledger.take(link::ScriptAnswered{"7", error}), Kind::NotTaken, {}, protocol::describe(error));
}

// --- Not answered.
TEST_F(ReadLedgerTest, givesUpWhenItsTimeIsOver) {
  ask();
  EXPECT_EQ(ledger.nextDeadline(), kDeadline);
  EXPECT_EQ(ledger.advance(kDeadline - 1ns), std::nullopt);
  expectFailure(ledger.advance(kDeadline), Kind::NoAnswer, {}, "no reply in time to the read script");
  EXPECT_EQ(ledger.nextDeadline(), std::nullopt);
  EXPECT_EQ(reply(), std::nullopt) << "late";
}

TEST_F(ReadLedgerTest, givesUpWhenTheLinkDoes) {
  ask();
  sendAll();
  expectFailure(ledger.take(link::ScriptAnswered{"7", link::NoReply{}}), Kind::NoAnswer, {},
                "no reply to the read script");
  ask();
  expectFailure(ledger.lost("closed"), Kind::Lost, {}, "the link was lost: closed");
}

TEST_F(ReadLedgerTest, namesWhatDidNotCome) {
  ask();
  mark();
  send(90, {0, 0, 150, 0, 0, 0});
  expectFailure(
      reply(), Kind::Incomplete, {kMass, kTable},
      "the read script was done, but no data arrived for TCP[\"gripper\"].Mass, Base[\"table\"].Value");
  ask({kMass});
  send(91, {2});
  expectFailure(reply(), Kind::Incomplete, {kMass},
                "the read script was done, but no data arrived for TCP[\"gripper\"].Mass");
}

// --- What does not fit.
TEST_F(ReadLedgerTest, refusesWhatIsNoValueOfItsAttribute) {
  ask();
  mark();
  send(90, {0, 0, 150});
  EXPECT_TRUE(send(91, {2}));
  expectFailure(reply(), Kind::Payload, {kGripper},
                "TCP[\"gripper\"].Value: expected 6 floats in 24 bytes, found 12 bytes");
  ask({kMass});
  mark();
  send(91, {std::numeric_limits<float>::quiet_NaN()});
  expectFailure(reply(), Kind::Payload, {kMass},
                "TCP[\"gripper\"].Mass: expected finite numbers, number 1 of 1 is nan");
}

TEST_F(ReadLedgerTest, refusesWhatComesInAnotherOrder) {
  ask();
  mark();
  send(91, {2});
  send(90, {0, 0, 150, 0, 0, 0});
  send(90, {1, 2, 3, 4, 5, 6});
  expectFailure(reply(), Kind::Mixed, {},
                "TMSTA 91 arrived where 90 was expected for TCP[\"gripper\"].Value");
}

TEST_F(ReadLedgerTest, refusesMoreThanItAskedFor) {
  ask();
  sendAll();
  send(90, {9, 9, 9, 9, 9, 9});
  expectFailure(reply(), Kind::Mixed, {}, "TMSTA 90 arrived after the last answer");
}

TEST_F(ReadLedgerTest, hasNoValuesWhenItAsksForNone) {
  ask({});
  mark();
  const auto outcome = reply();
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_TRUE((*outcome)->empty());
}

}  // namespace
}  // namespace cobot_command::robot
