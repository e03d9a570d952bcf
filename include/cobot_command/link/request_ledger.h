// Every frame that was sent on the script link and has no answer yet, in the order of sending.
//
// Script replies are matched by their id, exactly; TMSTA answers by what was asked; a CPERR, which carries no
// id, belongs to the oldest request. What nobody waits for is told apart, so that it can be counted and never
// applied.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/common/time.h"

namespace cobot_command::link {

inline constexpr Instant kNoDeadline = Instant::max();

struct Request {
  enum class Kind { Script, NodeQuery, TagQuery };
  Kind kind = Kind::NodeQuery;
  std::string script_id;           ///< of a Script
  int tag = 0;                     ///< of a TagQuery
  Instant deadline = kNoDeadline;  ///< when its answer counts as missing
};

class RequestLedger {
 public:
  /// Unique for the life of the ledger: "1", "2", ... never "0", which is the controller's own.
  [[nodiscard]] std::string newScriptId() { return std::to_string(++last_id_); }

  void add(Request request) { open_.push_back(std::move(request)); }

  // --- Taking out what an answer belongs to; nothing when nobody waits for it.
  std::optional<Request> takeScript(std::string_view id);
  std::optional<Request> takeNodeQuery();
  std::optional<Request> takeTagQuery(int tag);
  std::optional<Request> takeOldest();
  std::optional<Request> takeOldestScript();
  /// One request whose deadline has come.
  std::optional<Request> takeExpired(Instant now);

  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  /// Forgets all requests: the connection is gone. Ids go on.
  void clear() { open_.clear(); }

 private:
  template <class Predicate>
  std::optional<Request> takeFirst(Predicate matches);

  std::deque<Request> open_;
  unsigned long long last_id_ = 0;
};

}  // namespace cobot_command::link
