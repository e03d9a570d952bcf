// What a name means at a place of a file: in a routine, in its module, in the program.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draft.h"

namespace cobot_command::rapid {

/// What kind of name is meant, for "did you mean".
enum class Meant : std::uint8_t { Value, Procedure, Trap, Type, Signal };

class Names {
 public:
  explicit Names(FileDraft& file);

  [[nodiscard]] SymbolIndex module() const { return module_; }
  /// Forgets the names of a routine.
  void enterModule(SymbolIndex module);
  /// kNoSymbol if the name means nothing, or is no name.
  [[nodiscard]] SymbolIndex find(TokenIndex name);
  [[nodiscard]] SymbolIndex findType(TokenIndex name);

  /// Of a routine: `symbol` is what the name means from here on. Returns what it meant in the routine before.
  SymbolIndex set(NameIndex name, SymbolIndex symbol);
  /// What the name means in the routine itself.
  [[nodiscard]] SymbolIndex inRoutine(NameIndex name) const { return routine_[name]; }
  void leaveRoutine();

  /// The name that is most like a written one, as in its declaration; empty if none is close.
  [[nodiscard]] std::string nearest(TokenIndex name, Meant meant);

 private:
  struct Known {
    std::uint32_t module_number = 0;
    SymbolIndex symbol = kNoSymbol;
    SymbolIndex type = kNoSymbol;
  };

  const Known& known(NameIndex name);
  [[nodiscard]] bool isMeant(const Symbol& symbol, Meant meant) const;

  FileDraft& file_;
  SymbolIndex module_ = kNoSymbol;
  std::uint32_t module_number_ = 0;
  std::vector<Known> known_;              // by NameIndex
  std::vector<SymbolIndex> routine_;      // by NameIndex
  std::vector<NameIndex> routine_names_;  // those that are set in routine_
};

/// The name of `names` with at most two inserted, deleted, replaced or swapped letters, and not more than a
/// third of them; empty if there is none. Case does not count.
[[nodiscard]] std::string nearestName(std::string_view written, const std::vector<std::string_view>& names);

}  // namespace cobot_command::rapid
