// Random paths, and whatever may become of them, on a robot that carries them out: the rules hold.
//
// A failure prints its seed; COBOT_TEST_SEED chooses another.
#include <random>

#include "path_goals.h"
#include "thorough.h"

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

class Walk {
 public:
  Walk(unsigned seed, Duration planning) : random_(seed), cell_("tm5-900", {}, {}, planning) {
    cell_.connect();
  }

  void step() {
    switch (pick(24)) {
      case 0:
        cell_.submit(StopGoal());
        break;
      case 1:
      case 2:
        cancelAny();
        break;
      case 3:
      case 4:
      case 5:
      case 6:
        askForAFeedrate();
        break;
      case 7:
      case 8:
      case 9:
        static_cast<void>(cell_.switchTracking({static_cast<int>(pick(2)), pick(3) == 0, pick(2) == 0}));
        break;
      case 10:
        if (pick(4) == 0) cell_.finish();
        break;
      case 11:
        cell_.submit(ProgramControlGoal{0, static_cast<int>(pick(2))});
        break;
      case 12:
        if (pick(3) == 0) misfortune();
        break;
      case 13:
        recover();
        break;
      default:
        submitPath();
    }
    cell_.pass(std::chrono::milliseconds(pick(600)));
    checkCounts();
  }

  /// What waits can go on, or be stopped, and then the cell works.
  void finish() {
    recover();
    for (const GoalId id : paths_) cell_.cancel(id);
    cell_.pass(10s);
    for (const GoalId id : paths_) EXPECT_NE(cell_.outcome(id), nullptr) << "goal " << id;
    for (const auto& answer : feedrates_) EXPECT_TRUE(answer->has_value()) << "a feedrate has no answer";
    recover();
    cell_.pass(10s);
    cell_.setFeedrate(100);
    for (const int object : {0, 1}) static_cast<void>(cell_.switchTracking({object, false, false}));
    cell_.submit(ProgramControlGoal{0, 1});
    cell_.pass(2s);
    const GoalId last = cell_.submit(turns(2, true, 10));
    const Outcome& outcome = cell_.endOf(last);
    EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_id << " " << outcome.error_description;
    EXPECT_NEAR(radToDeg(cell_.robot().joints[0]), 36, 0.01);
  }

  int done = 0;

 private:
  std::size_t pick(std::size_t count) { return random_() % count; }

  void submitPath() {
    LoadPathGoal goal = turns(1 + static_cast<int>(pick(12)), pick(2) == 0, static_cast<int>(pick(20)));
    for (path::PathPoint& point : goal.path) {
      point.speed = 36;
      point.acceleration = point.deceleration = 180;
      if (pick(5) == 0) point.termination_type = 0;
    }
    goal.execution = static_cast<int>(pick(3));
    goal.allow_approximation = pick(2) == 0;
    goal.enable_tracking = {pick(8) == 0, pick(16) == 0};
    goal.buffer_mode = static_cast<int>(pick(8) == 0 ? 2 : pick(2));
    paths_.push_back(cell_.submit(goal));
  }
  void cancelAny() {
    if (paths_.empty()) return;
    cell_.cancel(paths_[paths_.size() - 1 - pick(std::min<std::size_t>(paths_.size(), 4))]);
  }
  void askForAFeedrate() {
    constexpr double kPercents[] = {0, 10, 33.3, 50, 100, 125};
    cell_.setFeedrate(pick(3) == 0 ? std::nullopt : std::optional(kPercents[pick(std::size(kPercents))]),
                      pick(2) == 0);
    feedrates_.push_back(cell_.feedratePromise());
  }
  void misfortune() {
    switch (pick(4)) {
      case 0:
        cell_.dropConnections();
        break;
      case 1:
        cell_.operate(simulator::PauseProject{});
        break;
      case 2:
        cell_.operate(simulator::SetEmergencyStop{pick(2) == 0});
        break;
      default:
        cell_.operate(simulator::StopProject{});
    }
  }
  void recover() {
    cell_.operate(simulator::SetEmergencyStop{false});
    cell_.operate(simulator::ClearError{});
    cell_.operate(simulator::RunProject{});
    cell_.operate(simulator::ResumeProject{});
    ConnectGoal goal;
    goal.host = "robot";
    cell_.submit(goal);
  }

  /// Of each goal, by what it was told last.
  void checkCounts() {
    for (std::size_t i = checked_; i < paths_.size(); ++i) {
      const auto& told = cell_.progress(paths_[i]);
      const auto* const place = told.empty() ? nullptr : told.back().detail.find<PathPlace>();
      if (place == nullptr) continue;
      EXPECT_LE(place->queued_path_points, 5);
      EXPECT_EQ(place->loaded, place->pending_path_points == 0);
      EXPECT_FALSE(place->waits_for_tracking && place->active);
    }
    for (; checked_ < paths_.size() && cell_.outcome(paths_[checked_]) != nullptr; ++checked_) {
      done += cell_.outcome(paths_[checked_])->ending == Ending::Done ? 1 : 0;
    }
  }

  std::mt19937 random_;
  CoreAndRobot cell_;
  std::vector<GoalId> paths_;
  std::size_t checked_ = 0;
  std::vector<CoreAndRobot::FeedratePromise> feedrates_;
};

void walk(Duration planning) {
  const unsigned seed = fromEnvironment("COBOT_TEST_SEED", 20261123);
  int done = 0;
  for (unsigned round = 0; round < 6 && !::testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed + round));
    Walk walk(seed + round, planning);
    for (int i = 0; i < 200 && !::testing::Test::HasFailure(); ++i) walk.step();
    walk.finish();
    done += walk.done;
  }
  EXPECT_GT(done, 0) << "it is worth its time only if paths are done, too";
}

TEST(LoadPathAtRandom, breaksNoRule) {
  walk(0ms);
}

TEST(LoadPathAtRandom, breaksNoRuleWhileItIsPlannedBesideTheCore) {
  walk(250ms);
}

}  // namespace
}  // namespace cobot_command::testing
