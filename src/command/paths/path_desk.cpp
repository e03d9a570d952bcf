#include "paths/path_desk.h"

#include <utility>

#include <fmt/format.h>

namespace cobot_command::command {

std::optional<std::string> PathDesk::switchTracking(const TrackingSwitch& request) {
  constexpr auto kCount = static_cast<int>(path::kTrackingObjects);
  if (request.object < 0 || request.object >= kCount) {
    return fmt::format("object is {}, allowed: 0 to {}: choose one of these", request.object, kCount - 1);
  }
  path::PathControls changed = controls_;
  changed.tracking[static_cast<std::size_t>(request.object)] = {request.on, request.automatic};
  use(changed);
  return std::nullopt;
}

void PathDesk::setFeedrate(double feedrate) {
  path::PathControls changed = controls_;
  changed.feedrate = feedrate;
  use(changed);
}

void PathDesk::stop(bool stopped) {
  path::PathControls changed = controls_;
  changed.stopped = stopped;
  use(changed);
}

void PathDesk::hold(bool held) {
  path::PathControls changed = controls_;
  changed.held = held;
  use(changed);
}

path::PathControls PathDesk::served() const {
  path::PathControls controls = controls_;
  controls.feedrate *= speed_.share();
  return controls;
}

void PathDesk::serve(blocks::PathControlled& run, Instant now) {
  run.use(served(), now);
  pvt_refused_ = pvt_refused_ || run.isPvtRefused();
  if (const auto wanted = run.wantedTracking()) {
    switchAutomatic(*wanted);
    run.use(served(), now);
  }
}

void PathDesk::leave(const blocks::PathControlled& run, const blocks::ConnectGoal& controller) {
  path::DrivenPath driven = run.driven();
  if (driven.isEmpty() && !driven.isCutShort()) return;
  driven_ = driven.isEmpty() ? nullptr : std::make_shared<const path::DrivenPath>(std::move(driven));
  driven_on_ = controller;
}

void PathDesk::bringTo(Duration place) {
  if (driven_ == nullptr) return;
  path::DrivenPath driven = *driven_;
  driven.bringTo(place);
  driven_ = std::make_shared<const path::DrivenPath>(std::move(driven));
}

std::shared_ptr<const path::DrivenPath> PathDesk::driven(const blocks::ConnectGoal& controller) const {
  const bool is_same = driven_on_.host == controller.host && driven_on_.port == controller.port &&
                       driven_on_.status_port == controller.status_port;
  return is_same ? driven_ : nullptr;
}

void PathDesk::switchAutomatic(const path::TrackingFlags& wanted) {
  path::PathControls changed = controls_;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (changed.tracking[i].automatic) changed.tracking[i].on = wanted[i];
  }
  use(changed);
}

void PathDesk::use(const path::PathControls& controls) {
  if (controls == controls_) return;
  controls_ = controls;
  actions_.emplace_back(PathControlsChanged{controls});
}

}  // namespace cobot_command::command
