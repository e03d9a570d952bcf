// Every frame that was sent on the script link and has no answer yet, in the order of sending.
//
// Script replies are matched by their id, exactly; TMSTA answers by what was asked; a CPERR, which carries no
// id, belongs to the oldest request. What nobody waits for is told apart, so that it can be counted and never
// applied. A TMSTA 01 has no id, and its answer reads like a report that nobody asked for: so a question that
// was given up is remembered until the answer of a later TMSTA 00 shows that its own will not come.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/common/time.h"

namespace cobot_command::link {

struct Request {
  enum class Kind { Script, NodeQuery, TagQuery };
  Kind kind = Kind::NodeQuery;
  std::string script_id;             ///< of a Script
  int tag = 0;                       ///< of a TagQuery
  Instant handed_over{};             ///< by the event that made it; planning may have taken long since then
  std::optional<Duration> patience;  ///< until its answer counts as missing; nothing: it never does
  std::optional<Instant> deadline;   ///< from the first look at the time behind that event: then it is out
  bool given_up = false;             ///< a TagQuery whose answer counts as missing: it would be late now
};

class RequestLedger {
 public:
  /// Unique for the life of the ledger: "1", "2", ... never "0", which is the controller's own.
  [[nodiscard]] std::string newScriptId() { return std::to_string(++last_id_); }

  void add(Request request) { open_.push_back(std::move(request)); }

  // --- Taking out what an answer belongs to; nothing when nobody waits for it.
  std::optional<Request> takeScript(std::string_view id);
  std::optional<Request> takeNodeQuery();
  /// The oldest of this tag; one that was given up, too.
  std::optional<Request> takeTagQuery(int tag);
  std::optional<Request> takeOldest();
  std::optional<Request> takeOldestScript();
  /// One request whose deadline has come. The time of those that are new begins with it.
  std::optional<Request> takeExpired(Instant now);

  /// The controller has not answered a script yet, and may still do so.
  [[nodiscard]] bool awaitsScript() const;
  /// With a new request: at once.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  /// Forgets all requests: the connection is gone. Ids go on.
  void clear() { open_.clear(); }

 private:
  using Open = std::deque<Request>;
  template <class Predicate>
  Open::iterator findAwaited(Predicate matches);
  std::optional<Request> take(const Open::iterator& request);
  std::optional<Request> giveUp(const Open::iterator& request);

  Open open_;
  unsigned long long last_id_ = 0;
};

}  // namespace cobot_command::link
