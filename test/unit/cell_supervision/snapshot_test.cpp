// A journal is made anew before it grows too long, and says the same then.
#include "cell_programs.h"
#include "supervised_cell.h"

namespace cobot_command::cell {
namespace {

using test_support::handover;
using test_support::iris;
using ::testing::HasSubstr;

constexpr std::size_t kMost = 4;

SupervisionSettings shortJournals() {
  SupervisionSettings settings;
  settings.most_records = kMost;
  return settings;
}

std::size_t recordsIn(const SupervisedCell& cell) {
  return static_cast<std::size_t>(std::count(cell.journal.begin(), cell.journal.end(), '\n'));
}

TEST(AJournalThatIsMadeAnew, hasAllThatTheRecordsBeforeCameTo) {
  SupervisedCell cell(iris(), Policy::Supervisor, shortJournals());
  std::string before;
  std::uint64_t epoch = 1;
  runCycles(cell, 3, [&] {
    EXPECT_LT(recordsIn(cell), kMost);
    if (cell.journal == before) return;
    const automata::Tuple tuple = cell.supervision->tuple();
    const CellStatus known = cell.supervision->status(cell.now);
    cell.start(99);
    before = cell.journal;
    EXPECT_EQ(cell.supervision->tuple(), tuple);
    const CellStatus status = cell.supervision->status(cell.now);
    EXPECT_EQ(status.instance, 7U);
    EXPECT_EQ(status.epoch, ++epoch);
    EXPECT_EQ(status.events, known.events);
    for (RobotIndex robot = 0; robot < 3; ++robot) {
      EXPECT_EQ(status.robots[robot].session, known.robots[robot].session);
      EXPECT_EQ(status.robots[robot].acknowledged, known.robots[robot].acknowledged);
    }
    for (EventRobot& robot : cell.robots) cell.supervision->take(robot.report(), cell.now);
    EXPECT_NE(cell.mode(), SupervisorMode::Recovery);
  });
  EXPECT_FALSE(cell.hasTwoHolders());
  EXPECT_GT(cell.tries_to_make_anew, 10);
}

TEST(AJournalThatIsMadeAnew, isNoNewOneToTheRobots) {
  SupervisedCell cell(handover(), Policy::Supervisor, shortJournals());
  cell.exchange();
  cell.bring(0, "T1>1");
  for (int i = 0; i < 3; ++i) cell.start();
  EXPECT_NE(cell.mode(), SupervisorMode::Running) << "each has to tell first where it is";
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Running);
  EXPECT_EQ(cell.zone(0).owner, "RA");
}

TEST(AJournalThatIsMadeAnew, keepsWhatPeopleHaveAskedFor) {
  SupervisedCell cell(handover(), Policy::Supervisor, shortJournals());
  cell.exchange();
  EXPECT_TRUE(cell.supervision->takeOut("RB", "Ann", cell.now).success);
  EXPECT_TRUE(cell.supervision->hold(true, cell.now).success);
  EXPECT_TRUE(cell.supervision->finish(true, cell.now).success);
  for (int i = 0; i < 3; ++i) cell.start();
  cell.exchange();
  EXPECT_THAT(cell.journal, HasSubstr("snapshot"));
  EXPECT_EQ(cell.mode(), SupervisorMode::Holding);
  EXPECT_EQ(cell.robot(1).state, RobotState::Out);
  EXPECT_TRUE(cell.supervision->status(cell.now).is_finishing);
}

TEST(AJournalThatCannotBeMadeAnew, growsOnAndIsTriedAgain) {
  SupervisedCell cell(handover(), Policy::Supervisor, shortJournals());
  cell.can_be_made_anew = false;
  runCycles(cell, 3, [] {});
  EXPECT_GT(recordsIn(cell), 2 * kMost);
  EXPECT_GE(cell.tries_to_make_anew, 2);
  EXPECT_LE(cell.tries_to_make_anew, static_cast<int>(recordsIn(cell) / kMost));
  EXPECT_NE(cell.mode(), SupervisorMode::Fault);
}

TEST(ASnapshot, isAFaultWhereItDoesNotFitTheCell) {
  SupervisedCell cell(handover(), Policy::Supervisor, shortJournals());
  cell.exchange();
  cell.bring(0, "T1>1");
  while (recordsIn(cell) != 1) cell.start();
  const auto contents = journal::read(cell.journal);
  ASSERT_TRUE(contents);
  const auto right = std::get<journal::Snapshot>(contents->records.front());
  std::vector<journal::Snapshot> wrong(5, right);
  wrong[0].robots[0].robot = "RX";
  wrong[1].robots.pop_back();
  wrong[2].states.pop_back();
  wrong[3].states.front() = 1000;
  wrong[4].hash = "another";
  for (const journal::Snapshot& one : wrong) {
    cell.journal = journal::toLine(one);
    cell.start();
    EXPECT_EQ(cell.mode(), SupervisorMode::Fault);
    EXPECT_THAT(cell.supervision->status(cell.now).diagnosis, HasSubstr("a new"));
  }
  cell.journal = journal::toLine(right);
  cell.start();
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Running);
}

}  // namespace
}  // namespace cobot_command::cell
