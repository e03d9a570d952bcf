// Finds the declaration of a name as a program sees it: in its routine, its module, the other modules of the
// file, and what is predefined.
#pragma once

#include "printer/scope.h"

#include "cobot_command/rapid/source/predefined_names.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

/// Has the declarations that are visible at one place of a walk over the tree.
class Declarations {
 public:
  Declarations(const Source& source, const PredefinedNames& predefined);

  void enterModule(NodeIndex module);
  void enterRoutine(NodeIndex routine);
  /// The counter of a FOR; returns what it hides. leaveFor() restores it.
  [[nodiscard]] NodeIndex enterFor(NodeIndex loop);
  void leaveFor(NodeIndex loop, NodeIndex hidden);

  // Each returns an empty DeclaredName if nothing has this name. `name`: a token.
  [[nodiscard]] DeclaredName find(TokenIndex name) const;
  [[nodiscard]] DeclaredName findType(TokenIndex name) const;
  [[nodiscard]] DeclaredName findLabel(TokenIndex name) const;
  /// A parameter of a routine, or a component of a record, that has the name of a token of the source.
  [[nodiscard]] DeclaredName findPart(const DeclaredName& whole, TokenIndex name) const;
  /// The record that is the type of data, of a parameter or of a component; empty if it is none.
  [[nodiscard]] DeclaredName recordOf(const DeclaredName& data) const;

 private:
  void declare(Scope& names, Scope& types, NodeIndex node);
  void declareList(NodeIndex list);
  [[nodiscard]] DeclaredName declared(NodeIndex node) const;
  [[nodiscard]] bool isName(TokenIndex token) const;
  [[nodiscard]] NameIndex nameOf(TokenIndex token) const { return source_.tokens()[token].name; }
  [[nodiscard]] DeclaredName typeOf(const DeclaredName& data) const;

  const Source& source_;
  const PredefinedNames& predefined_;
  Scope file_;
  Scope file_types_;
  Scope module_;
  Scope module_types_;
  Scope routine_;
  Scope labels_;
};

}  // namespace cobot_command::rapid
