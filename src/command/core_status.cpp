// What everyone may know: the latched status and the active frames.

#include <string_view>
#include <utility>

#include "core_impl.h"

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

std::string CommandCore::Impl::diagnosis() const {
  std::string text = keeper_.endedByCancel() ? keeper_.diagnosis() : robot::diagnose(links_.script(), robot_);
  const auto add = [&text](std::string_view more) {
    if (!more.empty()) text.append("; ").append(more);
  };
  const robot::OrphanWatch& orphan = arbiter_.stops().orphan();
  if (orphan.mayMove()) add(orphan.text());
  add(strangers_.text());
  add(forecast_.loose().text());
  add(keeper_.textOfTheRobotLeft());
  return text;
}

/// Over what was there: it is looked at behind each event and is nearly always the same, so its texts and
/// lists keep their places.
void CommandCore::Impl::describe(CommandStatus& status) const {
  const link::ScriptLink& script = links_.script();
  const ConnectRun& connect = keeper_.run();
  const bool next_is_planned = arbiter_.queue().plansTheNext();
  status.link = toLinkState(script.state());
  if (status.link == CommandStatus::LinkState::Ready && !connect.ready()) {
    status.link = CommandStatus::LinkState::Probing;
  }
  status.diagnosis = diagnosis();
  status.host = connect.target().host;
  status.port = connect.target().port;
  status.listen_node = script.listenNode();
  status.status_stream = links_.status().streaming();
  status.status_diagnosis = links_.status().diagnosis();
  status.last_connected = connect.lastConnected();
  status.last_lost = connect.lastLost();
  status.commands_under_way = arbiter_.turns().run() != nullptr || next_is_planned ? 1 : 0;
  status.commands_waiting = static_cast<int>(arbiter_.queue().size()) - (next_is_planned ? 1 : 0);
  status.queue_depth = status.commands_under_way + status.commands_waiting;
  status.waiting_return = arbiter_.turns().occupancy().busyWith().has_value();
  status.open_tags = tags_.openTags();
  status.late_replies = script.lateReplies() + tags_.staleReports() + links_.lateEvents();
  status.decode_faults = script.decodeFaults() + links_.status().decodeFaults();
  status.blocks = board_.outputs();
}

void CommandCore::Impl::publishStatus() {
  describe(status_);
  if (status_ == published_) return;
  published_ = status_;
  actions_.emplace_back(StatusChanged{published_});
}

void CommandCore::Impl::publishFrames() {
  robot::ActiveFrames frames = forecast_.frames();
  if (frames == published_frames_) return;
  published_frames_ = frames;
  actions_.emplace_back(ActiveFramesChanged{std::move(frames)});
}

void CommandCore::Impl::warn(std::string text) {
  actions_.emplace_back(LogMessage{Severity::Warning, std::move(text)});
}

}  // namespace cobot_command::command
