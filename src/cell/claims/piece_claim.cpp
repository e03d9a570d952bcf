#include "claims/piece_claim.h"

#include <cmath>

#include "cobot_command/cell/sweep/capsule_claim.h"
#include "cobot_command/cell/sweep/robot_claim.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::cell {
namespace {

/// What a claim is grown by besides what its bodies move [m].
double clearanceOf(const Parameters& parameters) {
  constexpr double kRoundingRoom = 1e-6;
  return parameters.body_tolerance + 0.5 * parameters.margin + kRoundingRoom;
}

}  // namespace

VoxelSet claimOf(const Piece& piece, const Parameters& parameters) {
  VoxelSet claim;
  const double clearance = clearanceOf(parameters);
  std::visit(Overloaded{[&](const ArmPosture& arm) {
                          const arm::JointVector half_widths =
                              (0.5 * arm.range.widths()).array() + parameters.tracking;
                          claimRobot(claim, *arm.bodies, arm.bodies->at(arm.range.centre()), half_widths,
                                     clearance, parameters.voxel);
                        },
                        // `tracking` is of measured joints, and a mechanism has none: what it may be beside
                        // its axis is `body_tolerance`.
                        [&](const AxisPosture& axis) {
                          const double half = 0.5 * std::abs(axis.to - axis.from);
                          const Capsules capsules = axis.bodies->at(axis.centre());
                          for (std::size_t body = 0; body < capsules.size(); ++body) {
                            Capsule grown = capsules[body];
                            grown.radius += axis.bodies->displacementBound(body, half) + clearance;
                            claimCapsule(claim, grown, parameters.voxel);
                          }
                        }},
             piece.posture);
  return claim;
}

}  // namespace cobot_command::cell
