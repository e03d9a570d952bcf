// Variables by name: those of the Listen node, or of the project. Whoever owns them decides how long they
// live.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Bytes that all variables may take together: ours, so that no client can use up the memory.
inline constexpr std::size_t kMaxVariableBytes = std::size_t{16} << 20;

class Variables {
 public:
  /// Nothing when there is no such variable. The pointer is valid until the next set() or clear().
  [[nodiscard]] const Value* find(std::string_view name) const;
  /// Makes a variable, or changes one: whoever changes it keeps its type. False when there is no room for it.
  bool set(std::string_view name, Value value);
  void clear();

 private:
  std::map<std::string, Value, std::less<>> values_;
  std::size_t bytes_ = 0;
};

/// What a script can see.
struct Scope {
  Variables& locals;   ///< declared by scripts; they end when the Listen node is left
  Variables& project;  ///< declared in the project
};

}  // namespace cobot_command::tm_script
