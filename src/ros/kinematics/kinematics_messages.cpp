#include "kinematics/kinematics_messages.h"

#include <algorithm>
#include <iterator>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

arm::ControllerJoints toJoints(const boost::array<double, arm::kJointCount>& message) {
  arm::ControllerJoints joints{};
  std::copy(message.begin(), message.end(), joints.begin());
  return joints;
}

cobot_command::ArmPosture toMessage(const kinematics::Posture& posture) {
  cobot_command::ArmPosture message;
  std::copy(posture.joints.begin(), posture.joints.end(), message.joints.begin());
  const auto bits = posture.bits.numbers();
  message.bits.config1 = bits[0];
  message.bits.config2 = bits[1];
  message.bits.config3 = bits[2];
  std::copy(posture.turns.begin(), posture.turns.end(), message.turns.begin());
  message.within_limits = 1;
  return message;
}

cobot_command::ArmPosture toMessage(const kinematics::Branch& branch) {
  cobot_command::ArmPosture message = toMessage(branch.posture);
  message.within_limits = static_cast<std::uint8_t>(!branch.outside);
  if (branch.outside) message.outside = *branch.outside + 1;
  return message;
}

template <class Response>
void fill(Response& response, const kinematics::Refusal& refusal) {
  response.error_id = refusal.error_id;
  response.message = forPeople(refusal.message);
}

}  // namespace

kinematics::ForwardQuestion toQuestion(const cobot_command::ForwardKinematics::Request& request) {
  return {toJoints(request.joints), {request.tool, request.frame}};
}

kinematics::InverseQuestion toQuestion(const cobot_command::InverseKinematics::Request& request) {
  kinematics::InverseQuestion question;
  question.pose = toSix(request.pose);
  question.numbers = {request.tool, request.frame};
  question.configuration = request.configuration;
  question.bits = {request.bits.config1, request.bits.config2, request.bits.config3};
  question.joints = toJoints(request.joints);
  return question;
}

kinematics::FrameQuestion toQuestion(const cobot_command::CalculateFrame::Request& request) {
  return {toSix(request.origin), toSix(request.on_x_axis), toSix(request.in_xy_plane), request.frame,
          request.reference};
}

kinematics::ToolQuestion toQuestion(const cobot_command::CalculateTool::Request& request) {
  kinematics::ToolQuestion question;
  std::transform(request.flanges.begin(), request.flanges.end(), std::back_inserter(question.flanges),
                 [](const cobot_command::Transformation& flange) { return toSix(flange); });
  question.most_error = request.most_error;
  return question;
}

cobot_command::ForwardKinematics::Response toResponse(
    const Result<kinematics::ForwardAnswer, kinematics::Refusal>& answer) {
  cobot_command::ForwardKinematics::Response response;
  if (!answer) {
    fill(response, answer.error());
    return response;
  }
  response.success = 1;
  response.pose = toTransformation(answer->pose);
  response.posture = toMessage(answer->posture);
  return response;
}

cobot_command::InverseKinematics::Response toResponse(const kinematics::InverseAnswer& answer) {
  cobot_command::InverseKinematics::Response response;
  std::transform(answer.branches.begin(), answer.branches.end(), std::back_inserter(response.branches),
                 [](const kinematics::Branch& branch) { return toMessage(branch); });
  if (!answer.chosen) {
    fill(response, answer.chosen.error());
    return response;
  }
  response.success = 1;
  response.posture = toMessage(*answer.chosen);
  return response;
}

cobot_command::CalculateFrame::Response toResponse(
    const Result<arm::ControllerPose, kinematics::Refusal>& answer) {
  cobot_command::CalculateFrame::Response response;
  if (!answer) {
    fill(response, answer.error());
    return response;
  }
  response.success = 1;
  response.pose = toTransformation(*answer);
  return response;
}

cobot_command::CalculateTool::Response toResponse(
    const Result<kinematics::ToolAnswer, kinematics::Refusal>& answer) {
  cobot_command::CalculateTool::Response response;
  if (!answer) {
    fill(response, answer.error());
    return response;
  }
  response.success = 1;
  response.tcp = toTransformation(answer->tcp);
  response.point = toTransformation(answer->point);
  response.mean_error = answer->mean_error;
  response.worst_error = answer->worst_error;
  return response;
}

}  // namespace cobot_command::ros_adapter
