// All frames that were sent on the script link and are not answered yet, in the order of sending.
//
// Script replies are matched exactly by their id, TMSTA answers by the question. A CPERR, which has no id,
// belongs to the oldest request. Answers that nothing waits for are separated, so that they can be counted
// and are never applied. A TMSTA 01 has no id, and its answer looks like a spontaneous report. Therefore a
// question that was given up is remembered, until the answer to a later TMSTA 00 shows that its own answer
// will not arrive.
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
  std::string script_id;  ///< of a Script
  int tag = 0;            ///< of a TagQuery
  /// Time of the event that created it; planning may have taken long since then.
  Instant handed_over{};
  /// Time until its answer counts as missing; nullopt: never.
  std::optional<Duration> patience;
  /// Set at the first look at the time after that event, when the request has been sent.
  std::optional<Instant> deadline;
  /// A TagQuery whose answer counts as missing: an answer would now be late.
  bool given_up = false;
};

class RequestLedger {
 public:
  /// Unique during the life of the ledger: "1", "2", ... never "0", which the controller uses itself.
  [[nodiscard]] std::string newScriptId() { return std::to_string(++last_id_); }

  void add(Request request) { open_.push_back(std::move(request)); }

  // --- Taking out the request of an answer; nullopt: nothing waits for it.
  std::optional<Request> takeScript(std::string_view id);
  std::optional<Request> takeNodeQuery();
  /// The oldest request for this tag, even if it was given up.
  std::optional<Request> takeTagQuery(int tag);
  std::optional<Request> takeOldest();
  std::optional<Request> takeOldestScript();
  /// One request whose deadline has passed. This call starts the time of new requests.
  std::optional<Request> takeExpired(Instant now);

  /// True: the controller has not answered a script yet, and may still do so.
  [[nodiscard]] bool awaitsScript() const;
  /// If there is a new request: at once.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  /// Forgets all requests, because the connection is closed. Ids continue.
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
