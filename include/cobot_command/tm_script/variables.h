// Variables by name: those of the Listen node, or of the project. The owner determines their lifetime.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Limit of the memory of all variables together. Chosen by this package, so that a client cannot exhaust the
/// memory.
inline constexpr std::size_t kMaxVariableBytes = std::size_t{16} << 20;

class Variables {
 public:
  /// nullptr if the variable does not exist. The pointer is valid until the next set() or clear().
  [[nodiscard]] const Value* find(std::string_view name) const;
  /// Creates or changes a variable. The caller must keep the type of an existing one. Returns false if there
  /// is no room for it.
  bool set(std::string_view name, Value value);
  void clear();

 private:
  std::map<std::string, Value, std::less<>> values_;
  std::size_t bytes_ = 0;
};

/// The variables that a script can access.
struct Scope {
  Variables& locals;   ///< declared by scripts; deleted when the Listen node is left
  Variables& project;  ///< declared in the project
};

}  // namespace cobot_command::tm_script
