// Names as a format allows them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace cobot_command::automata {

/// One to one: letters, digits and "_", no digit first, none of the words that the format keeps for itself.
class FormatNames {
 public:
  explicit FormatNames(std::set<std::string> reserved = {}) : taken_(std::move(reserved)) {}

  /// The same for the same name.
  const std::string& of(const std::string& name);
  /// "written = meant" of each that is written otherwise, in the order of their meaning.
  [[nodiscard]] std::vector<std::string> table() const;

 private:
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
};

}  // namespace cobot_command::automata
