// What the script link has asked and the controller has not answered yet, and what an answer tells of it.
//
// An answer that nobody waits for is counted, and tells nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "cobot_command/link/request_ledger.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::link {

struct NoReply {};  ///< in time
struct ScriptAnswered {
  std::string id;
  std::variant<protocol::ScriptReply, protocol::CommunicationError, NoReply> answer;
};
/// A tag report: spontaneous, or the answer to a question for the tag.
struct TagReported {
  int tag = 0;
  bool asked = false;
  protocol::TagState state = protocol::TagState::Unknown;
};
/// The question for a tag got no answer in time, or a CPERR.
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
  /// The connection is gone, and no answer will come.
  void clear() { ledger_.clear(); }
  /// Questions for the Listen node whose answers were lost.
  void dropNodeQueries();

  // --- What an answer tells; nothing when nobody waits for it.
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::ScriptReply& message);
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::TagReport& message);
  /// Nothing also when it is the answer to a question for the Listen node.
  [[nodiscard]] std::optional<ScriptAnswer> take(const protocol::CommunicationError& message);
  /// To the question for the Listen node. False: nobody has asked.
  [[nodiscard]] bool takeNodeState();
  /// Of one request whose time is over.
  [[nodiscard]] std::optional<ScriptAnswer> takeExpired(Instant now);

  /// Answers that nobody waited for.
  [[nodiscard]] std::uint64_t late() const { return late_; }

 private:
  RequestLedger ledger_;
  std::uint64_t late_ = 0;
};

}  // namespace cobot_command::link
