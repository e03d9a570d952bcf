// Types and initial values of data, of modules and of routines.
#pragma once

#include "expressions/expression_check.h"

namespace cobot_command::rapid {

class DataDeclaration {
 public:
  explicit DataDeclaration(ExpressionCheck& expressions)
      : expressions_(expressions), file_(expressions.file()), draft_(file_.draft()) {}

  /// Gives the symbol of a Data its type and value. Precondition: what its value names is declared already,
  /// if it can be. Reports E307 to E309, E312, E325, E326, and what expressions report.
  void declare(SymbolIndex data, bool is_of_system_module);

 private:
  TypeIndex withDimensions(TypeIndex element, NodeIndex data);
  void initialValue(NodeIndex data, SymbolIndex symbol, bool is_of_system_module);
  [[nodiscard]] NodeIndex firstNoLiteral(NodeIndex node, bool may_be_predefined) const;
  [[nodiscard]] NodeIndex firstNotConstant(NodeIndex node) const;
  [[nodiscard]] bool isConstantLeaf(NodeIndex node) const;

  ExpressionCheck& expressions_;
  FileDraft& file_;
  Draft& draft_;
};

}  // namespace cobot_command::rapid
