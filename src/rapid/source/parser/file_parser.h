// Files, modules and routines.
#pragma once

#include "parser/child_list.h"
#include "parser/cursor.h"
#include "parser/declaration_parser.h"
#include "parser/expression_parser.h"
#include "parser/list_parser.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

class FileParser {
 public:
  /// `has_bodies`: see ReadOptions. Both references must live as long as the parser.
  FileParser(Cursor& cursor, Tree& tree, bool has_bodies)
      : cursor_(cursor),
        tree_(tree),
        has_bodies_(has_bodies),
        expressions_(cursor, tree),
        declarations_(cursor, tree, expressions_),
        lists_(cursor, tree, expressions_, declarations_) {}

  /// The whole file. Its node becomes the root.
  void file();

 private:
  NodeIndex header();
  bool headerWords();
  void outside();
  NodeIndex module();
  void attributes(ChildList& module);
  bool attribute(ChildList& module, unsigned& seen);
  void items(ChildList& module);
  void item(ChildList& module, bool& has_routine);
  void declaration(ChildList& module, Prefix prefix, bool is_late);
  void stray();
  NodeIndex routine(Prefix prefix);
  bool routineHeader(NodeIndex node, ChildList& parts);
  void handlers(ChildList& parts, TokenKind routine);
  NodeIndex handler();
  void errorNumbers(ChildList& parts, TokenIndex word);
  void endRoutine(TokenIndex opening, TokenKind closing);

  Cursor& cursor_;
  Tree& tree_;
  bool has_bodies_;
  ExpressionParser expressions_;
  DeclarationParser declarations_;
  ListParser lists_;
};

}  // namespace cobot_command::rapid
