// The text of a cell file, before anything is known of what stands in it.
#pragma once

#include <cstddef>
#include <string>

#include "checks/fault_list.h"

namespace cobot_command::cell {

/// Of a cell file, and of a file of steps that it names; as for goals.
inline constexpr std::size_t kMostBytes = 1 << 20;

/// Finds what no text editor writes into a file, and what YAML would drop without a word.
void checkText(const std::string& text, FaultList& faults);

}  // namespace cobot_command::cell
