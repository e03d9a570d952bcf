#include "reading/names.h"

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/given.h"
#include "cobot_command/common/nearest.h"

namespace cobot_command::cell {

namespace {

constexpr std::size_t kLongestName = 64;
constexpr const char* kAllowedName = "1 to 64 ASCII letters, digits and _, starting with a letter";
constexpr const char* kAllowedSpace = "such names, separated by slashes";

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isName(const std::string& text) {
  if (text.empty() || text.size() > kLongestName || !isLetter(text.front())) return false;
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return isLetter(c) || c == '_' || (c >= '0' && c <= '9'); });
}

bool isNameSpace(const std::string& text) {
  std::size_t begin = !text.empty() && text.front() == '/' ? 1 : 0;
  while (true) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    if (!isName(text.substr(begin, end - begin))) return false;
    if (end == text.size()) return true;
    begin = end + 1;
  }
}

}  // namespace

std::string nameIn(const YAML::Node& node, const std::string& field) {
  if (!node.IsScalar() || !isName(node.Scalar())) {
    refuseAt(node.Mark(), {field, files::isShown(node), kAllowedName, ""});
  }
  return node.Scalar();
}

std::string nameIn(const files::YamlMap& map, const char* key) {
  return nameIn(map.required(key), key);
}

std::string nameSpaceIn(const files::YamlMap& map, const char* key) {
  const YAML::Node node = map.required(key);
  if (!node.IsScalar() || !isNameSpace(node.Scalar())) {
    refuseAt(node.Mark(),
             {key, files::isShown(node), fmt::format("{}, or {}", kAllowedName, kAllowedSpace), ""});
  }
  return node.Scalar();
}

files::YamlFinding unknown(const std::string& field, const std::string& name, const char* kind,
                           const std::vector<std::string>& known) {
  const std::string nearest = nearestOf(name, known);
  const std::string allowed = known.empty() ? fmt::format("none, because there is no {}", kind)
                                            : fmt::format("{}", fmt::join(known, ", "));
  return {field, fmt::format("is {}, which is not a {}", quoted(name), kind), foreignText(allowed),
          nearest.empty() ? "" : "write " + nearest};
}

void refuseUnknown(const YAML::Mark& mark, const std::string& field, const std::string& name,
                   const char* kind, const std::vector<std::string>& known) {
  refuseAt(mark, unknown(field, name, kind, known));
}

void forEachName(const YAML::Node& map, const std::string& field, std::size_t most, FaultList& faults,
                 const std::function<void(const std::string& name, const YAML::Node& value)>& read) {
  const bool readable = faults.collect("", [&] {
    if (!map.IsMap()) refuseAt(map.Mark(), {field, files::isShown(map), "a map of names", ""});
    if (map.size() > most) {
      refuseAt(map.Mark(),
               {field, fmt::format("has {} entries", map.size()), fmt::format("at most {}", most), ""});
    }
  });
  if (!readable) return;
  faults.collect(field, [&] { files::requireOwnKeys(map, field.c_str()); });
  for (const auto& entry : map) {
    std::string name;
    if (!faults.collect("", [&] { name = nameIn(entry.first, joined(field, "a name")); })) continue;
    faults.collect(joined(field, name), [&] { read(name, entry.second); });
  }
}

}  // namespace cobot_command::cell
