#include "preview/trail.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kRest = 1;          // [s]
constexpr double kStep = 0.001;      // [m] between two places
constexpr std::size_t kMost = 5000;  // places: the oldest ones go

}  // namespace

bool Trail::add(const Eigen::Vector3d& place, bool moves, double now) {
  if (!moves) return false;
  if (!has_moved_ || now - moved_last_ > kRest) places_.clear();
  has_moved_ = true;
  moved_last_ = now;
  if (!places_.empty() && (place - places_.back()).norm() < kStep) return false;
  places_.push_back(place);
  if (places_.size() > kMost) places_.pop_front();
  return true;
}

}  // namespace cobot_command::rviz_plugin
