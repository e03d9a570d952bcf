#include "dynamics/dynamics_services.h"

#include <string>
#include <utility>

#include "shared/core_answer.h"

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/capabilities/functions.h"
#include "cobot_command/common/units.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr const char* kNoModelText = "no model of the arm is known: nothing is planned";

std::optional<double> toDefault(double value) {
  return value < 0 ? std::nullopt : std::optional(value);
}

blocks::DefaultDynamics toDefaults(const cobot_command::DefaultDynamics& message) {
  return {toDefault(message.speed_percent), toDefault(message.speed_mm_s), toDefault(message.accel_time),
          toDefault(message.blending_percent), toDefault(message.blending_mm)};
}

cobot_command::DefaultDynamics toMessage(const blocks::DefaultDynamics& defaults) {
  constexpr double kNone = -1;
  cobot_command::DefaultDynamics message;
  message.speed_percent = defaults.speed_percent.value_or(kNone);
  message.speed_mm_s = defaults.speed_mm_s.value_or(kNone);
  message.accel_time = defaults.accel_time.value_or(kNone);
  message.blending_percent = defaults.blending_percent.value_or(kNone);
  message.blending_mm = defaults.blending_mm.value_or(kNone);
  return message;
}

template <class Six>
void toDegrees(const arm::JointVector& radians, Six& degrees) {
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    degrees[i] = radToDeg(radians[static_cast<Eigen::Index>(i)]);
  }
}

template <class Six>
arm::JointVector toRadians(const Six& degrees) {
  arm::JointVector radians;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    radians[static_cast<Eigen::Index>(i)] = degToRad(degrees[i]);
  }
  return radians;
}

}  // namespace

DynamicsServices::DynamicsServices(const ros::NodeHandle& node, Core core) : core_(std::move(core)) {
  OwnHandle n(node);
  using Self = DynamicsServices;
  services_.push_back(n.advertiseService("change_speed_override", &Self::changeSpeedOverride, this));
  services_.push_back(n.advertiseService("read_reference_dynamics", &Self::readReference, this));
  services_.push_back(n.advertiseService("write_reference_dynamics", &Self::writeReference));
  services_.push_back(n.advertiseService("read_default_dynamics", &Self::readDefaults, this));
  services_.push_back(n.advertiseService("write_default_dynamics", &Self::writeDefaults, this));
  services_.push_back(n.advertiseService("read_software_limits", &Self::readLimits, this));
  services_.push_back(n.advertiseService("write_software_limits", &Self::writeLimits, this));
}

bool DynamicsServices::changeSpeedOverride(cobot_command::ChangeSpeedOverride::Request& request,
                                           cobot_command::ChangeSpeedOverride::Response& response) {
  const auto answer = answerOf(core_.set_override(request.percent), response.message,
                               "requested; the controller has not confirmed it yet: see group_state");
  if (!answer) return true;
  fill(response, *answer);
  response.effective = answer->effective;
  return true;
}

bool DynamicsServices::readReference(cobot_command::ReadReferenceDynamics::Request& /*request*/,
                                     cobot_command::ReadReferenceDynamics::Response& response) {
  const auto answer = answerOf(core_.reference(), response.message);
  if (!answer) return true;
  response.success = static_cast<std::uint8_t>(answer->has_value());
  if (!*answer) {
    response.error_id = command::dynamics_error::kReferenceDynamics;
    response.message = kNoModelText;
    return true;
  }
  toDegrees((*answer)->joint_speeds, response.joint_speeds);
  response.tcp_speed = mToMm((*answer)->tcp_speed);
  response.turn_speed = radToDeg((*answer)->turn_speed);
  return true;
}

bool DynamicsServices::writeReference(cobot_command::WriteReferenceDynamics::Request& /*request*/,
                                      cobot_command::WriteReferenceDynamics::Response& response) {
  response.error_id = capabilities::kNotOffered;
  response.message =
      "the controller defines what 100 % means, and it cannot be written: use change_speed_override or "
      "write_default_dynamics";
  return true;
}

bool DynamicsServices::readDefaults(cobot_command::ReadDefaultDynamics::Request& /*request*/,
                                    cobot_command::ReadDefaultDynamics::Response& response) {
  const auto answer = answerOf(core_.defaults(), response.message);
  response.success = static_cast<std::uint8_t>(answer.has_value());
  if (answer) response.defaults = toMessage(*answer);
  return true;
}

bool DynamicsServices::writeDefaults(cobot_command::WriteDefaultDynamics::Request& request,
                                     cobot_command::WriteDefaultDynamics::Response& response) {
  const auto answer = answerOf(core_.write_defaults(toDefaults(request.defaults)), response.message);
  if (answer) fill(response, *answer);
  return true;
}

bool DynamicsServices::readLimits(cobot_command::ReadSoftwareLimits::Request& /*request*/,
                                  cobot_command::ReadSoftwareLimits::Response& response) {
  const auto answer = answerOf(core_.limits(), response.message);
  if (!answer) return true;
  response.success = static_cast<std::uint8_t>(answer->has_value());
  if (!*answer) {
    response.error_id = blocks::own_error::kNoModel;
    response.message = kNoModelText;
    return true;
  }
  toDegrees((*answer)->rule.lower, response.lower);
  toDegrees((*answer)->rule.upper, response.upper);
  toDegrees((*answer)->model.lower, response.lowest);
  toDegrees((*answer)->model.upper, response.highest);
  return true;
}

bool DynamicsServices::writeLimits(cobot_command::WriteSoftwareLimits::Request& request,
                                   cobot_command::WriteSoftwareLimits::Response& response) {
  const command::SoftwareLimits limits{toRadians(request.lower), toRadians(request.upper)};
  const auto answer = answerOf(core_.write_limits(limits), response.message);
  if (answer) fill(response, *answer);
  return true;
}

}  // namespace cobot_command::ros_adapter
