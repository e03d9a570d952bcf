// The faults of the world that a simulated controller can show, each off until it is turned on: standing, or
// for the next few times. A plain value; it says what is wrong, the controller does it.
//
// doc/simulator.md lists them; so does knownFaults().
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/simulator/operator_reply.h"

namespace cobot_command::simulator {

struct FaultSwitch {
  bool on = false;
  int left = 0;        ///< how often it still happens; 0: until it is turned off
  double seconds = 0;  ///< of a delay
  std::string text;    ///< what else it needs, see knownFaults()

  /// Does it happen this time? Counts.
  [[nodiscard]] bool take();
};

/// What is sent: the entry of the Listen node; OK or ERROR of a script; the spontaneous report of a tag; the
/// answer to TMSTA 00; the one to TMSTA 01; CPERR; a frame of the status stream; the answer to a request on
/// the status port.
enum class MessageKind { Entry, Reply, Tag, State, TagAnswer, Cperr, Stream, ItemAnswer };
inline constexpr std::size_t kMessageKinds = 8;

/// What can become of a message on its way; each message counts once, however many clients get it.
struct MessageFaults {
  FaultSwitch drop;
  FaultSwitch delay;      ///< others overtake it
  FaultSwitch duplicate;  ///< sent twice in a row
  FaultSwitch corrupt;    ///< a wrong checksum
};

struct FaultSwitches {
  FaultSwitch refuse_script, ignore_script, cperr_script, wrong_id;
  FaultSwitch refuse_stop, ignore_stop;
  FaultSwitch refuse_listen_send;
  FaultSwitch false_tag, early_tag, stale_tag, query_none, query_false;
  FaultSwitch silence, close_on_connect, refuse_connections, impostor;
  FaultSwitch hide_items;
  FaultSwitch pvt_linear;
  std::array<MessageFaults, kMessageKinds> messages;

  [[nodiscard]] MessageFaults& of(MessageKind kind) { return messages.at(static_cast<std::size_t>(kind)); }
};

/// What to do to a switch. The name is one of knownFaults().
struct SetFault {
  std::string name;
  bool active = true;
  int count = 0;       ///< how often it happens; 0: until it is turned off
  double seconds = 0;  ///< of a delay: 0.001 to 60
  std::string text;    ///< empty: as knownFaults() says
};

/// Not done, and the switch stands as before: an unknown name, a text or a number that is not for it.
[[nodiscard]] OperatorReply set(FaultSwitches& faults, const SetFault& order);

struct KnownFault {
  std::string name;
  std::string needs;  ///< "seconds", or what the text is; empty: nothing
  std::string meaning;
};
[[nodiscard]] const std::vector<KnownFault>& knownFaults();

}  // namespace cobot_command::simulator
