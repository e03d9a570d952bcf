// Lists of instructions, and the instructions that have lists in them.
#pragma once

#include "parser/child_list.h"
#include "parser/cursor.h"
#include "parser/declaration_parser.h"
#include "parser/expression_parser.h"
#include "parser/instruction_parser.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

/// Words that end a list are left to the caller. Those of a block count only while such a block is open: any
/// other one is E204.
class ListParser {
 public:
  ListParser(Cursor& cursor, Tree& tree, ExpressionParser& expressions, DeclarationParser& declarations)
      : cursor_(cursor),
        tree_(tree),
        expressions_(expressions),
        declarations_(declarations),
        instructions_(cursor, tree, expressions) {}

  /// Of a routine: declarations, then instructions.
  [[nodiscard]] NodeIndex body() { return list(true); }
  /// Of a handler: instructions alone.
  [[nodiscard]] NodeIndex handler() { return list(false); }
  /// At BACKWARD, ERROR, UNDO, and in s4c at a name UNDO on a line of its own.
  [[nodiscard]] bool isHandler() const;
  /// True if the routine was left because it is nested too deeply: its end was skipped to, and blocks in it
  /// are not reported as open. Resets it.
  [[nodiscard]] bool takeAbandoned();

 private:
  NodeIndex list(bool has_declarations);
  void item(ChildList& list, bool& has_declarations);
  void declaration(ChildList& list, bool may_be_here);
  void strayWord();
  void nothing(ChildList& list);
  NodeIndex instruction();
  NodeIndex nestedInstruction();
  NodeIndex ifInstruction();
  void compactIf(NodeIndex node, ChildList& parts);
  void ifBlocks(NodeIndex node, ChildList& parts);
  NodeIndex elseifBranch();
  NodeIndex elseBranch();
  NodeIndex forInstruction();
  bool forHeader(NodeIndex node, ChildList& parts);
  NodeIndex whileInstruction();
  NodeIndex testInstruction();
  void testItem(ChildList& parts, bool& has_default);
  NodeIndex caseBranch();
  bool caseValues(ChildList& parts);
  NodeIndex defaultBranch();

  [[nodiscard]] bool endsList() const;
  bool condition(ChildList& parts);
  void endHeader(NodeIndex node, bool is_read, TokenKind terminator);
  void endBlock(NodeIndex node, TokenKind opening, TokenKind closing);
  void markFaulty(NodeIndex node);

  Cursor& cursor_;
  Tree& tree_;
  ExpressionParser& expressions_;
  DeclarationParser& declarations_;
  InstructionParser instructions_;
  int depth_ = 0;
  bool is_abandoned_ = false;
  // How many are open.
  int ifs_ = 0;
  int fors_ = 0;
  int whiles_ = 0;
  int tests_ = 0;
};

}  // namespace cobot_command::rapid
