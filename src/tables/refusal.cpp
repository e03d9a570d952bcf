#include "cobot_command/tables/refusal.h"

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::tables {

std::string describe(const Refusal& refusal) {
  return forPeople(fmt::format("{} {}: {}; allowed: {}. {}", toString(refusal.kind), refusal.index,
                               refusal.found, refusal.allowed, refusal.remedy));
}

}  // namespace cobot_command::tables
