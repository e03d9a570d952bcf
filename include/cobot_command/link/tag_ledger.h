// Who waits for which queue tag (QueueTag, TMSTA 01).
//
// A tag on the wire is only a number from 1 to 15, so a report that was meant for a motion of the past looks
// like one for the present. Therefore a number whose motion did not end by its report (it was stopped, lost,
// or its link dropped) is suspect: it is not given out again until its late report has come, or a younger tag
// has completed (tags complete in the order of the queue, so nothing older can follow), or no other number is
// left.
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

  /// `first`: the number that is given out first, without a preference; the others follow in their order.
  explicit TagLedger(int first = kFirst);

  /// A number for a new motion: `preferred` if that is free, else the one that has been free for longest.
  /// Nothing when all are open. 0: no preference.
  [[nodiscard]] std::optional<int> open(int preferred = 0);

  /// A completion was reported. True when a motion of this epoch waits for it; it is free afterwards. Else it
  /// is stale: it is counted, and means nothing.
  [[nodiscard]] bool complete(int tag);

  /// Whether a report of it now, which nobody awaits, can be none of ours: neither the late one of a motion
  /// of the past, nor the last one once more.
  [[nodiscard]] bool isForeign(int tag) const;

  /// The motion ended without its report.
  void abandon(int tag);

  /// After a stop and after a reconnect: nobody waits for any tag that was given out before.
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
