#include "files/yaml_map.h"

#include <algorithm>
#include <locale>
#include <sstream>

#include <fmt/format.h>

namespace cobot_command::ros_adapter {
namespace {

template <class Value>
bool decode(const YAML::Node& node, Value& value) {
  return YAML::convert<Value>::decode(node, value);
}

/// yaml-cpp reads numbers by the locale of the process: where people write a comma, 2.5 would be none,
/// and 2.500 be 2500.
template <class Number>
bool decodeNumber(const YAML::Node& node, Number& value) {
  std::istringstream stream(node.Scalar());
  stream.imbue(std::locale::classic());
  stream.unsetf(std::ios::dec);  // 0x10 is a whole number as well
  return stream >> std::noskipws >> value && stream.peek() == std::istringstream::traits_type::eof();
}
template <>
bool decode(const YAML::Node& node, double& value) {
  return decodeNumber(node, value);
}
template <>
bool decode(const YAML::Node& node, int& value) {
  return decodeNumber(node, value);
}

template <class Value>
Value convert(const YAML::Node& node, const std::string& key, const char* allowed) {
  Value value{};
  if (!node.IsScalar() || !decode(node, value)) {
    throw YamlFault(node.Mark(), fmt::format("{} is {}; it must be {}", key, kindOf(node), allowed));
  }
  return value;
}

std::string listed(const YamlNames& names) {
  std::string text;
  for (const auto& [name, value] : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string describeAt(const std::string& name, const YAML::Mark& mark, const std::string& what) {
  return mark.is_null() ? fmt::format("{}: {}", name, what)
                        : fmt::format("{}:{}: {}", name, mark.line + 1, what);
}

}  // namespace

std::string kindOf(const YAML::Node& node) {
  if (node.IsScalar()) return "something else";
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "nothing";
}

double toNumber(const YAML::Node& node, const std::string& key, const char* allowed) {
  return convert<double>(node, key, allowed);
}

int toNamed(const YAML::Node& node, const std::string& key, const YamlNames& names) {
  const auto text = node.IsScalar() ? node.Scalar() : std::string();
  const auto entry = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == text; });
  if (entry == names.end()) {
    throw YamlFault(node.Mark(),
                    fmt::format("{} is {}; it must be one of: {}", key, kindOf(node), listed(names)));
  }
  return entry->second;
}

YamlMap::YamlMap(const YAML::Node& node, const char* what, const std::vector<std::string>& keys)
    : node_(node) {
  if (!node_.IsMap()) {
    throw YamlFault(node_.Mark(), fmt::format("{} is {}; it must be a map", what, kindOf(node_)));
  }
  std::vector<std::string> seen;
  for (const auto& entry : node_) {
    const auto key = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      throw YamlFault(entry.first.Mark(),
                      fmt::format("unknown key in {}; known: {}", what, fmt::join(keys, ", ")));
    }
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
      throw YamlFault(entry.first.Mark(), fmt::format("{} stands twice in {}", key, what));
    }
    seen.push_back(key);
  }
}

YAML::Node YamlMap::required(const char* key) const {
  const YAML::Node value = node_[key];
  if (!value.IsDefined()) throw YamlFault(node_.Mark(), fmt::format("{} is missing", key));
  return value;
}

double YamlMap::number(const char* key) const {
  return toNumber(required(key), key);
}

int YamlMap::whole(const char* key) const {
  return convert<int>(required(key), key, "a whole number");
}

bool YamlMap::truth(const char* key) const {
  return convert<bool>(required(key), key, "true or false");
}

std::string YamlMap::text(const char* key) const {
  return convert<std::string>(required(key), key, "a text");
}

int YamlMap::named(const char* key, const YamlNames& names) const {
  return toNamed(required(key), key, names);
}

YAML::Node YamlMap::list(const char* key, std::size_t count) const {
  const YAML::Node values = required(key);
  if (!values.IsSequence() || values.size() != count) {
    const auto is = values.IsSequence() ? fmt::format("a list of {}", values.size()) : kindOf(values);
    throw YamlFault(values.Mark(), fmt::format("{} is {}; it must be a list of {}", key, is, count));
  }
  return values;
}

YAML::Node YamlMap::listOf(const char* key, std::size_t most, const char* entries) const {
  const YAML::Node values = required(key);
  if (!values.IsSequence()) {
    throw YamlFault(values.Mark(), fmt::format("{} is {}; it must be a list", key, kindOf(values)));
  }
  if (values.size() > most) {
    throw YamlFault(values.Mark(), fmt::format("{} is a list of {}; it must have 1..{} {}", key,
                                               values.size(), most, entries));
  }
  return values;
}

std::string describe(const std::string& name, const YamlFault& fault) {
  return describeAt(name, fault.mark, fault.what());
}

/// The library's words, without what it found in the text.
std::string describe(const std::string& name, const YAML::Exception& fault) {
  return describeAt(name, fault.mark, "no YAML: " + fault.msg.substr(0, fault.msg.find(':')));
}

}  // namespace cobot_command::ros_adapter
