#include "agent/whereabouts.h"

#include <algorithm>
#include <utility>

#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/cell/artifact/place_parts.h"

namespace cobot_command::cell {

Whereabouts::Whereabouts(std::shared_ptr<const Artifact> artifact, RobotIndex robot, ZoneWatch zones)
    : artifact_(std::move(artifact)),
      robot_(robot),
      zones_(std::move(zones)),
      clear_frames_(artifact_->zones.size(), 0) {}

arm::JointVector Whereabouts::startOf(PathIndex path) const {
  return made().stations[artifact_->program.robots[robot_].paths[path].from].joints;
}

const std::vector<std::string>& Whereabouts::carriedByProgram(const CellPlace& place) const {
  if (place.station) return made().stations[*place.station].carried;
  const auto& frames = made().paths[place.path].frames;
  if (!tracker_) return frames.front().carried;
  const std::size_t frame = tracker_->nextFrame() - (tracker_->isDone() ? 0 : 1);
  if (frame < frames.size()) return frames[frame].carried;
  return made().stations[artifact_->program.robots[robot_].paths[place.path].to].carried;
}

void Whereabouts::setOut(PathIndex path) {
  std::fill(clear_frames_.begin(), clear_frames_.end(), 0);
  tracker_.emplace(made().paths[path], startOf(path), artifact_->parameters.tracking);
}

bool Whereabouts::locate(const CellPlace& place, const arm::JointVector& joints) {
  tracker_ =
      PathTracker::located(made().paths[place.path], artifact_->program.robots[robot_].paths[place.path],
                           startOf(place.path), artifact_->parameters.tracking, place.behind, joints);
  return tracker_.has_value();
}

void Whereabouts::startAnew() {
  tracker_.reset();
  std::fill(clear_frames_.begin(), clear_frames_.end(), 0);
}

bool Whereabouts::see(const CellPlace& place, const arm::JointVector& joints) {
  if (tracker_) {
    const bool is_on_path = tracker_->see(joints);
    for (ZoneIndex zone = 0; zone < clear_frames_.size(); ++zone) {
      const bool is_clear = is_on_path && !tracker_->willTouch(zone) && !zones_.touches(zone);
      clear_frames_[zone] = is_clear ? clear_frames_[zone] + 1 : 0;
    }
    return is_on_path;
  }
  return !place.station || placeFits(*artifact_, robot_, place, joints);
}

bool Whereabouts::lookAtZones(const CellPlace& place, const arm::JointVector& joints, ZoneWatch::Of whose) {
  const std::vector<ZoneIndex> before = zones_.touched();
  if (whose == ZoneWatch::Of::Everyone) {
    // Off its way nobody knows what it has taken or set down of what it may have had there.
    const Carried all = carriedAt(*artifact_, robot_, place);
    zones_.see(joints, {all.begin(), all.end()}, whose);
  } else {
    zones_.see(joints, carriedByProgram(place), whose);
  }
  return before != zones_.touched();
}

bool Whereabouts::isReleased(ZoneIndex zone, std::size_t piece) const {
  const auto measured = tracker_->piece();
  const bool is_last_sent = tracker_->nextFrame() > tracker_->path().pieces[piece].frame;
  return is_last_sent && measured && *measured > piece && clear_frames_[zone] >= 2;
}

}  // namespace cobot_command::cell
