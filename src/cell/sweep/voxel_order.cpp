// What of a set of voxels depends on where they are: their order, their bounds and cuts, and their bytes.
#include <algorithm>
#include <limits>

#include "cobot_command/cell/sweep/voxel_set.h"

namespace cobot_command::cell {
namespace {

constexpr std::size_t kBytesOfCount = 8;
constexpr std::size_t kBytesOfBlock = 3 * 4 + 8 * 8;

/// The least significant byte first.
void write(std::string& bytes, std::uint64_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
}

std::uint64_t read(std::string_view bytes, std::size_t from, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[from + i])} << (8 * i);
  }
  return value;
}

/// The voxels of a block below `below` (1 to 7) along `axis`.
VoxelBlock lowerPart(const VoxelBlock& block, std::size_t axis, std::int32_t below) {
  VoxelBlock part;
  for (std::size_t x = 0; x < 8; ++x) {
    std::uint64_t mask = ~std::uint64_t{0};
    if (axis == 0 && x >= static_cast<std::size_t>(below)) mask = 0;
    if (axis == 1) mask = (std::uint64_t{1} << (8 * below)) - 1;
    if (axis == 2) mask = ((std::uint64_t{1} << below) - 1) * 0x0101010101010101U;
    part.words[x] = block.words[x] & mask;
  }
  return part;
}

VoxelBlock without(const VoxelBlock& block, const VoxelBlock& part) {
  VoxelBlock rest;
  for (std::size_t x = 0; x < 8; ++x) rest.words[x] = block.words[x] & ~part.words[x];
  return rest;
}

/// Calls with x, y, z (0 to 7) of each voxel of one x of a block, by y and z.
template <class Function>
void forEachIn(std::uint64_t word, const Function& function) {
  for (std::int32_t bit = 0; word != 0; ++bit, word >>= 1) {
    if ((word & 1) != 0) function(bit >> 3, bit & 7);
  }
}

}  // namespace

std::vector<const VoxelSet::Entry*> VoxelSet::sortedEntries() const {
  std::vector<const Entry*> sorted;
  sorted.reserve(entries_.size());
  for (const Entry& entry : entries_) sorted.push_back(&entry);
  std::sort(sorted.begin(), sorted.end(), [](const Entry* a, const Entry* b) { return a->block < b->block; });
  return sorted;
}

std::optional<VoxelBounds> VoxelSet::bounds() const {
  if (empty()) return std::nullopt;
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  VoxelBounds bounds{{kMost, kMost, kMost}, {-kMost, -kMost, -kMost}};
  for (const Entry& entry : entries_) {
    for (std::int32_t x = 0; x < 8; ++x) {
      forEachIn(entry.voxels.words[static_cast<std::size_t>(x)], [&](std::int32_t y, std::int32_t z) {
        const Voxel voxel{8 * entry.block[0] + x, 8 * entry.block[1] + y, 8 * entry.block[2] + z};
        for (std::size_t i = 0; i < 3; ++i) {
          bounds.lower[i] = std::min(bounds.lower[i], voxel[i]);
          bounds.upper[i] = std::max(bounds.upper[i], voxel[i]);
        }
      });
    }
  }
  return bounds;
}

std::optional<Voxel> VoxelSet::lowest() const {
  std::optional<Voxel> lowest;
  for (const Entry& entry : entries_) {
    const auto& words = entry.voxels.words;
    const auto word = std::find_if(words.begin(), words.end(), [](std::uint64_t bits) { return bits != 0; });
    std::int32_t bit = 0;
    while ((*word >> bit & 1) == 0) ++bit;
    const auto x = static_cast<std::int32_t>(word - words.begin());
    const Voxel voxel{8 * entry.block[0] + x, 8 * entry.block[1] + (bit >> 3),
                      8 * entry.block[2] + (bit & 7)};
    if (!lowest || voxel < *lowest) lowest = voxel;
  }
  return lowest;
}

std::vector<Voxel> VoxelSet::sorted() const {
  std::vector<Voxel> voxels;
  voxels.reserve(count());
  for (const Entry& entry : entries_) {
    for (std::int32_t x = 0; x < 8; ++x) {
      forEachIn(entry.voxels.words[static_cast<std::size_t>(x)], [&](std::int32_t y, std::int32_t z) {
        voxels.push_back({8 * entry.block[0] + x, 8 * entry.block[1] + y, 8 * entry.block[2] + z});
      });
    }
  }
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

std::pair<VoxelSet, VoxelSet> VoxelSet::cut(std::size_t axis, std::int32_t at) const {
  std::pair<VoxelSet, VoxelSet> parts;
  for (const Entry& entry : entries_) {
    const std::int32_t below = at - 8 * entry.block[axis];
    if (below <= 0) {
      parts.second.insertBlock(entry.block, entry.voxels);
    } else if (below >= 8) {
      parts.first.insertBlock(entry.block, entry.voxels);
    } else {
      const VoxelBlock lower = lowerPart(entry.voxels, axis, below);
      parts.first.insertBlock(entry.block, lower);
      parts.second.insertBlock(entry.block, without(entry.voxels, lower));
    }
  }
  return parts;
}

std::string VoxelSet::bytes() const {
  std::string bytes;
  bytes.reserve(kBytesOfCount + kBytesOfBlock * entries_.size());
  write(bytes, entries_.size(), kBytesOfCount);
  for (const Entry* entry : sortedEntries()) {
    for (const std::int32_t place : entry->block) write(bytes, static_cast<std::uint32_t>(place), 4);
    for (const std::uint64_t word : entry->voxels.words) write(bytes, word, 8);
  }
  return bytes;
}

std::optional<VoxelSet> VoxelSet::fromBytes(std::string_view bytes) {
  if (bytes.size() < kBytesOfCount || (bytes.size() - kBytesOfCount) % kBytesOfBlock != 0) {
    return std::nullopt;
  }
  const std::size_t count = (bytes.size() - kBytesOfCount) / kBytesOfBlock;
  if (read(bytes, 0, kBytesOfCount) != count) return std::nullopt;
  VoxelSet set;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t from = kBytesOfCount + i * kBytesOfBlock;
    Entry entry;
    for (std::int32_t& place : entry.block) {
      place = static_cast<std::int32_t>(static_cast<std::uint32_t>(read(bytes, from, 4)));
      if (place < -kFarthestVoxel / 8 || place > kFarthestVoxel / 8) return std::nullopt;
      from += 4;
    }
    for (std::uint64_t& word : entry.voxels.words) {
      word = read(bytes, from, 8);
      from += 8;
    }
    const bool behind_the_last = set.empty() || set.entries_.back().block < entry.block;
    if (!behind_the_last || entry.voxels.empty()) return std::nullopt;
    set.insertBlock(entry.block, entry.voxels);
  }
  return set;
}

}  // namespace cobot_command::cell
