#include "cobot_command/files/yaml_map.h"

#include <algorithm>
#include <locale>
#include <map>
#include <sstream>
#include <type_traits>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/nearest.h"

namespace cobot_command::files {
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

/// 010 is 8 in YAML 1.1 and 10 in YAML 1.2, and people mean 10.
bool hasLeadingZero(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  const std::size_t first = text.find_first_not_of("+-");
  return first + 1 < text.size() && text[first] == '0' && text[first + 1] >= '0' && text[first + 1] <= '9';
}
void refuseLeadingZero(const YAML::Node& node, const std::string& key, const char* allowed) {
  if (!node.IsScalar() || !hasLeadingZero(node)) return;
  throw YamlFault(node.Mark(), fmt::format("{} has a leading zero; it must be {} without one", key, allowed),
                  {key, isShown(node), fmt::format("{} without a leading zero", allowed),
                   "remove the zero: some programs read such a number as octal"});
}

template <class Value>
Value convert(const YAML::Node& node, const std::string& key, const char* allowed) {
  if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, double>) {
    refuseLeadingZero(node, key, allowed);
  }
  Value value{};
  if (!node.IsScalar() || !decode(node, value)) {
    throw YamlFault(node.Mark(), fmt::format("{} is {}; it must be {}", key, kindOf(node), allowed),
                    {key, isShown(node), allowed, ""});
  }
  return value;
}

std::string listed(const YamlNames& names) {
  std::string text;
  for (const auto& [name, value] : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::vector<std::string> namesIn(const YamlNames& names) {
  std::vector<std::string> all;
  for (const auto& entry : names) all.emplace_back(entry.first);
  return all;
}

/// "write speed", if that may have been meant.
std::string adviceFor(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearestOf(word, known);
  return nearest.empty() ? "" : "write " + nearest;
}

std::string keyOf(const YAML::Node& key) {
  return key.IsScalar() ? key.Scalar() : std::string();
}

/// `first`: where the key stands for the first time.
[[noreturn]] void refuseSecond(const YAML::Node& key, const YAML::Node& first, const char* what) {
  const std::string told = fmt::format("twice in {}, first in line {}", what, first.Mark().line + 1);
  throw YamlFault(
      key.Mark(), fmt::format("{} is {}", foreignText(key.Scalar(), kQuoteLimit), told),
      {foreignText(key.Scalar(), kQuoteLimit), "is " + told, "each key once", "remove one of them"});
}

[[noreturn]] void refuseUnknown(const YAML::Node& key, const char* what,
                                const std::vector<std::string>& keys) {
  const std::string shown = key.IsScalar() ? foreignText(key.Scalar(), kQuoteLimit) : kindOf(key);
  throw YamlFault(key.Mark(), fmt::format("unknown key in {}; known: {}", what, fmt::join(keys, ", ")),
                  {shown, fmt::format("is no key of {}", what), fmt::format("{}", fmt::join(keys, ", ")),
                   adviceFor(keyOf(key), keys)});
}

FileFault faultAt(const std::string& name, const YAML::Mark& mark, const std::string& what,
                  YamlFinding finding) {
  if (mark.is_null()) return {name, 0, 0, what, std::move(finding)};
  return {name, mark.line + 1, mark.column + 1, what, std::move(finding)};
}

}  // namespace

std::string kindOf(const YAML::Node& node) {
  if (node.IsScalar()) return "something else";
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "empty";
}

std::string isShown(const YAML::Node& node) {
  if (node.IsScalar()) return "is " + quoted(node.Scalar());
  return node.IsSequence() ? fmt::format("is a list of {}", node.size()) : "is " + kindOf(node);
}

double toNumber(const YAML::Node& node, const std::string& key, const char* allowed) {
  return convert<double>(node, key, allowed);
}

int toNamed(const YAML::Node& node, const std::string& key, const YamlNames& names) {
  const auto text = node.IsScalar() ? node.Scalar() : std::string();
  const auto entry = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == text; });
  if (entry == names.end()) {
    throw YamlFault(node.Mark(),
                    fmt::format("{} is {}; it must be one of: {}", key, kindOf(node), listed(names)),
                    {key, isShown(node), listed(names), adviceFor(text, namesIn(names))});
  }
  return entry->second;
}

YAML::Node toList(const YAML::Node& node, const std::string& key, std::size_t count) {
  if (!node.IsSequence() || node.size() != count) {
    const auto is = node.IsSequence() ? fmt::format("a list of {}", node.size()) : kindOf(node);
    throw YamlFault(node.Mark(), fmt::format("{} is {}; it must be a list of {}", key, is, count),
                    {key, isShown(node), fmt::format("a list of {}", count), ""});
  }
  return node;
}

Given toGiven(const YAML::Node& node) {
  if (node.IsNull()) return {OtherKind{"nothing"}};
  if (node.IsMap()) return {OtherKind{"a map"}};
  if (node.IsSequence()) {
    GivenList list;
    // No deeper than any setting: an alias can stand for the very list that it stands in.
    for (const YAML::Node& entry : node) {
      list.push_back(entry.IsSequence() ? Given{OtherKind{"a list"}} : toGiven(entry));
    }
    return {list};
  }
  bool flag = false;
  int whole = 0;
  double real = 0;
  if (node.Tag() != "?") return {node.Scalar()};
  // So it is the number 10, and none for who wants a whole one.
  if (!hasLeadingZero(node) && decode(node, whole)) return {whole};
  if (decode(node, real)) return {real};
  if (decode(node, flag)) return {flag};
  return {node.Scalar()};
}

void requireOwnKeys(const YAML::Node& map, const char* what) {
  std::map<std::string, YAML::Node> seen;
  for (const auto& entry : map) {
    const auto [first, is_new] = seen.emplace(keyOf(entry.first), entry.first);
    if (!is_new) refuseSecond(entry.first, first->second, what);
  }
}

YamlMap::YamlMap(const YAML::Node& node, const char* what, const std::vector<std::string>& keys)
    : node_(node) {
  if (!node_.IsMap()) {
    throw YamlFault(node_.Mark(), fmt::format("{} is {}; it must be a map", what, kindOf(node_)),
                    {"", isShown(node), "a map", ""});
  }
  for (const auto& entry : node_) {
    if (std::find(keys.begin(), keys.end(), keyOf(entry.first)) == keys.end()) {
      refuseUnknown(entry.first, what, keys);
    }
  }
  requireOwnKeys(node_, what);
}

YAML::Node YamlMap::required(const char* key) const {
  const YAML::Node value = node_[key];
  if (!value.IsDefined()) {
    throw YamlFault(node_.Mark(), fmt::format("{} is missing", key), {key, "is missing", "", "add it"});
  }
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
  return toList(required(key), key, count);
}

YAML::Node YamlMap::listOf(const char* key, std::size_t most, const char* entries) const {
  const YAML::Node values = required(key);
  if (!values.IsSequence()) {
    throw YamlFault(values.Mark(), fmt::format("{} is {}; it must be a list", key, kindOf(values)),
                    {key, isShown(values), "a list", ""});
  }
  if (values.size() > most) {
    const std::string allowed = fmt::format("1..{} {}", most, entries);
    throw YamlFault(values.Mark(),
                    fmt::format("{} is a list of {}; it must have {}", key, values.size(), allowed),
                    {key, isShown(values), allowed, ""});
  }
  return values;
}

std::string describe(const FileFault& fault) {
  return forPeople(fault.line == 0 ? fmt::format("{}: {}", fault.file, fault.what)
                                   : fmt::format("{}:{}: {}", fault.file, fault.line, fault.what));
}

FileFault faultOf(const std::string& name, const YamlFault& fault) {
  return faultAt(name, fault.mark, fault.what(), fault.finding);
}

/// The library's words, without what it found in the text.
FileFault faultOf(const std::string& name, const YAML::Exception& fault) {
  const std::string words = fault.msg.substr(0, fault.msg.find(':'));
  return faultAt(
      name, fault.mark, "not YAML: " + words,
      {"", "is not YAML: " + words, "",
       "check for tabs, where YAML requires blanks, and check the indentation of the lines before"});
}

}  // namespace cobot_command::files
