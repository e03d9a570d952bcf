// What is known of one mechanism that is watched: a track by the position of its one axis.
#pragma once

#include <string>
#include <utility>

#include "monitor/track.h"

#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

class MechanismTrack : public Track {
 public:
  MechanismTrack(std::string name, MechanismBodies mechanism)
      : Track({}), name_(std::move(name)), mechanism_(std::move(mechanism)) {}

  /// As Monitor::takePosition(). Nobody tells its speed: it is what it did since the data before.
  Taken take(double position, Duration age, Instant now, Duration most);

  /// It has one name for all of its bodies.
  [[nodiscard]] const std::string& bodyName(std::size_t /*body*/) const override { return name_; }

 private:
  void place() override;
  [[nodiscard]] double displacement(std::size_t body, double seconds) const override;

  std::string name_;
  MechanismBodies mechanism_;
};

}  // namespace cobot_command::cell::monitor
