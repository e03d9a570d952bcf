#include "cobot_command/cell/zones/zones.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

/// Cuts what is longer than `most` voxels in the middle, again and again.
void cutTo(std::int32_t most, VoxelSet voxels, std::vector<VoxelSet>& pieces) {
  const auto bounds = voxels.bounds();
  if (!bounds) return;
  std::size_t longest = 0;
  std::array<std::int32_t, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    length[axis] = bounds->upper[axis] - bounds->lower[axis] + 1;
    if (length[axis] > length[longest]) longest = axis;
  }
  if (length[longest] <= most) return pieces.push_back(std::move(voxels));
  auto [lower, upper] = voxels.cut(longest, bounds->lower[longest] + length[longest] / 2);
  cutTo(most, std::move(lower), pieces);
  cutTo(most, std::move(upper), pieces);
}

/// With fewer voxels, what two share is a crumb of the grid: no zone of its own where another one is near.
constexpr std::size_t kCrumb = 8;
/// So many voxels between their boxes.
constexpr std::int32_t kNear = 4;

/// Along the axis along which they are farthest from each other; negative where their boxes meet.
std::int32_t gapBetween(const VoxelBounds& one, const VoxelBounds& other) {
  std::int32_t gap = std::numeric_limits<std::int32_t>::min();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gap = std::max({gap, one.lower[axis] - other.upper[axis] - 1, other.lower[axis] - one.upper[axis] - 1});
  }
  return gap;
}

bool fitTogether(const VoxelBounds& one, const VoxelBounds& other, std::int32_t most) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t upper = std::max(one.upper[axis], other.upper[axis]);
    if (upper - std::min(one.lower[axis], other.lower[axis]) >= most) return false;
  }
  return true;
}

/// Puts the crumbs among what two robots share to what is nearest to them.
void gatherCrumbs(std::vector<VoxelSet>& parts, std::int32_t most) {
  for (std::size_t crumb = 0; crumb < parts.size();) {
    std::size_t nearest = parts.size();
    std::int32_t gap = kNear + 1;
    for (std::size_t other = 0; parts[crumb].count() < kCrumb && other < parts.size(); ++other) {
      const auto bounds = std::make_pair(*parts[crumb].bounds(), *parts[other].bounds());
      if (other == crumb || !fitTogether(bounds.first, bounds.second, most)) continue;
      if (gapBetween(bounds.first, bounds.second) >= gap) continue;
      gap = gapBetween(bounds.first, bounds.second);
      nearest = other;
    }
    if (nearest == parts.size()) {
      ++crumb;
      continue;
    }
    parts[nearest] |= parts[crumb];
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(crumb));
    crumb = 0;
  }
}

std::vector<Zone> sharedByPairs(const std::vector<RobotClaim>& claims, const Parameters& parameters) {
  const auto most = std::max(1, static_cast<std::int32_t>(parameters.zone_size / parameters.voxel + 1e-9));
  std::vector<Zone> zones;
  for (RobotIndex one = 0; one < claims.size(); ++one) {
    for (RobotIndex other = one + 1; other < claims.size(); ++other) {
      std::vector<VoxelSet> pieces;
      for (VoxelSet& part : (claims[one].all & claims[other].all).components()) {
        cutTo(most, std::move(part), pieces);
      }
      gatherCrumbs(pieces, most);
      for (VoxelSet& piece : pieces) zones.push_back({"", {one, other}, std::move(piece)});
    }
  }
  return zones;
}

bool areToBeOne(const Zone& one, const Zone& other, double overlap) {
  if (one.users == other.users || overlap >= 1.0) return false;
  const auto common = static_cast<double>(one.voxels.countCommon(other.voxels));
  const auto smaller = static_cast<double>(std::min(one.voxels.count(), other.voxels.count()));
  return common > 0 && common >= overlap * smaller;
}

/// Until none are left that have to be one.
void unite(std::vector<Zone>& zones, double overlap) {
  for (std::size_t one = 0; one < zones.size(); ++one) {
    for (std::size_t other = one + 1; other < zones.size(); ++other) {
      if (!areToBeOne(zones[one], zones[other], overlap)) continue;
      zones[one].voxels |= zones[other].voxels;
      std::vector<RobotIndex> users;
      std::set_union(zones[one].users.begin(), zones[one].users.end(), zones[other].users.begin(),
                     zones[other].users.end(), std::back_inserter(users));
      zones[one].users = std::move(users);
      zones.erase(zones.begin() + static_cast<std::ptrdiff_t>(other));
      // It has grown: all others are looked at anew.
      one = static_cast<std::size_t>(-1);
      break;
    }
  }
}

void number(std::vector<Zone>& zones, const std::vector<RobotClaim>& claims) {
  const auto key = [&](const Zone& zone) {
    std::vector<std::string> names;
    for (const RobotIndex user : zone.users) names.push_back(claims[user].name);
    return std::make_pair(std::move(names), *zone.voxels.lowest());
  };
  std::sort(zones.begin(), zones.end(),
            [&](const Zone& one, const Zone& other) { return key(one) < key(other); });
  for (std::size_t zone = 0; zone < zones.size(); ++zone) zones[zone].name = fmt::format("Z{}", zone + 1);
}

}  // namespace

Result<std::vector<Zone>, std::string> findZones(const std::vector<RobotClaim>& claims,
                                                 const Parameters& parameters) {
  std::vector<Zone> zones = sharedByPairs(claims, parameters);
  unite(zones, parameters.zone_overlap);
  if (zones.size() > static_cast<std::size_t>(parameters.max_zones)) {
    return refuse(
        fmt::format("there are {} zones, but at most max_zones = {} are allowed: make zone_size larger, or "
                    "zone_overlap smaller",
                    zones.size(), parameters.max_zones));
  }
  number(zones, claims);
  return zones;
}

std::string boxOf(const Zone& zone, double voxel) {
  const auto bounds = zone.voxels.bounds();
  if (!bounds) return "empty";
  const auto side = [&](std::size_t axis, const char* name) {
    return fmt::format("{} {:.0f}..{:.0f}", name, mToMm(voxel * bounds->lower[axis]),
                       mToMm(voxel * (bounds->upper[axis] + 1)));
  };
  return fmt::format("{}, {}, {} mm", side(0, "x"), side(1, "y"), side(2, "z"));
}

}  // namespace cobot_command::cell
