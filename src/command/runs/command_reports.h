// What is told of one command while it is under way.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

class CommandReports {
 public:
  /// `planned`: how long it takes, if that is known.
  CommandReports(int command_id_ack, std::optional<Duration> planned)
      : command_id_ack_(command_id_ack), planned_(planned) {}

  /// `executed`: for how long it has been.
  void tell(blocks::Phase phase, std::string text, Duration executed, Instant now);
  /// That was told last.
  [[nodiscard]] blocks::Phase phase() const { return phase_; }
  /// It is being executed, and how far it is was told a while ago.
  [[nodiscard]] bool due(Instant now) const;

  /// What is new since the last call.
  [[nodiscard]] std::vector<blocks::Progress> take() { return std::exchange(progress_, {}); }

 private:
  int command_id_ack_;
  std::optional<Duration> planned_;
  blocks::Phase phase_ = blocks::Phase::Sent;
  Instant told_at_{};
  std::vector<blocks::Progress> progress_;
};

}  // namespace cobot_command::command
