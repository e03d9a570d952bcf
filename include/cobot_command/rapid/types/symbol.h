// What a name stands for.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "cobot_command/rapid/source/tree.h"
#include "cobot_command/rapid/types/type_table.h"

namespace cobot_command::rapid {

/// Index of a symbol in its Program. The predefined ones come first, and are the same in each program.
using SymbolIndex = std::uint32_t;
inline constexpr SymbolIndex kNoSymbol = std::numeric_limits<SymbolIndex>::max();
/// Index of a file in its Program.
using FileIndex = std::uint32_t;
/// Place of a value in Program::constants().
using ConstantIndex = std::uint32_t;
inline constexpr ConstantIndex kNoConstant = std::numeric_limits<ConstantIndex>::max();

enum class SymbolKind : std::uint8_t {
  Module,
  Type,  ///< of a RECORD or ALIAS, or built in
  Data,  ///< of a module or routine
  Parameter,
  Counter,  ///< of a FOR
  Label,
  Procedure,
  Function,
  Trap,
  Signal,   ///< of the signal file
  Refused,  ///< of the manual, not offered by this package
};

struct Symbol {
  enum Flag : std::uint8_t {
    Local = 1,      ///< declared LOCAL
    ReadOnly = 2,   ///< CONST, a loop counter, or predefined and not to be changed
    Optional = 4,   ///< a Parameter after a backslash
    Excludes = 8,   ///< a Parameter after `|`: at most one of it and the one before it is given
    NotBuilt = 16,  ///< a predefined routine that is declared and does not run yet
    Irc5Only = 32,  ///< predefined, and not in dialect s4c
    Faulty = 64,    ///< an error leaves open what it is: nothing should be concluded from it
  };

  SymbolKind kind = SymbolKind::Data;
  std::uint8_t flags = 0;
  /// Of Data: Var, Pers or Const. Of a Parameter: Inout, Var, Pers, or Name for IN. Else End.
  TokenKind word = TokenKind::End;
  FileIndex file = 0;
  NodeIndex node = kNoNode;  ///< its declaration in this file; kNoNode if it has none (built in, a signal)
  TypeIndex type = kNoType;  ///< of Data, Parameter, Counter, Signal, of the result of a Function; a Type's
  /// The routine of a Parameter, Counter, Label and of data in it; the module of the rest; kNoSymbol for
  /// what is in no module.
  SymbolIndex owner = kNoSymbol;
  /// Of Data: the value of a CONST, the initial value of a VAR or PERS. kNoConstant: zeros, or a value that
  /// only a run can calculate, which then is the expression of `node`.
  ConstantIndex value = kNoConstant;
  /// Of a routine: its parameters are `parameters` symbols from here on, in their order.
  SymbolIndex first_parameter = kNoSymbol;
  std::uint32_t parameters = 0;
  /// Of a Parameter: its position from 0. Of a Signal: in the signals of the program. Of a Refused: in
  /// refusals().
  std::uint32_t index = 0;
  std::string_view name;  ///< as in its declaration

  [[nodiscard]] bool has(Flag flag) const { return (flags & flag) != 0; }
  [[nodiscard]] bool isRoutine() const {
    return kind == SymbolKind::Procedure || kind == SymbolKind::Function || kind == SymbolKind::Trap;
  }
  /// What a Reference can stand for: a value or an object.
  [[nodiscard]] bool isData() const {
    return kind == SymbolKind::Data || kind == SymbolKind::Parameter || kind == SymbolKind::Counter ||
           kind == SymbolKind::Signal;
  }
};

}  // namespace cobot_command::rapid
