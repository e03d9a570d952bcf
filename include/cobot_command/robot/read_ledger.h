// Values of the controller's project that were asked for by one script, and what has come of them.
//
// TMSTA 90..99 carry no id, and go to all clients. They are told apart by the order on the wire, as the
// controller runs the scripts of all clients strictly one after the other: what is ours stands between the
// mark that our script sends first and the reply to our script, and its answers come in the order of its
// lines. What comes before the mark is of scripts before (run_script, other clients), what comes behind the
// reply of later ones. Whatever does not fit makes the whole reading fail: no value is ever guessed.
//
// Sans-I/O: it is told what was sent and what comes, in the order of the wire (ScriptLink::next()).
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
  std::vector<double> numbers;  ///< finite, as many as the attribute has, in its units; floats on the wire
};

struct ReadFailure {
  enum class Kind {
    Unknown,       ///< ERROR on lines of `reads`: the project does not have these names
    NoListenSend,  ///< ERROR on the line of the mark: TMflow before script::kAttributesSince
    Refused,       ///< ERROR on lines that are none, or without any
    NotTaken,      ///< CPERR: not in the Listen node, above all
    NoAnswer,      ///< no reply in time, from the caller's clock or the link's
    Incomplete,    ///< OK, but nothing came for `reads`
    Payload,       ///< what came for the one of `reads` is no value of it
    Mixed,         ///< what came is not what the lines send
    Lost           ///< the connection is gone
  };
  Kind kind = Kind::Lost;
  std::vector<script::AttributeRead> reads;  ///< that it is about; empty: all
  std::string reason;                        ///< one line for people
};

/// All values in the order of the reads, or none.
using ReadOutcome = Result<std::vector<ReadValue>, ReadFailure>;

class ReadLedger {
 public:
  /// It was sent under this id (ScriptLink::sendScript() of its text). Precondition: !waiting().
  void sent(script::ReadingScript script, std::string script_id, Instant deadline);
  [[nodiscard]] bool waiting() const { return state_ != ReadState::Idle; }

  /// Whether it belongs to the script; if not, it is for somebody else.
  bool take(const protocol::ListenData& data);

  // --- The outcome, once; nothing when that was not what it waits for.
  [[nodiscard]] std::optional<ReadOutcome> take(const link::ScriptAnswered& answered);
  /// When the deadline has come. What comes later is nobody's.
  [[nodiscard]] std::optional<ReadOutcome> advance(Instant now);
  [[nodiscard]] std::optional<ReadOutcome> lost(const std::string& reason);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  using Kind = ReadFailure::Kind;
  /// False: not listed.
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
  std::optional<ReadFailure> broken_;  ///< by what came first that does not fit
};

}  // namespace cobot_command::robot
