// The cubes that are within a distance of a segment, row by row.
//
// A row is all cubes along one axis, the one along which the core is longest, so that there are few rows.
// What of a row is within the distance is one interval, as all that is concerned is convex; its ends are
// found in closed form: the highest is the greatest of a(t) + sqrt(R^2 - g(t)), with a(t) the place of the
// core along the row, and g(t) the square of its distance from the row. That is a concave function of t, and
// g consists of parabolas.
#include "cobot_command/cell/sweep/capsule_claim.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cobot_command::cell {
namespace {

using Eigen::Index;

/// So much is added to the distance, for what rounding takes [m].
constexpr double kRounding = 1e-10;

/// One coordinate across the rows: where the core is in it, and between what the row is.
struct Across {
  double from = 0;
  double slope = 0;
  double lower = 0;
  double upper = 0;

  /// Of the core at t beyond the row; below it negative.
  [[nodiscard]] double beyond(double t) const {
    const double place = from + t * slope;
    return place < lower ? place - lower : std::max(0.0, place - upper);
  }
  [[nodiscard]] bool bends() const { return slope != 0; }
  /// Where the core comes nearer no more, for -slope as for slope.
  [[nodiscard]] Across reversed() const { return {from + slope, -slope, lower, upper}; }
};

/// A row as seen from a core whose place along it is from + t slope, with slope >= 0.
struct Row {
  double from = 0;
  double slope = 0;
  double squared_reach = 0;
  Across first;
  Across second;

  [[nodiscard]] Row reversed() const {
    return {-(from + slope), slope, squared_reach, first.reversed(), second.reversed()};
  }
};

/// Whether a(t) + sqrt(R^2 - g(t)) still rises at t; where it has no value, whether that is ahead.
bool rises(const Row& row, double t) {
  const double b = row.first.beyond(t);
  const double c = row.second.beyond(t);
  const double half_slope = b * row.first.slope + c * row.second.slope;
  if (half_slope <= 0) return true;
  return row.slope * row.slope * (row.squared_reach - b * b - c * c) >= half_slope * half_slope;
}

/// The stretch of t, without bends of g within, in which the highest is.
struct Stretch {
  double lower = 0;
  double upper = 1;
};

/// Cuts the stretch at t, and keeps the part that has the highest.
void narrow(Stretch& stretch, const Row& row, double t) {
  if (t <= stretch.lower || t >= stretch.upper) return;
  (rises(row, t) ? stretch.lower : stretch.upper) = t;
}

void narrow(Stretch& stretch, const Row& row, const Across& across) {
  if (!across.bends()) return;
  const double per_metre = 1 / across.slope;
  narrow(stretch, row, (across.lower - across.from) * per_metre);
  narrow(stretch, row, (across.upper - across.from) * per_metre);
}

/// Where it is highest in the stretch; any place where it has no value there.
double highestIn(const Stretch& stretch, const Row& row) {
  // g = P t^2 + 2 Q t + S, from those coordinates in which the core is beyond the row.
  double p = 0;
  double q = 0;
  double s = 0;
  const double middle = 0.5 * (stretch.lower + stretch.upper);
  for (const Across* across : {&row.first, &row.second}) {
    const double beyond = across->beyond(middle);
    if (beyond == 0) continue;
    const double at_zero = beyond - middle * across->slope;
    p += across->slope * across->slope;
    q += across->slope * at_zero;
    s += at_zero * at_zero;
  }
  if (p == 0) return stretch.upper;
  // With u = P t + Q: the derivative is zero where A^2 (R^2 - (u^2 + P S - Q^2) / P) = u^2.
  const double room = p * row.squared_reach - (p * s - q * q);
  if (room < 0) return middle;
  const double u = row.slope * std::sqrt(room / (p + row.slope * row.slope));
  return std::clamp((u - q) / p, stretch.lower, stretch.upper);
}

/// The highest place on the row that is within reach of the core; false where none is.
bool highestOn(const Row& row, double& highest) {
  double t = 1;
  if (!rises(row, 1)) {
    Stretch stretch;
    if (rises(row, 0)) {
      narrow(stretch, row, row.first);
      narrow(stretch, row, row.second);
      t = highestIn(stretch, row);
    } else {
      t = 0;
    }
  }
  const double b = row.first.beyond(t);
  const double c = row.second.beyond(t);
  const double room = row.squared_reach - b * b - c * c;
  if (room < 0) return false;
  highest = row.from + t * row.slope + std::sqrt(room);
  return true;
}

/// The voxels from `from` to `to` (0 to 7) in the row of a block along `axis`, at `b` and `c` along the axes
/// behind it (of z: x and y).
void fillRow(VoxelBlock& block, std::size_t axis, unsigned b, unsigned c, unsigned from, unsigned to) {
  const unsigned length = to - from + 1;
  if (axis == 0) {
    const std::uint64_t bit = std::uint64_t{1} << (8 * b + c);
    for (unsigned x = from; x <= to; ++x) block.words[x] |= bit;
  } else if (axis == 1) {
    const std::uint64_t column = 0x0101010101010101U >> (8 * (8 - length));
    block.words[c] |= column << (8 * from + b);
  } else {
    const std::uint64_t run = 0xFFU >> (8 - length);
    block.words[b] |= run << (8 * c + from);
  }
}

struct Interval {
  std::int32_t lower = 0;
  std::int32_t upper = -1;
};

class Claim {
 public:
  Claim(VoxelSet& set, const Capsule& grown, double edge)
      : set_(set), edge_(edge), reach_(grown.radius + kRounding), from_(grown.from), to_(grown.to) {
    Index along = 0;
    (to_ - from_).cwiseAbs().maxCoeff(&along);
    along_ = static_cast<std::size_t>(along);
    if (from_[along] > to_[along]) from_.swap(to_);
    rows_ = voxelsWithin(from_[along], to_[along]);
    const std::int32_t blocks = (rows_.upper >> 3) - (rows_.lower >> 3) + 1;
    column_.resize(static_cast<std::size_t>(blocks));
  }

  /// By columns of blocks along the rows, so that the set is asked for a block once.
  void make() {
    const Index first = static_cast<Index>((along_ + 1) % 3);
    const Interval all = voxelsWithin(std::min(from_[first], to_[first]), std::max(from_[first], to_[first]));
    for (std::int32_t block = all.lower >> 3; block <= all.upper >> 3; ++block) {
      first_ = {std::max(all.lower, 8 * block), std::min(all.upper, 8 * block + 7)};
      const Interval beside = secondWithin(first_);
      for (std::int32_t second = beside.lower >> 3; second <= beside.upper >> 3; ++second) {
        makeColumn(block, second);
      }
    }
  }

 private:
  [[nodiscard]] Interval voxelsWithin(double lower, double upper) const {
    return {static_cast<std::int32_t>(std::floor((lower - reach_) / edge_)),
            static_cast<std::int32_t>(std::floor((upper + reach_) / edge_))};
  }

  [[nodiscard]] Across acrossAt(Index axis, std::int32_t voxel) const {
    return {from_[axis], to_[axis] - from_[axis], edge_ * voxel, edge_ * (voxel + 1)};
  }

  /// Along the second axis across the rows: between what all voxels are that are claimed in these of the
  /// first.
  [[nodiscard]] Interval secondWithin(const Interval& first_voxels) const {
    const Index first = static_cast<Index>((along_ + 1) % 3);
    const Index second = static_cast<Index>((along_ + 2) % 3);
    const double slope = to_[first] - from_[first];
    double begin = 0;
    double end = 1;
    if (slope != 0) {
      const double one = (edge_ * first_voxels.lower - reach_ - from_[first]) / slope;
      const double other = (edge_ * (first_voxels.upper + 1) + reach_ - from_[first]) / slope;
      begin = std::clamp(std::min(one, other), 0.0, 1.0);
      end = std::clamp(std::max(one, other), 0.0, 1.0);
    }
    const double a = from_[second] + begin * (to_[second] - from_[second]);
    const double b = from_[second] + end * (to_[second] - from_[second]);
    return voxelsWithin(std::min(a, b), std::max(a, b));
  }

  void makeColumn(std::int32_t first_block, std::int32_t second_block) {
    bool any = false;
    for (std::int32_t i = first_.lower; i <= first_.upper; ++i) {
      const Interval beside = secondWithin({i, i});
      const std::int32_t end = std::min(beside.upper, 8 * second_block + 7);
      for (std::int32_t k = std::max(beside.lower, 8 * second_block); k <= end; ++k) {
        any = makeRow(i, k) || any;
      }
    }
    if (any) flush(first_block, second_block);
  }

  bool makeRow(std::int32_t first, std::int32_t second) {
    const Index along = static_cast<Index>(along_);
    const Row row{from_[along], to_[along] - from_[along], reach_ * reach_, acrossAt((along + 1) % 3, first),
                  acrossAt((along + 2) % 3, second)};
    double highest = 0;
    double lowest = 0;
    if (!highestOn(row, highest) || !highestOn(row.reversed(), lowest)) return false;
    // Rounding may take them across the end of all rows, where the column has no block.
    const auto from = std::max(rows_.lower, static_cast<std::int32_t>(std::floor(-lowest / edge_)));
    const auto to = std::min(rows_.upper, static_cast<std::int32_t>(std::floor(highest / edge_)));
    for (std::int32_t block = from >> 3; block <= to >> 3; ++block) {
      const std::int32_t begin = std::max(from, 8 * block) - 8 * block;
      const std::int32_t end = std::min(to, 8 * block + 7) - 8 * block;
      fillRow(column_[static_cast<std::size_t>(block - (rows_.lower >> 3))], along_,
              static_cast<unsigned>(first & 7), static_cast<unsigned>(second & 7),
              static_cast<unsigned>(begin), static_cast<unsigned>(end));
    }
    return true;
  }

  void flush(std::int32_t first_block, std::int32_t second_block) {
    for (std::size_t i = 0; i < column_.size(); ++i) {
      Voxel block{};
      block[along_] = (rows_.lower >> 3) + static_cast<std::int32_t>(i);
      block[(along_ + 1) % 3] = first_block;
      block[(along_ + 2) % 3] = second_block;
      set_.insertBlock(block, column_[i]);
      column_[i] = {};
    }
  }

  VoxelSet& set_;
  double edge_;
  double reach_;
  Eigen::Vector3d from_;
  Eigen::Vector3d to_;  ///< higher along the rows than from_, or as high
  std::size_t along_ = 0;
  Interval rows_;   ///< all voxels along them that may be claimed
  Interval first_;  ///< of the column that is under way
  std::vector<VoxelBlock> column_;
};

}  // namespace

void claimCapsule(VoxelSet& set, const Capsule& grown, double edge) {
  Claim(set, grown, edge).make();
}

}  // namespace cobot_command::cell
