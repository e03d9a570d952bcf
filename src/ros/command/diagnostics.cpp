#include "cobot_command/ros/command/diagnostics.h"

#include <cstdint>
#include <tuple>
#include <utility>

#include <ros/callback_queue.h>

#include "cobot_command/ros/shared/posted.h"

namespace cobot_command::ros_adapter {
namespace {

// From a change until it is told: soon enough for people, and no flood when a link comes and goes.
constexpr double kChangesTogether = 0.1;  // [s]

/// What is worth a message before the period is over.
auto significant(const command::CommandStatus& s) {
  return std::tie(s.link, s.diagnosis, s.host, s.port, s.listen_node, s.status_stream);
}
auto significant(const link::RobotStatus& s) {
  return std::tie(s.emergency_stop, s.safeguard, s.error, s.error_code, s.project_running, s.project_paused,
                  s.operating_mode);
}

auto significant(const command::GroupState& s) {
  return std::tie(s.ri_state, s.out_of_sync);
}

}  // namespace

// The updater looks for a period by itself, at any time, and throws at one that is no number: it is given a
// namespace where there is none.
Diagnostics::Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& self, double period,
                         bool status_wanted)
    : rate_since_(ros::SteadyTime::now()), updater_(node, ros::NodeHandle(self, "diagnostic_updater")) {
  view_.status_wanted = status_wanted;
  updater_.setHardwareID("none");
  add("Link", describeLink);
  add("Listen node", describeListenNode);
  add("Queue", describeQueue);
  add("Robot", describeRobot);
  add("Status stream", describeStatusStream);
  add("Exchange", describeExchange);
  periodic_ = node.createSteadyTimer(ros::WallDuration(period),
                                     [this](const ros::SteadyTimerEvent&) { publish(true); });
  soon_ = node.createSteadyTimer(
      ros::WallDuration(kChangesTogether), [this](const ros::SteadyTimerEvent&) { publish(false); }, true);
}

Diagnostics::~Diagnostics() {
  ros::getGlobalCallbackQueue()->removeByID(ownerOf(this));
}

/// With the lock. Nothing runs as long as nothing changes.
void Diagnostics::noteChange() {
  if (std::exchange(changed_, true)) return;
  const auto restart = [this] {
    soon_.stop();  // it has run once
    soon_.start();
  };
  post(*ros::getGlobalCallbackQueue(), restart,
       this);  // timers belong to the thread that their callbacks run on
}

void Diagnostics::add(const char* task, Describe describe) {
  updater_.add(task, [this, describe](diagnostic_updater::DiagnosticStatusWrapper& status) {
    describe(status, view_);
  });
}

void Diagnostics::take(const command::CommandStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (significant(status) != significant(command_)) noteChange();
  command_ = status;
}

void Diagnostics::take(const link::RobotStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (significant(status) != significant(robot_)) noteChange();
  robot_ = status;
  ++frames_;
  last_frame_ = ros::SteadyTime::now();
}

void Diagnostics::take(const command::GroupState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (significant(state) != significant(group_)) noteChange();
  group_ = state;
}

void Diagnostics::publish(bool due) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!due && !changed_) return;
    changed_ = false;
    view_.command = command_;
    view_.group = group_;
    view_.robot = robot_;
    view_.status_age.reset();
    if (last_frame_) view_.status_age = (now - *last_frame_).toSec();
    // Not over the short time between two changes: the rate would jump.
    if (due) {
      view_.status_rate = static_cast<double>(frames_ - rate_frames_) / (now - rate_since_).toSec();
      rate_frames_ = frames_;
      rate_since_ = now;
    }
  }
  updater_.setHardwareID(view_.command.host.empty() ? "none" : view_.command.host);
  updater_.force_update();
}

}  // namespace cobot_command::ros_adapter
