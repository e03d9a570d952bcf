// The tables of tools, frames and loads in the core: written and told.
#pragma once

#include <utility>
#include <vector>

#include "cobot_command/command/actions.h"
#include "cobot_command/command/table_write.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::command {

class TableDesk {
 public:
  /// `actions` has to live longer.
  TableDesk(tables::Payload payload, std::vector<Action>& actions)
      : store_({}, std::move(payload)), actions_(actions) {}

  [[nodiscard]] tables::TableStore& store() { return store_; }

  void use(tables::DataTables tables);
  [[nodiscard]] TableAnswer write(const TableWrite& write);
  /// What write() would answer.
  [[nodiscard]] TableAnswer tried(const TableWrite& write) const;

 private:
  tables::TableStore store_;
  std::vector<Action>& actions_;
};

}  // namespace cobot_command::command
