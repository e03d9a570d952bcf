#include "cobot_command/runtime/cell/any_id.h"

#include <random>

namespace cobot_command::runtime {

std::uint64_t anyId() {
  std::random_device random;
  return std::uniform_int_distribution<std::uint64_t>(1, std::uint64_t{1} << 62U)(random);
}

}  // namespace cobot_command::runtime
