// The link to the status stream (port 5891). It is opened, and opened again without end, while it is wanted.
//
// It owns no socket and no clock; see command_core.h. Not thread-safe.
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

  /// The next status in the received data; nullopt: more bytes are needed.
  [[nodiscard]] std::optional<RobotStatus> next(Instant now);

  [[nodiscard]] StatusLinkState state() const { return state_; }
  [[nodiscard]] bool streaming() const { return state_ == StatusLinkState::Streaming; }
  /// Why there is no data, or only a part of it, in plain words; empty: no problem.
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
  /// Data received since the connection was opened, or since the last status frame: it shows what the peer
  /// is.
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
  std::optional<std::string> content_;  ///< of the last readable frame, with its meaning:
  RobotStatus decoded_;
  IdentityQuestions questions_;  ///< of this connection
  std::string lacking_;          ///< missing items of that frame, as a diagnosis; empty: none
  std::string diagnosis_;
  std::uint64_t decode_faults_ = 0;
};

}  // namespace cobot_command::link
