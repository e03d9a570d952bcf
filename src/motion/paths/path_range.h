// Between which angles the joints are while they follow a piece of a path: proved, not sampled.
#pragma once

#include <optional>

#include "paths/path_postures.h"

#include "cobot_command/motion/joint_range.h"

namespace cobot_command::motion {

/// A piece of a path, around the place at which its posture is known.
struct PathPiece {
  double middle = 0.0;  ///< progress
  double before = 0.0;  ///< how far it reaches to either side of it, >= 0
  double behind = 0.0;
};

/// Contains the posture at every progress of the piece, the one in its middle being `joints`. Nothing where
/// that cannot be shown of so long a piece, or not closely.
///
/// Why it is true. Let s be the way from the middle, q(s) the joints, J(q) q' = x(s) the equation of the path
/// (PathEquation), J that in the middle, G its inverse, c = G x(0), and E(q) = G (J(q) - J), so that
///
///     q' = G x - E(q) q'
///
/// With RateChange, |(G x(s))_i - c_i| <= m_i s, where m_i = |G_i,lin| change_lin + |G_i,ang| change_ang. In
/// the box |q_i - q_i(0)| <= w_i the columns of J(q) are off those of J by at most (turn_j, way_j), below. So
/// |E_ij| <= K_ij(w) = |G_i,lin| way_j(w) + |G_i,ang| turn_j(w), which grows with w, at least in proportion.
///
/// Take a w > 0 with h (|c_i| + m_i h) + sum_j K_ij(w) w_j <= w_i for all i, h the longer one of both sides.
/// As long as q is in the box, let v be the greatest |q'_i| h / w_i. Then |q'_i| h / w_i <= (1 - k_i) + k_i
/// v, where k_i = sum_j K_ij w_j / w_i < 1, so v <= 1. So |q_i(s) - q_i(0)| <= s w_i / h, and q does not
/// leave the box before s = h: this is the argument of the first exit. There |E q'|_i <= (s / h) sum_j
/// K_ij(w) w_j / h, and by integration
///
///     |q_i(s) - q_i(0) - s c_i| <= (m_i h^2 + sum_j K_ij(w) w_j) / 2
///
/// which is what is added to the straight way s c_i. Moreover I + E is regular in the box, so no singularity
/// is there and the pose bits stay: q(s) is the posture that the path takes.
///
/// The columns. Column j of J is (z_j x (p - p_j); z_j), with p the TCP. Its derivative by q_k is
/// (z_min x lin_max; z_k x z_j for k < j, else 0), with min and max of j and k, and lin_max the upper half of
/// column max, as long as p is far from axis max. That distance depends on the joints behind max alone: in
/// the box it is at most r_j = |lin_j| + sum_{k>j} r_k w_k. So way_j = sum_k r_max(j,k) w_k, and turn_j =
/// sum_{k<j} w_k, without the k whose axis is parallel to j (2, 3 and 4 of the family).
[[nodiscard]] std::optional<JointRange> rangeOnPiece(const PathPostures& postures, const PathPiece& piece,
                                                     const arm::JointVector& joints);

}  // namespace cobot_command::motion
