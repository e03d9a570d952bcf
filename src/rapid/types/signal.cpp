#include "cobot_command/rapid/types/signal.h"

#include <array>

namespace cobot_command::rapid {

namespace {

constexpr std::array<std::string_view, 6> kNames{"di", "do", "gi", "go", "ai", "ao"};
constexpr std::array<std::string_view, 6> kTypes{"signaldi", "signaldo", "signalgi",
                                                 "signalgo", "signalai", "signalao"};

}  // namespace

std::string_view toString(SignalType type) {
  return kNames.at(static_cast<std::size_t>(type));
}

TypeIndex typeOf(SignalType type) {
  static const TypeTable types;
  return types.atomicNamed(kTypes.at(static_cast<std::size_t>(type)));
}

}  // namespace cobot_command::rapid
