// One table for each block; the catalogue is all of them, one after the other. Each is ordered by id.
#pragma once

#include <vector>

#include "cobot_command/blocks/error_catalogue.h"

namespace cobot_command::blocks {

[[nodiscard]] std::vector<ErrorEntry> connectErrors();
[[nodiscard]] std::vector<ErrorEntry> moveAbsoluteErrors();

}  // namespace cobot_command::blocks
