// The executed part of a path, in its order, and the progress of the robot on it. Used to retrace the path.
//
// Its time is the time of the plans, one after the other; standstill between them takes no time. If the robot
// was stopped on the path and the path was planned again from there, a nanosecond is inserted, so both sides
// of such a cut have their own time. A value: a copy costs one pointer per piece.
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

/// Upper bound of the time that a robot takes to stop, in path time. The robot may be this far past its last
/// observed place.
inline constexpr Duration kLongestStop = std::chrono::seconds(3);

class DrivenPath {
 public:
  /// Minimum number of remembered points. Of a longer path the last ones are kept.
  static constexpr std::size_t kMostPoints = 1000;
  /// The robot is at a place if each joint is within this distance [rad].
  static constexpr double kSamePlace = 0.0017453;
  [[nodiscard]] static bool isSamePlace(const arm::JointVector& a, const arm::JointVector& b) {
    return (a - b).cwiseAbs().maxCoeff() <= kSamePlace;
  }

  // --- Progress of the path. Points are counted from its first point.
  /// Appends a piece, from rest to rest, to the sent path; `first` is the number of its first point. Pieces
  /// that the robot has passed are discarded if enough points remain.
  void send(std::shared_ptr<const PathPlan> plan, std::size_t first);
  /// The robot is in the motion of that point, at that time of the motion; a point after the last one means
  /// the end. Progress never decreases.
  void come(std::size_t point, Duration time);
  /// The robot has stopped with these joints, near its last observed place: slightly after it, or slightly
  /// before it, because the robot may be slower than its clock. Returns false if the robot is not on the
  /// path.
  bool stand(const arm::JointVector& joints);
  /// The same, and the path after this place is discarded. The next piece continues from there. If the robot
  /// is not on the path, the whole driven path is discarded.
  void cut(const arm::JointVector& joints);
  /// The robot was moved along the path to this place.
  void bringTo(Duration place) { last_ = place; }

  // --- The driven path.
  /// True if the robot has not moved on the path.
  [[nodiscard]] bool isEmpty() const { return reached_ == Duration::zero(); }
  /// True if cut() has discarded what the robot drove before.
  [[nodiscard]] bool isCutShort() const { return is_cut_short_; }
  /// The place that the robot has reached by executing the path.
  [[nodiscard]] Duration reached() const { return reached_; }
  /// The joints there [rad]; std::nullopt: the place is uncertain.
  [[nodiscard]] const std::optional<arm::JointVector>& stood() const { return stood_; }
  /// The last place of the robot on the path.
  [[nodiscard]] Duration last() const { return last_; }
  /// Start of the remembered path and end of the sent path. The last place of the robot is between them.
  [[nodiscard]] Duration begin() const;
  [[nodiscard]] Duration end() const;
  /// The farthest place that the robot may have reached, because it may have moved on after its last observed
  /// place.
  [[nodiscard]] Duration farthest() const { return std::min(end(), reached_ + kLongestStop); }
  /// Before begin() the state there, after end() likewise. Precondition: not empty.
  [[nodiscard]] motion::JointState at(Duration time) const;
  /// A place where the robot was stopped on the path, with its joints there. `end` is the time of the first
  /// side; that of the other side is one nanosecond later.
  struct Cut {
    Duration end{};
    arm::JointVector joints;
  };
  [[nodiscard]] std::vector<Cut> cuts() const;
  /// A PVT point of the path. `lead` is the offset of its joints from at(), which keeps every cubic from
  /// being steeper than the path.
  struct Knot {
    Duration time{};
    arm::JointVector lead;
  };
  /// The points between two times, at most `most`.
  [[nodiscard]] std::vector<Knot> knots(Duration from, Duration until, std::size_t most) const;

  // --- Its points, identified by their goals (PlannedPoint).
  /// The goal of the first remembered point. Precondition: not empty.
  [[nodiscard]] int firstGoal() const;
  /// The goal of the last active point. Precondition: not empty.
  [[nodiscard]] int lastGoal() const;
  /// When the robot passed or reached the point; at a blended corner the middle of the overlap. std::nullopt:
  /// not passed.
  [[nodiscard]] std::optional<Duration> passed(int goal, int index) const;
  /// When the motion to the first point of the goal started; std::nullopt: not remembered.
  [[nodiscard]] std::optional<Duration> beginOf(int goal) const;
  /// The first and the last passed point of the goal that are remembered; std::nullopt: none.
  struct Range {
    int first = 0;
    int last = 0;
  };
  [[nodiscard]] std::optional<Range> passedOf(int goal) const;

 private:
  struct Piece {
    std::shared_ptr<const PathPlan> plan;
    std::size_t first = 0;                     ///< number of its first point
    Duration begin{};                          ///< in the time of the driven path
    Duration duration{};                       ///< of the part that is used
    std::optional<arm::JointVector> cut = {};  ///< joints where the robot was stopped, at its end
    [[nodiscard]] Duration end() const { return begin + duration; }
  };

  [[nodiscard]] static Duration passTime(const Piece& piece, std::size_t point);
  /// True if the robot has stopped there, slightly after its last observed place.
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
