// The link to the script port (5890) of one controller. It connects, asks whether the flow is in a Listen
// node, continues to ask (the heartbeat), and matches every answer to its request.
//
// It owns no socket and no clock; see command_core.h. Once started it tries without end, with a back-off; the
// Connect block limits the time. Heartbeats are TMSTA queries: they never enter the motion queue. Not
// thread-safe.
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
  Refused,      ///< no server on the port
  Unreachable,  ///< no route, host down
  UnknownHost,
  OpenTimedOut,
  OpenFailed,    ///< for another reason
  Silent,        ///< connected, but nothing answers
  NotTmRobot,    ///< connected, but something else answers
  OtherAnswers,  ///< connected; a controller answers, but not to the request
  StatusPort,    ///< connected to the status stream of a TM robot
  Closed,        ///< connected and closed again
  NotListening   ///< a TM robot, its flow is in another node
};

// --- Outputs of next().

/// The state or the diagnosis has changed.
struct LinkChanged {};
/// An established connection is lost: open requests will not be answered.
struct LinkLost {
  std::string reason;
};
/// For the answers see script_requests.h. ListenData: data that a script sent with ListenSend(), from any
/// client. It arrives after the answers to all scripts that the controller ran before that script, and before
/// the answer to that script.
using ScriptLinkOutput =
    std::variant<LinkChanged, LinkLost, ScriptAnswered, TagReported, TagQueryFailed, protocol::ListenData>;

class ScriptLink {
 public:
  ScriptLink(const LinkSettings& settings, Wire& wire);

  void start(const std::string& host, int port, Instant now);
  /// The settings that the link refers to have changed: the next heartbeat follows the new period.
  void settingsChanged(Instant now);
  void stop(Instant now);
  /// Another part of the layer has found that an established link is lost; the link tries again.
  void giveUp(std::string reason, Instant now);

  // --- Events of the connection for which owns() is true.
  [[nodiscard]] bool owns(ConnectionId id) const { return connection_ == id; }
  void opened(Instant now);
  void openFailed(const OpenFailure& failure, Instant now);
  void received(std::string_view bytes);
  void closed(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// The next output; nullopt: there is none. Frames are decoded one by one as they are requested, so that
  /// the reaction to one applies before the next is read.
  [[nodiscard]] std::optional<ScriptLinkOutput> next(Instant now);

  // --- Requests. Precondition: connected().
  /// Returns the script id. A ScriptAnswered with this id follows, unless the connection is closed first.
  /// `reply_timeout`: replaces that of the settings, for lines that wait.
  std::string sendScript(const std::string& script, Instant now,
                         std::optional<Duration> reply_timeout = std::nullopt);
  void queryTag(int tag, Instant now);
  /// A script with ScriptExit() was accepted: the flow is leaving the node.
  void exitAccepted(Instant now);

  [[nodiscard]] ScriptLinkState state() const { return state_; }
  /// TCP is up: a script can be sent, although it may not be accepted.
  [[nodiscard]] bool connected() const { return isConnected(state_); }
  [[nodiscard]] bool established() const { return isEstablished(state_); }
  [[nodiscard]] Trouble trouble() const { return trouble_; }
  [[nodiscard]] const std::string& diagnosis() const { return diagnosis_; }
  [[nodiscard]] const std::string& listenNode() const { return listen_node_; }
  /// Time of the controller's last frame on this connection; nullopt: none.
  [[nodiscard]] std::optional<Instant> heardAt() const { return heard_at_; }
  /// Unanswered requests, and answers that nothing waited for.
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
  int listening_since_exit_ = 0;  ///< consecutive answers "in the Listen node"
  /// What was understood last, if it was not the answer that makes the state Ready.
  std::string heard_;
  std::optional<Instant> heard_at_;
  bool foreign_bytes_ = false;  ///< the last bytes on this connection were not understood
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
