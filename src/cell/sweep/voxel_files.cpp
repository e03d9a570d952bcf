#include "cobot_command/cell/sweep/voxel_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

void appendFloat(std::string& bytes, double value) {
  const auto number = static_cast<float>(value);
  static_assert(sizeof(number) == sizeof(std::uint32_t));
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  // From low to high, whatever this machine does.
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(bits >> shift));
}

/// Bits of the three coordinates in turns, x lowest: the way from the root of the tree to a voxel, three bits
/// for each level.
using Way = std::uint64_t;
constexpr unsigned kLevels = 16;

Way wayTo(const Voxel& voxel) {
  Way way = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto key = static_cast<std::uint32_t>(voxel[axis] + kFarthestOfOctomap);
    for (unsigned bit = 0; bit < kLevels; ++bit) way |= Way{(key >> bit) & 1U} << (3 * bit + axis);
  }
  return way;
}

/// Of a tree: its nodes in the order in which OctoMap reads them.
class TreeWriter {
 public:
  using Ways = std::vector<Way>;

  explicit TreeWriter(Ways ways) {
    if (ways.empty()) return;
    std::sort(ways.begin(), ways.end());
    nodes_ = 1;
    write(ways.begin(), ways.end(), kLevels);
  }
  /// With the root; none, where it is empty.
  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  struct Child {
    Ways::const_iterator first;
    Ways::const_iterator last;
    bool has_children = false;
  };

  /// A node that is neither empty nor full, `level` above the voxels: two bits for each child, the first four
  /// in one byte; then all of that for those of its children that have some.
  void write(Ways::const_iterator first, Ways::const_iterator last, unsigned level) {
    constexpr unsigned kOccupied = 2;
    constexpr unsigned kHasChildren = 3;
    std::array<Child, 8> children{};
    unsigned bits = 0;
    const unsigned shift = 3 * (level - 1);
    for (unsigned index = 0; index < 8; ++index) {
      Child& child = children[index];
      child.first = first;
      child.last = std::find_if(first, last, [&](Way way) { return ((way >> shift) & 7U) != index; });
      first = child.last;
      const auto count = static_cast<std::uint64_t>(child.last - child.first);
      if (count == 0) continue;
      ++nodes_;
      child.has_children = count != std::uint64_t{1} << shift;
      bits |= (child.has_children ? kHasChildren : kOccupied) << (2 * index);
    }
    bytes_.push_back(static_cast<char>(bits));
    bytes_.push_back(static_cast<char>(bits >> 8U));
    for (const Child& child : children) {
      if (child.has_children) write(child.first, child.last, level - 1);
    }
  }

  std::size_t nodes_ = 0;
  std::string bytes_;
};

}  // namespace

std::string toPly(const VoxelSet& voxels, double edge, const std::string& about) {
  const std::vector<Voxel> sorted = voxels.sorted();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\ncomment centres [m] of cubes of {} m\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
      about, edge, sorted.size());
  for (const Voxel& voxel : sorted) {
    for (const std::int32_t coordinate : voxel) appendFloat(bytes, (coordinate + 0.5) * edge);
  }
  return bytes;
}

Result<std::string, std::string> toOctomap(const VoxelSet& voxels, double edge, const std::string& about) {
  const auto bounds = voxels.bounds();
  for (std::size_t axis = 0; bounds && axis < 3; ++axis) {
    if (bounds->lower[axis] >= -kFarthestOfOctomap && bounds->upper[axis] < kFarthestOfOctomap) continue;
    return refuse(fmt::format(
        "its voxels extend from {:.1f} to {:.1f} m along {}, but an OctoMap with voxels of {:g} mm extends "
        "from {:.1f} to {:.1f} m: use larger voxels, or move the world's origin into the cell",
        bounds->lower[axis] * edge, (bounds->upper[axis] + 1) * edge, "xyz"[axis], 1000.0 * edge,
        -kFarthestOfOctomap * edge, kFarthestOfOctomap * edge));
  }
  std::vector<Way> ways;
  for (const Voxel& voxel : voxels.sorted()) ways.push_back(wayTo(voxel));
  const TreeWriter tree(std::move(ways));
  return fmt::format("# Octomap OcTree binary file\n# {}\nid OcTree\nsize {}\nres {}\ndata\n", about,
                     tree.nodes(), edge) +
         tree.bytes();
}

}  // namespace cobot_command::cell
