// How far a chain is on its way, piece after piece.
#pragma once

#include <cstddef>
#include <optional>

#include "chain/path_chain.h"
#include "paths/path_follower.h"
#include "paths/path_stand.h"

namespace cobot_command::blocks {

class PathProgress {
 public:
  /// Of the piece that moves the robot.
  struct Motion {
    LoadedPiecePtr piece;
    std::size_t first = 0;  ///< of its points
    Duration time{};        ///< since it began, by its plan
    double rate = 1.0;      ///< see PathFollower; 0 while it is held
  };

  explicit PathProgress(const arm::ArmModel& arm) : arm_(arm) {}

  /// That piece moves the robot from now on. `rate`: see PathFollower.
  void begin(const PathChain::Sent& sent, double rate, Instant now);
  [[nodiscard]] bool isUnderWay() const { return follower_.has_value(); }
  void hold(bool held, Instant now);
  /// The project speed was changed: nobody knows by which one the pieces run that are sent.
  void loseClock();
  void see(const arm::JointVector& joints, Instant now);
  /// By a tag: the points in front of that one are done.
  void done(std::size_t points);
  /// The piece under way is over: done, or not.
  void end();

  /// By all that is known until now. Points are not done by it that no tag has told of, at the end of a
  /// piece.
  [[nodiscard]] PathChain::Place placeAt(Instant now);
  /// The points in front of that one are done by what the stream has certainly shown.
  [[nodiscard]] std::size_t shown() const;
  /// Of the way of the active point, 0..1.
  [[nodiscard]] double share() const { return share_; }
  /// Nothing: none is under way.
  [[nodiscard]] std::optional<Motion> motion(Instant now) const;
  /// Where its arm was seen last. Nothing: none is under way.
  [[nodiscard]] std::optional<PathStand> standAt(Instant now) const;
  [[nodiscard]] ProgressSource source() const;
  [[nodiscard]] Duration remaining(Instant now) const;
  /// Of all pieces until now.
  [[nodiscard]] path::Deviation deviation() const;
  /// By the last frame [m].
  [[nodiscard]] double offThePath() const { return follower_ ? follower_->offThePath() : 0; }

 private:
  arm::ArmModel arm_;
  std::optional<PathFollower> follower_;
  LoadedPiecePtr piece_;   ///< under way
  std::size_t first_ = 0;  ///< point of it
  double rate_ = 1.0;      ///< of it
  bool is_held_ = false;
  std::size_t done_ = 0;
  double share_ = 0;
  bool has_clock_ = true;
  path::Deviation ended_;  ///< of the pieces that are over
};

}  // namespace cobot_command::blocks
