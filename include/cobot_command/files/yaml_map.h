// Maps of YAML files that people write by hand: every key has to be known, every value of its type, and what
// is wrong is told with its line. The text of an error never says what stands in the file, which may be any;
// who may show it finds it in YamlFinding.
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

/// What is wrong with a value, with what stands in the file: bounded, without control characters.
struct YamlFinding {
  std::string field;    ///< "speed", "target_position[2]"; empty: the map or list itself
  std::string found;    ///< `is "fast"`, "is missing"
  std::string allowed;  ///< "a whole number"; empty: nothing is there to be said
  std::string advice;   ///< "write speed"; empty: as `allowed` says
};

/// Leaves readYaml() as its error.
struct YamlFault : std::runtime_error {
  YamlFault(const YAML::Mark& place, const std::string& what, YamlFinding finding_of_it = {})
      : std::runtime_error(what), mark(place), finding(std::move(finding_of_it)) {}
  YAML::Mark mark;
  YamlFinding finding;
};

using YamlNames = std::vector<std::pair<const char*, int>>;

/// What a value is called in errors.
[[nodiscard]] std::string kindOf(const YAML::Node& node);
/// The same with what stands there: `is "fast"`, "is a list of 3".
[[nodiscard]] std::string isShown(const YAML::Node& node);

// Values; `key`: theirs, for errors. They throw a YamlFault.
[[nodiscard]] double toNumber(const YAML::Node& node, const std::string& key,
                              const char* allowed = "a number");
[[nodiscard]] int toNamed(const YAML::Node& node, const std::string& key, const YamlNames& names);
/// A list of `count` values.
[[nodiscard]] YAML::Node toList(const YAML::Node& node, const std::string& key, std::size_t count);
/// As a setting takes it: what stands in quotes is a text, whatever it looks like.
[[nodiscard]] Given toGiven(const YAML::Node& node);

/// All functions throw a YamlFault where the file is not as they say.
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
  /// A list of 0 to `most` entries, which `entries` calls them. Looked at before any is read: aliases make
  /// long lists of short files.
  [[nodiscard]] YAML::Node listOf(const char* key, std::size_t most, const char* entries) const;

 private:
  YAML::Node node_;
};

/// Throws a YamlFault that names the key which stands twice; `what`: the map, for errors. For maps of names.
void requireOwnKeys(const YAML::Node& map, const char* what);

/// Why a file could not be read.
struct FileFault {
  std::string file;
  int line = 0;    ///< from 1; 0: it is not known
  int column = 0;  ///< from 1; 0: it is not known
  std::string what;
  YamlFinding finding;
};
/// "cell.yaml:7: speed is something else; it must be a whole number"
[[nodiscard]] std::string describe(const FileFault& fault);
/// Of what came while a document with that name was read.
[[nodiscard]] FileFault faultOf(const std::string& name, const YamlFault& fault);
[[nodiscard]] FileFault faultOf(const std::string& name, const YAML::Exception& fault);

/// What `read` makes of the document.
template <class Value>
[[nodiscard]] Result<Value, FileFault> tryYaml(const std::string& text, const std::string& name,
                                               const std::function<Value(const YAML::Node&)>& read) {
  try {
    return read(YAML::Load(text));
  } catch (const YamlFault& fault) {
    return refuse(faultOf(name, fault));
  } catch (const YAML::Exception& fault) {
    return refuse(faultOf(name, fault));
  }
}

/// The same; the error is "name:line: what is wrong".
template <class Value>
[[nodiscard]] Result<Value, std::string> readYaml(const std::string& text, const std::string& name,
                                                  const std::function<Value(const YAML::Node&)>& read) {
  auto value = tryYaml<Value>(text, name, read);
  if (!value) return refuse(describe(value.error()));
  return *std::move(value);
}

}  // namespace cobot_command::files
