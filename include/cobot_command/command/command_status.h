// The latched status of one robot's command layer, for all clients.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

/// The PLCopen outputs of one block. At most one of busy, done, error, command_aborted is true.
struct BlockOutputs {
  blocks::Block block{};
  bool busy = false;
  bool active = false;
  bool done = false;
  bool error = false;
  bool command_aborted = false;
  int error_id = 0;
  std::string error_description;  ///< stays until the block is executed again
  int command_id_ack = 0;

  friend bool operator==(const BlockOutputs& a, const BlockOutputs& b);
};

struct CommandStatus {
  enum class LinkState { Disconnected, Connecting, Probing, NotListening, Ready };
  LinkState link = LinkState::Disconnected;
  std::string diagnosis;  ///< in plain words: "connection refused: no project is running on the controller"
  std::string host;
  int port = 0;
  std::string listen_node;     ///< entry message of the Listen node, while the flow is in it
  bool status_stream = false;  ///< the status link delivers data
  /// Why there is no status stream, or why it is incomplete, and what follows from that.
  std::string status_diagnosis;
  std::optional<Instant> last_connected;  ///< LastConnTime
  std::optional<Instant> last_lost;       ///< LastLostTime
  int queue_depth = 0;                    ///< running and queued commands: the sum of the next two
  int commands_under_way = 0;             ///< commands whose turn has come; a cycle, or a wait, counts as one
  int commands_waiting = 0;               ///< queued in this layer, not sent
  /// WaitingReturn (thesis 5.3.1.2): the robot is occupied, and a command with BufferMode::Refuse is refused.
  /// Also true while a goal is suspended; Refuse is accepted then.
  bool waiting_return = false;
  std::vector<int> open_tags;
  std::uint64_t late_replies = 0;  ///< replies that nothing waited for: counted, never applied
  std::uint64_t decode_faults = 0;
  std::vector<BlockOutputs> blocks;

  friend bool operator==(const CommandStatus& a, const CommandStatus& b);
};
[[nodiscard]] const char* toString(CommandStatus::LinkState state);
/// Why no script can be sent now; empty: it can be sent.
[[nodiscard]] std::string whyNotReady(const CommandStatus& status);

}  // namespace cobot_command::command
