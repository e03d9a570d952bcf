// Names in cell files, and maps from names to things.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "checks/fault_list.h"

namespace cobot_command::cell {

/// A name of the cell file's own: it becomes part of events and of names in other formats.
[[nodiscard]] std::string nameIn(const YAML::Node& node, const std::string& field);
/// The same, of a value that has to stand in the map.
[[nodiscard]] std::string nameIn(const files::YamlMap& map, const char* key);
/// One of ROS: parts with slashes between them.
[[nodiscard]] std::string nameSpaceIn(const files::YamlMap& map, const char* key);

/// Of a thing that is not there: what was found, which there are, and the nearest of them.
[[nodiscard]] files::YamlFinding unknown(const std::string& field, const std::string& name, const char* kind,
                                         const std::vector<std::string>& known);
/// Throws that.
[[noreturn]] void refuseUnknown(const YAML::Mark& mark, const std::string& field, const std::string& name,
                                const char* kind, const std::vector<std::string>& known);
template <class Thing>
[[nodiscard]] std::vector<std::string> namesOf(const std::vector<Thing>& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const Thing& thing : things) names.push_back(thing.name);
  return names;
}

/// Tells of each entry of a map of names, at most `most`; faults are collected, entry by entry.
void forEachName(const YAML::Node& map, const std::string& field, std::size_t most, FaultList& faults,
                 const std::function<void(const std::string& name, const YAML::Node& value)>& read);

template <class Thing>
void sortByName(std::vector<Thing>& things) {
  std::sort(things.begin(), things.end(), [](const Thing& a, const Thing& b) { return a.name < b.name; });
}

}  // namespace cobot_command::cell
