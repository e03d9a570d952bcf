// Which voxels hang together: each step goes on in all directions from all voxels of a block at once.
#include <algorithm>
#include <utility>

#include "cobot_command/cell/sweep/voxel_set.h"

namespace cobot_command::cell {
namespace {

/// From a block to one of the 27 that begin at most one block away; each -1, 0 or 1.
using Direction = std::array<std::int32_t, 3>;

constexpr std::uint64_t kLowestZ = 0x0101010101010101U;
constexpr std::uint64_t kHighestZ = 0x8080808080808080U;

/// A block one step lower and higher along an axis, without what leaves the block.
VoxelBlock lowered(const VoxelBlock& block, std::size_t axis) {
  VoxelBlock result;
  for (std::size_t x = 0; x < 8; ++x) {
    if (axis == 0) result.words[x] = x < 7 ? block.words[x + 1] : 0;
    if (axis == 1) result.words[x] = block.words[x] >> 8;
    if (axis == 2) result.words[x] = (block.words[x] & ~kLowestZ) >> 1;
  }
  return result;
}
VoxelBlock raised(const VoxelBlock& block, std::size_t axis) {
  VoxelBlock result;
  for (std::size_t x = 0; x < 8; ++x) {
    if (axis == 0) result.words[x] = x > 0 ? block.words[x - 1] : 0;
    if (axis == 1) result.words[x] = block.words[x] << 8;
    if (axis == 2) result.words[x] = (block.words[x] & ~kHighestZ) << 1;
  }
  return result;
}

/// What of a block comes into the next one when it goes a step higher (`up`) or lower along an axis.
VoxelBlock crossed(const VoxelBlock& block, std::size_t axis, bool up) {
  VoxelBlock result;
  if (axis == 0) {
    result.words[up ? 0 : 7] = block.words[up ? 7 : 0];
    return result;
  }
  for (std::size_t x = 0; x < 8; ++x) {
    const std::uint64_t word = block.words[x];
    if (axis == 1) result.words[x] = up ? word >> 56 : word << 56;
    if (axis == 2) result.words[x] = up ? (word & kHighestZ) >> 7 : (word & kLowestZ) << 7;
  }
  return result;
}

VoxelBlock united(const VoxelBlock& a, const VoxelBlock& b) {
  VoxelBlock result;
  for (std::size_t x = 0; x < 8; ++x) result.words[x] = a.words[x] | b.words[x];
  return result;
}

/// Of the block in this direction, the voxels that are the same as, or touch, one of `block`.
VoxelBlock spread(VoxelBlock block, const Direction& direction) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0) {
      block = crossed(block, axis, direction[axis] > 0);
    } else {
      block = united(block, united(lowered(block, axis), raised(block, axis)));
    }
  }
  return block;
}

/// Moves what is in both out of `left`, and tells it.
VoxelBlock taken(VoxelBlock& left, const VoxelBlock& reached) {
  VoxelBlock common;
  for (std::size_t x = 0; x < 8; ++x) {
    common.words[x] = left.words[x] & reached.words[x];
    left.words[x] &= ~reached.words[x];
  }
  return common;
}

/// All that hangs together with `voxels` within their block, moved out of `left`.
VoxelBlock grownWithin(VoxelBlock voxels, VoxelBlock& left) {
  while (true) {
    const VoxelBlock more = taken(left, spread(voxels, {0, 0, 0}));
    if (more.empty()) return voxels;
    voxels = united(voxels, more);
  }
}

/// Any one voxel of a block that has some.
VoxelBlock oneOf(const VoxelBlock& block) {
  VoxelBlock one;
  const auto word =
      std::find_if(block.words.begin(), block.words.end(), [](std::uint64_t bits) { return bits != 0; });
  one.words[static_cast<std::size_t>(word - block.words.begin())] = *word & (~*word + 1);
  return one;
}

}  // namespace

/// What hangs together with one voxel of `left` in this entry, moved out of `left`, which has a block for
/// each entry.
VoxelSet VoxelSet::componentAround(std::size_t entry, std::vector<VoxelBlock>& left) const {
  VoxelSet component;
  std::vector<std::pair<std::size_t, VoxelBlock>> open;
  open.emplace_back(entry, taken(left[entry], oneOf(left[entry])));
  while (!open.empty()) {
    const std::size_t place = open.back().first;
    const VoxelBlock voxels = grownWithin(open.back().second, left[place]);
    open.pop_back();
    const Voxel& block = entries_[place].block;
    component.insertBlock(block, voxels);
    for (std::int32_t i = 0; i < 27; ++i) {
      const Direction direction{i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
      const VoxelBlock reached = spread(voxels, direction);
      if (reached.empty()) continue;
      const std::uint32_t next =
          index_[slotOf({block[0] + direction[0], block[1] + direction[1], block[2] + direction[2]})];
      if (next == 0) continue;
      const VoxelBlock more = taken(left[next - 1], reached);
      if (!more.empty()) open.emplace_back(next - 1, more);
    }
  }
  return component;
}

std::vector<VoxelSet> VoxelSet::components() const {
  std::vector<VoxelBlock> left;
  left.reserve(entries_.size());
  for (const Entry& entry : entries_) left.push_back(entry.voxels);
  std::vector<std::pair<Voxel, VoxelSet>> found;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    while (!left[i].empty()) {
      VoxelSet component = componentAround(i, left);
      const Voxel lowest = *component.lowest();
      found.emplace_back(lowest, std::move(component));
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<VoxelSet> components;
  components.reserve(found.size());
  for (auto& [lowest, component] : found) components.push_back(std::move(component));
  return components;
}

}  // namespace cobot_command::cell
