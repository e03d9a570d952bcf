#include "bound.h"

#include <algorithm>

namespace cobot_command::cell {

/// When the next event of a robot that has one happens, at the earliest.
Duration Bound::nextOf(std::size_t robot, const std::uint32_t* counts, const Duration* times,
                       Duration now) const {
  return std::max(times[robot] + work_.robots[robot].after[counts[robot]], now);
}

/// The holds that are left, one behind the other: from when the zone is free and the first of them wants it,
/// and with the shortest way home behind the last one.
Duration Bound::ofZone(const Workload::Zone& zone, const std::uint32_t* counts, const Duration* times,
                       Duration now) const {
  Duration free = now;
  Duration wanted = Duration::max();
  Duration held{};
  Duration way_home = Duration::max();
  for (const CycleHold& hold : zone.holds) {
    const Workload::Robot& robot = work_.robots[hold.robot];
    const std::size_t count = counts[hold.robot];
    const std::size_t last = robot.size() - 1;
    const std::size_t release = hold.release.value_or(last);
    if (count > release) continue;
    const Duration next = nextOf(hold.robot, counts, times, now);
    if (!hold.booking || count > *hold.booking) {
      free = std::max(free, next + robot.between(count, release));
      continue;
    }
    wanted = std::min(wanted, next + robot.between(count, *hold.booking));
    held += robot.between(*hold.booking, release);
    way_home = std::min(way_home, robot.between(release, last));
  }
  if (wanted == Duration::max()) return {};
  return std::max(free, wanted) + held + way_home;
}

Duration Bound::of(const std::uint32_t* counts, const Duration* times, Duration now) const {
  Duration bound{};
  for (std::size_t robot = 0; robot < work_.robots.size(); ++robot) {
    const Workload::Robot& cycle = work_.robots[robot];
    const bool is_home = counts[robot] == cycle.size();
    const Duration home =
        is_home ? times[robot]
                : nextOf(robot, counts, times, now) + cycle.between(counts[robot], cycle.size() - 1);
    bound = std::max(bound, home);
  }
  for (const Workload::Zone& zone : work_.zones) {
    bound = std::max(bound, ofZone(zone, counts, times, now));
  }
  return bound;
}

}  // namespace cobot_command::cell
