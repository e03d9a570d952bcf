#include "cobot_command/link/identity_questions.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "status_decoding.h"

namespace cobot_command::link {
namespace {

using Field = std::optional<std::string> ControllerIdentity::*;
struct Question {
  const char* id;  ///< of the request, and of its answer; those of the stream are numbers
  const char* item;
  Field field;
};
constexpr Question kQuestions[] = {{"RobotModel", "Robot_Model", &ControllerIdentity::robot_model},
                                   {"ControlBoxSN", "ControlBox_SN", &ControllerIdentity::control_box_sn},
                                   {"TMflowVersion", "TMflow_Version", &ControllerIdentity::tmflow_version}};

}  // namespace

std::vector<protocol::StatusFrame> IdentityQuestions::missingIn(const ControllerIdentity& told) {
  std::vector<protocol::StatusFrame> requests;
  for (const Question& question : kQuestions) {
    if (told.*question.field) continue;
    requests.push_back({question.id, static_cast<int>(protocol::StatusMode::ReadBinary),
                        protocol::encodeBinaryNames({question.item})});
  }
  return requests;
}

bool IdentityQuestions::take(const protocol::StatusFrame& frame) {
  const auto* const question = std::find_if(std::begin(kQuestions), std::end(kQuestions),
                                            [&frame](const Question& one) { return one.id == frame.id; });
  if (question == std::end(kQuestions)) return false;
  if (frame.mode == static_cast<int>(protocol::StatusMode::Reply)) return true;
  if (frame.mode != static_cast<int>(protocol::StatusMode::ReadBinary)) return false;
  if (const auto items = protocol::parseBinaryItems(frame.content)) {
    auto told = toRobotStatus(*items, Instant{}).identity.*question->field;
    if (told) answered_.*question->field = std::move(told);
  }
  return true;
}

void IdentityQuestions::complete(ControllerIdentity& told) const {
  for (const Question& question : kQuestions) {
    if (!(told.*question.field)) told.*question.field = answered_.*question.field;
  }
}

}  // namespace cobot_command::link
