// What holds paths back, and how fast their time runs, from outside of any goal: tracking objects and the
// feedrate.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace cobot_command::path {

inline constexpr std::size_t kTrackingObjects = 2;

/// Of each tracking object: on.
using TrackingFlags = std::array<bool, kTrackingObjects>;

struct TrackingObject {
  bool on = false;
  bool automatic = false;  ///< switches itself to what the next goal wants
};
using TrackingObjects = std::array<TrackingObject, kTrackingObjects>;

inline bool operator==(const TrackingObject& a, const TrackingObject& b) {
  return a.on == b.on && a.automatic == b.automatic;
}

/// Whether a goal may load its points that wants the objects so: a gate that holds it back, and no more.
[[nodiscard]] inline bool isGateOpen(const TrackingObjects& objects, const TrackingFlags& wanted) {
  for (std::size_t i = 0; i < kTrackingObjects; ++i) {
    if (objects[i].on != wanted[i]) return false;
  }
  return true;
}

/// The highest feedrate [1]; and the lowest one above 0: at a lower one the shortest motion takes more than 3
/// h.
inline constexpr double kHighestFeedrate = 1.25;
inline constexpr double kLowestFeedrate = 1e-6;

struct PathControls {
  TrackingObjects tracking{};
  double feedrate = 1.0;  ///< (0..1.25]: so much faster runs the time of what is not sent yet
  bool stopped = false;   ///< on the path: nothing more of it is sent, and nothing is lost
  bool held = false;      ///< what the controller has stands on its way, as it has told

  /// Of what is sent next.
  [[nodiscard]] double asked() const { return stopped ? 0 : feedrate; }
  /// Of what moves the arm now. `running`: that what the controller has was planned with; nothing: it has
  /// nothing.
  [[nodiscard]] double effective(const std::optional<double>& running) const {
    return held ? 0 : running.value_or(asked());
  }
};

inline bool operator==(const PathControls& a, const PathControls& b) {
  return a.tracking == b.tracking && a.feedrate == b.feedrate && a.stopped == b.stopped && a.held == b.held;
}

}  // namespace cobot_command::path
