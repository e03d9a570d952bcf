// Who waits for what: requests by id, tags by number and epoch.

#include <gtest/gtest.h>

#include "cobot_command/link/back_off.h"
#include "cobot_command/link/request_ledger.h"
#include "cobot_command/link/tag_ledger.h"

namespace cobot_command::link {
namespace {

using namespace std::chrono_literals;

Request script(std::string id, std::optional<Duration> patience = std::nullopt) {
  Request request;
  request.kind = Request::Kind::Script;
  request.script_id = std::move(id);
  request.handed_over = Instant(1s);
  request.patience = patience;
  return request;
}

Request tagQuery(int tag, std::optional<Duration> patience = std::nullopt) {
  Request request;
  request.kind = Request::Kind::TagQuery;
  request.tag = tag;
  request.patience = patience;
  return request;
}

TEST(RequestLedger, givesEveryScriptAnIdOfItsOwnAlsoAfterAReconnect) {
  RequestLedger ledger;
  EXPECT_EQ(ledger.newScriptId(), "1");
  EXPECT_EQ(ledger.newScriptId(), "2");
  ledger.clear();
  EXPECT_EQ(ledger.newScriptId(), "3");
}

TEST(RequestLedger, matchesIdsExactlyAndOnce) {
  RequestLedger ledger;
  ledger.add(script("12"));
  EXPECT_FALSE(ledger.takeScript("1"));
  EXPECT_FALSE(ledger.takeScript("2"));
  EXPECT_FALSE(ledger.takeScript("012"));
  EXPECT_TRUE(ledger.takeScript("12"));
  EXPECT_FALSE(ledger.takeScript("12"));
}

TEST(RequestLedger, tellsTheKindsApart) {
  RequestLedger ledger;
  ledger.add(Request{});
  ledger.add(tagQuery(3));
  ledger.add(script("1"));
  EXPECT_FALSE(ledger.takeTagQuery(4));
  EXPECT_EQ(ledger.takeOldestScript()->script_id, "1");
  EXPECT_EQ(ledger.takeOldest()->kind, Request::Kind::NodeQuery);
  EXPECT_FALSE(ledger.takeNodeQuery());
  EXPECT_EQ(ledger.takeTagQuery(3)->tag, 3);
  EXPECT_FALSE(ledger.takeOldest());
}

TEST(RequestLedger, remembersAQuestionThatItGaveUpUntilItsAnswer) {
  RequestLedger ledger;
  ledger.add(tagQuery(3, 1s));
  EXPECT_FALSE(ledger.takeExpired(Instant(1s)));
  ASSERT_TRUE(ledger.takeExpired(Instant(2s)));
  EXPECT_FALSE(ledger.takeExpired(Instant(9s)));
  EXPECT_FALSE(ledger.nextDeadline());
  EXPECT_FALSE(ledger.takeOldest());
  ledger.add(tagQuery(3));
  EXPECT_TRUE(ledger.takeTagQuery(3)->given_up);  // answers come in the order of the questions
  EXPECT_FALSE(ledger.takeTagQuery(3)->given_up);
  EXPECT_FALSE(ledger.takeTagQuery(3));
}

TEST(RequestLedger, remembersAQuestionWhoseErrorMayHaveBeenAnothersToo) {
  RequestLedger ledger;
  ledger.add(tagQuery(3));
  EXPECT_EQ(ledger.takeOldest()->tag, 3);
  EXPECT_FALSE(ledger.takeOldest());
  EXPECT_TRUE(ledger.takeTagQuery(3)->given_up);
}

TEST(RequestLedger, forgetsWhatItGaveUpWithTheAnswerToALaterQuestion) {
  RequestLedger ledger;
  ledger.add(tagQuery(3));
  ledger.add(Request{});
  ledger.add(tagQuery(4));
  ASSERT_TRUE(ledger.takeOldest());
  ASSERT_TRUE(ledger.takeNodeQuery());
  EXPECT_FALSE(ledger.takeTagQuery(3));
  EXPECT_FALSE(ledger.takeTagQuery(4)->given_up);
}

TEST(RequestLedger, knowsItsEarliestDeadline) {
  RequestLedger ledger;
  EXPECT_EQ(ledger.nextDeadline(), std::nullopt);
  ledger.add(Request{});
  EXPECT_EQ(ledger.nextDeadline(), std::nullopt) << "a lifesign has none of its own";
  ledger.add(script("1", 4s));
  ledger.add(script("2", 2s));
  EXPECT_EQ(ledger.nextDeadline(), Instant(1s)) << "from then on they count";
  EXPECT_FALSE(ledger.takeExpired(Instant(1s)));
  EXPECT_EQ(ledger.nextDeadline(), Instant(3s));
  EXPECT_FALSE(ledger.takeExpired(Instant(3s) - 1ns));
  EXPECT_EQ(ledger.takeExpired(Instant(3s))->script_id, "2");
  EXPECT_EQ(ledger.nextDeadline(), Instant(5s));
  ledger.clear();
  EXPECT_EQ(ledger.nextDeadline(), std::nullopt);
}

TEST(RequestLedger, countsFromTheFirstLookAtTheTime) {
  RequestLedger ledger;
  ledger.add(script("1", 2s));
  EXPECT_FALSE(ledger.takeExpired(Instant(30s)));
  EXPECT_EQ(ledger.nextDeadline(), Instant(32s));
  ledger.add(script("2", 2s));
  EXPECT_EQ(ledger.nextDeadline(), Instant(1s));
  EXPECT_EQ(ledger.takeExpired(Instant(33s))->script_id, "1");
  EXPECT_FALSE(ledger.takeExpired(Instant(34s)));
  EXPECT_EQ(ledger.takeExpired(Instant(35s))->script_id, "2");
}

TEST(TagLedger, givesOutAllFifteenAndNoMore) {
  TagLedger ledger;
  for (int tag = 1; tag <= 15; ++tag) EXPECT_EQ(ledger.open(), tag);
  EXPECT_EQ(ledger.open(), std::nullopt);
  EXPECT_EQ(ledger.open(7), std::nullopt);
  EXPECT_TRUE(ledger.complete(7));
  EXPECT_EQ(ledger.openTags().size(), 14u);
  EXPECT_EQ(ledger.open(), 7);
}

/// Two command layers on one controller hear each other's tags.
TEST(TagLedger, beginsWhereItIsTold) {
  TagLedger ledger(14);
  for (const int tag : {14, 15, 1, 2}) EXPECT_EQ(ledger.open(), tag);
  EXPECT_EQ(ledger.open(9), 9);
  EXPECT_EQ(ledger.open(), 3);
  EXPECT_TRUE(ledger.complete(1));
  for (const int tag : {4, 5, 6, 7, 8, 10, 11, 12, 13, 1}) EXPECT_EQ(ledger.open(), tag);
  for (const int nonsense : {0, -1, 16}) EXPECT_EQ(TagLedger(nonsense).open(), 1);
}

TEST(TagLedger, tellsAForeignReportFromALateOneAndFromADuplicate) {
  TagLedger ledger;
  EXPECT_TRUE(ledger.isForeign(1)) << "it was never given out";
  EXPECT_TRUE(ledger.isForeign(0));
  EXPECT_TRUE(ledger.isForeign(16));
  EXPECT_EQ(ledger.open(), 1);
  EXPECT_FALSE(ledger.isForeign(1));
  EXPECT_TRUE(ledger.complete(1));
  EXPECT_FALSE(ledger.isForeign(1)) << "the same report once more";
  EXPECT_EQ(ledger.open(), 2);
  ledger.renewEpoch();
  EXPECT_FALSE(ledger.isForeign(2)) << "a late one";
  EXPECT_FALSE(ledger.complete(2));
  EXPECT_TRUE(ledger.isForeign(1));
}

TEST(TagLedger, honoursAWishThatIsFree) {
  TagLedger ledger;
  EXPECT_EQ(ledger.open(5), 5);
  EXPECT_EQ(ledger.open(5), 1) << "taken";
  EXPECT_EQ(ledger.open(0), 2);
  EXPECT_EQ(ledger.open(16), 3);
  EXPECT_EQ(ledger.open(-1), 4);
  EXPECT_EQ(ledger.open(), 6);
}

TEST(TagLedger, completesOnlyWhatIsOpenAndCountsTheRest) {
  TagLedger ledger;
  for (const int tag : {0, 1, 15, 16, -1, 99}) EXPECT_FALSE(ledger.complete(tag));
  EXPECT_EQ(ledger.staleReports(), 6u);
  const int tag = *ledger.open();
  EXPECT_TRUE(ledger.complete(tag));
  EXPECT_FALSE(ledger.complete(tag)) << "a duplicate";
  EXPECT_EQ(ledger.staleReports(), 7u);
}

TEST(TagLedger, makesReportsStaleWithANewEpoch) {
  TagLedger ledger;
  EXPECT_EQ(ledger.open(4), 4);
  const auto epoch = ledger.epoch();
  ledger.renewEpoch();
  EXPECT_EQ(ledger.epoch(), epoch + 1);
  EXPECT_FALSE(ledger.isOpen(4));
  EXPECT_FALSE(ledger.complete(4));
}

TEST(TagLedger, avoidsASuspectNumberUntilItsLateReportHasCome) {
  TagLedger ledger;
  EXPECT_EQ(ledger.open(4), 4);
  ledger.abandon(4);
  EXPECT_NE(ledger.open(4), 4);
  EXPECT_FALSE(ledger.complete(4));
  EXPECT_EQ(ledger.open(4), 4);
}

TEST(TagLedger, trustsASuspectNumberAgainWhenAYoungerTagHasCompleted) {
  TagLedger ledger;
  EXPECT_EQ(ledger.open(4), 4);
  EXPECT_EQ(ledger.open(5), 5);
  ledger.abandon(5);
  EXPECT_TRUE(ledger.complete(4));
  EXPECT_NE(ledger.open(5), 5) << "4 was in front of it in the queue";
  EXPECT_EQ(ledger.open(6), 6);
  EXPECT_TRUE(ledger.complete(6));
  EXPECT_EQ(ledger.open(5), 5) << "6 was behind it";
}

TEST(TagLedger, takesTheOldestSuspectWhenNothingElseIsLeft) {
  TagLedger ledger;
  for (int i = 0; i < 15; ++i) {
    EXPECT_TRUE(ledger.open(i == 0 ? 3 : 0));
    ledger.renewEpoch();
  }
  EXPECT_EQ(ledger.open(), 3);
}

TEST(BackOff, doublesUpToItsMaximumAndStartsAnew) {
  BackOff back_off;
  for (const Duration wait : {100ms, 200ms, 400ms, 800ms, 1000ms, 1000ms}) {
    EXPECT_EQ(back_off.next(100ms, 1s), Duration(wait));
  }
  back_off.reset();
  EXPECT_EQ(back_off.next(100ms, 1s), Duration(100ms));
}

TEST(BackOff, keepsToLimitsThatHaveChanged) {
  BackOff back_off;
  EXPECT_EQ(back_off.next(100ms, 1s), Duration(100ms));
  EXPECT_EQ(back_off.next(500ms, 1s), Duration(500ms));
  EXPECT_EQ(back_off.next(10ms, 300ms), Duration(300ms));
}

}  // namespace
}  // namespace cobot_command::link
