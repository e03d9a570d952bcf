// A request to write an entry of the tables of tools, frames and loads, and its result.
#pragma once

#include <optional>
#include <variant>

#include "cobot_command/common/result.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::command {

/// nullopt in `entry`: the entry becomes empty.
struct TableWrite {
  int index = 0;
  std::variant<std::optional<tables::Tool>, std::optional<tables::Frame>, std::optional<tables::Load>> entry;
};

struct TableWritten {
  tables::DataTables tables;  ///< present tables
  bool changed = false;       ///< false: the entry already had this value
};
using TableAnswer = Result<TableWritten, tables::Refusal>;

}  // namespace cobot_command::command
