// Where an agent's robot is, as measured: how far on its path, and in which zones its bodies are.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "agent/path_tracker.h"
#include "agent/zone_watch.h"

#include "cobot_command/cell/model/cell_model.h"

namespace cobot_command::cell {

class Whereabouts {
 public:
  Whereabouts(std::shared_ptr<const Artifact> artifact, RobotIndex robot, ZoneWatch zones);

  // --- Its path.
  /// Nothing: it is at a station.
  [[nodiscard]] const std::optional<PathTracker>& tracker() const { return tracker_; }
  void setOut(PathIndex path);
  /// It is said to be at that place of a path. False: these joints are not on it.
  [[nodiscard]] bool locate(const CellPlace& place, const arm::JointVector& joints);
  void sent() { tracker_->sent(); }
  void done() {
    if (tracker_) tracker_->done();
  }
  void leavePath() { tracker_.reset(); }
  /// What was measured before says nothing any more.
  void startAnew();

  /// All its frames were sent, and the last one ends there.
  [[nodiscard]] bool isAtEndOfPath(const arm::JointVector& joints) const {
    return tracker_->allSent() && tracker_->isAtEnd(joints);
  }

  // --- What is measured.
  /// False: the joints are not where the program is.
  [[nodiscard]] bool see(const CellPlace& place, const arm::JointVector& joints);
  /// Afterwards zones() tells. True: they are others than before.
  bool lookAtZones(const CellPlace& place, const arm::JointVector& joints, ZoneWatch::Of whose);
  [[nodiscard]] const std::vector<ZoneIndex>& zones() const { return zones_.touched(); }
  /// By two frames in a row; the piece behind which it may be says that its last frame was sent.
  [[nodiscard]] bool isReleased(ZoneIndex zone, std::size_t piece) const;

 private:
  [[nodiscard]] const ArtifactRobot& made() const { return artifact_->robots[robot_]; }
  [[nodiscard]] arm::JointVector startOf(PathIndex path) const;
  [[nodiscard]] const std::vector<std::string>& carriedByProgram(const CellPlace& place) const;

  std::shared_ptr<const Artifact> artifact_;
  RobotIndex robot_;
  ZoneWatch zones_;
  std::optional<PathTracker> tracker_;
  std::vector<int> clear_frames_;  ///< by zone: outside of it, and with nothing ahead in it, so often
};

}  // namespace cobot_command::cell
