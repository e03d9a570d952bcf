// Blending: how a motion continues into the next one without a stop at the corner.
//
// The next motion starts while the previous one still decelerates. During this overlap the two are added in
// joint space: q(t) = before(t) + next(t - start) - corner. Both are continuous in position and speed, so
// their sum is too. Two PLines do not decelerate: the next one takes over before the first one decelerates,
// and rounds the corner itself. See doc/motion.md.
#pragma once

#include <limits>
#include <variant>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// Share of the time in which both motions are on their ramps: 0 (a stop) .. 1.
struct BlendShare {
  double value = 0.0;
};
/// Within this distance of the corner the TCP leaves the path of the first motion and reaches the path of the
/// second [m]; 0: a stop.
struct BlendRadius {
  double metres = 0.0;
};
/// Largest part of the paths that the blend may cut off: the last part of the first motion and the first part
/// of the second, each as a ratio (0..1). The TCP also stays within `radius` of the corner [m].
struct BlendWay {
  double before = 0.0;
  double next = 1.0;
  double radius = std::numeric_limits<double>::infinity();
};
using Blend = std::variant<BlendShare, BlendRadius, BlendWay>;

/// Two motions, each planned from rest to rest. The second starts at the end of the first.
struct Corner {
  const Trajectory& before;
  const Trajectory& next;
  arm::Pose tcp = arm::Pose::Identity();  ///< in the flange [m]
};

/// Limits of an overlap.
struct OverlapLimits {
  Duration most = Duration::max();  ///< such as the remaining time when the next motion becomes known
  Duration step = Duration(1);      ///< the overlap is a multiple of this
  Duration least{};                 ///< a shorter overlap becomes a stop
};

/// A time interval of a motion, since its start.
struct Interval {
  Duration from{};
  Duration to{};
};

/// The overlap that the blend requests. This is the upper bound, no matter when the next motion becomes
/// known: the other limits of overlapAt() only shorten it.
[[nodiscard]] Duration longestOverlap(const arm::ArmModel& arm, const Corner& corner, const Blend& blend);

/// Parts of a corner: the end of the first motion and the beginning of the second.
struct CornerReach {
  Duration before{};
  Duration next{};
};

/// The largest parts of both motions that can belong to the corner if each runs at its planned speed or at a
/// lower one, independently of the other. This is needed because a project speed applies to the motions that
/// start after it is set. If the next motion is slow and long, more of the first motion belongs to the corner
/// than longestOverlap() of both as planned. The completed share of `next` within its reach never exceeds
/// that of `before` within its own. Valid for motions whose speed rises and falls linearly, as all script
/// motions.
[[nodiscard]] CornerReach cornerReach(const arm::ArmModel& arm, const Corner& corner, const Blend& blend);

/// A range that contains the arm wherever the two motions are added, with `before` at any time of `of_before`
/// and `next` at any time of `of_next`, for every overlap: the sum of both ranges, minus the corner. With the
/// last and the first longestOverlap() it covers the whole corner, however late the next motion arrives,
/// including a stop. For a tighter range divide both times into parts. Pairs in which `next` has completed a
/// larger share of its time than `before` can be omitted, because they never occur. Precondition: `next`
/// starts where `before` ends. Refused if a time of either motion has no range.
[[nodiscard]] Result<JointRange, Unbounded> cornerRange(const Trajectory& before, const Interval& of_before,
                                                        const Trajectory& next, const Interval& of_next);

/// How long before the end of the first motion the next one can start. At most the ramps of both, half of
/// each motion (so that three in a row do not overlap), the overlap that the blend requests, and `limits`.
/// Shorter, down to zero, if otherwise a joint would leave its limits or exceed its rated speed, or the TCP
/// would leave the radius.
[[nodiscard]] Duration overlapAt(const arm::ArmModel& arm, const Corner& corner, const Blend& blend,
                                 const OverlapLimits& limits = {});

/// The state of the arm if `next` starts `overlap` before the end of `before`; `time` counts from that start.
[[nodiscard]] JointState stateIn(const Trajectory& before, const Trajectory& next, Duration overlap,
                                 Duration time);

/// The next motion as executed: during its first `overlap` the end of the previous motion is added. Returns
/// `next` itself if `overlap` is zero.
[[nodiscard]] TrajectoryPtr blended(const TrajectoryPtr& before, const TrajectoryPtr& next, Duration overlap);

/// The transition to the next motion.
struct Passage {
  Duration overlap{};     ///< time before the end of the previous motion; zero: no overlap
  TrajectoryPtr path;     ///< the motion as executed from there
  TrajectoryPtr planned;  ///< for blending into the motion after it: `path` without the previous motion
};

/// `before` and `next` as in Corner, but `before` may be the `planned` of a passage. PLines with a BlendShare
/// continue without deceleration if the arm can; all other motions blend with overlapAt().
[[nodiscard]] Passage passInto(const arm::ArmModel& arm, const TrajectoryPtr& before,
                               const TrajectoryPtr& next, const arm::Pose& tcp, const Blend& blend,
                               Duration left = Duration::max());

}  // namespace cobot_command::motion
