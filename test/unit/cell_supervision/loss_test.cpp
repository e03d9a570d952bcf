// What gets lost, comes twice, late or in another order changes nothing but time; and nothing is forgotten
// over a restart.
#include <map>
#include <random>

#include "cell_programs.h"
#include "supervised_cell.h"
#include "thorough.h"

namespace cobot_command::cell {
namespace {

using test_support::handover;
using test_support::iris;
using namespace std::chrono_literals;

/// Messages on their way, by when they arrive.
template <class Message>
class Network {
 public:
  explicit Network(std::mt19937& chance) : chance_(chance) {}

  /// Three of ten get lost; some come twice; all come up to two seconds later.
  void send(const Message& message, Instant now) {
    for (int copy = 0; copy < 2; ++copy) {
      if (chance_() % 10 < 3 || (copy == 1 && chance_() % 4 != 0)) continue;
      underway_.emplace(now + std::chrono::milliseconds(chance_() % 2000), message);
    }
  }
  std::vector<Message> arrived(Instant now) {
    std::vector<Message> messages;
    while (!underway_.empty() && underway_.begin()->first <= now) {
      messages.push_back(std::move(underway_.begin()->second));
      underway_.erase(underway_.begin());
    }
    return messages;
  }

 private:
  std::mt19937& chance_;
  std::multimap<Instant, Message> underway_;
};

TEST(ACellOnABadNetwork, neverHasTwoHoldersAndEndsAllCycles) {
  const int cycles = testing::quickOrThorough(200, 1000);
  SupervisedCell cell(iris());
  std::mt19937 chance(35);
  Network<RobotReport> reports(chance);
  Network<CellStatus> states(chance);
  const auto is_done = [&] {
    return std::all_of(cell.robots.begin(), cell.robots.end(),
                       [&](const auto& robot) { return robot.cycles() >= cycles; });
  };
  int ticks = 0;
  for (; !is_done() && ticks < 4000 * cycles; ++ticks) {
    cell.now += 50ms;
    for (EventRobot& robot : cell.robots) {
      // Behind a booking it goes on at once, or not at all for a while.
      if (!robot.waits() && robot.cycles() < cycles && chance() % 3 == 0) robot.goOn();
      if (robot.waits() && chance() % 200 == 0) robot.withdraw();
      if (ticks % 4 == 0) reports.send(robot.report(), cell.now);
    }
    for (const RobotReport& report : reports.arrived(cell.now)) cell.supervision->take(report, cell.now);
    if (ticks % 4 == 0) states.send(cell.supervision->status(cell.now), cell.now);
    for (const CellStatus& state : states.arrived(cell.now)) {
      for (EventRobot& robot : cell.robots) robot.hear(state);
    }
    ASSERT_FALSE(cell.hasTwoHolders());
  }
  EXPECT_TRUE(is_done()) << ticks << " ticks";
  cell.exchange();
  for (RobotIndex robot = 0; robot < 3; ++robot) EXPECT_EQ(cell.robot(robot).state, RobotState::Ready);
}

TEST(ASupervisorThatWasKilled, knowsWhatItKnewAtEachRecord) {
  SupervisedCell cell(iris());
  const int cycles = testing::quickOrThorough(3, 20);
  std::size_t before = 0;
  std::uint64_t epoch = 1;
  runCycles(cell, cycles, [&] {
    if (cell.journal.size() == before) return;
    before = cell.journal.size();
    const automata::Tuple tuple = cell.supervision->tuple();
    const std::uint64_t events = cell.supervision->status(cell.now).events;
    cell.start(99);
    before = cell.journal.size();
    EXPECT_EQ(cell.supervision->tuple(), tuple);
    const CellStatus status = cell.supervision->status(cell.now);
    EXPECT_EQ(status.instance, 7U);
    EXPECT_EQ(status.epoch, ++epoch);
    EXPECT_EQ(status.events, events);
    // Nothing is granted before each robot has told that it is where it was.
    EXPECT_NE(status.mode, SupervisorMode::Running);
    for (EventRobot& robot : cell.robots) cell.supervision->take(robot.report(), cell.now);
    EXPECT_NE(cell.mode(), SupervisorMode::Recovery);
  });
  EXPECT_FALSE(cell.hasTwoHolders());
}

TEST(ASupervisorThatWasKilledAtAnyByte, goesOnFromWhatItHadTold) {
  SupervisedCell whole(handover());
  runCycles(whole, 1, [] {});
  for (std::size_t limit = 0; limit < whole.journal.size(); limit += testing::strideWhenWatched()) {
    SupervisedCell cell(handover());
    cell.journal_limit = std::max(limit, cell.journal.size());
    for (int tick = 0; tick < 100 && cell.mode() != SupervisorMode::Fault; ++tick) {
      for (EventRobot& robot : cell.robots) robot.goOn();
      cell.exchange();
    }
    ASSERT_EQ(cell.mode(), SupervisorMode::Fault) << limit;
    const automata::Tuple tuple = cell.supervision->tuple();
    cell.journal_limit = std::numeric_limits<std::size_t>::max();
    cell.start();
    ASSERT_EQ(cell.supervision->tuple(), tuple) << limit;
    const int cycles = cell.robots[0].cycles() + 1;
    runCycles(cell, cycles, [&] { ASSERT_FALSE(cell.hasTwoHolders()) << limit; });
    ASSERT_NE(cell.mode(), SupervisorMode::Recovery) << limit;
  }
}

TEST(ASupervisorThatWasKilledWithinARecord, dropsItAsNobodyWasTold) {
  SupervisedCell whole(handover());
  runCycles(whole, 1, [] {});
  const std::string all = whole.journal;
  for (std::size_t length = 0; length <= all.size(); ++length) {
    const auto contents = journal::read(std::string_view(all).substr(0, length));
    ASSERT_TRUE(contents) << length;
    const auto last_line = all.rfind('\n', length == 0 ? 0 : length - 1);
    const std::size_t complete = last_line == std::string::npos || length == 0 ? 0 : last_line + 1;
    EXPECT_EQ(contents->torn, length - complete);
  }
}

TEST(AJournalWithAWrongByte, isRefusedWithItsLine) {
  SupervisedCell whole(handover());
  runCycles(whole, 1, [] {});
  for (std::size_t at = 0; at < whole.journal.size(); ++at) {
    std::string damaged = whole.journal;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    const auto contents = journal::read(damaged);
    // A newline that is gone at the very end is a record that was not written wholly.
    if (at + 1 == whole.journal.size()) continue;
    ASSERT_FALSE(contents) << at;
    EXPECT_EQ(contents.error().line,
              static_cast<std::size_t>(std::count(
                  whole.journal.begin(), whole.journal.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
                  1);
  }
}

TEST(ASupervisorBehindARestart, waitsForARobotThatWasStartedAnewToo) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.start();
  EventRobot again(cell.model(), 0, 999);
  EXPECT_FALSE(cell.supervision->take(again.report(), cell.now)) << "the other one may be heard soon";
  cell.now += 501ms;
  cell.supervision->take(again.report(), cell.now);
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Recovery);
  EXPECT_EQ(cell.zone(0).owner, "RA");
  EXPECT_TRUE(cell.supervision->recover("RA", "HOME", "me", cell.now).success);
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ASupervisorBehindARestart, waitsForARobotThatIsNotWhereItWas) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.start();
  cell.fits = false;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Recovery);
  cell.fits = true;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ASupervisorWithoutItsJournal, isAnotherOneToTheRobots) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.journal.clear();
  cell.start(8);
  cell.exchange();
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  EXPECT_THAT(cell.robot(0).text, ::testing::HasSubstr("another supervisor"));
  EXPECT_NE(cell.mode(), SupervisorMode::Running);
  EXPECT_THAT(cell.supervision->recover("RA", "T1>1", "me", cell.now).message,
              ::testing::HasSubstr("restart its node"));
  cell.now += std::chrono::seconds(1);
  cell.robots.clear();
  for (RobotIndex robot = 0; robot < 2; ++robot) {
    cell.robots.emplace_back(cell.model(), robot, 200 + robot, 8);
  }
  cell.fits = false;  // one of them is not at home
  cell.exchange();
  cell.fits = true;
  EXPECT_TRUE(cell.supervision->recover("RA", "T1>1", "me", cell.now).success);
  EXPECT_TRUE(cell.supervision->recover("RB", "HOME", "me", cell.now).success);
  EXPECT_EQ(cell.zone(0).owner, "RA");
}

TEST(AJournalOfAnotherArtifact, isAFault) {
  SupervisedCell cell(handover());
  cell.exchange();
  std::string& text = cell.journal;
  text = journal::toLine(journal::Started{7, 1, "another"});
  cell.start();
  EXPECT_EQ(cell.mode(), SupervisorMode::Fault);
  EXPECT_THAT(cell.supervision->status(cell.now).diagnosis, ::testing::HasSubstr("another artifact"));
}

TEST(RandomInterleavingsOfABooking, neverHaveTwoHolders) {
  std::mt19937 chance(34);
  for (int run = 0; run < testing::quickOrThorough(300, 20000); ++run) {
    SupervisedCell cell(handover());
    cell.exchange();
    cell.bring(0, "T1>");
    cell.bring(1, "T1>");
    for (int step = 0; step < 24; ++step) {
      EventRobot& robot = cell.robots[chance() % 2];
      switch (chance() % 4) {
        case 0:
          robot.goOn();
          break;
        case 1:
          if (robot.waits()) robot.withdraw();
          break;
        case 2:
          cell.now += 10ms;
          cell.supervision->take(robot.report(), cell.now);
          break;
        default:
          robot.hear(cell.supervision->status(cell.now));
      }
      ASSERT_FALSE(cell.hasTwoHolders());
      ASSERT_NE(cell.robot(robot.index()).state, RobotState::Fault) << cell.robot(robot.index()).text;
    }
  }
}

TEST(ARobotStartedAnew, isLetInWhereItStandsAtHome) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.now += std::chrono::seconds(1);
  cell.robots.clear();
  for (RobotIndex robot = 0; robot < 2; ++robot) cell.robots.emplace_back(cell.model(), robot, 200 + robot);
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
  cell.bring(0, "T1>1");
}

TEST(WhatPeopleHaveAskedFor, holdsBehindARestart) {
  SupervisedCell cell(handover());
  cell.exchange();
  EXPECT_TRUE(cell.supervision->hold(true, cell.now).success);
  EXPECT_TRUE(cell.supervision->finish(true, cell.now).success);
  cell.start();
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Holding);
  EXPECT_TRUE(cell.supervision->hold(false, cell.now).success);
  EXPECT_TRUE(cell.supervision->status(cell.now).is_finishing);
}

TEST(ARobotWhoseJointsAreOld, isNotRecovered) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.robots[0].condition = RobotCondition::Stopped;
  cell.exchange();
  RobotReport report = cell.robots[0].report();
  report.status_age = 3.0;
  cell.supervision->take(report, cell.now);
  EXPECT_THAT(cell.supervision->recover("RA", "T1>1", "me", cell.now).message,
              ::testing::HasSubstr("measured 3.0 s ago"));
}

TEST(AnIntrusion, stopsBothAlsoWhileTheCellIsHeld) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  EXPECT_TRUE(cell.supervision->hold(true, cell.now).success);
  RobotReport report = cell.robots[1].report();
  report.touched_zones = {0};
  cell.supervision->take(report, cell.now);
  EXPECT_EQ(cell.takeStopOrders().size(), 2U);
  report.number += 1;
  cell.supervision->take(report, cell.now);
  EXPECT_EQ(cell.takeStopOrders().size(), 0U) << "once";
  EXPECT_THAT(cell.supervision->hold(false, cell.now).message, ::testing::HasSubstr("INTRUSION"));
  EXPECT_EQ(cell.takeStopOrders().size(), 2U) << "and again where it lasts";
}

/// The journal's disk may take long, or for ever.
TEST(AStop, isOrderedBeforeItIsWritten) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  std::size_t written = cell.journal.size();
  cell.at_stop = [&] { EXPECT_EQ(cell.journal.size(), written); };
  RobotReport intrudes = cell.robots[1].report();
  intrudes.touched_zones = {0};
  cell.robots[1].goOn();
  intrudes.events = cell.robots[1].report().events;
  cell.supervision->take(intrudes, cell.now);
  EXPECT_EQ(cell.takeStopOrders().size(), 2U) << "of an intrusion";
  EXPECT_GT(cell.journal.size(), written);

  written = cell.journal.size();
  EXPECT_TRUE(cell.supervision->stop(cell.now).success);
  EXPECT_EQ(cell.takeStopOrders().size(), 2U) << "that a person asks for";
  EXPECT_GT(cell.journal.size(), written);
}

TEST(AMechanismThatWasLetGo, keepsRobotsFromBeingRecoveredInItsWay) {
  SupervisedCell cell(test_support::pallet());
  cell.exchange();
  cell.bring(1, "IN>");
  cell.exchange();
  const auto answer = cell.supervision->recover("RA", "T1>1", "me", cell.now);
  EXPECT_FALSE(answer.success);
  EXPECT_THAT(answer.message, ::testing::HasSubstr("PALLET was released"));
}

TEST(ZonesOfALostRobot, areNotFreedWhileItMoves) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.robots[0].condition = RobotCondition::Stopped;
  cell.robots[0].moving = true;
  cell.exchange();
  EXPECT_THAT(cell.supervision->confirmClear("RA", "me", true, cell.now).message,
              ::testing::HasSubstr("wait until it is at standstill"));
}

}  // namespace
}  // namespace cobot_command::cell
