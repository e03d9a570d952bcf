// A path under way, block by block: each is one PVT from rest to rest, sent once the robot stands at the end
// of the one in front of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::blocks {

class LoadPathRun final : public Run {
 public:
  /// `planned`: what plan() found. Precondition: it found a path.
  LoadPathRun(GoalId id, const LoadPathGoal& goal, const Outcome& planned, Instant now);

  [[nodiscard]] std::optional<Command> next() const override;
  void commandStarted(CommandKey key) override;
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;

  void interrupt(const std::string& why, Instant now) override {
    taken_away_ = true;
    cancel(why, now);
  }
  [[nodiscard]] bool failed() const override { return Run::failed() && !interrupted_; }
  void cancel(const std::string& why, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;

 private:
  struct Piece {
    path::PvtBlock block;
    std::size_t key = 0;
  };

  [[nodiscard]] const path::PathPlan& plan() const;
  [[nodiscard]] bool isLoaded() const { return sent_ == pieces_.size(); }
  /// How far along the path it is, by the time of the piece under way.
  [[nodiscard]] PathPlace placeAt(Duration time) const;
  /// In the array of the goal; -1: there is no such point.
  [[nodiscard]] int indexOf(std::size_t point) const;
  /// `why`: and what became of the robot.
  void endCancelled(const std::string& why, Instant now);
  void fail(const Failure& failure, Instant now);
  void endAs(Outcome outcome, Instant now);

  GoalTraits traits_;
  PathReport report_;
  std::optional<Duration> planned_;
  Instant started_at_;
  std::vector<Piece> pieces_;  ///< those that move
  std::size_t sent_ = 0;       ///< of them
  bool under_way_ = false;
  int active_ = -1;           ///< index of the point that moves the robot; -1: none does
  bool taken_away_ = false;   ///< not by its own client
  bool interrupted_ = false;  ///< it has ended with that
};

}  // namespace cobot_command::blocks
