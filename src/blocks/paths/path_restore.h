// Base and TCP are those of in front of a path again, when it ends before its own last command.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/command.h"

namespace cobot_command::blocks {

class PathRestore {
 public:
  /// Of no piece of a path.
  static constexpr CommandKey kKey = std::numeric_limits<CommandKey>::max();
  static constexpr const char* kNotRestored = "; base and TCP may still be those of the path";

  /// No lines: nothing has to be set back.
  void begin(Order order) { order_ = std::move(order); }
  void started() {
    order_ = Order();
    is_sent_ = true;
  }
  /// Or it could not be sent.
  void ended() {
    order_ = Order();
    is_sent_ = false;
  }
  [[nodiscard]] bool isOwed() const { return !order_.lines.empty(); }
  [[nodiscard]] bool isSent() const { return is_sent_; }
  /// Precondition: it is owed.
  [[nodiscard]] Command command() const {
    Command command;
    command.key = kKey;
    command.block = kBlock<LoadPathGoal>;
    command.order = [order = order_](const arm::Pose& /*base*/) { return order; };
    return command;
  }

 private:
  Order order_;
  bool is_sent_ = false;
};

}  // namespace cobot_command::blocks
