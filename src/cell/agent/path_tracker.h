// How far a robot is on a path, by its measured joints alone: never by time, a tag, or an answer (cell.md,
// M32).
#pragma once

#include <cstddef>
#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class PathTracker {
 public:
  /// At its beginning, nothing of it sent. `path` has to live longer; `start` are the joints there, and
  /// `tracking` is how far each joint may be from what is planned [rad].
  PathTracker(const ArtifactPath& path, const arm::JointVector& start, double tracking);

  /// Where a robot with these joints may go on, when so many zone steps of the path's program are done:
  /// nothing, when it is not on the path behind them.
  [[nodiscard]] static std::optional<PathTracker> located(const ArtifactPath& path,
                                                          const PathProgram& program,
                                                          const arm::JointVector& start, double tracking,
                                                          std::size_t behind, const arm::JointVector& joints);

  // --- Frames.
  /// The first one that was not sent.
  [[nodiscard]] std::size_t nextFrame() const { return next_frame_; }
  [[nodiscard]] bool allSent() const { return next_frame_ >= path_->frames.size(); }
  void sent();
  /// The last one that was sent, with all that follows it where it ends: it carries what it goes on with.
  void done() { is_done_ = true; }
  [[nodiscard]] bool isDone() const { return is_done_; }
  /// The next frame is one that was stopped on its way: it goes on from within this range.
  [[nodiscard]] const std::optional<motion::JointRange>& resumesWithin() const { return resumes_within_; }

  // --- What is measured.
  /// False: the joints are where no frame that was sent leads, from where it was last.
  [[nodiscard]] bool see(const arm::JointVector& joints);
  /// The piece it is in, or nothing before the first frame. Of those that hang together the first one, so
  /// that nothing is passed too early; but where all from there on that were sent have the joints, it rests
  /// at the end of its motion: in the first of its rests, and in the last one when that frame is done.
  [[nodiscard]] std::optional<std::size_t> piece() const;
  /// What is still to come of the frames that were sent touches the zone.
  [[nodiscard]] bool willTouch(ZoneIndex zone) const;
  /// Where the last frame that was sent ends, or where the path begins.
  [[nodiscard]] bool isAtEnd(const arm::JointVector& joints) const;
  /// Until the next frame takes over, or the robot stands, when nothing holds it up.
  [[nodiscard]] Duration remaining() const;
  [[nodiscard]] const ArtifactPath& path() const { return *path_; }

 private:
  [[nodiscard]] bool isAtStart(const arm::JointVector& joints) const;
  /// Of the pieces of all frames that were sent.
  [[nodiscard]] std::size_t endOfSent() const;
  /// Of the last frame that was sent.
  [[nodiscard]] std::size_t firstRest() const;

  const ArtifactPath* path_;
  arm::JointVector start_;
  double tracking_;
  std::size_t next_frame_ = 0;
  std::size_t piece_ = 0;
  bool is_done_ = true;
  bool is_at_rest_ = false;  ///< in all pieces from that one to the end of what was sent
  std::optional<motion::JointRange> resumes_within_;
};

}  // namespace cobot_command::cell
