#include "paths/path_status_report.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/units.h"
#include "cobot_command/path/flange_rates.h"

namespace cobot_command::blocks {
namespace {

constexpr Duration kEvery = std::chrono::milliseconds(50);

int moveIdOf(const PathChain& chain, std::size_t point) {
  const PathChain::Member& member = chain.members()[chain.memberAt(point)];
  return point >= member.first && point < member.behind() ? member.loaded->move_ids[point - member.first] : 0;
}

void tellPoint(PathStatus& status, const path::PathPoint& point) {
  status.active_interpolation = point.interpolation;
  status.active_type = point.pose_type;
  status.active_type_id = point.pose_id;
  status.active_ref_frame_type = point.ref_frame_type;
  status.active_ref_frame_id = point.ref_frame_id;
}

void tellRates(PathStatus& status, const path::FlangeRates& rates, double rate) {
  status.linear_velocity = mToMm(rates.linear_velocity) * rate;
  status.linear_acceleration = mToMm(rates.linear_acceleration) * rate * rate;
  status.angular_velocity = radToDeg(rates.angular_velocity) * rate;
  status.angular_acceleration = radToDeg(rates.angular_acceleration) * rate * rate;
}

}  // namespace

void PathStatusClock::begin(Instant now) {
  if (!due_) due_ = now;
}

/// In step, as long as it is not late by more than that.
bool PathStatusClock::takeDue(Instant now) {
  if (!due_ || now < *due_) return false;
  due_ = (now < *due_ + kEvery ? *due_ : now) + kEvery;
  return true;
}

bool PathStatusClock::end() {
  return std::exchange(due_, std::nullopt).has_value();
}

PathStatus statusOf(const PathChain& chain, const PathChain::Place& place, const PathProgress& progress,
                    Instant now) {
  PathStatus status;
  status.path_planner_active = true;
  status.source = progress.source();
  const auto motion = progress.motion(now);
  if (!motion || place.done >= place.behind_active || place.done < motion->first) return status;
  const path::PathPlan& plan = motion->piece->plan;
  const std::size_t active = place.done - motion->first;
  if (active >= plan.points().size()) return status;
  status.active_move_id = moveIdOf(chain, place.done);
  status.active_move_percent = kPercent * progress.share();
  tellPoint(status, plan.points()[active].point);
  const path::PathPlan::Place now_at = plan.placeAt(motion->time);
  if (now_at.blends && place.done + 2 == place.behind_active) {
    status.blending_move_id = moveIdOf(chain, place.done + 1);
    status.blending_move_percent = kPercent * now_at.next_share;
  }
  const LoadedPath& loaded = *chain.members().front().loaded;
  if (!loaded.knows_arm) return status;
  const auto& arm = loaded.end->scene().arm;
  tellRates(status, path::flangeRatesAt(plan, motion->time, arm), motion->rate);
  return status;
}

}  // namespace cobot_command::blocks
