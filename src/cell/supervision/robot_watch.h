// What is heard of one robot, and whether it may be granted anything.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// A go or booking that is not granted yet.
struct Request {
  NumberedEvent event;
  Instant since;
};

class RobotWatch {
 public:
  enum class Session {
    Known,   ///< the one that is listened to
    New,     ///< another one, of a node that was started anew: only a person can let it join
    Foreign  ///< a second node beside the first, or what was late of one before
  };

  /// A report of it came, whatever it is worth.
  void noticed(Instant now) { noticed_ = noticed_.value_or(now); }
  /// What a report of that session is, `listened` being the one that is listened to; 0: none. Whoever was
  /// listened to before this supervisor was started anew has the lease to be heard first.
  [[nodiscard]] Session judge(std::uint64_t session, std::uint64_t listened, Instant now,
                              Duration lease) const;
  /// False: it tells nothing that is newer than what is known.
  bool hear(const RobotReport& report, Instant now);
  /// Its session is listened to from now on: what was wrong with the one before is over.
  void joined();
  /// Where it was measured last is where it is not any more.
  void forgetPlace();

  [[nodiscard]] bool wasHeard() const { return heard_.has_value(); }
  [[nodiscard]] Duration age(Instant now) const { return heard_ ? now - *heard_ : Duration{}; }
  [[nodiscard]] bool isSilent(Instant now, Duration lease) const { return heard_ && now - *heard_ > lease; }
  /// Its joints were measured no longer ago, when it told them.
  [[nodiscard]] bool isFresh(Duration oldest) const { return report_.status_age <= toSeconds(oldest); }
  /// Something can be sent to it.
  [[nodiscard]] bool isLinked() const { return report_.condition != RobotCondition::Unlinked; }
  [[nodiscard]] std::optional<Instant> heard() const { return heard_; }
  /// Of the last report.
  [[nodiscard]] std::uint64_t session() const { return session_; }
  /// The last one.
  [[nodiscard]] const RobotReport& report() const { return report_; }
  [[nodiscard]] bool touches(ZoneIndex zone) const;
  [[nodiscard]] std::uint64_t highestNumber() const { return highest_number_; }

  // --- What a person has to look at.
  void fail(std::string why) { fault_ = std::move(why); }
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// A person knew of the condition that it still tells when they let it go on.
  [[nodiscard]] bool isExcused() const { return excused_ && *excused_ == report_.condition; }

  std::optional<Request> request;
  /// Of a request that was taken back, until the end of the report that did so.
  std::optional<Instant> waits_since;

 private:
  RobotReport report_;
  std::optional<Instant> noticed_;  ///< first
  std::optional<Instant> heard_;
  std::set<std::uint64_t> former_sessions_;
  std::uint64_t session_ = 0;  ///< of the last report
  std::uint64_t highest_number_ = 0;
  std::string fault_;
  std::optional<RobotCondition> excused_;
};

}  // namespace cobot_command::cell
