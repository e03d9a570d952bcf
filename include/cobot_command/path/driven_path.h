// What was sent of a path, in its order, and how far the robot has come on it: the way to drive back.
//
// Its time is that of the plans, one behind the other; where the robot stood meanwhile no time passes. Only
// where it was stopped on its way, which then was planned anew from there, a nanosecond does: so either side
// of such a cut has a time of its own.
// A value: a copy costs a pointer for each piece.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// No robot takes longer to stop, in the time of its path: so far it may have come behind what was seen of
/// it.
inline constexpr Duration kLongestStop = std::chrono::seconds(3);

class DrivenPath {
 public:
  /// So many points are remembered at least; of a longer path the last ones.
  static constexpr std::size_t kMostPoints = 1000;
  /// Within this of each joint the robot is at a place [rad].
  static constexpr double kSamePlace = 0.0017453;
  [[nodiscard]] static bool isSamePlace(const arm::JointVector& a, const arm::JointVector& b) {
    return (a - b).cwiseAbs().maxCoeff() <= kSamePlace;
  }

  // --- What becomes of the path. Points are counted from the first one of it on.
  /// A piece, from rest to rest, behind what was sent; its first point is that one. What the robot has passed
  /// and nobody can ask for any more is forgotten.
  void send(std::shared_ptr<const PathPlan> plan, std::size_t first);
  /// The robot is in the motion of that point, at that time of it; behind the last point at the end. Never
  /// back.
  void come(std::size_t point, Duration time);
  /// The robot stands with these joints, next to where it was seen last: a little further, or not yet there,
  /// as it may be slower than its clock. False: it is not on its way.
  bool stand(const arm::JointVector& joints);
  /// The same; and what lies in front of it is taken back, and goes on from there. Where it is not on its
  /// way, all that it has driven is forgotten.
  void cut(const arm::JointVector& joints);
  /// The robot was brought to there, along it.
  void bringTo(Duration place) { last_ = place; }

  // --- The way.
  /// The robot has not moved on it.
  [[nodiscard]] bool isEmpty() const { return reached_ == Duration::zero(); }
  /// It is not the whole of what the robot has driven.
  [[nodiscard]] bool isCutShort() const { return is_cut_short_; }
  /// Where the path has left the robot.
  [[nodiscard]] Duration reached() const { return reached_; }
  /// Its joints there [rad]; nothing: where that was is not certain.
  [[nodiscard]] const std::optional<arm::JointVector>& stood() const { return stood_; }
  /// Where the robot was on it last.
  [[nodiscard]] Duration last() const { return last_; }
  /// Of what is remembered, and of what was sent: where the robot was last is between them.
  [[nodiscard]] Duration begin() const;
  [[nodiscard]] Duration end() const;
  /// The robot may have come to there, as it was moved on behind what was seen of it last.
  [[nodiscard]] Duration farthest() const { return std::min(end(), reached_ + kLongestStop); }
  /// Before the begin where that is, after the end likewise. Precondition: it is not empty.
  [[nodiscard]] motion::JointState at(Duration time) const;
  /// Where the robot was stopped on its way, with these joints: the time of the one side, that of the other
  /// is a nanosecond later.
  struct Cut {
    Duration end{};
    arm::JointVector joints;
  };
  [[nodiscard]] std::vector<Cut> cuts() const;
  /// A point of a PVT of it: so far from at() the joints are there, so that no cubic is steeper than the
  /// path.
  struct Knot {
    Duration time{};
    arm::JointVector lead;
  };
  /// Between two times, but no more than `most`.
  [[nodiscard]] std::vector<Knot> knots(Duration from, Duration until, std::size_t most) const;

  // --- Its points, as their goals name them (PlannedPoint).
  /// Whose point is the first one that is remembered. Precondition: it is not empty.
  [[nodiscard]] int firstGoal() const;
  /// Whose point was under way last. Precondition: it is not empty.
  [[nodiscard]] int lastGoal() const;
  /// When it was driven past, or to: in a corner the middle of that. Nothing: it was not.
  [[nodiscard]] std::optional<Duration> passed(int goal, int index) const;
  /// Where the first point of that goal was set out for; nothing: that is not remembered.
  [[nodiscard]] std::optional<Duration> beginOf(int goal) const;
  /// The points of that goal that were passed and are remembered, the first and the last one; nothing: none.
  struct Range {
    int first = 0;
    int last = 0;
  };
  [[nodiscard]] std::optional<Range> passedOf(int goal) const;

 private:
  struct Piece {
    std::shared_ptr<const PathPlan> plan;
    std::size_t first = 0;                     ///< of its points
    Duration begin{};                          ///< in the time of the way
    Duration duration{};                       ///< as much of it as counts
    std::optional<arm::JointVector> cut = {};  ///< where the robot was stopped, at its end
    [[nodiscard]] Duration end() const { return begin + duration; }
  };

  [[nodiscard]] static Duration passTime(const Piece& piece, std::size_t point);
  /// There, which is a little further than where it was seen.
  [[nodiscard]] bool standsAt(const Piece& piece, Duration time) const;
  template <class Take>
  void forEachPassed(const Take& take) const;

  std::deque<Piece> pieces_;
  Duration reached_{};
  Duration last_{};
  std::optional<arm::JointVector> stood_;
  bool is_cut_short_ = false;
};

}  // namespace cobot_command::path
