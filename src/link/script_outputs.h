// What comes out of the script link, put behind what is there already.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <variant>

#include "cobot_command/link/script_link.h"

namespace cobot_command::link {

inline void tell(std::optional<ScriptAnswer> answer, std::deque<ScriptLinkOutput>& outputs) {
  if (!answer) return;
  std::visit([&](auto& what) { outputs.push_back(std::move(what)); }, *answer);
}

}  // namespace cobot_command::link
