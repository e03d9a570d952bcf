#include "covering/cover_grid.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::cell {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

/// What of it is at or above (`side` 1), or at or below (-1), a height along an axis.
Polygon clipped(const Polygon& polygon, Eigen::Index axis, double height, double side) {
  Polygon left;
  for (std::size_t at = 0; at < polygon.size(); ++at) {
    const Eigen::Vector3d& here = polygon[at];
    const Eigen::Vector3d& next = polygon[(at + 1) % polygon.size()];
    const double above = side * (here[axis] - height);
    const double above_next = side * (next[axis] - height);
    if (above >= 0) left.push_back(here);
    if ((above > 0 && above_next < 0) || (above < 0 && above_next > 0)) {
      Eigen::Vector3d crossing = here + (next - here) * (above / (above - above_next));
      crossing[axis] = height;
      left.push_back(crossing);
    }
  }
  return left;
}

AlignedBox boundsOf(const Polygon& polygon) {
  AlignedBox bounds{polygon.front(), polygon.front()};
  for (const Eigen::Vector3d& corner : polygon) {
    bounds.lower = bounds.lower.cwiseMin(corner);
    bounds.upper = bounds.upper.cwiseMax(corner);
  }
  return bounds;
}

}  // namespace

CoverGrid::CoverGrid(const Eigen::Vector3d& lower, const Index& size, double edge)
    : lower_(lower), size_(size), edge_(edge), states_(size[0] * size[1] * size[2], State::Free) {}

void CoverGrid::add(const Triangle& triangle) {
  addPart(Polygon(triangle.begin(), triangle.end()), 0, {});
}

/// Slab by slab along x, each slab along y, and each row along z. The ends of slabs belong to both, so that
/// nothing is lost between them.
void CoverGrid::addPart(const Polygon& polygon, std::size_t axis, Index cell) {
  const AlignedBox bounds = boundsOf(polygon);
  if (axis == 3) return isFace(cell, bounds) ? takeFace(cell, bounds) : take(cell, bounds);
  const auto along = static_cast<Eigen::Index>(axis);
  const auto last = static_cast<double>(size_[axis] - 1);
  const auto slab_at = [&](double place) {
    return static_cast<std::size_t>(std::clamp(std::floor((place - lower_[along]) / edge_), 0.0, last));
  };
  const std::size_t first = slab_at(bounds.lower[along]);
  const std::size_t end = slab_at(bounds.upper[along]) + 1;
  for (std::size_t slab = first; slab < end; ++slab) {
    Polygon within = polygon;
    // The outer ones have no end: what rounding takes beyond is theirs.
    if (slab != first) within = clipped(within, along, lowerEndOf(slab, along), 1);
    if (slab + 1 != end) within = clipped(within, along, lowerEndOf(slab + 1, along), -1);
    if (within.empty()) continue;
    // What only touches it is in the slab before.
    if (slab != first && boundsOf(within).upper[along] <= lowerEndOf(slab, along)) continue;
    cell[axis] = slab;
    addPart(within, axis + 1, cell);
  }
}

bool CoverGrid::isFace(const Index& cell, const AlignedBox& part) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<Eigen::Index>(axis);
    if (cell[axis] > 0 && part.upper[along] <= lowerEndOf(cell[axis], along)) return true;
  }
  return false;
}

/// The cell before it may have it already, or have it filled: that is known in the end.
void CoverGrid::takeFace(const Index& cell, const AlignedBox& part) {
  State& state = states_[numberOf(cell)];
  if (state == State::Free) state = State::Wall;
  faces_.push_back({cell, part});
}

void CoverGrid::take(const Index& cell, const AlignedBox& part) {
  const std::size_t number = numberOf(cell);
  states_[number] = State::Taken;
  AlignedBox& known = parts_.try_emplace(number, part).first->second;
  known.lower = known.lower.cwiseMin(part.lower);
  known.upper = known.upper.cwiseMax(part.upper);
}

void CoverGrid::flood(const Index& from, std::vector<Index>& open) {
  State& state = states_[numberOf(from)];
  if (state != State::Free) return;
  state = State::Outside;
  open.push_back(from);
}

bool CoverGrid::isNeeded(const Face& face) const {
  const auto covers = [&](const Index& cell) {
    if (!isTaken(cell)) return false;
    const AlignedBox needed = neededOf(cell);
    return (needed.lower.array() <= face.part.lower.array()).all() &&
           (needed.upper.array() >= face.part.upper.array()).all();
  };
  if (covers(face.cell)) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (face.cell[axis] == 0) continue;
    Index before = face.cell;
    --before[axis];
    if (covers(before)) return false;
  }
  return true;
}

void CoverGrid::fill() {
  floodFromOutside();
  for (State& state : states_) {
    if (state == State::Free) {
      state = State::Taken;
    } else if (state != State::Taken) {
      state = State::Free;
    }
  }
  for (const Face& face : faces_) {
    if (isNeeded(face)) take(face.cell, face.part);
  }
}

void CoverGrid::floodFromOutside() {
  std::vector<Index> open;
  for (std::size_t z = 0; z < size_[2]; ++z) {
    for (std::size_t y = 0; y < size_[1]; ++y) {
      for (std::size_t x = 0; x < size_[0]; ++x) {
        const bool is_outer =
            x == 0 || y == 0 || z == 0 || x + 1 == size_[0] || y + 1 == size_[1] || z + 1 == size_[2];
        if (is_outer) flood({x, y, z}, open);
      }
    }
  }
  while (!open.empty()) {
    const Index cell = open.back();
    open.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Index beside = cell;
      if (cell[axis] > 0) {
        --beside[axis];
        flood(beside, open);
      }
      beside = cell;
      if (++beside[axis] < size_[axis]) flood(beside, open);
    }
  }
}

AlignedBox CoverGrid::boxOf(const Index& cell) const {
  const Eigen::Vector3d place(static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                              static_cast<double>(cell[2]));
  const Eigen::Vector3d lower = lower_ + edge_ * place;
  return {lower, lower + Eigen::Vector3d::Constant(edge_)};
}

AlignedBox CoverGrid::neededOf(const Index& cell) const {
  const auto part = parts_.find(numberOf(cell));
  return part == parts_.end() ? boxOf(cell) : part->second;
}

}  // namespace cobot_command::cell
