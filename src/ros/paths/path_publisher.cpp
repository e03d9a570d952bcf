#include "paths/path_publisher.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "paths/path_messages.h"

#include "cobot_command/blocks/load_path.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 100;

}  // namespace

PathPublisher::PathPublisher(OwnHandle node, std::string base_frame)
    : base_frame_(std::move(base_frame)),
      line_(node.advertise<visualization_msgs::Marker>("planned_path", kQueueSize, true)),
      points_(node.advertise<visualization_msgs::MarkerArray>("planned_points", kQueueSize, true)),
      active_point_(node.advertise<visualization_msgs::Marker>("active_point", kQueueSize, true)),
      status_(node.advertise<cobot_command::PathStatus>("path_status", kQueueSize, true)) {
  status_.publish(toMessage(blocks::PathStatus(), ros::Time::now()));  // so that it can be read at once
}

MarkerSite PathPublisher::site() const {
  return {base_frame_, ros::Time::now()};
}

void PathPublisher::take(const command::PathPlanned& path) {
  line_.publish(toLine(path.tool_path, site()));
  if (board_.shown().empty()) return;
  board_.dropEnded();
  points_.publish(toPoints(board_.shown(), site()));
}

void PathPublisher::take(const command::GoalPreviewed& preview) {
  const auto* const path = preview.preview.find<path::PathPreview>();
  if (path == nullptr) return;
  board_.show(preview.goal, *path);
  line_.publish(toLine(board_.shown(), site()));
  points_.publish(toPoints(board_.shown(), site()));
}

void PathPublisher::take(const command::GoalProgressed& progress) {
  const auto* const place = progress.progress.detail.find<blocks::PathPlace>();
  if (place == nullptr) return;
  board_.setActive(progress.goal, place->active_path_point);
  showActive();
}

void PathPublisher::take(const command::GoalEnded& end) {
  board_.end(end.goal);
  showActive();
}

void PathPublisher::take(const command::RunTold& told) {
  const auto* const status = told.news.find<blocks::PathStatus>();
  if (status == nullptr) return;
  told_ = *status;
  status_.publish(toMessage(told_, ros::Time::now()));
}

void PathPublisher::take(const command::PathControlsChanged& changed) {
  if (told_.path_planner_active) return;
  told_.feedrate = kPercent * changed.controls.asked();
  told_.feedrate_effective = kPercent * changed.controls.effective(std::nullopt);
  status_.publish(toMessage(told_, ros::Time::now()));
}

void PathPublisher::showActive() {
  const auto active = board_.activePlace();
  if (active == active_) return;
  active_ = active;
  active_point_.publish(toActivePoint(active, site()));
}

}  // namespace cobot_command::ros_adapter
