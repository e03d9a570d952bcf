// The predefined items of the status port, a row each: name, value, who may write it and what that does, and
// the versions of TMflow that have it (TM 3.1).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "status_port/item_values.h"
#include "status_port/item_write.h"

namespace cobot_command::simulator {

/// Automatic: in automatic mode alone; Always: in manual mode, too.
enum class Access { ReadOnly, Automatic, Always };

struct ItemRow {
  const char* name;   ///< `#` stands for the numbers from 0 on
  std::size_t count;  ///< how many; 1 without `#`
  protocol::ItemValue (*read)(const ItemValues&, std::size_t number);
  int since = 0;     ///< 176: TMflow 1.76
  int until = 9999;  ///< included
  Access access = Access::ReadOnly;
  /// The value has the type and the size of what `read` gives. Nothing: it is out of range.
  std::optional<ItemWrite> (*write)(const protocol::ItemValue&, std::size_t number) = nullptr;
};

[[nodiscard]] const std::vector<ItemRow>& itemRows();

}  // namespace cobot_command::simulator
