// How soon all can be home at the earliest, from anywhere on the way.
#pragma once

#include <cstdint>
#include <vector>

#include "workload.h"

#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class Bound {
 public:
  /// The work has to live longer.
  explicit Bound(const Workload& work) : work_(work) {}

  /// By robot: how many of its events have happened, and when the last of them did. Nothing happens before
  /// `now` any more. No schedule that goes on from there ends before what is returned.
  [[nodiscard]] Duration of(const std::uint32_t* counts, const Duration* times, Duration now) const;

 private:
  [[nodiscard]] Duration ofZone(const Workload::Zone& zone, const std::uint32_t* counts,
                                const Duration* times, Duration now) const;
  [[nodiscard]] Duration nextOf(std::size_t robot, const std::uint32_t* counts, const Duration* times,
                                Duration now) const;

  const Workload& work_;
};

}  // namespace cobot_command::cell
