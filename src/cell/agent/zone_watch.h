// Which zones the bodies of a robot are in, where it is measured.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

class ZoneWatch {
 public:
  /// `artifact` has to live longer. A fault is a sentence: there is no such arm.
  [[nodiscard]] static Result<ZoneWatch, std::string> of(const Artifact& artifact, RobotIndex robot);

  /// Whose zones count. On its path a robot may well be in those of others: what it may meet of each of them
  /// is in a zone that it is a user of.
  enum class Of { Users, Everyone };

  /// The bodies at these joints [rad], with those parts, grown as claims are, but for what they could move.
  void see(const arm::JointVector& joints, const std::vector<std::string>& carried, Of of);
  /// Ascending.
  [[nodiscard]] const std::vector<ZoneIndex>& touched() const { return touched_; }
  [[nodiscard]] bool touches(ZoneIndex zone) const;

 private:
  ZoneWatch(const Artifact& artifact, RobotIndex robot, RobotBodies bare);

  [[nodiscard]] const RobotBodies& carrying(const std::vector<std::string>& parts);
  [[nodiscard]] bool isOfInterest(ZoneIndex zone, Of of) const;
  /// Most bodies are far from all zones at most times, and looking at boxes is cheap.
  [[nodiscard]] bool isNearOne(const Capsule& grown, Of of) const;

  const Artifact* artifact_;
  RobotIndex robot_;
  RobotBodies bare_;
  std::map<std::vector<std::string>, RobotBodies> known_;
  std::vector<std::optional<AlignedBox>> boxes_;  ///< around each zone [m]
  PlacedRobot placed_;
  VoxelSet claim_;
  std::vector<ZoneIndex> touched_;
};

}  // namespace cobot_command::cell
