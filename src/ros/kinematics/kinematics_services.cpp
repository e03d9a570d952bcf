#include "kinematics/kinematics_services.h"

#include <utility>

#include "kinematics/kinematics_messages.h"

#include "cobot_command/capabilities/functions.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

template <class Response>
void refuseWithoutArm(Response& response) {
  response.error_id = capabilities::kNotOffered;
  response.message = std::string("not offered: ") + capabilities::kNoArm;
}

bool calculateTool(cobot_command::CalculateTool::Request& request,
                   cobot_command::CalculateTool::Response& response) {
  response = toResponse(kinematics::calculateTool(toQuestion(request)));
  return true;
}

}  // namespace

KinematicsServices::KinematicsServices(const ros::NodeHandle& node, Sources sources)
    : sources_(std::move(sources)) {
  OwnHandle handle(node);
  services_.push_back(handle.advertiseService("forward_kinematics", &KinematicsServices::forward, this));
  services_.push_back(handle.advertiseService("inverse_kinematics", &KinematicsServices::inverse, this));
  services_.push_back(handle.advertiseService("calculate_frame", &KinematicsServices::frame, this));
  services_.push_back(handle.advertiseService("calculate_tool", &calculateTool));
}

bool KinematicsServices::forward(cobot_command::ForwardKinematics::Request& request,
                                 cobot_command::ForwardKinematics::Response& response) {
  if (const auto arm = sources_.arm()) {
    response = toResponse(kinematics::forward(*arm, sources_.tables(), toQuestion(request)));
  } else {
    refuseWithoutArm(response);
  }
  return true;
}

bool KinematicsServices::inverse(cobot_command::InverseKinematics::Request& request,
                                 cobot_command::InverseKinematics::Response& response) {
  if (const auto arm = sources_.arm()) {
    response = toResponse(kinematics::inverse(*arm, sources_.tables(), toQuestion(request)));
  } else {
    refuseWithoutArm(response);
  }
  return true;
}

bool KinematicsServices::frame(cobot_command::CalculateFrame::Request& request,
                               cobot_command::CalculateFrame::Response& response) {
  response = toResponse(kinematics::calculateFrame(sources_.tables(), toQuestion(request)));
  return true;
}

}  // namespace cobot_command::ros_adapter
