#include "cobot_command/cell/sweep/voxel_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace cobot_command::cell {
namespace {

constexpr std::size_t kFewestSlots = 16;

Voxel blockOf(const Voxel& voxel) {
  return {voxel[0] >> 3, voxel[1] >> 3, voxel[2] >> 3};
}

std::size_t wordOf(const Voxel& voxel) {
  return static_cast<std::size_t>(voxel[0] & 7);
}

std::uint64_t bitOf(const Voxel& voxel) {
  return std::uint64_t{1} << (8 * (voxel[1] & 7) + (voxel[2] & 7));
}

/// Neighbours are far from each other in it.
std::size_t hashOf(const Voxel& block) {
  const auto part = [](std::int32_t value) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value));
  };
  std::uint64_t hash = part(block[0]) * 0x9E3779B97F4A7C15U;
  hash = (hash ^ part(block[1])) * 0xC2B2AE3D27D4EB4FU;
  hash = (hash ^ part(block[2])) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

std::size_t bitsOf(std::uint64_t word) {
  word -= (word >> 1) & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::size_t>((word * 0x0101010101010101U) >> 56);
}

}  // namespace

Voxel voxelAt(const Eigen::Vector3d& point, double edge) {
  Voxel voxel{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = std::floor(point[static_cast<Eigen::Index>(i)] / edge);
    assert(std::abs(place) <= kFarthestVoxel);
    voxel[i] = static_cast<std::int32_t>(place);
  }
  return voxel;
}

AlignedBox cubeOf(const Voxel& voxel, double edge) {
  const Eigen::Vector3d lower(voxel[0], voxel[1], voxel[2]);
  return {edge * lower, edge * (lower + Eigen::Vector3d::Ones())};
}

bool VoxelBlock::empty() const {
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == 0; });
}

bool VoxelSet::insert(const Voxel& voxel) {
  std::uint64_t& word = at(blockOf(voxel)).words[wordOf(voxel)];
  const bool is_new = (word & bitOf(voxel)) == 0;
  word |= bitOf(voxel);
  return is_new;
}

bool VoxelSet::contains(const Voxel& voxel) const {
  const VoxelBlock* block = find(blockOf(voxel));
  return block != nullptr && (block->words[wordOf(voxel)] & bitOf(voxel)) != 0;
}

std::size_t VoxelSet::count() const {
  std::size_t sum = 0;
  for (const Entry& entry : entries_) {
    for (const std::uint64_t word : entry.voxels.words) sum += bitsOf(word);
  }
  return sum;
}

void VoxelSet::clear() {
  entries_.clear();
  index_.clear();
}

void VoxelSet::insertBlock(const Voxel& block, const VoxelBlock& voxels) {
  if (voxels.empty()) return;
  VoxelBlock& mine = at(block);
  for (std::size_t i = 0; i < mine.words.size(); ++i) mine.words[i] |= voxels.words[i];
}

VoxelSet& VoxelSet::operator|=(const VoxelSet& other) {
  if (this == &other) return *this;
  for (const Entry& entry : other.entries_) insertBlock(entry.block, entry.voxels);
  return *this;
}

VoxelSet& VoxelSet::operator&=(const VoxelSet& other) {
  static const VoxelBlock none;
  for (Entry& entry : entries_) {
    const VoxelBlock* theirs = other.find(entry.block);
    if (theirs == nullptr) theirs = &none;
    for (std::size_t i = 0; i < 8; ++i) entry.voxels.words[i] &= theirs->words[i];
  }
  dropEmptyBlocks();
  return *this;
}

VoxelSet& VoxelSet::operator-=(const VoxelSet& other) {
  if (this == &other) {
    clear();
    return *this;
  }
  for (Entry& entry : entries_) {
    const VoxelBlock* theirs = other.find(entry.block);
    if (theirs == nullptr) continue;
    for (std::size_t i = 0; i < 8; ++i) entry.voxels.words[i] &= ~theirs->words[i];
  }
  dropEmptyBlocks();
  return *this;
}

bool operator==(const VoxelSet& a, const VoxelSet& b) {
  if (a.entries_.size() != b.entries_.size()) return false;
  return std::all_of(a.entries_.begin(), a.entries_.end(), [&](const VoxelSet::Entry& entry) {
    const VoxelBlock* theirs = b.find(entry.block);
    return theirs != nullptr && theirs->words == entry.voxels.words;
  });
}

bool VoxelSet::touches(const VoxelSet& other) const {
  if (other.entries_.size() < entries_.size()) return other.touches(*this);
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    const VoxelBlock* theirs = other.find(entry.block);
    if (theirs == nullptr) return false;
    std::uint64_t common = 0;
    for (std::size_t i = 0; i < 8; ++i) common |= entry.voxels.words[i] & theirs->words[i];
    return common != 0;
  });
}

std::size_t VoxelSet::countCommon(const VoxelSet& other) const {
  if (other.entries_.size() < entries_.size()) return other.countCommon(*this);
  std::size_t sum = 0;
  for (const Entry& entry : entries_) {
    const VoxelBlock* theirs = other.find(entry.block);
    if (theirs == nullptr) continue;
    for (std::size_t i = 0; i < 8; ++i) sum += bitsOf(entry.voxels.words[i] & theirs->words[i]);
  }
  return sum;
}

std::size_t VoxelSet::memory() const {
  return entries_.capacity() * sizeof(Entry) + index_.capacity() * sizeof(std::uint32_t);
}

/// That of the block, or the empty one where it would be. Precondition: there is an index.
std::size_t VoxelSet::slotOf(const Voxel& block) const {
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = hashOf(block) & mask;
  while (index_[slot] != 0 && entries_[index_[slot] - 1].block != block) slot = (slot + 1) & mask;
  return slot;
}

const VoxelBlock* VoxelSet::find(const Voxel& block) const {
  if (index_.empty()) return nullptr;
  const std::uint32_t place = index_[slotOf(block)];
  return place == 0 ? nullptr : &entries_[place - 1].voxels;
}

/// Who asks for it puts something into it.
VoxelBlock& VoxelSet::at(const Voxel& block) {
  if (2 * (entries_.size() + 1) > index_.size()) makeIndex(std::max(kFewestSlots, 2 * index_.size()));
  const std::size_t slot = slotOf(block);
  if (index_[slot] == 0) {
    entries_.push_back({block, {}});
    index_[slot] = static_cast<std::uint32_t>(entries_.size());
  }
  return entries_[index_[slot] - 1].voxels;
}

/// Precondition: `slots` is a power of two, and at least twice the blocks.
void VoxelSet::makeIndex(std::size_t slots) {
  index_.assign(slots, 0);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    index_[slotOf(entries_[i].block)] = static_cast<std::uint32_t>(i + 1);
  }
}

void VoxelSet::dropEmptyBlocks() {
  const auto end = std::remove_if(entries_.begin(), entries_.end(),
                                  [](const Entry& entry) { return entry.voxels.empty(); });
  if (end == entries_.end()) return;
  entries_.erase(end, entries_.end());
  makeIndex(index_.size());
}

}  // namespace cobot_command::cell
