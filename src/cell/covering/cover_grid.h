// The cells of a grid that a mesh is in, or closes in, and what of each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/covering/stl.h"

namespace cobot_command::cell {

class CoverGrid {
 public:
  using Index = std::array<std::size_t, 3>;

  /// Around all of it. Precondition: there are as many cells as can be kept, and at least one along each
  /// axis.
  CoverGrid(const Eigen::Vector3d& lower, const Index& size, double edge);

  /// Precondition: it is within.
  void add(const Triangle& triangle);
  /// Behind all triangles: takes each cell, too, that cannot be reached from outside without crossing one, so
  /// that there are fewer boxes.
  void fill();

  [[nodiscard]] const Index& size() const { return size_; }
  [[nodiscard]] bool isTaken(const Index& cell) const { return states_[numberOf(cell)] == State::Taken; }
  /// It has been put into a box.
  void release(const Index& cell) { states_[numberOf(cell)] = State::Free; }
  /// What has to be covered of a cell that is taken.
  [[nodiscard]] AlignedBox neededOf(const Index& cell) const;

 private:
  enum class State : std::uint8_t { Free, Wall, Outside, Taken };
  /// What lies just between two cells, with the one behind it.
  struct Face {
    Index cell{};
    AlignedBox part;
  };

  [[nodiscard]] std::size_t numberOf(const Index& cell) const {
    return (cell[2] * size_[1] + cell[1]) * size_[0] + cell[0];
  }
  [[nodiscard]] AlignedBox boxOf(const Index& cell) const;
  [[nodiscard]] double lowerEndOf(std::size_t slab, Eigen::Index axis) const {
    return lower_[axis] + edge_ * static_cast<double>(slab);
  }
  void addPart(const std::vector<Eigen::Vector3d>& polygon, std::size_t axis, Index cell);
  void take(const Index& cell, const AlignedBox& part);
  [[nodiscard]] bool isFace(const Index& cell, const AlignedBox& part) const;
  void takeFace(const Index& cell, const AlignedBox& part);
  [[nodiscard]] bool isNeeded(const Face& face) const;
  void floodFromOutside();
  void flood(const Index& from, std::vector<Index>& open);

  Eigen::Vector3d lower_;
  Index size_;
  double edge_;
  std::vector<State> states_;
  std::vector<Face> faces_;
  /// Of triangles, by cell; what is taken without one is taken as a whole.
  std::unordered_map<std::size_t, AlignedBox> parts_;
};

}  // namespace cobot_command::cell
