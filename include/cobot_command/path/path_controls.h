// Controls that act on all path goals from outside: tracking objects, which can hold back a goal, and the
// feedrate, which scales the path time.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace cobot_command::path {

inline constexpr std::size_t kTrackingObjects = 2;

/// On or off, for each tracking object.
using TrackingFlags = std::array<bool, kTrackingObjects>;

struct TrackingObject {
  bool on = false;
  bool automatic = false;  ///< switches automatically to what the next goal requires
};
using TrackingObjects = std::array<TrackingObject, kTrackingObjects>;

inline bool operator==(const TrackingObject& a, const TrackingObject& b) {
  return a.on == b.on && a.automatic == b.automatic;
}

/// True if a goal that requires these flags may load its points. The objects only hold a goal back; they have
/// no other effect.
[[nodiscard]] inline bool isGateOpen(const TrackingObjects& objects, const TrackingFlags& wanted) {
  for (std::size_t i = 0; i < kTrackingObjects; ++i) {
    if (objects[i].on != wanted[i]) return false;
  }
  return true;
}

/// The highest feedrate [1], and the lowest one above 0. At a lower feedrate the shortest motion would take
/// more than 3 h.
inline constexpr double kHighestFeedrate = 1.25;
inline constexpr double kLowestFeedrate = 1e-6;

struct PathControls {
  TrackingObjects tracking{};
  double feedrate = 1.0;  ///< (0..1.25]: time scale of the motions that are not sent yet
  bool stopped = false;   ///< stopped on the path: nothing more is sent, and nothing is lost
  bool held = false;      ///< the controller has reported that its current motion is paused

  /// Feedrate of what is sent next.
  [[nodiscard]] double asked() const { return stopped ? 0 : feedrate; }
  /// Feedrate of the current motion. `running`: the feedrate that the motions at the controller were planned
  /// with; std::nullopt: the controller has none.
  [[nodiscard]] double effective(const std::optional<double>& running) const {
    return held ? 0 : running.value_or(asked());
  }
};

inline bool operator==(const PathControls& a, const PathControls& b) {
  return a.tracking == b.tracking && a.feedrate == b.feedrate && a.stopped == b.stopped && a.held == b.held;
}

}  // namespace cobot_command::path
