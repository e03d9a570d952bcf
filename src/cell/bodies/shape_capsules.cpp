#include "cobot_command/cell/bodies/shape_capsules.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

bool isRadius(double radius) {
  return std::isfinite(radius) && radius > 0;
}

BodyRefusal wrongLengths(const char* shape) {
  return {
      fmt::format("A {} has an invalid length: radii must be finite and above 0, lengths finite and not "
                  "negative. Correct it.",
                  shape)};
}

/// How a cross-section is cut.
struct Cut {
  double across = 1;  ///< cells along its first edge
  double up = 1;      ///< cells along its second edge
  double radius = 0;  ///< half a diagonal of a cell [m]

  [[nodiscard]] double cells() const { return across * up; }
};

/// The fewest cells; of as many those with the smallest diagonal. In floating point, as a wish may be for
/// more cells than an integer can count.
Cut cutOf(double width, double height, double body_cell) {
  const double diagonal = 2 * body_cell;
  Cut best;
  bool found = false;
  for (double across = std::floor(width / diagonal) + 1; !found || across <= best.cells(); ++across) {
    const double cell = width / across;
    const double room = std::sqrt((diagonal - cell) * (diagonal + cell));
    const double up = std::max(1.0, std::ceil(height / room));
    const Cut cut{across, up, 0.5 * std::hypot(cell, height / up)};
    const bool better =
        cut.cells() < best.cells() || (cut.cells() == best.cells() && cut.radius < best.radius);
    if (!found || better) best = cut;
    found = true;
    if (best.cells() > 16 * kMostCapsulesOfBox) break;  // refused in any case, so not worth a long search
  }
  return best;
}

Result<Capsules, BodyRefusal> coverOf(const BoxShape& box, double body_cell) {
  const Vector3d& size = box.size;
  if (!size.allFinite() || size.minCoeff() < 0 || size.maxCoeff() <= 0) return refuse(wrongLengths("box"));
  Index along = 0;
  size.maxCoeff(&along);
  const Index first = (along + 1) % 3;
  const Index second = (along + 2) % 3;
  const Cut cut = cutOf(size[first], size[second], body_cell);
  if (cut.cells() > kMostCapsulesOfBox) {
    return refuse(BodyRefusal{
        fmt::format("A box of {:.0f} x {:.0f} x {:.0f} mm needs {:.0f} capsules at a body_cell of {:.1f} mm, "
                    "but {:.0f} are allowed. Make body_cell larger, or use smaller boxes.",
                    mToMm(size.x()), mToMm(size.y()), mToMm(size.z()), cut.cells(), mToMm(body_cell),
                    kMostCapsulesOfBox)});
  }
  Capsules capsules;
  const auto across = static_cast<std::size_t>(cut.across);
  const auto up = static_cast<std::size_t>(cut.up);
  for (std::size_t i = 0; i < across; ++i) {
    for (std::size_t j = 0; j < up; ++j) {
      Vector3d middle = Vector3d::Zero();
      middle[first] = size[first] * ((static_cast<double>(i) + 0.5) / cut.across - 0.5);
      middle[second] = size[second] * ((static_cast<double>(j) + 0.5) / cut.up - 0.5);
      const Vector3d half = 0.5 * size[along] * Vector3d::Unit(along);
      capsules.push_back({middle - half, middle + half, cut.radius});
    }
  }
  return capsules;
}

Result<Capsules, BodyRefusal> coverOf(const CapsuleShape& capsule, double /*body_cell*/) {
  if (!isRadius(capsule.radius) || !capsule.from.allFinite() || !capsule.to.allFinite()) {
    return refuse(wrongLengths("capsule"));
  }
  return Capsules{capsule};
}

Result<Capsules, BodyRefusal> coverOf(const SphereShape& sphere, double /*body_cell*/) {
  if (!isRadius(sphere.radius)) return refuse(wrongLengths("sphere"));
  return Capsules{{Vector3d::Zero(), Vector3d::Zero(), sphere.radius}};
}

Result<Capsules, BodyRefusal> coverOf(const CylinderShape& cylinder, double /*body_cell*/) {
  if (!isRadius(cylinder.radius) || !std::isfinite(cylinder.length) || cylinder.length < 0) {
    return refuse(wrongLengths("cylinder"));
  }
  const Vector3d half = 0.5 * cylinder.length * Vector3d::UnitZ();
  return Capsules{{-half, half, cylinder.radius}};
}

}  // namespace

Result<Capsules, BodyRefusal> capsulesOf(const Shape& shape, double body_cell) {
  assert(isRadius(body_cell));
  auto capsules = std::visit([body_cell](const auto& kind) { return coverOf(kind, body_cell); }, shape.kind);
  if (!capsules) return capsules;
  for (Capsule& capsule : *capsules) capsule = placed(shape.at, capsule);
  return capsules;
}

Result<Capsules, BodyRefusal> capsulesOf(const std::vector<Shape>& shapes, double body_cell) {
  Capsules all;
  for (const Shape& shape : shapes) {
    const auto capsules = capsulesOf(shape, body_cell);
    if (!capsules) return refuse(capsules.error());
    all.insert(all.end(), capsules->begin(), capsules->end());
  }
  return all;
}

}  // namespace cobot_command::cell
