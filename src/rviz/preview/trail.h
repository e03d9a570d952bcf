// Where the tool has been since the robot began to move last.
#pragma once

#include <deque>

#include <Eigen/Core>

namespace cobot_command::rviz_plugin {

class Trail {
 public:
  /// `place` [m]. `moves`: whether the robot moves. `now` [s], of any clock that does not go back.
  /// A motion that begins behind a rest of a second begins a new trail.
  /// True: it is another one than before.
  bool add(const Eigen::Vector3d& place, bool moves, double now);

  [[nodiscard]] const std::deque<Eigen::Vector3d>& places() const { return places_; }

 private:
  std::deque<Eigen::Vector3d> places_;
  double moved_last_ = 0;
  bool has_moved_ = false;
};

}  // namespace cobot_command::rviz_plugin
