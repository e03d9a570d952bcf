// The faults that a simulated controller can show. Each is off until it is switched on, permanently or for a
// number of times. A plain value: it selects the faults, and the controller produces them.
//
// doc/simulator.md and knownFaults() list them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/simulator/operator_reply.h"

namespace cobot_command::simulator {

struct FaultSwitch {
  bool on = false;
  int left = 0;        ///< remaining occurrences; 0: until it is switched off
  double seconds = 0;  ///< of a delay
  std::string text;    ///< other required value, see knownFaults()

  /// True if the fault occurs this time. Counts the occurrence.
  [[nodiscard]] bool take();
};

/// Kinds of sent messages: the entry of the Listen node; OK or ERROR of a script; the spontaneous report of a
/// tag; the answer to TMSTA 00; the answer to TMSTA 01; CPERR; a frame of the status stream; the answer to a
/// request on the status port.
enum class MessageKind { Entry, Reply, Tag, State, TagAnswer, Cperr, Stream, ItemAnswer };
inline constexpr std::size_t kMessageKinds = 8;

/// Faults of sent messages. A message counts once, regardless of the number of clients that receive it.
struct MessageFaults {
  FaultSwitch drop;
  FaultSwitch delay;      ///< later messages overtake it
  FaultSwitch duplicate;  ///< sent twice in a row
  FaultSwitch corrupt;    ///< with a wrong checksum
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

/// A change of a switch. The name is one of knownFaults().
struct SetFault {
  std::string name;
  bool active = true;
  int count = 0;       ///< number of occurrences; 0: until it is switched off
  double seconds = 0;  ///< of a delay: 0.001 to 60
  std::string text;    ///< empty: the default of knownFaults()
};

/// Changes a switch. Not done, and the switch is unchanged: an unknown name, or an invalid text or number.
[[nodiscard]] OperatorReply set(FaultSwitches& faults, const SetFault& order);

struct KnownFault {
  std::string name;
  std::string needs;  ///< "seconds", or the meaning of the text; empty: nothing
  std::string meaning;
};
[[nodiscard]] const std::vector<KnownFault>& knownFaults();

}  // namespace cobot_command::simulator
