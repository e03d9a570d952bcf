// Instructions that have no list of instructions in them.
#pragma once

#include "parser/child_list.h"
#include "parser/cursor.h"
#include "parser/expression_parser.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

class InstructionParser {
 public:
  InstructionParser(Cursor& cursor, Tree& tree, ExpressionParser& expressions)
      : cursor_(cursor), tree_(tree), expressions_(expressions) {}

  /// True if an instruction, also one with a list, can begin with this token.
  [[nodiscard]] static bool canBegin(TokenKind kind);
  /// An instruction up to its `;`. After a syntax error it is faulty, and the cursor is where reading
  /// continues. Precondition: one can begin here, and it is none of IF, FOR, WHILE and TEST.
  [[nodiscard]] NodeIndex instruction();

 private:
  NodeIndex open(NodeKind kind);
  bool read(NodeIndex node, ChildList& children);
  bool assignment(ChildList& children);
  bool call(NodeIndex node, ChildList& children);
  bool lateCall(ChildList& children);
  bool connect(NodeIndex node, ChildList& children);
  bool placeholder();
  [[nodiscard]] bool hasBracketsOfCall() const;
  bool callInBrackets(ChildList& children);
  [[nodiscard]] NodeKind kindHere() const;
  [[nodiscard]] NodeKind kindOfName() const;

  Cursor& cursor_;
  Tree& tree_;
  ExpressionParser& expressions_;
};

}  // namespace cobot_command::rapid
