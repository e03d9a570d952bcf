#include "status_port/item_table.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "robot/tmflow_version.h"
#include "status_port/variable_items.h"

namespace cobot_command::simulator {

namespace {

using protocol::ItemValue;

std::string nameOf(const ItemRow& row, std::size_t number) {
  std::string name = row.name;
  const std::size_t place = name.find('#');
  if (place != std::string::npos) name.replace(place, 1, std::to_string(number));
  return name;
}

bool isHidden(std::string_view name, const FaultSwitch& hidden) {
  if (!hidden.on) return false;
  std::istringstream names(hidden.text);
  const std::istream_iterator<std::string> first(names), last;
  return std::find(first, last, name) != last;
}

bool isOfVersion(const ItemRow& row, int version) {
  return row.since <= version && version <= row.until;
}

}  // namespace

ItemValue Item::read(const ItemValues& values) const {
  return row == nullptr ? toItem(*values.source.project.variables.find(name)) : row->read(values, number);
}

std::optional<ItemWrite> Item::write(const ItemValue& value, const ItemValue& old) const {
  const bool fits =
      value.index() == old.index() && protocol::elementCount(value) == protocol::elementCount(old);
  if (!fits) return std::nullopt;
  if (row != nullptr) return row->write(value, number);
  if (protocol::encodeValue(protocol::ItemFormat::Binary, value).size() > protocol::kMaxItemBytes) {
    return std::nullopt;
  }
  return SetVariable{std::string(name), value};
}

ItemTable::ItemTable(const Settings& settings, const tm_script::Variables& variables) {
  const tm_script::Version tmflow = tmflowVersion(settings.tmflow_version);
  const int version = 100 * tmflow.major + tmflow.minor;
  const auto add = [&](const std::string& name, const ItemRow* row, std::size_t number) {
    const auto place = items_.emplace(name, Item{{}, row, number}).first;
    place->second.name = place->first;
  };
  for (const ItemRow& row : itemRows()) {
    for (std::size_t number = 0; isOfVersion(row, version) && number < row.count; ++number) {
      add(nameOf(row, number), &row, number);
    }
  }
  std::set<std::string_view> seen;
  const auto stream = [&](const std::string& name) {
    if (variables.find(name) != nullptr && !isItem(name)) add(name, nullptr, 0);
    const auto found = items_.find(name);
    if (found != items_.end() && seen.insert(found->first).second) stream_.push_back(found->second);
  };
  stream("Robot_Link");
  std::for_each(settings.stream_items.begin(), settings.stream_items.end(), stream);
}

std::vector<Item> shown(const std::vector<Item>& items, const FaultSwitch& hidden) {
  std::vector<Item> rest;
  std::copy_if(items.begin(), items.end(), std::back_inserter(rest),
               [&](const Item& item) { return !isHidden(item.name, hidden); });
  return rest;
}

std::optional<Item> ItemTable::find(std::string_view name, const ItemSource& source) const {
  const auto found = items_.find(name);
  if (found == items_.end() || isHidden(name, source.hidden)) return std::nullopt;
  return found->second;
}

bool isItem(std::string_view name) {
  for (const ItemRow& row : itemRows()) {
    for (std::size_t number = 0; number < row.count; ++number) {
      if (nameOf(row, number) == name) return true;
    }
  }
  return false;
}

}  // namespace cobot_command::simulator
