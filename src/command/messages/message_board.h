// The messages of the layer: the last hundred, and which of them are pending.
//
// One cause is one message: as long as it is pending, nothing new is to be known of it.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/command/message.h"

namespace cobot_command::command {

class MessageBoard {
 public:
  static constexpr std::size_t kMost = 100;

  /// Messages of this severity and above are kept; Off: none.
  void keep(Severity least) { least_ = least; }
  [[nodiscard]] bool keeps(Severity severity) const { return least_ != Severity::Off && severity >= least_; }

  /// Returns what is new; nothing: it is pending already, or not kept. `lasts`: warnings alone; it is pending
  /// until end(). Errors are pending until they are acknowledged.
  std::optional<Message> raise(Message message, bool lasts = false);
  /// The cause of what lasts, of that origin and code, is gone. True when that was pending.
  bool end(const std::string& origin, int code);
  /// The same, of the same cause and in the same words.
  [[nodiscard]] bool isPending(const Message& message) const;
  /// All that is pending is seen by somebody; returns how much that was. `still`: what is wrong still stays.
  std::size_t acknowledge(const std::vector<MessageType>& still = {});

  /// In the order of their ids.
  [[nodiscard]] std::vector<Message> pending() const;
  [[nodiscard]] std::vector<Message> all(Severity least, std::uint32_t after_id) const;
  [[nodiscard]] std::size_t countPending(Severity severity) const;

 private:
  Severity least_ = Severity::Info;
  std::uint32_t last_id_ = 0;
  std::deque<Message> messages_;
};

}  // namespace cobot_command::command
