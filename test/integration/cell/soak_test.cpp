// Hours of an iris with a fault each minute and somebody who sets right what it has left (P9): every goal
// ends, no zone ever has two holders, the arms keep their distance, and nobody waits for ever.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>
#include <set>

#include "run_rig.h"
#include "thorough.h"

namespace cobot_command::trial {
namespace {

using cell::RobotState;
using std::chrono::minutes;

constexpr Duration kBetweenFaults = minutes(1);
/// Whatever fails, each robot ends a goal in the meantime.
constexpr Duration kPatience = minutes(15);

/// So that a supervisor that is started anew mostly goes on from a journal that was made anew.
TrialSettings withShortJournals() {
  TrialSettings settings;
  settings.most_records = 40;
  return settings;
}

class Soak {
 public:
  explicit Soak(std::uint64_t seed)
      : random_(seed), rig_(artifactOf("iris"), withShortJournals()), ended_(3), goals_(3, 0) {}

  void run(Duration duration) {
    rig_.begin(1);
    const Instant end = rig_.trial->now() + duration;
    ended_.assign(3, rig_.trial->now());
    while (rig_.trial->now() < end && !::testing::Test::HasFatalFailure()) {
      const auto relief = fault();
      is_in_trouble_ = true;
      attend(fromSeconds(1.0 + share() * 9.0));
      relief();
      is_in_trouble_ = false;
      attend(kBetweenFaults - 10s);
    }
    for (cell::RobotIndex robot = 0; robot < 3; ++robot) {
      std::cout << rig_.robot(robot).name() << ": " << goals_[robot] << " goals, " << cycles_
                << " cycles of all\n";
      EXPECT_GT(goals_[robot], 0);
    }
    std::cout << faults_ << " faults, " << recoveries_ << " recoveries; least distance "
              << 1000.0 * rig_.trial->least().distance << " mm\n";
  }

 private:
  using Relief = std::function<void()>;

  [[nodiscard]] double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  [[nodiscard]] std::size_t anyOf(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  /// What ends it.
  Relief fault() {
    ++faults_;
    const cell::RobotIndex robot = anyOf(3);
    switch (anyOf(4)) {
      case 0:
        return faultOfController(robot);
      case 1:
        return faultOfOperator(robot);
      case 2:
        return faultOfNode(robot);
      default:
        return faultOfSupervisor();
    }
  }

  Relief faultOfController(cell::RobotIndex robot) {
    TrialRobot& one = rig_.robot(robot);
    switch (anyOf(4)) {
      case 0:
        one.operate(simulator::RaiseError{0x14058, "it is too much"});
        return [&one] { one.operate(simulator::ClearError{}); };
      case 1:
        one.operate(simulator::SetFault{"drop_stream", true, 0, 0, ""});
        return [&one] { one.operate(simulator::SetFault{"drop_stream", false, 0, 0, ""}); };
      case 2:
        one.operate(simulator::SetFault{"early_tag", true, 0, 0, ""});
        return [&one] { one.operate(simulator::SetFault{"early_tag", false, 0, 0, ""}); };
      default:
        one.dropConnections();
        return [] {};
    }
  }

  Relief faultOfOperator(cell::RobotIndex robot) {
    TrialRobot& one = rig_.robot(robot);
    switch (anyOf(5)) {
      case 0:
        one.operate(simulator::SetEmergencyStop{true});
        return [&one] {
          one.operate(simulator::SetEmergencyStop{false});
          one.operate(simulator::RunProject{});
        };
      case 1:
        one.operate(simulator::PauseProject{});
        return [&one] { one.operate(simulator::ResumeProject{}); };
      case 2:
        one.operate(simulator::SetOperatingMode{simulator::OperatingMode::Manual});
        return [&one] { one.operate(simulator::SetOperatingMode{simulator::OperatingMode::Automatic}); };
      case 3:
        one.operate(simulator::StopProject{});
        return [&one] { one.operate(simulator::RunProject{}); };
      default:
        one.operate(simulator::SetProjectSpeed{static_cast<int>(5 + 5 * anyOf(20))});
        return [&one] { one.operate(simulator::SetProjectSpeed{100}); };
    }
  }

  Relief faultOfNode(cell::RobotIndex robot) {
    switch (anyOf(4)) {
      case 0:
        rig_.robot(robot).restart(1000 + static_cast<std::uint64_t>(faults_));
        without_goal_.insert(robot);  // that goes with its node, and nobody is told an end of it
        return [] {};
      case 1:
        rig_.trial->cut(robot, true);
        return [this, robot] { rig_.trial->cut(robot, false); };
      case 2:
        static_cast<void>(rig_.robot(robot).submit(blocks::StopGoal{}));
        return [] {};
      default:
        rig_.robot(robot).cancel(rig_.robot(robot).lastGoal());
        return [] {};
    }
  }

  Relief faultOfSupervisor() {
    switch (anyOf(3)) {
      case 0:
        rig_.trial->killSupervisor();
        return [this] { rig_.trial->startSupervisor(); };
      case 1:
        static_cast<void>(rig_.supervision().hold(true, rig_.trial->now()));
        return [this] { static_cast<void>(rig_.supervision().hold(false, rig_.trial->now())); };
      default:
        static_cast<void>(rig_.supervision().stop(rig_.trial->now()));
        return [this] { static_cast<void>(rig_.supervision().hold(false, rig_.trial->now())); };
    }
  }

  /// Passes time, and sets right what can be.
  void attend(Duration duration) {
    const Instant end = rig_.trial->now() + duration;
    while (rig_.trial->now() < end && !::testing::Test::HasFatalFailure()) {
      rig_.pass(1s);
      for (cell::RobotIndex robot = 0; robot < 3; ++robot) attendTo(robot);
    }
  }

  void attendTo(cell::RobotIndex robot) {
    if (rig_.trial->hasSupervisor() && needsRecovery(robot)) recover(robot);
    // As behind an intrusion: one that people move may be in a zone of others.
    const bool is_held = rig_.trial->hasSupervisor() && rig_.mode() == cell::SupervisorMode::Holding;
    if (is_held && !is_in_trouble_) static_cast<void>(rig_.supervision().hold(false, rig_.trial->now()));
    attendToGoal(robot);
    const simulator::RobotState state = rig_.robot(robot).state();
    ASSERT_LT(rig_.trial->now() - ended_[robot], kPatience)
        << (state.in_motion ? "moving " : "") << (state.project_paused ? "paused " : "")
        << (state.project_running ? "" : "stopped ") << (state.listening ? "" : "elsewhere ")
        << state.project_speed_percent << " % " << rig_.robot(robot).name() << " is at "
        << rig_.placeOf(robot) << ": " << rig_.robot(robot).agent().stand(rig_.trial->now()).text
        << "; the cell is " << (rig_.trial->hasSupervisor() ? toString(rig_.mode()) : "without a supervisor");
  }

  void attendToGoal(cell::RobotIndex robot) {
    const bool is_gone = without_goal_.erase(robot) != 0;
    if (!is_gone && !rig_.robot(robot).hasEnded()) return;
    if (!is_gone) {
      ended_[robot] = rig_.trial->now();
      ++goals_[robot];
      cycles_ += rig_.robot(robot).lastOutcome()->detail.as<blocks::ProgramReport>().cycles_done;
    }
    rig_.order(robot, 1 + static_cast<int>(anyOf(4)));
  }

  [[nodiscard]] bool needsRecovery(cell::RobotIndex robot) const {
    const cell::RobotStatus status = rig_.of(robot);
    const bool is_unheard =
        rig_.mode() == cell::SupervisorMode::Recovery && status.state == RobotState::Absent;
    return is_unheard || status.state == RobotState::Fault || status.state == RobotState::OffPath ||
           status.state == RobotState::Lost;
  }

  /// Where it was last, or wherever it is by its joints, as a person would.
  void recover(cell::RobotIndex robot) {
    std::vector<std::string> places = {rig_.of(robot).place};
    for (const cell::CellPlace& place : model_.places[robot]) places.push_back(place.name);
    for (const std::string& place : places) {
      const auto answer =
          rig_.supervision().recover(rig_.robot(robot).name(), place, "the test", rig_.trial->now());
      if (!answer.success) continue;
      ++recoveries_;
      return;
    }
  }

  std::mt19937_64 random_;
  RunRig rig_;
  cell::CellModel model_ = *cell::modelOf(rig_.artifact->program);
  std::vector<Instant> ended_;  ///< by robot: when it ended a goal last
  std::vector<int> goals_;
  std::set<cell::RobotIndex> without_goal_;
  int cycles_ = 0;
  int faults_ = 0;
  int recoveries_ = 0;
  bool is_in_trouble_ = false;
};

TEST(AnIrisWithAFaultEachMinute, endsEveryGoalWithinTheMargin) {
  const auto seed = testing::fromEnvironment("COBOT_CELL_SEED", 9U);
  const auto most = testing::fromEnvironment("COBOT_CELL_MINUTES", testing::quickOrThorough(15U, 480U));
  Soak(seed).run(minutes(most));
}

}  // namespace
}  // namespace cobot_command::trial
