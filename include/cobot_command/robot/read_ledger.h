// Values of the controller's project that one script has requested, and their answers.
//
// TMSTA 90..99 have no id, and are sent to all clients. They are assigned by their order on the wire, because
// the controller runs the scripts of all clients strictly one after the other. The answers to this script are
// between the mark that it sends first and the reply to it, in the order of its lines. Data before the mark
// belongs to earlier scripts (run_script, other clients), data after the reply to later ones. Any data that
// does not fit makes the whole reading fail: no value is ever guessed.
//
// Sans-I/O: it is notified of what was sent and what was received, in the order of the wire
// (ScriptLink::next()).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/script_requests.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/robot/read_ledger_states.h"
#include "cobot_command/script/project_attributes.h"

namespace cobot_command::robot {

struct ReadValue {
  script::AttributeRead read;
  /// Finite, as many as the attribute has, in its units; floats on the wire.
  std::vector<double> numbers;
};

struct ReadFailure {
  enum class Kind {
    Unknown,       ///< ERROR on lines of `reads`: the project does not have these names
    NoListenSend,  ///< ERROR on the line of the mark: TMflow before script::kAttributesSince
    Refused,       ///< ERROR on other lines, or without line numbers
    NotTaken,      ///< CPERR: usually because the flow is not in the Listen node
    NoAnswer,      ///< no reply in time, by the caller's clock or the link's
    Incomplete,    ///< OK, but no data arrived for `reads`
    Payload,       ///< the data for the one read in `reads` is no value of it
    Mixed,         ///< the data is not what the lines send
    Lost           ///< the connection is closed
  };
  Kind kind = Kind::Lost;
  std::vector<script::AttributeRead> reads;  ///< reads that the failure concerns; empty: all
  std::string reason;                        ///< one line for people
};

/// All values in the order of the reads, or no value.
using ReadOutcome = Result<std::vector<ReadValue>, ReadFailure>;

class ReadLedger {
 public:
  /// The script was sent under this id (ScriptLink::sendScript() of its text). Precondition: !waiting().
  void sent(script::ReadingScript script, std::string script_id, Instant deadline);
  [[nodiscard]] bool waiting() const { return state_ != ReadState::Idle; }

  /// True: the data belongs to the script; false: it belongs to another client or script.
  bool take(const protocol::ListenData& data);

  // --- The outcome, once; nullopt: the event was not the awaited one.
  [[nodiscard]] std::optional<ReadOutcome> take(const link::ScriptAnswered& answered);
  /// Call it when the deadline has passed. Data that arrives later is ignored.
  [[nodiscard]] std::optional<ReadOutcome> advance(Instant now);
  [[nodiscard]] std::optional<ReadOutcome> lost(const std::string& reason);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  using Kind = ReadFailure::Kind;
  /// False: the event is not listed for this state.
  bool fire(ReadEvent event);
  void store(const protocol::ListenData& data);
  [[nodiscard]] ReadFailure failureOf(const protocol::ScriptReply& reply) const;
  [[nodiscard]] ReadOutcome collected();
  [[nodiscard]] ReadOutcome end(ReadOutcome outcome);

  ReadState state_ = ReadState::Idle;
  script::ReadingScript script_;
  std::string script_id_;
  Instant deadline_{};
  std::vector<ReadValue> values_;
  std::optional<ReadFailure> broken_;  ///< the first data that does not fit
};

}  // namespace cobot_command::robot
