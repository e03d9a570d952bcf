// An entry of the tables of tools, frames and loads that somebody wants written, and what became of it.
#pragma once

#include <optional>
#include <variant>

#include "cobot_command/common/result.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::command {

/// Nothing in it: the entry becomes empty.
struct TableWrite {
  int index = 0;
  std::variant<std::optional<tables::Tool>, std::optional<tables::Frame>, std::optional<tables::Load>> entry;
};

struct TableWritten {
  tables::DataTables tables;  ///< as they are now
  bool changed = false;       ///< false: it was written already
};
using TableAnswer = Result<TableWritten, tables::Refusal>;

}  // namespace cobot_command::command
