// What TMSTA 01 can be asked about: the last four queue tags (TM 1.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "queue/queued_tag.h"

#include "cobot_command/protocol/message.h"

namespace cobot_command::simulator {

class TagTable {
 public:
  enum class Fate { Open, Complete, Failed };

  static constexpr std::size_t kRemembered = 4;

  /// A new tag, open. The fifth-last is forgotten.
  QueuedTag add(int tag);
  void settle(const QueuedTag& tag, Fate fate);
  /// The tag will never complete, and nobody is to be told.
  void forget(const QueuedTag& tag);

  /// Still open? A forgotten one is not.
  [[nodiscard]] bool isOpen(const QueuedTag& tag) const;
  /// The latest with that number, if it is remembered.
  [[nodiscard]] std::optional<QueuedTag> latest(int tag) const;
  /// The answer to TMSTA 01.
  [[nodiscard]] protocol::TagState query(int tag) const;

 private:
  struct Entry {
    QueuedTag tag;
    Fate fate = Fate::Open;
  };
  [[nodiscard]] const Entry* find(int tag) const;

  std::deque<Entry> entries_;
  std::uint64_t next_serial_ = 1;
};

}  // namespace cobot_command::simulator
