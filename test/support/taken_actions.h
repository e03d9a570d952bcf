// What a part of the core has asked for.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "cobot_command/command/actions.h"

namespace cobot_command::testing {

/// Those of one kind, in their order; all actions are taken away.
template <typename Kind>
std::vector<Kind> takeOf(std::vector<command::Action>& actions) {
  std::vector<Kind> found;
  for (const command::Action& action : std::exchange(actions, {})) {
    if (const auto* one = std::get_if<Kind>(&action)) found.push_back(*one);
  }
  return found;
}

}  // namespace cobot_command::testing
