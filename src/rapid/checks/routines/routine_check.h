// The instructions of routines.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "data_declaration.h"
#include "expressions/call_check.h"
#include "expressions/expression_check.h"
#include "routines/flow.h"
#include "routines/routine_scope.h"

namespace cobot_command::rapid {

class RoutineCheck {
 public:
  RoutineCheck(FileDraft& file, Names& names)
      : file_(file),
        draft_(file.draft()),
        names_(names),
        expressions_(file, names),
        calls_(expressions_),
        data_(expressions_),
        scope_(file, names) {}

  /// Checks the body and the handlers of a routine.
  void check(SymbolIndex routine);

 private:
  void handler(NodeIndex node);
  void list(NodeIndex node);
  void instruction(NodeIndex node);
  void simpleInstruction(NodeIndex node);
  void mark(NodeIndex node);

  void ifInstruction(NodeIndex node);
  void branch(NodeIndex node, Reach before, Reach& after);
  void forInstruction(NodeIndex node);
  void bounds(NodeIndex node);
  void whileInstruction(NodeIndex node);
  void testInstruction(NodeIndex node);
  void caseValue(NodeIndex node, TypeIndex type, std::set<std::string>& earlier);

  void assignment(NodeIndex node);
  void call(NodeIndex node);
  [[nodiscard]] bool isPassedOver(TokenIndex name);
  void procedure(NodeIndex node, SymbolIndex found);
  void lateCall(NodeIndex node);
  void connect(NodeIndex node);
  void returnInstruction(NodeIndex node);
  void raise(NodeIndex node);
  void requireHandler(NodeIndex node);

  FileDraft& file_;
  Draft& draft_;
  Names& names_;
  ExpressionCheck expressions_;
  CallCheck calls_;
  DataDeclaration data_;
  RoutineScope scope_;
  SymbolIndex routine_ = kNoSymbol;
  TokenKind handler_ = TokenKind::End;  // Error, Backward or Undo in one of these
  bool has_error_handler_ = false;
  bool is_uncertain_ = false;  // text that was not read may end the routine
  Reach reach_ = Reach::Open;
  std::vector<NodeIndex> blocks_;
};

}  // namespace cobot_command::rapid
