#include "status_desk.h"

#include <string_view>
#include <utility>

#include "cobot_command/common/foreign_text.h"
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

std::string StatusDesk::diagnosis() const {
  std::string text = parts_.keeper.endedByCancel() ? parts_.keeper.diagnosis()
                                                   : robot::diagnose(parts_.links.script(), parts_.robot);
  const auto add = [&text](std::string_view more) {
    if (!more.empty()) text.append("; ").append(more);
  };
  const robot::OrphanWatch& orphan = parts_.arbiter.stops().orphan();
  if (orphan.mayMove()) add(orphan.text());
  if (parts_.keeper.run().ready()) add(robot::whatIsUnseen(parts_.robot));
  add(parts_.strangers.text());
  add(parts_.forecast.loose().text());
  add(parts_.keeper.textOfTheRobotLeft());
  return text;
}

/// Over what was there: it is looked at behind each event and is nearly always the same, so its texts and
/// lists keep their places.
void StatusDesk::describe(CommandStatus& status) const {
  const link::ScriptLink& script = parts_.links.script();
  const ConnectRun& connect = parts_.keeper.run();
  const bool next_is_planned = parts_.arbiter.queue().plansTheNext();
  status.link = toLinkState(script.state());
  if (status.link == CommandStatus::LinkState::Ready && !connect.ready()) {
    status.link = CommandStatus::LinkState::Probing;
  }
  status.diagnosis = forPeople(diagnosis());
  status.host = connect.target().host;
  status.port = connect.target().port;
  status.listen_node = script.listenNode();
  status.status_stream = parts_.links.status().streaming();
  status.status_diagnosis = forPeople(parts_.links.status().diagnosis());
  status.last_connected = connect.lastConnected();
  status.last_lost = connect.lastLost();
  status.commands_under_way = parts_.arbiter.turns().isAnythingThere() || next_is_planned ? 1 : 0;
  const SetAside& aside = parts_.arbiter.aside();
  status.commands_waiting = static_cast<int>(parts_.arbiter.queue().size()) - (next_is_planned ? 1 : 0) +
                            static_cast<int>(aside.underWay() + aside.waiting());
  status.queue_depth = status.commands_under_way + status.commands_waiting;
  status.waiting_return = parts_.arbiter.turns().occupancy().busyWith().has_value() || aside.block();
  status.open_tags = parts_.tags.openTags();
  status.late_replies = script.requests().late() + parts_.tags.staleReports() + parts_.links.lateEvents();
  status.decode_faults = script.decodeFaults() + parts_.links.status().decodeFaults();
  status.blocks = parts_.board.outputs();
}

void StatusDesk::tell() {
  tellFrames();
  tellStatus();
}

void StatusDesk::tellStatus() {
  describe(status_);
  if (status_ == told_) return;
  told_ = status_;
  actions_.emplace_back(StatusChanged{told_});
}

void StatusDesk::tellFrames() {
  robot::ActiveFrames frames = parts_.forecast.frames();
  if (frames == told_frames_) return;
  told_frames_ = frames;
  actions_.emplace_back(ActiveFramesChanged{std::move(frames)});
}

}  // namespace cobot_command::command
