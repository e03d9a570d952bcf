#include "cobot_command/motion/joint_range.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

Unbounded unbounded(Duration from, Duration to, const char* why) {
  return {from, to,
          fmt::format(
              "UNBOUNDED: from {:.6f} s to {:.6f} s of the motion no range of the joints can be proved, {}",
              toSeconds(from), toSeconds(to), why)};
}

Result<JointRange, Unbounded> Trajectory::jointRange(Duration from, Duration to) const {
  const Duration end = duration();
  const Duration first = std::clamp(std::min(from, to), Duration::zero(), end);
  const Duration last = std::clamp(std::max(from, to), Duration::zero(), end);
  auto range = first == last ? Result<JointRange, Unbounded>(JointRange::of(at(first).position))
                             : rangeWithin(first, last);
  if (range) {
    range->lower.array() -= kRangeRoom;
    range->upper.array() += kRangeRoom;
  }
  return range;
}

Result<JointRange, Unbounded> Trajectory::rangeWithin(Duration from, Duration to) const {
  return refuse(unbounded(from, to, "because this kind of motion guarantees none: use one that is planned"));
}

}  // namespace cobot_command::motion
