// Makes messages of what the core tells: errors of goals, the link, the controller and the arm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "messages/message_board.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class MessageDesk {
 public:
  /// The references must live longer. `arm`: name of the arm model, "tm5-900"; empty: none.
  MessageDesk(std::string arm, const robot::RobotWatch& robot, std::vector<Action>& actions)
      : arm_(std::move(arm)), robot_(robot), actions_(actions) {}

  /// To be called behind each event: what was told since the last look, and what the robot shows.
  void look(Instant now);
  /// The actions that were looked at are gone.
  void actionsTaken() { looked_at_ = 0; }

  /// Messages of this severity and above are kept and logged; Off: none.
  void keep(Severity least) { board_.keep(least); }
  void keepAsAtTheStart() { board_.keep(kLeastAtTheStart); }

  /// Of a goal that never came to the core; told with the next look.
  void tellEnd(blocks::Block block, const blocks::Outcome& outcome, Instant now);

  /// A warning that is pending as long as it is so; in other words it is another one. Told with the next
  /// look.
  void show(bool is_so, const Message& warning);

  /// An error of the controller that is shown still stays: nobody but who stands there can clear it.
  [[nodiscard]] ResetAnswer reset();
  [[nodiscard]] std::size_t pendingErrors() const {
    return board_.countPending(Severity::Error) + board_.countPending(Severity::Fatal);
  }
  [[nodiscard]] std::size_t pendingWarnings() const { return board_.countPending(Severity::Warning); }
  [[nodiscard]] std::vector<Message> read(Severity least, std::uint32_t after_id) const {
    return board_.all(least, after_id);
  }

 private:
  static constexpr Severity kLeastAtTheStart = Severity::Info;

  /// What is not kept is not logged either.
  void quieten(Action& action) const;
  void take(const GoalEnded& end);
  void take(const LogMessage& message);
  void take(const StatusChanged& changed);
  void take(const RobotStatusReceived& received);
  template <class Other>
  void take(const Other& /*action*/) {}
  void tellMissingItems(const link::RobotStatus& status);
  void tellAnotherArm(const link::RobotStatus& status);
  void raise(Message message, bool lasts = false);
  void tellPending();

  std::string arm_;
  const robot::RobotWatch& robot_;
  std::vector<Action>& actions_;
  std::size_t looked_at_ = 0;
  Instant now_{};
  MessageBoard board_;
  std::vector<Message> raised_;  ///< in this look
  std::vector<Message> told_pending_;
};

}  // namespace cobot_command::command
