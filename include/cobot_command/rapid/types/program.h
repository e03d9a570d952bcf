// A program whose names are bound: all modules of a task, with the meaning of each node of their trees.
//
//   for (const NodeIndex node : tree.children(call)) program.typeAt(file, node) ...
//
// A code generator walks the trees and looks no name up. Programs are made by rapid/checks, and never change.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/source.h"
#include "cobot_command/rapid/types/cells.h"
#include "cobot_command/rapid/types/signal.h"
#include "cobot_command/rapid/types/symbol.h"
#include "cobot_command/rapid/types/type_table.h"

namespace cobot_command::rapid {

inline constexpr std::size_t kMostModules = 64;  ///< of a program, predefined ones not counted

/// What a node stands for. Of an Operation: the type of its chain up to it. A value that a node does not
/// have, or that an error leaves open, is missing.
struct Meaning {
  /// Of a declaration, For, Label, Goto, Connect (the trap), Call, Function, Reference: the symbol of its
  /// name. Of an Argument: the parameter. Of a Part: the position of the component in its record.
  SymbolIndex symbol = kNoSymbol;
  /// Of an expression, Index, Part: its type; that of an aggregate is what it is used as. A signaldi,
  /// signalgi or signalai is read where a num is needed.
  TypeIndex type = kNoType;
  /// Of an expression: its value, if it is constant.
  ConstantIndex constant = kNoConstant;
};

struct ProgramFile {
  std::shared_ptr<const Source> source;
  std::vector<Meaning> meanings;  ///< by NodeIndex
};

/// Names in small letters. The texts belong to the sources. An ordered map: a hash table is slow with names
/// that were chosen for it.
using NameMap = std::map<std::string_view, SymbolIndex>;

/// kNoSymbol if it is not there.
[[nodiscard]] SymbolIndex foundIn(const NameMap& names, std::string_view folded);

/// The names of a program. Those of types have a space of their own: data may have the name of a predefined
/// type.
struct NameSpace {
  NameMap predefined;
  NameMap globals;                         ///< of all modules
  std::map<SymbolIndex, NameMap> modules;  ///< of each module: all that it declares

  /// What a name means in a module: its own names hide global ones, these predefined ones.
  [[nodiscard]] SymbolIndex find(SymbolIndex module, std::string_view folded) const;
  /// What the module itself declares.
  [[nodiscard]] SymbolIndex inModule(SymbolIndex module, std::string_view folded) const;
};

/// From what a Program is made.
struct ProgramParts {
  std::vector<ProgramFile> files;
  TypeTable types;
  std::vector<Symbol> symbols;
  std::vector<Cell> constants;
  std::shared_ptr<const std::vector<Signal>> signals;
  NameSpace names;  ///< of routines, data, signals and modules, not of types
  SymbolIndex main = kNoSymbol;
};

class Program {
 public:
  explicit Program(ProgramParts parts) : parts_(std::move(parts)) {}

  /// The predefined modules come first: kPredefinedFiles.
  [[nodiscard]] std::size_t files() const { return parts_.files.size(); }
  [[nodiscard]] const Source& source(FileIndex file) const { return *parts_.files[file].source; }
  [[nodiscard]] const TypeTable& types() const { return parts_.types; }
  [[nodiscard]] std::size_t symbols() const { return parts_.symbols.size(); }
  [[nodiscard]] const Symbol& symbol(SymbolIndex symbol) const { return parts_.symbols[symbol]; }
  [[nodiscard]] const std::vector<Signal>& signals() const { return *parts_.signals; }
  /// kNoSymbol if the modules are a library.
  [[nodiscard]] SymbolIndex main() const { return parts_.main; }

  [[nodiscard]] const Meaning& at(FileIndex file, NodeIndex node) const {
    return parts_.files[file].meanings[node];
  }
  /// The value of a constant expression: as many cells as its type has; nullptr if it is not constant.
  [[nodiscard]] const Cell* constantAt(FileIndex file, NodeIndex node) const {
    return cellsAt(at(file, node).constant);
  }
  /// The value of a CONST, the initial value of a VAR or PERS; nullptr: see Symbol::value.
  [[nodiscard]] const Cell* valueOf(const Symbol& symbol) const { return cellsAt(symbol.value); }

  /// The argument of each parameter of a Call or Function whose routine is bound: an expression or, of an
  /// argument with a name, the Argument; kNoNode for one that is not given.
  [[nodiscard]] std::vector<NodeIndex> argumentsOf(FileIndex file, NodeIndex call) const;

  /// What a name means in a module, outside of its routines: for names that are known only at run time.
  /// `folded`: in small letters. kNoSymbol if there is none.
  [[nodiscard]] SymbolIndex find(SymbolIndex module, std::string_view folded) const {
    return parts_.names.find(module, folded);
  }

 private:
  [[nodiscard]] const Cell* cellsAt(ConstantIndex place) const {
    return place == kNoConstant ? nullptr : parts_.constants.data() + place;
  }

  ProgramParts parts_;
};

/// Files of a Program that are built in: predefinedData() and catalogue().
inline constexpr FileIndex kPredefinedFiles = 2;

}  // namespace cobot_command::rapid
