// Which items a controller has: the predefined ones of its version of TMflow, and the global variables that
// its stream is set to hold.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "status_port/item_rows.h"

namespace cobot_command::simulator {

/// An item that was found in a table.
struct Item {
  std::string_view name;
  const ItemRow* row = nullptr;  ///< none: a global variable
  std::size_t number = 0;

  [[nodiscard]] Access access() const { return row == nullptr ? Access::Always : row->access; }
  [[nodiscard]] protocol::ItemValue read(const ItemValues& values) const;
  /// What to do for the value. Nothing: it has another type or size than what `read` gives, or is out of
  /// range.
  [[nodiscard]] std::optional<ItemWrite> write(const protocol::ItemValue& value,
                                               const protocol::ItemValue& old) const;
};

class ItemTable {
 public:
  /// Of the settings' version and stream. What is wrong in them (faultIn) is left out.
  ItemTable(const Settings& settings, const tm_script::Variables& variables);

  /// Robot_Link first. Items that the fault hides are among them: see shown().
  [[nodiscard]] const std::vector<Item>& stream() const { return stream_; }
  /// Items that the fault hides are not there.
  [[nodiscard]] std::optional<Item> find(std::string_view name, const ItemSource& source) const;

 private:
  std::map<std::string, Item, std::less<>> items_;
  std::vector<Item> stream_;
};

/// Those that the fault does not hide.
[[nodiscard]] std::vector<Item> shown(const std::vector<Item>& items, const FaultSwitch& hidden);

/// Is there a predefined item of that name in any version?
[[nodiscard]] bool isItem(std::string_view name);

}  // namespace cobot_command::simulator
