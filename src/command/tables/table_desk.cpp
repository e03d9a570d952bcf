#include "tables/table_desk.h"

#include "cobot_command/common/overloaded.h"

namespace cobot_command::command {
namespace {

using tables::DataTables;

Result<DataTables, tables::Refusal> changed(const tables::TableStore& store, const TableWrite& write) {
  return std::visit(
      Overloaded{
          [&](const std::optional<tables::Tool>& tool) { return store.withTool(write.index, tool); },
          [&](const std::optional<tables::Frame>& frame) { return store.withFrame(write.index, frame); },
          [&](const std::optional<tables::Load>& load) { return store.withLoad(write.index, load); },
      },
      write.entry);
}

bool isThere(const tables::Entries& entries, const TableWrite& write) {
  const auto i = static_cast<std::size_t>(write.index);
  return std::visit(Overloaded{
                        [&](const std::optional<tables::Tool>& tool) { return entries.tools[i] == tool; },
                        [&](const std::optional<tables::Frame>& frame) { return entries.frames[i] == frame; },
                        [&](const std::optional<tables::Load>& load) { return entries.loads[i] == load; },
                    },
                    write.entry);
}

}  // namespace

void TableDesk::use(DataTables tables) {
  store_.replace(std::move(tables));
  actions_.emplace_back(TablesChanged{store_.tables()});
}

TableAnswer TableDesk::tried(const TableWrite& write) const {
  auto written = changed(store_, write);
  if (!written) return refuse(written.error());
  const bool is_new = !isThere(store_.tables().entries(), write);
  return TableWritten{*std::move(written), is_new};
}

TableAnswer TableDesk::write(const TableWrite& write) {
  auto written = tried(write);
  if (written && written->changed) use(std::move(written->tables));
  if (written) written->tables = store_.tables();
  return written;
}

}  // namespace cobot_command::command
