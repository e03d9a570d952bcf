// The goals of a chain that is under way: where their points are, what they are told of that, and how those
// end that end before the chain does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "chain/path_chain.h"
#include "chain/path_replan.h"
#include "paths/path_progress.h"
#include "paths/path_status_report.h"

#include "cobot_command/blocks/shared/path_controlled.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/path/path_controls.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

class PathGoals final : public GoalChain {
 public:
  using Member = PathChain::Member;

  /// `reports` has to live longer.
  PathGoals(RunReports& reports, GoalId first, const PathReport& planned);

  [[nodiscard]] PathChain& pieces() { return chain_; }
  [[nodiscard]] const PathChain& pieces() const { return chain_; }
  [[nodiscard]] const PathChain::Place& place() const { return place_; }

  // --- GoalChain.
  [[nodiscard]] bool isJoinedBy(Block block) const override;
  [[nodiscard]] Detail end() const override;
  [[nodiscard]] bool join(GoalId goal, const Outcome& planned, Instant now) override;
  [[nodiscard]] bool takeOut(GoalId goal, const std::string& why, Instant now) override;
  [[nodiscard]] std::size_t waiting() const override;

  // --- What becomes of the pieces.
  /// Of the command of the first piece.
  void progressed(const Progress& progress, Instant now);
  /// The first piece moves the robot, as the one in front of it is done.
  void begin(Instant now);
  /// Where the robot has come to on it; nothing: it was not under way.
  std::optional<PathStand> pieceEnded(Instant now);
  /// By a tag: the points in front of that one are done. True: that is the whole chain, whose last goal is to
  /// end with it.
  [[nodiscard]] bool done(std::size_t points, Instant now);
  /// That command was stopped, to be planned anew from where the robot stands.
  std::optional<PathStand> takeBack(CommandKey key, Instant now);
  /// All that was sent is done, or taken back.
  void rewind(const arm::JointVector& joints, Instant now);
  void robotChanged(const robot::RobotWatch& robot, Instant now);
  void use(const path::PathControls& controls, Instant now);
  /// Nothing more is sent: what is not under way stays where it is.
  void stay() { stays_ = true; }

  // --- What everyone is told of it (PathStatus).
  [[nodiscard]] std::optional<Instant> statusDue() const { return status_clock_.due(); }
  /// When it is due.
  void tellStatus(Instant now);
  /// The last one.
  void endStatus();

  // --- What is known.
  /// When the piece under way should be done.
  [[nodiscard]] std::optional<Instant> pieceEnd() const { return piece_end_; }
  /// Nothing: the robot is as near to its path as the goal that moves it allows.
  [[nodiscard]] std::optional<Failure> deviation() const;
  [[nodiscard]] PathPace pace() const;
  [[nodiscard]] PathReplan& replan() { return replan_; }
  /// What is next may be sent, as far as feedrate and gates go.
  [[nodiscard]] bool mayGoOn() const;

  // --- Ends.
  /// Of goals behind the first one, of which nothing was sent.
  void dropUntouched(const std::string& why, Instant now);
  /// Of all behind the first one, with these outcomes; returns what is that one's.
  [[nodiscard]] Outcome endAll(const std::vector<Outcome>& outcomes, Instant now);
  /// With all that is known of how that goal went; where it ends without a place, that is the one of now.
  [[nodiscard]] Outcome complete(const Member& member, Outcome outcome, Instant now) const;

 private:
  void dropFrom(std::size_t member, const std::string& why, Instant now);
  void holdProgress(Instant now);
  void follow(Instant now);
  /// Of goals in front of that point, which are done. True: see done().
  [[nodiscard]] bool endUpTo(std::size_t points, Instant now);
  void tell(Instant now);
  void tellPhase(Progress& progress, const Member& member, const PathPlace& place) const;
  [[nodiscard]] Progress progressOf(const Member& member, const PathPlace& place) const;

  RunReports& reports_;
  PathChain chain_;
  PathReplan replan_{chain_};
  PathProgress progress_;
  PathChain::Place place_;
  PathStatusClock status_clock_;
  path::PathControls controls_;
  Phase phase_ = Phase::Sent;
  std::string text_;
  double rate_ = 1.0;
  std::optional<Instant> piece_end_;  ///< by the clock
  std::optional<PathStand> stand_;    ///< where the robot was seen on what was taken back
  std::optional<double> speed_;       ///< of the project, as streamed last
  std::optional<SixValues> joints_;   ///< that were streamed last [deg]
  std::optional<SixValues> pose_;
  bool stays_ = false;
  bool is_held_ = false;  ///< the robot is
};

}  // namespace cobot_command::blocks
