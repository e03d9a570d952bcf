// The link to the script port (5890) of one controller: it connects, asks whether the flow is in a Listen
// node, keeps asking (the lifesign), and matches every answer to its request.
//
// Owns no socket and no clock; see command_core.h. Once started it tries for ever, with a back-off; how long
// is for the Connect block to say. Lifesigns are TMSTA queries: they never enter the motion queue.
// Not thread-safe.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "cobot_command/link/back_off.h"
#include "cobot_command/link/script_link_states.h"
#include "cobot_command/link/script_requests.h"
#include "cobot_command/link/wire.h"
#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::link {

/// Why the link is not established, or not in the Listen node.
enum class Trouble {
  None,
  NotTriedYet,
  Refused,      ///< nobody listens on the port
  Unreachable,  ///< no route, host down
  UnknownHost,
  OpenTimedOut,
  OpenFailed,    ///< for another reason
  Silent,        ///< connected, and nothing answers
  NotTmRobot,    ///< connected, and something else answers
  OtherAnswers,  ///< connected, and what comes is a controller's, but not what was asked for
  StatusPort,    ///< connected to the status stream of a TM robot
  Closed,        ///< connected and closed again
  NotListening   ///< a TM robot, its flow is in another node
};

// --- What comes out of next().

/// The state or the diagnosis is another one than before.
struct LinkChanged {};
/// An established connection is gone: whatever was open will not be answered.
struct LinkLost {
  std::string reason;
};
/// What answers tell: script_requests.h. ListenData: what a script sent with ListenSend(), whoever's it was;
/// it comes behind the answers to all scripts that the controller ran before, and in front of its own.
using ScriptLinkOutput =
    std::variant<LinkChanged, LinkLost, ScriptAnswered, TagReported, TagQueryFailed, protocol::ListenData>;

class ScriptLink {
 public:
  ScriptLink(const LinkSettings& settings, Wire& wire);

  void start(const std::string& host, int port, Instant now);
  /// The settings that it refers to are others: the next lifesign comes as the new period says.
  void settingsChanged(Instant now);
  void stop(Instant now);
  /// An established link is lost, as somebody else has found; it is tried again.
  void giveUp(std::string reason, Instant now);

  // --- Events of the connection for which owns() is true.
  [[nodiscard]] bool owns(ConnectionId id) const { return connection_ == id; }
  void opened(Instant now);
  void openFailed(const OpenFailure& failure, Instant now);
  void received(std::string_view bytes);
  void closed(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// The next thing that happened; nothing when there is none. Frames are decoded one by one as they are
  /// asked for, so a reaction to one is in force before the next is looked at.
  [[nodiscard]] std::optional<ScriptLinkOutput> next(Instant now);

  // --- Requests. Precondition: connected().
  /// Returns the script id; a ScriptAnswered with it follows, unless the connection goes down first. For
  /// lines that wait `reply_timeout` may be another than that of the settings.
  std::string sendScript(const std::string& script, Instant now,
                         std::optional<Duration> reply_timeout = std::nullopt);
  void queryTag(int tag, Instant now);
  /// A script with ScriptExit() was accepted: the node is being left.
  void exitAccepted(Instant now);

  [[nodiscard]] ScriptLinkState state() const { return state_; }
  /// TCP is up: a script can be sent, though it may be that nobody takes it.
  [[nodiscard]] bool connected() const { return isConnected(state_); }
  [[nodiscard]] bool established() const { return isEstablished(state_); }
  [[nodiscard]] Trouble trouble() const { return trouble_; }
  [[nodiscard]] const std::string& diagnosis() const { return diagnosis_; }
  [[nodiscard]] const std::string& listenNode() const { return listen_node_; }
  /// When the last frame of the controller came on this connection; nothing: none has.
  [[nodiscard]] std::optional<Instant> heardAt() const { return heard_at_; }
  /// What has no answer yet, and answers that nobody waited for.
  [[nodiscard]] const ScriptRequests& requests() const { return requests_; }
  [[nodiscard]] std::uint64_t decodeFaults() const { return decode_faults_; }

 private:
  void fire(ScriptLinkEvent event, Instant now);
  void act(ScriptLinkAction action, Instant now);
  void diagnose(Trouble trouble, std::string diagnosis);
  void askForNode(Instant now);
  void lifesignDue(Instant now);
  void drop();

  void transmit(const protocol::ClientMessage& message, Request request, Instant now);
  void read(const protocol::DecodeEvent& event, Instant now);
  void take(const protocol::ControllerMessage& message, Instant now);
  void take(const protocol::ListenNodeState& message, Instant now);
  void fault(std::string_view bytes, const std::string& meaning, Instant now);

  const LinkSettings& settings_;
  Wire& wire_;
  ScriptLinkState state_ = ScriptLinkState::Disconnected;
  std::string host_;
  int port_ = 0;
  std::optional<ConnectionId> connection_;
  std::optional<Instant> retry_at_;
  std::optional<Instant> lifesign_at_;
  int unanswered_lifesigns_ = 0;
  int listening_since_exit_ = 0;  ///< answers "in the Listen node", one after the other
  std::string heard_;             ///< what was understood last, in place of the answer that makes it Ready
  std::optional<Instant> heard_at_;
  bool foreign_bytes_ = false;  ///< what arrived last on this connection was not understood
  BackOff back_off_;
  protocol::FrameDecoder decoder_;
  ScriptRequests requests_;
  std::deque<ScriptLinkOutput> outputs_;
  Trouble trouble_ = Trouble::None;
  std::string diagnosis_ = "not connected";
  std::string listen_node_;
  std::uint64_t decode_faults_ = 0;
};

}  // namespace cobot_command::link
