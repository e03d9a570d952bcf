// Peers that are not what they should be, on both ports: a table of bytes and how goals may end that meet
// them.
//
// Owns no socket and no clock, so the table is tried in invented time as well as over real connections.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cobot_command/link/connection.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::testing {

struct PeerTalk {
  std::string bytes;
  bool closes = false;  ///< the connection, behind the bytes
};

/// How often a peer may say something by itself.
inline constexpr Duration kPeerTick = std::chrono::milliseconds(10);

struct MisbehavingPeer {
  std::string name;
  link::Channel port = link::Channel::Script;
  std::function<PeerTalk()> greets;                                 ///< when it is connected
  std::function<PeerTalk(const protocol::ClientMessage&)> answers;  ///< whatever it is sent
  std::function<PeerTalk(int tick)> talks;                          ///< from tick 1 on, by itself
  int connect_error = 0;                                            ///< of a connect goal; 0: it connects
  std::set<int> goal_errors;                                        ///< of a motion then; empty: it is Done
  std::string words;  ///< in the end that is an error; for a status port, in its diagnosis
};

/// What a controller answers whose motions take no time.
[[nodiscard]] PeerTalk goodAnswer(const protocol::ClientMessage& message);
[[nodiscard]] PeerTalk goodGreeting();
/// A frame of a stream of a robot that stands at these joints [deg], with other or further items.
[[nodiscard]] std::string streamFrame(const std::vector<float>& joints_deg = {0, 0, 90, 0, 90, 0});

/// Peers of either port that behave.
[[nodiscard]] MisbehavingPeer goodController();
[[nodiscard]] MisbehavingPeer goodStream();

/// On the script port: never a controller that could be commanded.
[[nodiscard]] std::vector<MisbehavingPeer> peersThatCannotBeCommanded();
/// On the script port: a controller until it gets a script, or with strange habits.
[[nodiscard]] std::vector<MisbehavingPeer> peersThatAnswerStrangely();
/// On the status port.
[[nodiscard]] std::vector<MisbehavingPeer> peersOfTheStatusPort();

}  // namespace cobot_command::testing
