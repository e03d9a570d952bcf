// Grant, cancel, undo, loss and restart at each point of one booking, in every order (oracle 34).
#include <array>
#include <deque>
#include <iostream>
#include <set>

#include "agent/program_walk.h"
#include "agent/state_watch.h"
#include "cell_programs.h"
#include "supervised_cell.h"
#include "thorough.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;

constexpr Duration kLease = 500ms;
/// So many older messages of each sender may still arrive, in any order, again, or never.
const std::size_t kUnderWay = testing::quickOrThorough(1U, 2U);

template <class Message>
void keep(std::deque<Message>& messages, Message message) {
  messages.push_front(std::move(message));
  if (messages.size() > kUnderWay) messages.pop_back();
}

struct Told {
  CellStatus state;
  std::uint64_t number = 0;
};

/// What one robot's side does about a booking: the parts of its agent, without an arm.
class BookingRobot {
 public:
  BookingRobot(const CellModel& model, RobotIndex index)
      : model_(&model),
        index_(index),
        walk_(std::make_unique<ProgramWalk>(model, index)),
        states_(name(), 100 + index, kHash, kLease) {}

  [[nodiscard]] const std::string& name() const { return model_->program.robots[index_].name; }
  [[nodiscard]] const std::string& place() const { return walk_->place().name; }
  [[nodiscard]] bool holdsByItself() const { return !walk_->place().holds.empty(); }
  [[nodiscard]] bool hasSent() const { return has_sent_; }
  [[nodiscard]] bool waits() const { return walk_->waits(); }

  /// False, here and below: it cannot be done now.
  bool ask() {
    if (waits() || place() != "T1>") return false;
    walk_->want(walk_->next());
    keep(reports, report());
    return true;
  }
  bool cancel() {
    if (!waits() && !walk_->unused()) return false;
    walk_->withdraw();
    keep(reports, report());
    return true;
  }
  /// The frame leaves, as far as the robot can know that it may.
  bool send(Instant now) {
    if (waits() || !holdsByItself() || has_sent_ || states_.objection(now)) return false;
    walk_->use();
    has_sent_ = true;
    return true;
  }
  void hear(const Told& told, Instant now) {
    // How old a state is by the robot's own reports is not looked at here.
    states_.told(told.state.robots[index_].report, now);
    if (!states_.hear(told.state, told.number, now)) return;
    heard_ = told.number;
    const RobotStatus& mine = *states_.mine();
    if (mine.session != 100 + index_) return;
    if (joins_ == mine.joins) return walk_->acknowledge(mine.acknowledged);
    joins_ = mine.joins;
    EXPECT_TRUE(walk_->restart(mine.place, mine.acknowledged));
  }
  [[nodiscard]] RobotReport report() {
    RobotReport report;
    report.robot = name();
    report.hash = kHash;
    report.session = 100 + index_;
    report.instance = states_.instance();
    report.number = ++reports_;
    report.events = walk_->untold();
    return report;
  }

  /// All that what follows depends on, numbers as seen from `acknowledged`.
  [[nodiscard]] std::string key(std::uint64_t acknowledged, std::uint64_t taken, Instant now) const {
    std::string text =
        fmt::format("{} {}{}{}{} [{}]", place(), waits(), walk_->unused().has_value(), has_sent_,
                    states_.objection(now).has_value(), textOf(walk_->untold(), acknowledged));
    for (const RobotReport& report : reports) {
      if (report.number > taken) text += fmt::format(" r[{}]", textOf(report.events, acknowledged));
    }
    for (const Told& told : states) {
      if (told.number <= heard_) continue;
      text += fmt::format(" s{}",
                          static_cast<std::int64_t>(told.state.robots[index_].acknowledged - acknowledged));
    }
    return text;
  }

  std::deque<RobotReport> reports;
  std::deque<Told> states;

 private:
  [[nodiscard]] static std::string textOf(const std::vector<NumberedEvent>& events, std::uint64_t from) {
    std::string text;
    for (const NumberedEvent& event : events) {
      text +=
          fmt::format("{}.{} ", static_cast<std::int64_t>(event.number - from), static_cast<int>(event.kind));
    }
    return text;
  }

  const CellModel* model_;
  RobotIndex index_;
  std::unique_ptr<ProgramWalk> walk_;
  StateWatch states_;
  std::optional<std::uint32_t> joins_;
  std::uint64_t reports_ = 0;
  std::uint64_t heard_ = 0;
  bool has_sent_ = false;
};

enum class Act {
  Ask,
  Cancel,
  Send,
  Report,
  LateReport,
  LaterReport,
  Hear,
  HearLate,
  HearLater,
  Silence,
  Restart
};
constexpr int kActs = 11;

struct Step {
  RobotIndex robot = 0;
  Act act = Act::Ask;
};

std::string describe(const std::vector<Step>& steps) {
  constexpr const char* kNames[kActs] = {"asks",          "cancels",        "sends",  "is heard",
                                         "is heard late", "is heard later", "hears",  "hears late",
                                         "hears later",   "silence",        "restart"};
  std::string text;
  for (const Step& step : steps) {
    text += fmt::format("{} {}; ", step.robot == 0 ? "RA" : "RB", kNames[static_cast<std::size_t>(step.act)]);
  }
  return text;
}

/// Two robots before one zone, and their supervisor.
class Booking {
 public:
  /// `journal`: of robots that were let in and have set out.
  Booking(const CellModel& model, const std::vector<PartSupervisor>& parts, std::string journal)
      : model_(model), parts_(parts), journal_(std::move(journal)) {
    start();
    for (RobotIndex robot = 0; robot < 2; ++robot) {
      robots_.emplace_back(model, robot);
      supervision_->take(robots_[robot].report(), now_);
    }
    for (BookingRobot& robot : robots_) {
      robot.hear({supervision_->status(now_), ++told_}, now_);
      EXPECT_EQ(robot.place(), "T1>");
    }
    taken_ = {1, 1};
  }

  /// False: that cannot be done.
  bool carryOut(const Step& step) {
    BookingRobot& robot = robots_[step.robot];
    switch (step.act) {
      case Act::Ask:
        return robot.ask();
      case Act::Cancel:
        return robot.cancel();
      case Act::Send:
        return robot.send(now_);
      case Act::Report:
        take(step.robot, robot.report());
        return true;
      case Act::LateReport:
        return takeLate(step.robot, 0);
      case Act::LaterReport:
        return takeLate(step.robot, 1);
      case Act::Hear:
        robot.hear({supervision_->status(now_), ++told_}, now_);
        return true;
      case Act::HearLate:
        return hearLate(robot, 0);
      case Act::HearLater:
        return hearLate(robot, 1);
      case Act::Silence:
        now_ += kLease + 1ms;
        supervision_->tick(now_);
        return true;
      case Act::Restart:
        start();
        return true;
    }
    return false;
  }

  /// All that is under way arrives.
  void settle() {
    for (int round = 0; round < 3; ++round) {
      for (RobotIndex robot = 0; robot < 2; ++robot) {
        take(robot, robots_[robot].report());
        for (BookingRobot& one : robots_) one.hear({supervision_->status(now_), ++told_}, now_);
      }
    }
  }

  /// What must hold in every state; empty: it does.
  [[nodiscard]] std::string fault() const {
    const CellStatus status = supervision_->status(now_);
    if (robots_[0].holdsByItself() && robots_[1].holdsByItself()) return "the zone has two holders";
    for (RobotIndex robot = 0; robot < 2; ++robot) {
      const RobotStatus& one = status.robots[robot];
      if (one.state == RobotState::Fault) return one.name + ": " + one.text;
      if (robots_[robot].hasSent() && status.zones.front().owner != one.name) {
        return one.name + " has sent its frame, and the zone is not its own";
      }
    }
    return status.mode == SupervisorMode::Fault ? status.diagnosis : "";
  }
  [[nodiscard]] bool agrees() const {
    const CellStatus status = supervision_->status(now_);
    return status.robots[0].place == robots_[0].place() && status.robots[1].place == robots_[1].place();
  }

  [[nodiscard]] std::string key() const {
    const CellStatus status = supervision_->status(now_);
    std::array<std::string, 2> texts;
    for (RobotIndex robot = 0; robot < 2; ++robot) {
      const RobotStatus& one = status.robots[robot];
      texts[robot] =
          fmt::format("|{} {} {} {} ", one.place, toString(one.state), one.place_in_queue, lastOf(robot));
      texts[robot] += robots_[robot].key(one.acknowledged, taken_[robot], now_);
    }
    // Which of them is which does not matter.
    std::sort(texts.begin(), texts.end());
    return toString(status.mode) + texts[0] + texts[1];
  }

 private:
  void start() {
    const auto contents = journal::read(journal_);
    EXPECT_TRUE(contents);
    SupervisionPorts ports;
    ports.append = [this](const std::string& line) {
      journal_ += line;
      return true;
    };
    ports.fits = [](RobotIndex, automata::StateIndex, const std::array<double, 6>&) { return true; };
    ports.stop = [](const StopOrder&) {};
    supervision_ =
        std::make_unique<Supervision>(Rules(model_, parts_, Policy::Supervisor), kHash, 7, contents->records,
                                      SupervisionSettings{kLease, 24h}, std::move(ports));
    taken_ = {0, 0};
  }

  void take(RobotIndex robot, const RobotReport& report) {
    supervision_->take(report, now_);
    taken_[robot] = std::max(taken_[robot], report.number);
    const Told told{supervision_->status(now_), ++told_};
    for (BookingRobot& one : robots_) keep(one.states, told);
  }
  bool takeLate(RobotIndex robot, std::size_t index) {
    const auto& reports = robots_[robot].reports;
    if (index >= reports.size() || reports[index].number <= taken_[robot]) return false;
    take(robot, RobotReport(reports[index]));
    return true;
  }
  bool hearLate(BookingRobot& robot, std::size_t index) {
    if (index >= robot.states.size()) return false;
    robot.hear(robot.states[index], now_);
    return true;
  }
  /// Of the journal: what was carried out of that robot last.
  [[nodiscard]] int lastOf(RobotIndex robot) const {
    int last = -1;
    const auto contents = journal::read(journal_);
    for (const journal::Record& record : contents->records) {
      const auto* one = std::get_if<journal::CarriedOut>(&record);
      if (one != nullptr && one->robot == robots_[robot].name()) last = static_cast<int>(one->event.kind);
    }
    return last;
  }

  const CellModel& model_;
  const std::vector<PartSupervisor>& parts_;
  Instant now_ = Instant(1h);
  std::string journal_;
  std::unique_ptr<Supervision> supervision_;
  std::vector<BookingRobot> robots_;
  std::uint64_t told_ = 0;
  std::array<std::uint64_t, 2> taken_{};
};

/// Breadth first, each state once: what two ways lead to goes on the same behind both.
class EveryOrder {
 public:
  EveryOrder()
      : model_(*modelOf(test_support::handover())),
        parts_(*synthesizeParts(model_, Policy::Supervisor, 1000)) {
    SupervisedCell cell(test_support::handover());
    cell.exchange();
    cell.bring(0, "T1>");
    cell.bring(1, "T1>");
    journal_ = cell.journal;
  }

  void explore(int depth) {
    std::vector<std::vector<Step>> level{{}};
    for (int at = 0; at < depth && !level.empty() && !::testing::Test::HasFailure(); ++at) {
      std::vector<std::vector<Step>> next;
      for (const auto& steps : level) goOn(steps, next);
      level = std::move(next);
      std::cout << "depth " << at + 1 << ": " << level.size() << " new states, " << seen_.size()
                << " in all\n";
    }
  }
  [[nodiscard]] std::size_t states() const { return seen_.size(); }

 private:
  void goOn(const std::vector<Step>& steps, std::vector<std::vector<Step>>& next) {
    for (int choice = 0; choice < 2 * kActs; ++choice) {
      const Step step{static_cast<RobotIndex>(choice % 2), static_cast<Act>(choice / 2)};
      const bool is_of_both = step.act == Act::Silence || step.act == Act::Restart;
      if (is_of_both && step.robot == 1) continue;
      Booking booking(model_, parts_, journal_);
      for (const Step& before : steps) (void)booking.carryOut(before);
      if (!booking.carryOut(step)) continue;
      std::vector<Step> done = steps;
      done.push_back(step);
      const std::string fault = booking.fault();
      ASSERT_EQ(fault, "") << describe(done);
      if (!seen_.insert(booking.key()).second) continue;
      booking.settle();
      ASSERT_EQ(booking.fault(), "") << describe(done);
      ASSERT_TRUE(booking.agrees()) << describe(done);
      next.push_back(std::move(done));
    }
  }

  CellModel model_;
  std::vector<PartSupervisor> parts_;
  std::string journal_;
  std::set<std::string> seen_;
};

TEST(EveryOrderOfGrantCancelUndoAndLoss, leavesOneHolderAndNoFrameWithoutAPermit) {
  EveryOrder all;
  const unsigned quick = testing::strideWhenWatched() > 1 ? 6U : 7U;  // a tenth of the orders
  all.explore(
      static_cast<int>(testing::fromEnvironment("COBOT_CELL_DEPTH", testing::quickOrThorough(quick, 12U))));
  EXPECT_GT(all.states(), 100U);
}

}  // namespace
}  // namespace cobot_command::cell
