#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::rapid {

std::string_view toString(Dialect dialect) {
  return dialect == Dialect::S4c ? "s4c" : "irc5";
}

std::optional<Dialect> dialectNamed(std::string_view name) {
  for (const Dialect dialect : {Dialect::Irc5, Dialect::S4c}) {
    if (name == toString(dialect)) return dialect;
  }
  return std::nullopt;
}

}  // namespace cobot_command::rapid
