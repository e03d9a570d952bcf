#include "cobot_command/command/command_status.h"

#include <tuple>

namespace cobot_command::command {
namespace {

auto tie(const BlockOutputs& o) {
  return std::tie(o.block, o.busy, o.active, o.done, o.error, o.command_aborted, o.error_id,
                  o.error_description, o.command_id_ack);
}

auto tie(const CommandStatus& s) {
  return std::tie(s.link, s.diagnosis, s.host, s.port, s.listen_node, s.status_stream, s.status_diagnosis,
                  s.last_connected, s.last_lost, s.queue_depth, s.commands_under_way, s.commands_waiting,
                  s.waiting_return, s.open_tags, s.late_replies, s.decode_faults, s.blocks);
}

}  // namespace

bool operator==(const BlockOutputs& a, const BlockOutputs& b) {
  return tie(a) == tie(b);
}

bool operator==(const CommandStatus& a, const CommandStatus& b) {
  return tie(a) == tie(b);
}

const char* toString(CommandStatus::LinkState state) {
  switch (state) {
    case CommandStatus::LinkState::Disconnected:
      return "disconnected";
    case CommandStatus::LinkState::Connecting:
      return "connecting";
    case CommandStatus::LinkState::Probing:
      return "probing";
    case CommandStatus::LinkState::NotListening:
      return "not listening";
    case CommandStatus::LinkState::Ready:
      return "ready";
  }
  return "unknown";
}

std::string whyNotReady(const CommandStatus& status) {
  if (status.link == CommandStatus::LinkState::Ready) return "";
  if (status.link == CommandStatus::LinkState::Disconnected && status.diagnosis.empty()) {
    return "not connected";
  }
  return status.diagnosis.empty() ? toString(status.link) : status.diagnosis;
}

}  // namespace cobot_command::command
