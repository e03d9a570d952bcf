// The default dynamics of moves: kept, written, and put into every goal that comes.
#pragma once

#include <optional>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/command/dynamics.h"

namespace cobot_command::command {

class DefaultsDesk {
 public:
  [[nodiscard]] DynamicsAnswer write(const blocks::DefaultDynamics& defaults);
  [[nodiscard]] const blocks::DefaultDynamics& defaults() const { return defaults_; }
  /// As it is to be checked and carried out, with the defaults of now, whenever its turn comes; nothing: as
  /// it is, as there are none.
  [[nodiscard]] std::optional<blocks::Goal> filled(const blocks::Goal& goal) const;

 private:
  blocks::DefaultDynamics defaults_;
};

}  // namespace cobot_command::command
