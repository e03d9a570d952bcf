#include "cobot_command/tables/refusal.h"

#include <fmt/format.h>

namespace cobot_command::tables {

std::string describe(const Refusal& refusal) {
  return fmt::format("{} {}: {}; allowed: {}. {}", toString(refusal.kind), refusal.index, refusal.found,
                     refusal.allowed, refusal.remedy);
}

}  // namespace cobot_command::tables
