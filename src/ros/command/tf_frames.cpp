#include "cobot_command/ros/command/tf_frames.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <ros/exceptions.h>
#include <tf2/exceptions.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "cobot_command/common/given.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

// The frames of a robot that moves come late by some tens of milliseconds, those of a node that has just
// started by a few hundred.
constexpr auto kPatience = std::chrono::milliseconds(200);
// Whoever has just begun to listen has first to connect to all who send.
constexpr auto kFirstPatience = std::chrono::seconds(3);
// What has begun at the end of the node comes to its end where the master answers.
constexpr auto kEndPatience = std::chrono::milliseconds(100);

}  // namespace

/// What is known of tf, and who listens to it. Outlives the object where the master hangs: that cannot be
/// waited for.
class TfFrames::Listener {
 public:
  /// Begins on a thread that may wait for the master.
  static void begin(const std::shared_ptr<Listener>& self) {
    const std::lock_guard<std::mutex> lock(self->mutex_);
    self->is_beginning_ = true;
    std::thread([self] { self->listen(); }).detach();
  }
  void close() {
    std::unique_lock<std::mutex> lock(mutex_);
    is_closed_ = true;
    changed_.wait_for(lock, kEndPatience, [this] { return !is_beginning_; });
    listener_.reset();
  }
  [[nodiscard]] arm::Pose find(const std::string& base, const std::string& frame,
                               const ros::Time& time) const {
    return toPose(buffer_.lookupTransform(base, frame, time).transform);
  }

 private:
  void listen() {
    std::unique_ptr<tf2_ros::TransformListener> listener;
    try {
      listener = std::make_unique<tf2_ros::TransformListener>(buffer_);
    } catch (const ros::ConflictingSubscriptionException&) {
      // A topic of tf has the name of another one: the start of the node ends by that (CommandNode).
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!is_closed_) listener_ = std::move(listener);
    is_beginning_ = false;
    changed_.notify_all();
  }

  tf2_ros::Buffer buffer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_beginning_ = false;
  bool is_closed_ = false;
  std::unique_ptr<tf2_ros::TransformListener> listener_;  // after the buffer that it fills
};

TfFrames::TfFrames(std::string robot_base, bool from_start)
    : robot_base_(std::move(robot_base)), listener_(std::make_shared<Listener>()) {
  if (from_start) listen();
}

TfFrames::~TfFrames() {
  listener_->close();
}

void TfFrames::listen() {
  asked_at_ = ros::SteadyTime::now();
  Listener::begin(listener_);
}

Duration TfFrames::patience() const {
  if (!asked_at_) return kPatience;
  const Duration listened((ros::SteadyTime::now() - *asked_at_).toNSec());
  return std::max<Duration>(kPatience, kFirstPatience - listened);
}

FramePlace TfFrames::find(const std_msgs::Header& header) {
  const std::string& frame = header.frame_id;
  // tf2 says so as well, but its text ends where the right name should stand.
  if (frame.compare(0, 1, "/") == 0) {
    return {std::nullopt,
            fmt::format("names of tf frames have no leading /; is {} meant?", quoted(frame.substr(1)))};
  }
  if (!asked_at_) listen();
  try {
    return {listener_->find(robot_base_, frame, header.stamp), ""};
  } catch (const tf2::TransformException& fault) {
    return {std::nullopt, fault.what()};
  }
}

std::optional<arm::Pose> TfFrames::whereNow(const std::string& frame) const {
  try {
    return listener_->find(robot_base_, frame, ros::Time(0));
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace cobot_command::ros_adapter
