// The motions that wait for queue tags (QueueTag, TMSTA 01).
//
// On the wire a tag is only a number from 1 to 15, so a report for an earlier motion looks like one for the
// present motion. Therefore a number is suspect if its motion did not end by its report (the motion was
// stopped or lost, or its link dropped). A suspect number is not given out again until its late report has
// arrived, or a younger tag has completed, or no other number is left. Tags complete in the order of the
// queue, so after a younger tag no older one can follow.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cobot_command::link {

class TagLedger {
 public:
  static constexpr int kFirst = 1;
  static constexpr int kLast = 15;

  /// `first`: the first number that is given out without a preference; the others follow in order.
  explicit TagLedger(int first = kFirst);

  /// A number for a new motion: `preferred` if it is free, otherwise the one that has been free for the
  /// longest time. 0: no preference. nullopt: all are open.
  [[nodiscard]] std::optional<int> open(int preferred = 0);

  /// A completion was reported. True: a motion of this epoch waits for it; the number is then free. False:
  /// the report is stale; it is counted and has no effect.
  [[nodiscard]] bool complete(int tag);

  /// True: an unexpected report of this tag cannot be one of this layer, neither a late report of an earlier
  /// motion nor a repetition of the last report.
  [[nodiscard]] bool isForeign(int tag) const;

  /// The motion ended without its report.
  void abandon(int tag);

  /// After a stop and after a reconnect: nothing waits for the tags that were given out before.
  void renewEpoch();

  [[nodiscard]] bool isOpen(int tag) const;
  [[nodiscard]] std::vector<int> openTags() const;
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  [[nodiscard]] std::uint64_t staleReports() const { return stale_reports_; }

 private:
  enum class Use { Free, Open, Suspect };
  struct Entry {
    Use use = Use::Free;
    std::uint64_t since = 0;  ///< serial number of the opening
  };

  [[nodiscard]] static bool exists(int tag) { return tag >= kFirst && tag <= kLast; }
  [[nodiscard]] Entry& at(int tag) { return entries_[static_cast<std::size_t>(tag)]; }
  [[nodiscard]] const Entry& at(int tag) const { return entries_[static_cast<std::size_t>(tag)]; }
  [[nodiscard]] std::optional<int> oldest(Use use) const;

  std::array<Entry, kLast + 1> entries_;  ///< by number; 0 is not used
  std::uint64_t serial_ = 0;
  int last_reported_ = 0;
  std::uint64_t epoch_ = 0;
  std::uint64_t stale_reports_ = 0;
};

}  // namespace cobot_command::link
