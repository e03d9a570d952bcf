// How a motion passes into the next one without a stop at the corner between them.
//
// The next motion starts while the one before it still slows down, and for that time the two add up in joint
// space: q(t) = before(t) + next(t - start) - corner. Both are continuous in position and speed, so their sum
// is. Two PLines do not slow down: the next one takes over before the first one does, and rounds the corner
// itself. See doc/motion.md.
#pragma once

#include <limits>
#include <variant>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// Of the time for which both motions are on their ramps, this share: 0 (a stop) .. 1.
struct BlendShare {
  double value = 0.0;
};
/// The TCP leaves the path of the one motion, and is on the path of the other, within this distance of the
/// corner [m]; 0: a stop.
struct BlendRadius {
  double metres = 0.0;
};
/// What is left out at most: of the way of the one motion its last part, of that of the other its first, each
/// as a share (0..1); and the TCP stays within `radius` of the corner [m].
struct BlendWay {
  double before = 0.0;
  double next = 1.0;
  double radius = std::numeric_limits<double>::infinity();
};
using Blend = std::variant<BlendShare, BlendRadius, BlendWay>;

/// Two motions, each planned from rest to rest, the next one from the end of the one before it.
struct Corner {
  const Trajectory& before;
  const Trajectory& next;
  arm::Pose tcp = arm::Pose::Identity();  ///< in the flange [m]
};

/// Of how an overlap may be.
struct OverlapLimits {
  Duration most = Duration::max();  ///< such as the time to the end when the next motion becomes known
  Duration step = Duration(1);      ///< it is a whole number of these
  Duration least{};                 ///< a shorter one is a stop
};

/// From one moment of a motion to another, since that motion began.
struct Interval {
  Duration from{};
  Duration to{};
};

/// The overlap that the blend asks for by itself. None is longer, whenever the next motion becomes known:
/// what keeps overlapAt() from it makes it shorter.
[[nodiscard]] Duration longestOverlap(const arm::ArmModel& arm, const Corner& corner, const Blend& blend);

/// So much of the end of the one motion, and of the beginning of the other.
struct CornerReach {
  Duration before{};
  Duration next{};
};

/// How much of both can be a corner when either is made at the speed that it was planned for, or at a lower
/// one, each at its own: the project speed counts for the motions that start from then on. With the next one
/// slow and long, more of the one before is a corner than longestOverlap() of both as planned has. The share
/// that `next` has made of its reach is never more than that which `before` has made of its own. For motions
/// whose speed grows and falls evenly, as of all that scripts have.
[[nodiscard]] CornerReach cornerReach(const arm::ArmModel& arm, const Corner& corner, const Blend& blend);

/// Contains the arm wherever the two add up while `before` is at any moment of `of_before` and `next` at any
/// of `of_next`, whatever the overlap: the sum of the ranges of both, less the corner. With the last and the
/// first longestOverlap() it is the whole corner however late the next motion comes, a stop included. Who
/// wants it closer cuts both times into parts, and needs no pair in which `next` is farther within its time
/// than `before` is: it never is. Precondition: `next` begins where `before` ends. Refused with a moment of
/// the one that has no range.
[[nodiscard]] Result<JointRange, Unbounded> cornerRange(const Trajectory& before, const Interval& of_before,
                                                        const Trajectory& next, const Interval& of_next);

/// How long before the end of the first motion the next one can start. Never longer than the ramps of both
/// and than half of each, so that three in a row do not overlap; than the blend asks for; nor than `limits`
/// allow. Shorter, down to zero, where a joint would otherwise leave its limits or be faster than rated, or
/// the TCP leave the radius.
[[nodiscard]] Duration overlapAt(const arm::ArmModel& arm, const Corner& corner, const Blend& blend,
                                 const OverlapLimits& limits = {});

/// Where the arm is when `next` begins `overlap` before the end of `before`; `time` counts from there.
[[nodiscard]] JointState stateIn(const Trajectory& before, const Trajectory& next, Duration overlap,
                                 Duration time);

/// The next motion as the arm makes it: over its first `overlap` the end of the one before it fades out.
/// `next` itself where `overlap` is zero.
[[nodiscard]] TrajectoryPtr blended(const TrajectoryPtr& before, const TrajectoryPtr& next, Duration overlap);

/// How the next motion takes over.
struct Passage {
  Duration overlap{};     ///< so long before the end of the motion before it; zero: behind it
  TrajectoryPtr path;     ///< as the arm makes it from there on
  TrajectoryPtr planned;  ///< what passes into the motion behind it: `path` without the end of the one before
};

/// `before` and `next` as in Corner, but `before` may be the `planned` of a passage. PLines with a BlendShare
/// pass on at their speed where the arm can; all else blends by overlapAt().
[[nodiscard]] Passage passInto(const arm::ArmModel& arm, const TrajectoryPtr& before,
                               const TrajectoryPtr& next, const arm::Pose& tcp, const Blend& blend,
                               Duration left = Duration::max());

}  // namespace cobot_command::motion
