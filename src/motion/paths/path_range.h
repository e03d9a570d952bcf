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
/// the box |q_i - q_i(0)| <= w_i, |E_ij| <= K_ij(w), below, which grows with w at least in proportion.
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
/// K. Column j of J is (z_j x (p - p_j); z_j), with p the TCP. Its derivative by q_k is (z_min x lin_max; z_k
/// x z_j for k < j, else 0), with min and max of j and k, and lin_max the upper half of column max: what is
/// behind an axis turns about it. Likewise, its second derivative by q_k and q_l has an upper half no longer
/// than lin_max of the three, and a lower half no longer than 1, none but for k, l < j. The length of lin_j
/// is the distance of p from axis j, which depends on the joints behind j alone: in the box it is at most r_j
/// = |lin_j| + sum_{k>j} r_k w_k. So, with H_ijk row i of G times the derivative of column j by q_k in the
/// middle,
///
///     K_ij(w) = sum_k |H_ijk| w_k + |G_i,lin| sum_kl r_max(j,k,l) w_k w_l / 2 + |G_i,ang| (sum_{k<j} w_k)^2
///     / 2
///
/// Next to a singularity G is large, but most of the H are not: what they have in closed form makes pieces
/// there tens of times as long as lengths alone would allow.
[[nodiscard]] std::optional<JointRange> rangeOnPiece(const PathPostures& postures, const PathPiece& piece,
                                                     const arm::JointVector& joints);

}  // namespace cobot_command::motion
