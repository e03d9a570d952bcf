// --dialect of the subcommands that read modules.
#pragma once

#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::tools {

[[nodiscard]] inline Setting dialectSetting(rapid::Dialect& dialect) {
  using rapid::Dialect;
  return {"dialect",
          setting_kinds::choice<Dialect>(dialect, {{"irc5", Dialect::Irc5}, {"s4c", Dialect::S4c}}),
          "Dialect of RAPID"};
}

}  // namespace cobot_command::tools
