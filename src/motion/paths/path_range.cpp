#include "paths/path_range.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace cobot_command::motion {
namespace {

using arm::JointVector;

/// What is added to the straight way may be this share of it: so much closer is the range than it must be.
constexpr double kLoose = 0.2;
/// Or this [rad], where the joints hardly move: at a place where all of them turn round.
constexpr double kFine = 1e-7;
/// A pose counts as one whose axes are off by this (input_check.h): no equation of a path is more exact.
constexpr double kInexact = 4e-6;
/// The closed-form inverse is as good as if the pose were off by less than 1e-15 [m and rad], on three
/// singularities at once, too: so far a joint may be off for each unit of the inverse Jacobian.
constexpr double kRounding = 1e-14;
/// A joint that does not move at all has a box, too [rad].
constexpr double kThin = 1e-12;

/// Pairs of joints, the first one not above the second one.
constexpr int kPairs = 21;

/// The equation of the path in the middle of a piece, solved for the joints.
struct Solved {
  JointVector slope;     ///< c: rad for each unit of progress
  JointVector linear;    ///< |G_i,lin|
  JointVector angular;   ///< |G_i,ang|
  JointVector inexact;   ///< of the slope
  JointVector rounding;  ///< of a posture [rad]
  JointVector reach;     ///< of the TCP from each axis [m]
  bool turns;
  Eigen::Matrix<double, 6, kPairs> first_order;  ///< |H_ijk| + |H_ikj| of each pair, |H_ijj|
};

/// H of all pairs, from the derivatives of the columns.
Eigen::Matrix<double, 6, kPairs> firstOrder(const PathEquation& equation, const arm::Jacobian& inverse) {
  Eigen::Matrix<double, 3, kPairs> linear;
  Eigen::Matrix<double, 3, kPairs> angular;
  for (Eigen::Index k = 0, pair = 0; k < 6; ++k) {
    for (Eigen::Index j = k; j < 6; ++j, ++pair) {
      linear.col(pair) = equation.axes.col(k).cross(equation.jacobian.col(j).head<3>());
      angular.col(pair) = equation.axes.col(k).cross(equation.axes.col(j));
    }
  }
  const Eigen::Matrix<double, 6, kPairs> of_linear = inverse.leftCols<3>() * linear;
  Eigen::Matrix<double, 6, kPairs> both = of_linear;
  if (equation.turns) both += inverse.rightCols<3>() * angular;
  Eigen::Matrix<double, 6, kPairs> sum = both.cwiseAbs();
  for (Eigen::Index k = 0, pair = 0; k < 6; ++k) {
    for (Eigen::Index j = k; j < 6; ++j, ++pair) {
      if (j > k) sum.col(pair) += of_linear.col(pair).cwiseAbs();
    }
  }
  return sum;
}

Solved solve(const PathEquation& equation) {
  const arm::Jacobian inverse = equation.jacobian.inverse();
  Solved solved;
  solved.slope = inverse * equation.rate;
  solved.linear = inverse.leftCols<3>().rowwise().norm();
  solved.angular = inverse.rightCols<3>().rowwise().norm();
  solved.inexact = kInexact * (equation.rate.head<3>().norm() + equation.rate.tail<3>().norm()) *
                   (solved.linear + solved.angular);
  solved.rounding = kRounding * (solved.linear + solved.angular);
  solved.reach = equation.jacobian.topRows<3>().colwise().norm().transpose();
  solved.turns = equation.turns;
  solved.first_order = firstOrder(equation, inverse);
  return solved;
}

/// sum_j K_ij(w) w_j, for all i.
JointVector pushedBy(const Solved& at, const JointVector& w) {
  Eigen::Matrix<double, kPairs, 1> pairs;
  double turn = 0.0;
  double before = 0.0;
  JointVector cubes;  // of the sums of w up to each joint, less that of the joint before
  for (Eigen::Index k = 0, pair = 0; k < 6; ++k) {
    for (Eigen::Index j = k; j < 6; ++j, ++pair) pairs[pair] = w[k] * w[j];
    const double sum = before + w[k];
    turn += w[k] * before * before;
    cubes[k] = sum * sum * sum - before * before * before;
    before = sum;
  }
  double way = 0.0;
  double farther = 0.0;  // sum of r_k w_k over the joints behind
  for (Eigen::Index j = 5; j >= 0; --j) {
    const double reach = at.reach[j] + farther;
    way += reach * cubes[j];
    farther += reach * w[j];
  }
  JointVector push = at.first_order * pairs + 0.5 * way * at.linear;
  if (at.turns) push += 0.5 * turn * at.angular;
  return push;
}

/// What the other postures of the box push the joints off the straight way, at most; nothing where no box is
/// found. `least` is what they move without it.
std::optional<JointVector> boundedPush(const Solved& at, const JointVector& least) {
  constexpr int kTries = 6;
  constexpr double kMore = 1.2;  // than in the box before it
  const double limit = 2.0 * std::max(kLoose * least.maxCoeff(), kFine);
  JointVector push = pushedBy(at, least);
  for (int i = 0; i < kTries && push.maxCoeff() <= limit; ++i) {
    const JointVector taken = kMore * push;
    push = pushedBy(at, least + taken);
    if ((push.array() <= taken.array()).all()) return push;
  }
  return std::nullopt;
}

}  // namespace

std::optional<JointRange> rangeOnPiece(const PathPostures& postures, const PathPiece& piece,
                                       const JointVector& joints) {
  const PathEquation equation = postures.equationAt(piece.middle, joints);
  const RateChange change = postures.rateChange(piece.middle - piece.before, piece.middle + piece.behind);
  const Solved at = solve(equation);
  const double half = std::max(piece.before, piece.behind);
  const JointVector straight = half * at.slope.cwiseAbs();
  const JointVector bent = half * half * (change.linear * at.linear + change.angular * at.angular);
  const JointVector inexact = half * at.inexact;
  if (!(straight + bent).allFinite()) return std::nullopt;

  const JointVector least = straight + bent + inexact + JointVector::Constant(kThin);
  const auto push = boundedPush(at, least);
  if (!push) return std::nullopt;
  const JointVector more = 0.5 * (bent + *push) + inexact + at.rounding;
  if (more.maxCoeff() > std::max(kLoose * straight.maxCoeff(), kFine)) return std::nullopt;
  JointRange range = JointRange::of(joints);
  range.include(joints - piece.before * at.slope);
  range.include(joints + piece.behind * at.slope);
  range.lower -= more;
  range.upper += more;
  return range;
}

}  // namespace cobot_command::motion
