// The pieces of one robot's programs, without what they claim.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "claims/bodies_of_robot.h"

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/motion/blend.h"

namespace cobot_command::cell {

class Sweep {
 public:
  Sweep(const Cell& cell, const Robot& robot, const PlannedRobot& planned, BodiesOfRobot bodies)
      : parameters_(cell.parameters), robot_(robot), planned_(planned), bodies_(std::move(bodies)) {}

  [[nodiscard]] RobotClaim pieces();
  [[nodiscard]] PathClaim piecesOf(std::size_t path);
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }

 private:
  /// What all pieces of a motion have in common.
  struct Made {
    Piece::Kind kind = Piece::Kind::Motion;
    std::size_t frame = 0;
    std::size_t motion = 0;
    std::shared_ptr<const RobotBodies> bodies;
  };

  void claimFrame(const PlannedPath& path, std::size_t frame);
  void claimMotion(const motion::Trajectory& trajectory, const Made& made, motion::Interval time);
  void claimRests(const PlannedPath& path, const Made& made);
  void claimCorner(const PlannedMotion& before, const PlannedMotion& next, const Made& made);
  /// `reach`: of the whole corner.
  void claimCornerPart(const motion::Corner& corner, const Made& made, const motion::CornerReach& reach,
                       motion::Interval of_before, motion::Interval of_next);
  [[nodiscard]] Piece rest(const arm::JointVector& joints, const Made& made) const;
  /// False: a body moves too far.
  bool add(const motion::JointRange& range, const Made& made, motion::Interval time, bool at_any_rate);
  void fault(std::size_t frame, const motion::Unbounded& unbounded);

  const Parameters& parameters_;
  const Robot& robot_;
  const PlannedRobot& planned_;
  BodiesOfRobot bodies_;
  // Of the path that is being claimed.
  const Path* path_ = nullptr;
  std::vector<Piece> pieces_;
  const PlannedMotion* last_ = nullptr;                   ///< motion so far
  arm::JointVector standing_ = arm::JointVector::Zero();  ///< where the last motion so far ends
  std::vector<Fault> faults_;
};

}  // namespace cobot_command::cell
