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
/// A joint that does not move at all has a box, too [rad].
constexpr double kThin = 1e-12;

/// The equation of the path in the middle of a piece, solved for the joints.
struct Solved {
  JointVector slope;    ///< c: rad for each unit of progress
  JointVector linear;   ///< the lengths of the halves of the rows of the inverse
  JointVector angular;  ///< 0 where the angular rows of the equation are constant
  JointVector inexact;  ///< of the slope
  JointVector reach;    ///< of the TCP from each axis [m]
};

Solved solve(const PathEquation& equation) {
  const arm::Jacobian inverse = equation.jacobian.inverse();
  Solved solved;
  solved.slope = inverse * equation.rate;
  solved.linear = inverse.leftCols<3>().rowwise().norm();
  solved.angular = inverse.rightCols<3>().rowwise().norm();
  solved.reach = equation.jacobian.topRows<3>().colwise().norm().transpose();
  solved.inexact = kInexact * (equation.rate.head<3>().norm() + equation.rate.tail<3>().norm()) *
                   (solved.linear + solved.angular);
  return solved;
}

/// sum_j K_ij(w) w_j, for all i.
JointVector pushedBy(const Solved& at, bool turns, const JointVector& w) {
  JointVector reach = at.reach;
  double farther = 0.0;  // sum of r_k w_k over the joints behind
  double way = 0.0;
  for (Eigen::Index j = 5; j >= 0; --j) {
    reach[j] += farther;
    way += w[j] * (reach[j] * w.head(j + 1).sum() + farther);
    farther += reach[j] * w[j];
  }
  if (!turns) return at.linear * way;
  const double before_wrist_2 = w.head<4>().sum();
  const double turn = w[0] * (w[1] + w[2] + w[3]) + before_wrist_2 * w[4] + (before_wrist_2 + w[4]) * w[5];
  return at.linear * way + at.angular * turn;
}

/// What the other postures of the box push the joints off the straight way, at most; nothing where no box is
/// found. `least` is what they move without it.
std::optional<JointVector> boundedPush(const Solved& at, bool turns, const JointVector& least) {
  constexpr int kTries = 6;
  constexpr double kMore = 1.2;  // than in the box before it
  const double limit = 2.0 * std::max(kLoose * least.maxCoeff(), kFine);
  JointVector push = pushedBy(at, turns, least);
  for (int i = 0; i < kTries && push.maxCoeff() <= limit; ++i) {
    const JointVector taken = kMore * push;
    push = pushedBy(at, turns, least + taken);
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
  const auto push = boundedPush(at, equation.turns, least);
  if (!push) return std::nullopt;
  const JointVector more = 0.5 * (bent + *push) + inexact;
  if (more.maxCoeff() > std::max(kLoose * straight.maxCoeff(), kFine)) return std::nullopt;
  JointRange range = JointRange::of(joints);
  range.include(joints - piece.before * at.slope);
  range.include(joints + piece.behind * at.slope);
  range.lower -= more;
  range.upper += more;
  return range;
}

}  // namespace cobot_command::motion
