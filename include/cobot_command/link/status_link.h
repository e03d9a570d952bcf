// The link to the status stream (port 5891): opened and reopened for ever while it is wanted.
//
// Owns no socket and no clock; see command_core.h. Not thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/link/back_off.h"
#include "cobot_command/link/identity_questions.h"
#include "cobot_command/link/robot_status.h"
#include "cobot_command/link/status_link_states.h"
#include "cobot_command/link/wire.h"
#include "cobot_command/protocol/frame_decoder.h"

namespace cobot_command::link {

class StatusLink {
 public:
  StatusLink(const LinkSettings& settings, Wire& wire);

  void start(const std::string& host, int port, Instant now);
  void stop(Instant now);

  // --- Events of the connection for which owns() is true.
  [[nodiscard]] bool owns(ConnectionId id) const { return connection_ == id; }
  void opened(Instant now);
  void openFailed(const OpenFailure& failure, Instant now);
  void received(std::string_view bytes);
  void closed(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return deadline_; }

  /// The next status in what was received; nothing when more bytes are needed.
  [[nodiscard]] std::optional<RobotStatus> next(Instant now);

  [[nodiscard]] StatusLinkState state() const { return state_; }
  [[nodiscard]] bool streaming() const { return state_ == StatusLinkState::Streaming; }
  /// Why nothing is delivered, or not all of it, in plain words; empty while all is well.
  [[nodiscard]] const std::string& diagnosis() const { return diagnosis_; }
  [[nodiscard]] std::uint64_t decodeFaults() const { return decode_faults_; }

 private:
  void fire(StatusLinkEvent event, Instant now);
  void act(StatusLinkAction action, Instant now);
  void drop();
  [[nodiscard]] std::optional<RobotStatus> read(const protocol::Frame& frame, Instant now);
  [[nodiscard]] std::optional<std::string> decode(std::string content);
  void ask(Instant now);
  void fault(std::string_view bytes, std::string meaning, Instant now);
  /// What came since the connection was opened, or since the last status frame: it tells what the peer is.
  enum class Heard { Nothing, Garbage, ScriptPort, OtherFrames };
  [[nodiscard]] std::string silence() const;

  const LinkSettings& settings_;
  Wire& wire_;
  StatusLinkState state_ = StatusLinkState::Off;
  std::string host_;
  int port_ = 0;
  std::optional<ConnectionId> connection_;
  std::optional<Instant> deadline_;  ///< of the back-off or of the watchdog
  BackOff back_off_;
  protocol::FrameDecoder decoder_;
  Heard heard_ = Heard::Nothing;
  std::optional<std::string> content_;  ///< of the last frame that could be read, and what it says:
  RobotStatus decoded_;
  IdentityQuestions questions_;  ///< of this connection
  std::string lacking_;          ///< of that frame, as a diagnosis; empty: all is there
  std::string diagnosis_;
  std::uint64_t decode_faults_ = 0;
};

}  // namespace cobot_command::link
