// Declarations of data, types and parameters.
#pragma once

#include "parser/child_list.h"
#include "parser/cursor.h"
#include "parser/expression_parser.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

/// LOCAL and TASK before a declaration.
struct Prefix {
  TokenIndex first = kNoToken;  ///< the first token of the declaration
  std::uint8_t flags = 0;       ///< Node::Local, Task
};

/// Each function reports syntax errors, continues after them, and returns a node: what has a name is
/// declared.
class DeclarationParser {
 public:
  DeclarationParser(Cursor& cursor, Tree& tree, ExpressionParser& expressions)
      : cursor_(cursor), tree_(tree), expressions_(expressions) {}

  /// True at VAR, PERS, CONST and TASK.
  [[nodiscard]] bool isData() const;
  /// True at RECORD and ALIAS.
  [[nodiscard]] bool isType() const;
  [[nodiscard]] NodeIndex data(Prefix prefix);
  [[nodiscard]] NodeIndex type(Prefix prefix);
  /// From `(` to `)`. Adds nothing after an error at the beginning; false after any error.
  [[nodiscard]] bool parameters(ChildList& routine);
  /// The type of a FUNC; kNoNode after a finding.
  [[nodiscard]] NodeIndex typeName();

 private:
  NodeIndex open(NodeKind kind, Prefix prefix);
  void close(NodeIndex declaration, bool is_read);
  bool typeAndName(NodeIndex declaration, ChildList& children);
  bool dataParts(NodeIndex data, ChildList& children);
  bool hasValue();
  void checkValue(NodeIndex data);
  NodeIndex record(Prefix prefix);
  NodeIndex component();
  NodeIndex alias(Prefix prefix);
  bool parameterGroup(ChildList& parameters);
  bool parameter(ChildList& parameters, std::uint8_t flags);
  bool parameterDimensions(ChildList& parameter);

  Cursor& cursor_;
  Tree& tree_;
  ExpressionParser& expressions_;
};

}  // namespace cobot_command::rapid
