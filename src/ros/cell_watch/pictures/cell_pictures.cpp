#include "cell_watch/pictures/cell_pictures.h"

#include <algorithm>
#include <utility>

#include "cell_watch/pictures/body_markers.h"
#include "cell_watch/pictures/marker_parts.h"
#include "cell_watch/pictures/shortest_way.h"
#include <fmt/format.h>
#include <ros/console.h>

#include "cobot_command/cell/splitting/split_cell.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::MarkerArray;

/// Between two complaints of the same kind [s].
constexpr double kComplaintPeriod = 10;

/// What of a zone is drawn.
bool looksLike(const cobot_command::CellZone& a, const cobot_command::CellZone& b) {
  return a.name == b.name && a.state == b.state && a.owner == b.owner && a.waiting == b.waiting;
}

bool looksLike(const std::vector<cobot_command::CellZone>& a, const std::vector<cobot_command::CellZone>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return looksLike(one, other); });
}

}  // namespace

CellPictures::CellPictures(const ros::NodeHandle& node, cell::Cell cell, std::optional<CellScene> scene)
    : node_(node), cell_(std::move(cell)), scene_(std::move(scene)) {
  bodies_ = node_.advertise<MarkerArray>("bodies", 1, true);
  obstacles_ = node_.advertise<MarkerArray>("obstacles", 1, true);
  closest_ = node_.advertise<MarkerArray>("closest", 1, true);
  claims_topic_ = node_.advertise<MarkerArray>("claims", 1, true);
  show_claims_ = node_.advertiseService("show_claims", &CellPictures::showClaims, this);
  if (!scene_) return;
  zones_ = node_.advertise<MarkerArray>("zones", 1, true);
  zones_.publish(toZoneMarkers(*scene_, cobot_command::CellState(), ros::Time::now()));
  const boost::function<void(const cobot_command::CellStateConstPtr&)> take =
      [this](const cobot_command::CellStateConstPtr& message) { hear(*message); };
  states_ = node_.subscribe<cobot_command::CellState>("state", 1, take);
}

void CellPictures::hear(const cobot_command::CellState& state) {
  if (state.hash != scene_->hash) {
    ROS_WARN_STREAM_THROTTLE(kComplaintPeriod, "the supervisor uses another artifact ("
                                                   << foreignText(state.hash) << ") than the zone pictures ("
                                                   << scene_->hash << "): give both the same file");
    return;
  }
  if (looksLike(state.zones, shown_zones_)) return;
  shown_zones_ = state.zones;
  zones_.publish(toZoneMarkers(*scene_, state, ros::Time::now()));
}

bool CellPictures::showClaims(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  are_claims_wanted_ = request.data != 0;
  response.success = 1;
  if (!are_claims_wanted_ || claims_) {
    publishClaims();
    response.message = are_claims_wanted_ ? "Claims are shown." : "Claims are hidden.";
    return true;
  }
  response.message = "Claims are being calculated, and are shown when that is done.";
  if (found_claims_.valid()) return true;
  found_claims_ = std::async(std::launch::async, [cell = cell_]() -> Claims {
    auto split = cell::splitCell(cell);
    if (!split) return refuse(split.error());
    return std::move(split->claims);
  });
  return true;
}

void CellPictures::publishClaims() {
  const bool are_shown = are_claims_wanted_ && claims_;
  const std::vector<cell::RobotClaim> none;
  claims_topic_.publish(
      toClaimMarkers(are_shown ? *claims_ : none, cell_.parameters.voxel, ros::Time::now()));
}

void CellPictures::showBodies(const WatchView& view) {
  const auto end_of_movers =
      view.bodies.begin() + static_cast<std::ptrdiff_t>(std::min(view.movers.size(), view.bodies.size()));
  const ros::Time now = ros::Time::now();
  if (!are_obstacles_shown_ && !view.bodies.empty()) {
    are_obstacles_shown_ = true;
    obstacles_.publish(toBodyMarkers({end_of_movers, view.bodies.end()}, 0, now));
  }
  if (bodies_.getNumSubscribers() == 0) return;
  MarkerArray bodies = toBodyMarkers({view.bodies.begin(), end_of_movers}, view.movers.size(), now);
  MarkerArray told = areSameMarkers(bodies, shown_bodies_) ? MarkerArray() : cleared(now);
  told.markers.insert(told.markers.end(), bodies.markers.begin(), bodies.markers.end());
  bodies_.publish(told);
  shown_bodies_ = std::move(bodies);
}

void CellPictures::show(const WatchView& view) {
  showBodies(view);
  const auto way = shortestWay(view);
  if (way || is_way_shown_) closest_.publish(toDistanceMarkers(way, ros::Time::now()));
  is_way_shown_ = way.has_value();
  const bool are_found =
      found_claims_.valid() && found_claims_.wait_for(Duration(0)) == std::future_status::ready;
  if (!are_found) return;
  auto found = found_claims_.get();
  if (!found) {
    ROS_ERROR_STREAM(
        "no claims can be shown: " << forPeople(fmt::format("{}", fmt::join(found.error(), "; "))));
    return;
  }
  claims_ = std::move(*found);
  publishClaims();
}

}  // namespace cobot_command::ros_adapter
