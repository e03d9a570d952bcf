// Requests of the script link that the controller has not answered yet, and the meaning of an answer.
//
// An answer that nothing waits for is counted and has no effect.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "cobot_command/link/request_ledger.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::link {

struct NoReply {};  ///< before the timeout
struct ScriptAnswered {
  std::string id;
  std::variant<protocol::ScriptReply, protocol::CommunicationError, NoReply> answer;
};
/// A tag report: spontaneous, or the answer to a tag query.
struct TagReported {
  int tag = 0;
  bool asked = false;
  protocol::TagState state = protocol::TagState::Unknown;
};
/// A tag query got no answer before the timeout, or a CPERR.
struct TagQueryFailed {
  int tag = 0;
  std::string reason;
};
using ScriptAnswer = std::variant<ScriptAnswered, TagReported, TagQueryFailed>;

class ScriptRequests {
 public:
  /// See RequestLedger.
  [[nodiscard]] std::string newScriptId() { return ledger_.newScriptId(); }
  [[nodiscard]] bool awaitsScript() const { return ledger_.awaitsScript(); }
  void add(Request request) { ledger_.add(std::move(request)); }
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return ledger_.nextDeadline(); }
  /// The connection is closed, and no answer will arrive.
  void clear() { ledger_.clear(); }
  /// Removes the queries for the Listen node whose answers were lost.
  void dropNodeQueries();

  // --- Meaning of an answer; nullopt: nothing waits for it.
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::ScriptReply& message);
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::TagReport& message);
  /// nullopt also if it is the answer to a query for the Listen node.
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::CommunicationError& message);
  /// The answer to a query for the Listen node. False: there was no query.
  [[nodiscard]] bool takeNodeState();
  /// For one request whose time is over.
  [[nodiscard]] std::optional<ScriptAnswer> takeExpired(Instant now);

  /// Number of answers that nothing waited for.
  [[nodiscard]] std::uint64_t late() const { return late_; }

 private:
  RequestLedger ledger_;
  std::uint64_t late_ = 0;
};

}  // namespace cobot_command::link
