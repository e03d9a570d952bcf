#include "cobot_command/cell/covering/box_cover.h"

#include <algorithm>
#include <cmath>

#include "covering/cover_grid.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using Index = CoverGrid::Index;

/// Of a coordinate: what rounding takes of it is far below any tolerance.
constexpr double kFarthest = 1e6;
constexpr double kTenths = 10.0;
/// No box is thinner: bodies have a size.
constexpr double kThinnest = 1.0;

/// Cells from `first` to behind `end`.
struct Block {
  Index first{};
  Index end{};

  [[nodiscard]] std::size_t cells() const {
    return (end[0] - first[0]) * (end[1] - first[1]) * (end[2] - first[2]);
  }
};

template <class Visitor>
void forEachCell(const Block& block, const Visitor& visit) {
  for (std::size_t z = block.first[2]; z < block.end[2]; ++z) {
    for (std::size_t y = block.first[1]; y < block.end[1]; ++y) {
      for (std::size_t x = block.first[0]; x < block.end[0]; ++x) visit(Index{x, y, z});
    }
  }
}

bool isAllTaken(const CoverGrid& grid, const Block& block) {
  bool all = true;
  forEachCell(block, [&](const Index& cell) { all = all && grid.isTaken(cell); });
  return all;
}

/// From a cell on, as far as all is taken along one axis after the other, in the order that gives the most.
Block largestFrom(const CoverGrid& grid, const Index& cell) {
  Block largest;
  Index order = {0, 1, 2};
  do {
    Block block{cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}};
    for (const std::size_t axis : order) {
      while (block.end[axis] < grid.size()[axis]) {
        Block next = block;
        next.first[axis] = block.end[axis];
        ++next.end[axis];
        if (!isAllTaken(grid, next)) break;
        ++block.end[axis];
      }
    }
    if (block.cells() > largest.cells()) largest = block;
  } while (std::next_permutation(order.begin(), order.end()));
  return largest;
}

/// What is needed of its cells, in whole tenths.
AlignedBox boxOf(const CoverGrid& grid, const Block& block) {
  AlignedBox box = grid.neededOf(block.first);
  forEachCell(block, [&](const Index& cell) {
    const AlignedBox needed = grid.neededOf(cell);
    box.lower = box.lower.cwiseMin(needed.lower);
    box.upper = box.upper.cwiseMax(needed.upper);
  });
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double thin = std::max(0.0, kThinnest - (box.upper[axis] - box.lower[axis]));
    box.lower[axis] = std::floor((box.lower[axis] - 0.5 * thin) * kTenths) / kTenths;
    box.upper[axis] = std::ceil((box.upper[axis] + 0.5 * thin) * kTenths) / kTenths;
  }
  return box;
}

Result<CoverGrid, std::string> gridAround(const std::vector<Triangle>& triangles, double edge) {
  AlignedBox bounds{triangles.front()[0], triangles.front()[0]};
  for (const Triangle& triangle : triangles) {
    for (const Eigen::Vector3d& corner : triangle) {
      bounds.lower = bounds.lower.cwiseMin(corner);
      bounds.upper = bounds.upper.cwiseMax(corner);
    }
  }
  const double farthest = std::max(bounds.lower.cwiseAbs().maxCoeff(), bounds.upper.cwiseAbs().maxCoeff());
  if (!(farthest <= kFarthest)) {
    return refuse(
        fmt::format("a corner is {:.0f} mm from the origin, and at most {:.0f} mm are allowed: is it in "
                    "another unit?",
                    farthest, kFarthest));
  }
  Index size{};
  double cells = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<Eigen::Index>(axis);
    const double count = std::max(1.0, std::ceil((bounds.upper[along] - bounds.lower[along]) / edge - 1e-9));
    cells *= count;
    size[axis] = static_cast<std::size_t>(std::min(count, 1e9));
  }
  if (cells > static_cast<double>(kMostCoverCells)) {
    return refuse(
        fmt::format("{:.0f} cells of {:g} mm are needed, but at most {} are allowed: choose larger ones",
                    cells, edge, kMostCoverCells));
  }
  return CoverGrid(bounds.lower, size, edge);
}

/// 120.5, not 120.500000001: tenths are what the boxes are made of.
std::string numberText(double number) {
  std::string text = fmt::format("{:.2f}", number);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

Result<std::vector<AlignedBox>, std::string> boxesOver(const std::vector<Triangle>& triangles, double edge) {
  std::vector<AlignedBox> boxes;
  if (triangles.empty()) return boxes;
  auto grid = gridAround(triangles, edge);
  if (!grid) return refuse(grid.error());
  for (const Triangle& triangle : triangles) grid->add(triangle);
  grid->fill();
  forEachCell({{0, 0, 0}, grid->size()}, [&](const Index& cell) {
    if (!grid->isTaken(cell)) return;
    const Block block = largestFrom(*grid, cell);
    boxes.push_back(boxOf(*grid, block));
    forEachCell(block, [&](const Index& of_block) { grid->release(of_block); });
  });
  return boxes;
}

std::string shapesText(const std::vector<AlignedBox>& boxes) {
  const auto list = [](const Eigen::Vector3d& numbers, const char* more) {
    return fmt::format("[{}, {}, {}{}]", numberText(numbers.x()), numberText(numbers.y()),
                       numberText(numbers.z()), more);
  };
  std::string text = "shapes:\n";
  for (const AlignedBox& box : boxes) {
    text += fmt::format("  - box: {{size: {}}}\n    at: {}\n", list(box.upper - box.lower, ""),
                        list(0.5 * (box.lower + box.upper), ", 0, 0, 0"));
  }
  return text;
}

}  // namespace cobot_command::cell
