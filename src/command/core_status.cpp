// What everyone may know: the latched status, the active frames, planned paths, the flight recorder.

#include <utility>

#include "core_impl.h"
#include <fmt/format.h>

#include "cobot_command/robot/diagnosis.h"

namespace cobot_command::command {
namespace {

CommandStatus::LinkState toLinkState(link::ScriptLinkState state) {
  switch (state) {
    case link::ScriptLinkState::Disconnected:
      break;
    case link::ScriptLinkState::BackingOff:
    case link::ScriptLinkState::Connecting:
      return CommandStatus::LinkState::Connecting;
    case link::ScriptLinkState::Probing:
      return CommandStatus::LinkState::Probing;
    case link::ScriptLinkState::NotListening:
    case link::ScriptLinkState::Leaving:
      return CommandStatus::LinkState::NotListening;
    case link::ScriptLinkState::Ready:
      return CommandStatus::LinkState::Ready;
  }
  return CommandStatus::LinkState::Disconnected;
}

}  // namespace

std::string CommandCore::Impl::linkDiagnosis() const {
  std::string text = script_.diagnosis();
  if (automaticLinkEnded()) {
    text += text.empty() ? "" : "; ";
    text +=
        "the connect goal that was cancelled has ended the automatic link (auto_connect): send a connect "
        "goal, or start the node again";
  }
  return text;
}

std::string CommandCore::Impl::textOfTheRobotLeft() const {
  return fmt::format("the link to {}:{} was lost with a motion under way: {}", left_moving_->host,
                     left_moving_->port, robot::LooseMotion::kMayStillMove);
}

void CommandCore::Impl::publishStatus() {
  CommandStatus status;
  status.link = toLinkState(script_.state());
  if (status.link == CommandStatus::LinkState::Ready && !connect_.ready()) {
    status.link = CommandStatus::LinkState::Probing;
  }
  status.diagnosis = robot::diagnose(script_, robot_);
  if (automaticLinkEnded()) status.diagnosis = linkDiagnosis();
  if (orphan_.mayMove()) status.diagnosis += fmt::format("; {}", orphan_.text());
  if (const std::string text = strangers_.text(); !text.empty()) status.diagnosis += "; " + text;
  if (!forecast_.loose().text().empty()) status.diagnosis += "; " + forecast_.loose().text();
  if (left_moving_) status.diagnosis += "; " + textOfTheRobotLeft();
  status.host = connect_.target().host;
  status.port = connect_.target().port;
  status.listen_node = script_.listenNode();
  status.status_stream = status_.streaming();
  status.status_diagnosis = status_.diagnosis();
  status.last_connected = connect_.lastConnected();
  status.last_lost = connect_.lastLost();
  status.commands_under_way = run_ || plansTheNext() ? 1 : 0;
  status.commands_waiting = static_cast<int>(waiting_.size()) - (plansTheNext() ? 1 : 0);
  status.queue_depth = status.commands_under_way + status.commands_waiting;
  status.waiting_return = busyBlock().has_value();
  status.open_tags = tags_.openTags();
  status.late_replies = script_.lateReplies() + tags_.staleReports() + links_.lateEvents();
  status.decode_faults = script_.decodeFaults() + status_.decodeFaults();
  status.blocks = board_.outputs();
  if (status == published_) return;
  published_ = status;
  actions_.emplace_back(StatusChanged{std::move(status)});
}

void CommandCore::Impl::publishFrames() {
  robot::ActiveFrames frames = forecast_.frames();
  if (frames == published_frames_) return;
  published_frames_ = frames;
  actions_.emplace_back(ActiveFramesChanged{std::move(frames)});
}

void CommandCore::Impl::log(Severity severity, std::string text) {
  actions_.emplace_back(LogMessage{severity, std::move(text)});
}

}  // namespace cobot_command::command
