// Sets of voxels: cubes of one grid, whose origin is that of the world.
//
// Stored as bits in blocks of 8 x 8 x 8, so set operations process 64 voxels at once. A set does not store
// the edge; the caller must combine only sets of the same grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cobot_command/cell/bodies/capsule.h"

namespace cobot_command::cell {

/// The cube from (x, y, z) times the edge to (x + 1, y + 1, z + 1) times the edge. Coordinates are within
/// +-kFarthestVoxel.
using Voxel = std::array<std::int32_t, 3>;
inline constexpr std::int32_t kFarthestVoxel = 1 << 24;

/// The voxel that contains a point [m]; on a face, the voxel with the larger coordinate. Precondition: not
/// beyond kFarthestVoxel.
[[nodiscard]] Voxel voxelAt(const Eigen::Vector3d& point, double edge);
/// The cube of a voxel [m].
[[nodiscard]] AlignedBox cubeOf(const Voxel& voxel, double edge);

/// The 512 voxels of a block. One word per x, from low to high; bit 8 y + z in it.
struct VoxelBlock {
  std::array<std::uint64_t, 8> words{};

  [[nodiscard]] bool empty() const;
};

/// Bounds of voxels or blocks, both inclusive.
struct VoxelBounds {
  Voxel lower{};
  Voxel upper{};

  friend bool operator==(const VoxelBounds& a, const VoxelBounds& b) {
    return a.lower == b.lower && a.upper == b.upper;
  }
};

/// A value. Several threads may read it concurrently.
class VoxelSet {
 public:
  /// Returns false if it was already in the set.
  bool insert(const Voxel& voxel);
  [[nodiscard]] bool contains(const Voxel& voxel) const;
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] std::size_t count() const;
  void clear();

  /// Inserts the voxels of one block, which starts at 8 times `block`.
  void insertBlock(const Voxel& block, const VoxelBlock& voxels);

  VoxelSet& operator|=(const VoxelSet& other);
  VoxelSet& operator&=(const VoxelSet& other);
  VoxelSet& operator-=(const VoxelSet& other);
  friend VoxelSet operator|(VoxelSet a, const VoxelSet& b) { return a |= b; }
  friend VoxelSet operator&(VoxelSet a, const VoxelSet& b) { return a &= b; }
  friend VoxelSet operator-(VoxelSet a, const VoxelSet& b) { return a -= b; }
  friend bool operator==(const VoxelSet& a, const VoxelSet& b);
  friend bool operator!=(const VoxelSet& a, const VoxelSet& b) { return !(a == b); }

  /// Whether the sets have common voxels, and how many, without creating the intersection.
  [[nodiscard]] bool touches(const VoxelSet& other) const;
  [[nodiscard]] std::size_t countCommon(const VoxelSet& other) const;

  /// std::nullopt for an empty set.
  [[nodiscard]] std::optional<VoxelBounds> bounds() const;

  /// The first by x, then y, then z. std::nullopt for an empty set.
  [[nodiscard]] std::optional<Voxel> lowest() const;

  /// All voxels, sorted by x, then y, then z.
  [[nodiscard]] std::vector<Voxel> sorted() const;

  /// The voxels whose coordinate along `axis` (0 to 2) is below `at`, and the others.
  [[nodiscard]] std::pair<VoxelSet, VoxelSet> cut(std::size_t axis, std::int32_t at) const;

  /// The components connected by faces, edges or corners, ordered by their lowest() voxels.
  [[nodiscard]] std::vector<VoxelSet> components() const;

  /// The same bytes for the same voxels, on every machine and for every order of insertion.
  [[nodiscard]] std::string bytes() const;
  /// std::nullopt if they are not exactly the bytes() of a set.
  [[nodiscard]] static std::optional<VoxelSet> fromBytes(std::string_view bytes);

  /// Allocated memory of the set [bytes].
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Entry {
    Voxel block{};
    VoxelBlock voxels;
  };

  [[nodiscard]] std::size_t slotOf(const Voxel& block) const;
  [[nodiscard]] const VoxelBlock* find(const Voxel& block) const;
  [[nodiscard]] VoxelBlock& at(const Voxel& block);
  [[nodiscard]] std::vector<const Entry*> sortedEntries() const;
  [[nodiscard]] VoxelSet componentAround(std::size_t entry, std::vector<VoxelBlock>& left) const;
  void makeIndex(std::size_t slots);
  void dropEmptyBlocks();

  std::vector<Entry> entries_;        ///< none of them empty, in any order
  std::vector<std::uint32_t> index_;  ///< open addressing: 0 for none, else the index in entries_, plus 1
};

}  // namespace cobot_command::cell
