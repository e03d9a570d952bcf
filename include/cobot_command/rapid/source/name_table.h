// The names of one source. Case does not count: names that differ only in case are one name.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/token.h"

namespace cobot_command::rapid {

/// `name` in small letters. Letters are those of ASCII and of ISO 8859-1, in UTF-8. The sharp s and the y
/// with diaeresis have no capital.
[[nodiscard]] std::string folded(std::string_view name);

/// Movable only: the entries point into each other.
class NameTable {
 public:
  /// Contains the reserved words of both dialects: the index of a word is the value of its TokenKind.
  NameTable();
  ~NameTable() = default;
  NameTable(const NameTable&) = delete;
  NameTable& operator=(const NameTable&) = delete;
  NameTable(NameTable&&) = default;
  NameTable& operator=(NameTable&&) = default;

  /// The index of a name; a new name is added.
  [[nodiscard]] NameIndex add(std::string_view name);
  [[nodiscard]] std::optional<NameIndex> find(std::string_view name) const;
  /// The name in small letters. It is valid as long as the table.
  [[nodiscard]] std::string_view folded(NameIndex name) const { return *names_[name]; }
  /// Number of names; the indices are the numbers below it.
  [[nodiscard]] std::size_t size() const { return names_.size(); }

 private:
  static constexpr std::size_t kRecent = 1024;

  NameIndex addFolded(std::string_view folded);

  // An ordered map, because a file may contain millions of names that were chosen to be slow in a hash table.
  std::map<std::string, NameIndex, std::less<>> indices_;
  std::vector<const std::string*> names_;
  /// The last name of each of a few places, so that most names are found without the map.
  std::vector<NameIndex> recent_;
};

}  // namespace cobot_command::rapid
