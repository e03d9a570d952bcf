#include "preview/target.h"

#include <algorithm>
#include <utility>

#include "own_topics.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr float kScale = 0.2F;  // [m]

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;

/// Along an axis and about it. The orientation of a control is where its own x goes.
void addAxis(InteractiveMarker& marker, double x, double y, double z) {
  for (const std::uint8_t mode :
       {InteractiveMarkerControl::MOVE_AXIS, InteractiveMarkerControl::ROTATE_AXIS}) {
    InteractiveMarkerControl& control = marker.controls.emplace_back();
    control.interaction_mode = mode;
    control.orientation.w = M_SQRT1_2;
    control.orientation.x = x * M_SQRT1_2;
    control.orientation.y = y * M_SQRT1_2;
    control.orientation.z = z * M_SQRT1_2;
  }
}

InteractiveMarker markerIn(const std::string& frame, const std::string& name) {
  InteractiveMarker marker;
  marker.header.frame_id = frame;
  marker.name = name;
  marker.scale = kScale;
  addAxis(marker, 1, 0, 0);
  addAxis(marker, 0, 0, 1);
  addAxis(marker, 0, 1, 0);
  return marker;
}

std::string nextName() {
  static int count = 0;
  return "target_" + std::to_string(++count);
}

Configuration configurationOf(const cobot_command::RobotPose& bits) {
  return {bits.config1, bits.config2, bits.config3};
}

}  // namespace

Target::Target(Robot& robot, Preview& preview)
    : robot_(robot),
      preview_(preview),
      name_(nextName()),
      server_(
          std::make_unique<interactive_markers::InteractiveMarkerServer>(ownTopic(kPreviewTarget), name_)) {}

void Target::show(const Six& target, const std::optional<Configuration>& configuration) {
  is_hidden_ = false;
  shown_ = target;
  placeMarker(target);
  const Question question{target, configuration};
  if (is_asking_) {
    next_ = question;
  } else {
    ask(question);
  }
}

void Target::hide() {
  is_hidden_ = true;
  next_.reset();
  configurations_.clear();
  server_->clear();
  server_->applyChanges();
  preview_.hide();
}

void Target::placeMarker(const Six& target) {
  const std::string frame = robot_.activeBaseFrame();
  if (frame.empty()) return;
  InteractiveMarker marker;
  if (!server_->get(name_, marker)) {
    server_->insert(markerIn(frame, name_),
                    [this](const InteractiveMarkerFeedback::ConstPtr& feedback) { hear(*feedback); });
  }
  server_->setPose(name_, ros_adapter::toPoseMessage(arm::toPose(target)));
  server_->applyChanges();
}

void Target::hear(const InteractiveMarkerFeedback& feedback) {
  if (feedback.event_type != InteractiveMarkerFeedback::POSE_UPDATE || is_hidden_) return;
  // Displays name themselves by their node. What is dragged in another RViz is not what the operator of this
  // one sees.
  const std::string own = ros::this_node::getName() + "/";
  if (feedback.client_id.compare(0, own.size(), own) != 0) {
    placeMarker(shown_);
    return;
  }
  if (dragged_) dragged_(arm::toControllerPose(ros_adapter::toPose(feedback.pose)));
}

void Target::ask(const Question& question) {
  const cobot_command::ActiveFrames& frames = robot_.activeFrames();
  if (!frames.base_known || !frames.tcp_known) return;
  const auto& [target, configuration] = question;
  // The service knows no active TCP: the flange in the robot base says the same.
  const Eigen::Isometry3d flange =
      ros_adapter::toPose(frames.base) * arm::toPose(target) * ros_adapter::toPose(frames.tcp).inverse();
  cobot_command::InverseKinematics service;
  service.request.pose = ros_adapter::toTransformation(arm::toControllerPose(flange));
  service.request.configuration = configuration ? cobot_command::InverseKinematicsRequest::GIVEN
                                                : cobot_command::InverseKinematicsRequest::SAME;
  if (configuration) {
    service.request.bits.config1 = (*configuration)[0];
    service.request.bits.config2 = (*configuration)[1];
    service.request.bits.config3 = (*configuration)[2];
  }
  const auto joints = robot_.joints();
  if (joints) std::copy(joints->begin(), joints->end(), service.request.joints.begin());
  is_asking_ = true;
  calls_.call<cobot_command::InverseKinematics>(
      robot_.node().resolveName("inverse_kinematics"), service,
      [this, asked = question.target](bool answered, const cobot_command::InverseKinematics& told) {
        answer(asked, answered, told);
      });
}

void Target::answer(const Six& target, bool answered, const cobot_command::InverseKinematics& service) {
  is_asking_ = false;
  if (is_hidden_) return;
  if (next_) {
    const Question newest = *next_;
    next_.reset();
    ask(newest);
    return;
  }
  configurations_.clear();
  for (const cobot_command::ArmPosture& branch : service.response.branches) {
    if (branch.within_limits) configurations_.push_back(configurationOf(branch.bits));
  }
  if (!answered) {
    preview_.hide();
    return;
  }
  if (!service.response.success) {
    preview_.showUnreachable(target, service.response.message);
    return;
  }
  Six joints{};
  std::copy(service.response.posture.joints.begin(), service.response.posture.joints.end(), joints.begin());
  preview_.showArm(joints);
}

}  // namespace cobot_command::rviz_plugin
