// Strict reader for hand-written YAML maps: every key must be known and every value must have its type.
// Errors report the line. The error text never quotes the content of the file, which may be arbitrary.
// YamlFinding has the content, for callers that may show it.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "cobot_command/common/given.h"
#include "cobot_command/common/result.h"

namespace cobot_command::files {

/// An invalid value, with the content of the file: bounded, without control characters.
struct YamlFinding {
  std::string field;    ///< "speed", "target_position[2]"; empty: the map or list itself
  std::string found;    ///< `is "fast"`, "is missing"
  std::string allowed;  ///< "a whole number"; empty: not applicable
  std::string advice;   ///< "write speed"; empty: follow `allowed`
};

/// tryYaml() and readYaml() convert it to their error.
struct YamlFault : std::runtime_error {
  YamlFault(const YAML::Mark& place, const std::string& what, YamlFinding finding_of_it = {})
      : std::runtime_error(what), mark(place), finding(std::move(finding_of_it)) {}
  YAML::Mark mark;
  YamlFinding finding;
};

using YamlNames = std::vector<std::pair<const char*, int>>;

/// Name of the type of a value in errors.
[[nodiscard]] std::string kindOf(const YAML::Node& node);
/// The same with the content: `is "fast"`, "is a list of 3".
[[nodiscard]] std::string isShown(const YAML::Node& node);

// Readers of values. `key` is the key of the value, for errors. They throw a YamlFault.
[[nodiscard]] double toNumber(const YAML::Node& node, const std::string& key,
                              const char* allowed = "a number");
[[nodiscard]] int toNamed(const YAML::Node& node, const std::string& key, const YamlNames& names);
/// A list of `count` values.
[[nodiscard]] YAML::Node toList(const YAML::Node& node, const std::string& key, std::size_t count);
/// Converts a value for a setting. A value in quotes is always a text.
[[nodiscard]] Given toGiven(const YAML::Node& node);

/// All functions throw a YamlFault if the file does not match.
class YamlMap {
 public:
  YamlMap(const YAML::Node& node, const char* what, const std::vector<std::string>& keys);

  [[nodiscard]] bool has(const char* key) const { return node_[key].IsDefined(); }
  [[nodiscard]] YAML::Mark mark() const { return node_.Mark(); }
  [[nodiscard]] YAML::Node required(const char* key) const;
  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] int whole(const char* key) const;
  [[nodiscard]] bool truth(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] int named(const char* key, const YamlNames& names) const;
  /// A list of `count` values.
  [[nodiscard]] YAML::Node list(const char* key, std::size_t count) const;
  /// A list of 0 to `most` entries; `entries` is their plural in the error. The length is checked before an
  /// entry is read, because aliases make long lists from short files.
  [[nodiscard]] YAML::Node listOf(const char* key, std::size_t most, const char* entries) const;

 private:
  YAML::Node node_;
};

/// Throws a YamlFault that names a key that is in the map twice. `what` names the map in the error. For maps
/// with arbitrary names as keys.
void requireOwnKeys(const YAML::Node& map, const char* what);

/// Why a file could not be read.
struct FileFault {
  std::string file;
  int line = 0;    ///< from 1; 0: unknown
  int column = 0;  ///< from 1; 0: unknown
  std::string what;
  YamlFinding finding;
};
/// "cell.yaml:7: speed is something else; it must be a whole number"
[[nodiscard]] std::string describe(const FileFault& fault);
/// The fault of an exception thrown while reading the document `name`.
[[nodiscard]] FileFault faultOf(const std::string& name, const YamlFault& fault);
[[nodiscard]] FileFault faultOf(const std::string& name, const YAML::Exception& fault);

/// The one document of the text. Throws a YamlFault if there is another one, which YAML::Load() ignores.
/// YAML::LoadAll() does not end if a document starts with a comma.
[[nodiscard]] YAML::Node documentIn(const std::string& text);

/// Parses the document and converts it with `read`.
template <class Value>
[[nodiscard]] Result<Value, FileFault> tryYaml(const std::string& text, const std::string& name,
                                               const std::function<Value(const YAML::Node&)>& read) {
  try {
    return read(documentIn(text));
  } catch (const YamlFault& fault) {
    return refuse(faultOf(name, fault));
  } catch (const YAML::Exception& fault) {
    return refuse(faultOf(name, fault));
  }
}

/// As tryYaml(); the error is the text "name:line: what is wrong".
template <class Value>
[[nodiscard]] Result<Value, std::string> readYaml(const std::string& text, const std::string& name,
                                                  const std::function<Value(const YAML::Node&)>& read) {
  auto value = tryYaml<Value>(text, name, read);
  if (!value) return refuse(describe(value.error()));
  return *std::move(value);
}

}  // namespace cobot_command::files
