// The names that each program has without declaring them.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

/// A declaration in one of several sources.
struct DeclaredName {
  std::string_view written;        ///< as in its declaration; empty: there is no such name
  const Source* source = nullptr;  ///< nullptr if only the name is known
  NodeIndex node = kNoNode;
};

class PredefinedNames {
 public:
  PredefinedNames() = default;
  /// All declarations of the modules of `sources`, and further names of which nothing but the spelling is
  /// known. Both must live as long as this object. The first declaration of a name counts.
  PredefinedNames(const std::vector<const Source*>& sources, const std::vector<std::string_view>& others);

  /// `folded`: in small letters. Data may have the name of a type.
  [[nodiscard]] DeclaredName find(std::string_view folded) const;
  [[nodiscard]] DeclaredName findType(std::string_view folded) const;

 private:
  using Declarations = std::unordered_map<std::string, DeclaredName>;
  Declarations types_;
  Declarations others_;
};

}  // namespace cobot_command::rapid
