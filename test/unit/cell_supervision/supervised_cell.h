// A supervisor with robots that run their programs as events, in invented time.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "cobot_command/cell/supervision/supervision.h"

namespace cobot_command::cell {

inline constexpr const char* kHash = "0123456789abcdef";

/// What a robot's own side does of it: knows its place, asks, waits, and tells what happened.
inline constexpr std::uint64_t kInstance = 7;

class EventRobot {
 public:
  /// `instance`: of the supervisor that it has heard of.
  EventRobot(const CellModel& model, RobotIndex index, std::uint64_t session,
             std::uint64_t instance = kInstance)
      : model_(model), index_(index), session_(session), instance_(instance) {
    place_ = model.problem.automata[index].initial;
  }

  /// Hears of the state; goes on by itself as far as it can, one event with each call.
  void hear(const CellStatus& status) {
    const RobotStatus& mine = status.robots[index_];
    if (mine.session != session_) return;
    instance_ = status.instance;
    acknowledged_ = std::max(acknowledged_, mine.acknowledged);
    while (!events_.empty() && events_.front().number <= acknowledged_) events_.erase(events_.begin());
    if (wanted_ && wanted_->number <= acknowledged_) {
      place_ = next(wanted_->event);
      wanted_.reset();
    }
  }

  /// Asks for its next go or booking, or does what its program has next. Nothing while it waits.
  void goOn() {
    if (wanted_) return;
    for (const auto& transition : model_.problem.automata[index_].transitions) {
      if (transition.from == place_) return begin(transition.event);
    }
  }

  void withdraw() {
    events_.push_back({++number_, NumberedEvent::Kind::Withdrawn, wanted_->event});
    wanted_.reset();
  }

  [[nodiscard]] RobotReport report() {
    RobotReport report;
    report.robot = model_.program.robots[index_].name;
    report.hash = kHash;
    report.session = session_;
    report.instance = instance_;
    report.number = ++report_number_;
    report.events = events_;
    for (const ZoneIndex zone : model_.places[index_][place_].holds) {
      if (touches) report.touched_zones.push_back(static_cast<std::uint32_t>(zone));
    }
    report.condition = condition;
    report.moving = moving;
    return report;
  }

  [[nodiscard]] bool waits() const { return wanted_.has_value(); }
  [[nodiscard]] automata::StateIndex place() const { return place_; }
  [[nodiscard]] int cycles() const { return cycles_; }
  [[nodiscard]] RobotIndex index() const { return index_; }

  RobotCondition condition = RobotCondition::Ok;
  bool moving = false;
  bool touches = false;  ///< the zones that it holds

 private:
  [[nodiscard]] automata::StateIndex next(automata::EventIndex event) const {
    for (const auto& transition : model_.problem.automata[index_].transitions) {
      if (transition.from == place_ && transition.event == event) return transition.to;
    }
    return place_;
  }

  void begin(automata::EventIndex event) {
    const bool asks = model_.problem.events[event].controllable;
    const auto kind = asks ? NumberedEvent::Kind::Wanted : NumberedEvent::Kind::Happened;
    events_.push_back({++number_, kind, event});
    if (asks) {
      wanted_ = events_.back();
    } else {
      place_ = next(event);
      if (place_ == model_.problem.automata[index_].initial) ++cycles_;
    }
  }

  const CellModel& model_;
  RobotIndex index_;
  std::uint64_t session_;
  std::uint64_t instance_;
  std::uint64_t number_ = 0;
  std::uint64_t acknowledged_ = 0;
  std::uint64_t report_number_ = 0;
  std::vector<NumberedEvent> events_;
  std::optional<NumberedEvent> wanted_;
  automata::StateIndex place_ = 0;
  int cycles_ = 0;
};

inline Rules rulesOf(const CellProgram& program, Policy policy) {
  CellModel model = *modelOf(program);
  const auto parts = synthesizeParts(model, policy, 1000000);
  EXPECT_TRUE(parts) << parts.error();
  return {std::move(model), *parts, policy};
}

class SupervisedCell {
 public:
  explicit SupervisedCell(const CellProgram& program, Policy policy = Policy::Supervisor,
                          SupervisionSettings settings = {})
      : program_(program), policy_(policy), settings_(std::move(settings)), model_(*modelOf(program)) {
    start();
    for (RobotIndex robot = 0; robot < model_.robots(); ++robot) {
      robots.emplace_back(model_, robot, 100 + robot);
    }
  }

  /// The supervisor anew, with the journal as it is.
  void start(std::uint64_t instance = kInstance) {
    const auto contents = journal::read(journal);
    ASSERT_TRUE(contents);
    journal.resize(journal.size() - contents->torn);
    supervision = std::make_unique<Supervision>(rulesOf(program_, policy_), kHash, instance,
                                                contents->records, settings_, ports());
  }

  /// All report, and hear.
  void exchange() {
    now += std::chrono::milliseconds(50);
    for (EventRobot& robot : robots) supervision->take(robot.report(), now);
    for (EventRobot& robot : robots) robot.hear(supervision->status(now));
  }

  /// That robot goes on until it has to wait, or is at that place.
  void bring(RobotIndex robot, const std::string& place) {
    for (int step = 0; step < 50 && placeOf(robot) != place; ++step) {
      robots[robot].goOn();
      exchange();
    }
    EXPECT_EQ(placeOf(robot), place);
  }
  void ask(RobotIndex robot) {
    robots[robot].goOn();
    exchange();
  }

  [[nodiscard]] std::string placeOf(RobotIndex robot) const {
    return model_.places[robot][robots[robot].place()].name;
  }
  [[nodiscard]] RobotStatus robot(RobotIndex robot) const { return supervision->status(now).robots[robot]; }
  [[nodiscard]] ZoneStatus zone(ZoneIndex zone) const { return supervision->status(now).zones[zone]; }
  [[nodiscard]] std::vector<StopOrder> takeStopOrders() { return std::exchange(stop_orders, {}); }
  [[nodiscard]] SupervisorMode mode() const { return supervision->status(now).mode; }
  [[nodiscard]] const CellModel& model() const { return model_; }

  /// Zones that two robots hold, by what they themselves believe.
  [[nodiscard]] bool hasTwoHolders() const {
    std::vector<ZoneIndex> held;
    for (const EventRobot& robot : robots) {
      const auto& holds = model_.places[robot.index()][robot.place()].holds;
      held.insert(held.end(), holds.begin(), holds.end());
    }
    std::sort(held.begin(), held.end());
    return std::adjacent_find(held.begin(), held.end()) != held.end();
  }

  Instant now = Instant(std::chrono::hours(1));
  std::string journal;
  bool journal_is_full = false;
  bool can_be_made_anew = true;
  int tries_to_make_anew = 0;
  /// Of a record that goes beyond so many bytes, only that is written which does not.
  std::size_t journal_limit = std::numeric_limits<std::size_t>::max();
  bool fits = true;
  std::vector<StopOrder> stop_orders;
  std::function<void()> at_stop;
  std::unique_ptr<Supervision> supervision;
  std::vector<EventRobot> robots;

 private:
  [[nodiscard]] SupervisionPorts ports() {
    return {[this](const std::string& line) {
              if (journal_is_full) return false;
              const std::size_t room = std::max(journal_limit, journal.size()) - journal.size();
              journal += line.substr(0, room);
              return line.size() <= room;
            },
            [this](const std::string& line) {
              ++tries_to_make_anew;
              if (can_be_made_anew) journal = line;
              return can_be_made_anew;
            },
            [this](RobotIndex, automata::StateIndex, const std::array<double, 6>&) { return fits; },
            [this](const StopOrder& order) {
              stop_orders.push_back(order);
              if (at_stop) at_stop();
            }};
  }

  CellProgram program_;
  Policy policy_;
  SupervisionSettings settings_;
  CellModel model_;
};

/// Runs all robots by turns, and calls `each` behind every report.
template <class Each>
void runCycles(SupervisedCell& cell, int cycles, const Each& each) {
  for (int tick = 0; tick < 1000; ++tick) {
    bool is_done = true;
    for (EventRobot& robot : cell.robots) {
      if (robot.cycles() < cycles) {
        robot.goOn();
        is_done = false;
      }
      cell.now += std::chrono::milliseconds(10);
      cell.supervision->take(robot.report(), cell.now);
      robot.hear(cell.supervision->status(cell.now));
      each();
    }
    if (is_done) return;
  }
  FAIL() << "they did not come to an end";
}

}  // namespace cobot_command::cell
