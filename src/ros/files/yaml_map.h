// Maps of YAML files that people write by hand: every key has to be known, every value of its type, and what
// is wrong is told with its line. Never what stands in the file, which may be any.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// Leaves readYaml() as its error.
struct YamlFault : std::runtime_error {
  YamlFault(const YAML::Mark& place, const std::string& what) : std::runtime_error(what), mark(place) {}
  YAML::Mark mark;
};

using YamlNames = std::vector<std::pair<const char*, int>>;

/// What a value is called in errors.
[[nodiscard]] std::string kindOf(const YAML::Node& node);

// Values; `key`: theirs, for errors. They throw a YamlFault.
[[nodiscard]] double toNumber(const YAML::Node& node, const std::string& key,
                              const char* allowed = "a number");
[[nodiscard]] int toNamed(const YAML::Node& node, const std::string& key, const YamlNames& names);

/// All functions throw a YamlFault where the file is not as they say.
class YamlMap {
 public:
  YamlMap(const YAML::Node& node, const char* what, const std::vector<std::string>& keys);

  [[nodiscard]] bool has(const char* key) const { return node_[key].IsDefined(); }
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

/// What `read` makes of the document; or "name:line: what is wrong".
template <class Value>
[[nodiscard]] Result<Value, std::string> readYaml(const std::string& text, const std::string& name,
                                                  const std::function<Value(const YAML::Node&)>& read);

/// Of a fault that came while a document with that name was read.
[[nodiscard]] std::string describe(const std::string& name, const YamlFault& fault);
[[nodiscard]] std::string describe(const std::string& name, const YAML::Exception& fault);

template <class Value>
Result<Value, std::string> readYaml(const std::string& text, const std::string& name,
                                    const std::function<Value(const YAML::Node&)>& read) {
  try {
    return read(YAML::Load(text));
  } catch (const YamlFault& fault) {
    return refuse(describe(name, fault));
  } catch (const YAML::Exception& fault) {
    return refuse(describe(name, fault));
  }
}

}  // namespace cobot_command::ros_adapter
