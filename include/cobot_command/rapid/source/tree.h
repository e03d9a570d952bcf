// The tree of a source text: nodes in one vector, linked by indices.
//
// A node refers to tokens only; Source::textOf() returns their text. The depth is bounded by kMostNesting,
// not by the length of the text: operators of one rank are one node with many operands. So recursion over a
// tree needs a bounded stack.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "cobot_command/rapid/source/token.h"

namespace cobot_command::rapid {

/// The comment of each kind has its children in their order: `?` at most one, `*` any number. EXPR is any
/// kind of the last group, LIST is List. `name` and `word` are those of the Node.
enum class NodeKind : std::uint8_t {
  File,       ///< (Header | Module)*
  Header,     ///< `%%% VERSION:1 LANGUAGE:ENGLISH %%%`
  Module,     ///< Attribute* (Record | Alias | Data | Routine | Placeholder | Unread)*; name
  Attribute,  ///< word: Sysmodule, Noview, Nostepin, Viewonly or Readonly

  // Declarations. Local where LOCAL is before it.
  Record,     ///< Component*; name
  Component,  ///< TypeName; name
  Alias,      ///< TypeName; name
  Data,       ///< TypeName Dimensions? EXPR? (the value); name; word: Var, Pers or Const; Task
  Routine,  ///< TypeName? (of a FUNC) Parameters? (not of a TRAP) LIST Handler*; name; word: Proc, Func, Trap
  Parameters,    ///< (Parameter | Placeholder)*
  Parameter,     ///< TypeName Dimensions?; name; word: Inout, Var, Pers, or Name for none; Optional;
                 ///< Excludes
  Handler,       ///< ErrorNumbers? LIST; word: Backward, Error or Undo
  ErrorNumbers,  ///< EXPR*; of ERROR (n,m)
  TypeName,      ///< name
  Dimensions,    ///< EXPR*; of a parameter Star*

  // Instructions, in a List. Data is in one too: at its beginning, if the text has no E205.
  List,
  Assignment,   ///< Reference EXPR
  Call,         ///< (EXPR | Argument)*; name: of the procedure
  LateCall,     ///< EXPR (EXPR | Argument)*; the name is the value of the first one
  Label,        ///< name
  If,           ///< EXPR LIST Elseif* Else?
  Elseif,       ///< EXPR LIST
  Else,         ///< LIST
  CompactIf,    ///< EXPR, and an instruction; without the latter only if Faulty
  For,          ///< EXPR (from) EXPR (to) Step? LIST; name: the counter
  Step,         ///< EXPR
  While,        ///< EXPR LIST
  Test,         ///< EXPR (Case | DefaultCase)*
  Case,         ///< EXPR* LIST
  DefaultCase,  ///< LIST
  Goto,         ///< name
  Return,       ///< EXPR?
  Raise,        ///< EXPR?
  Retry,
  Trynext,
  Exit,
  Connect,  ///< Reference; name: of the trap
  Unread,   ///< text in which nothing was recognized; Faulty

  // Parts of expressions and calls.
  Argument,   ///< EXPR?; name; an argument with a name. One without is the EXPR itself. See Optional
  Operation,  ///< EXPR; word: the operator before it. Part of a Chain
  Index,      ///< EXPR*; `{1,2}` of a Reference
  Part,       ///< name; `.x` of a Reference

  // Expressions.
  Number,
  String,
  Bool,         ///< word: True or False
  Reference,    ///< (Index | Part)*; name; data, or anything else with a name
  Function,     ///< (EXPR | Argument)*; name
  Aggregate,    ///< EXPR*
  Parentheses,  ///< EXPR
  Sign,         ///< EXPR; word: Plus or Minus
  Not,          ///< EXPR; a whole AND chain if NOT is at its beginning, otherwise one relation
  Chain,        ///< EXPR Operation Operation*; operators of one rank, grouped from the left
  Star,         ///< `*`
  Placeholder,  ///< also a declaration, an instruction or a parameter
};

using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = std::numeric_limits<NodeIndex>::max();

struct Node {
  enum Flag : std::uint8_t {
    /// An error in it (1xx, 2xx, other than E102 E105 E107 E203 E205): no finding of its meaning should be
    /// reported. Of an instruction with a list: an error in what is before and between its lists.
    Faulty = 1,
    Local = 2,
    Task = 4,
    Optional = 8,      ///< a Parameter or an Argument after a backslash
    Excludes = 16,     ///< a Parameter after `|`: at most one of it and the one before it is given
    Conditional = 32,  ///< an optional Argument `\name?parameter`; its child is the Reference `parameter`
  };

  NodeKind kind = NodeKind::File;
  std::uint8_t flags = 0;
  TokenKind word = TokenKind::End;  ///< where NodeKind names one
  TokenIndex first = kNoToken;      ///< its first token
  TokenIndex last = kNoToken;       ///< its last token; for nodes without tokens the one before first
  TokenIndex name = kNoToken;       ///< where NodeKind names one; kNoToken if it is missing in the text
  NodeIndex child = kNoNode;        ///< the first child
  NodeIndex next = kNoNode;         ///< the next child of its parent

  [[nodiscard]] bool has(Flag flag) const { return (flags & flag) != 0; }
};
static_assert(sizeof(Node) == 24);

[[nodiscard]] constexpr bool isExpression(NodeKind kind) {
  return kind >= NodeKind::Number;
}

/// A List, and what has lists or an instruction: a block, a branch of one, a compact IF.
[[nodiscard]] constexpr bool containsInstructions(NodeKind kind) {
  switch (kind) {
    case NodeKind::List:
    case NodeKind::If:
    case NodeKind::Elseif:
    case NodeKind::Else:
    case NodeKind::CompactIf:
    case NodeKind::For:
    case NodeKind::While:
    case NodeKind::Test:
    case NodeKind::Case:
    case NodeKind::DefaultCase:
      return true;
    default:
      return false;
  }
}

class Tree {
 public:
  /// Index of the File, which each tree has.
  static constexpr NodeIndex kRoot = 0;

  /// For `for (NodeIndex child : tree.children(node))`.
  class Children {
   public:
    class Iterator {
     public:
      Iterator(const Tree& tree, NodeIndex node) : tree_(&tree), node_(node) {}
      NodeIndex operator*() const { return node_; }
      Iterator& operator++() {
        node_ = (*tree_)[node_].next;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return node_ != other.node_; }

     private:
      const Tree* tree_;
      NodeIndex node_;
    };

    Children(const Tree& tree, NodeIndex first) : tree_(tree), first_(first) {}
    [[nodiscard]] Iterator begin() const { return {tree_, first_}; }
    [[nodiscard]] Iterator end() const { return {tree_, kNoNode}; }

   private:
    const Tree& tree_;
    NodeIndex first_;
  };

  [[nodiscard]] const Node& operator[](NodeIndex node) const { return nodes_[node]; }
  [[nodiscard]] Node& operator[](NodeIndex node) { return nodes_[node]; }
  [[nodiscard]] Children children(NodeIndex node) const { return {*this, nodes_[node].child}; }
  /// The first child of a kind; kNoNode if there is none.
  [[nodiscard]] NodeIndex childOf(NodeIndex node, NodeKind kind) const;
  /// The value of a Data, of a Return, of an Argument ...: the first child that is an expression.
  [[nodiscard]] NodeIndex expressionOf(NodeIndex node) const;
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  /// Adds a node without parent. References to nodes become invalid.
  NodeIndex add(const Node& node) {
    nodes_.push_back(node);
    return static_cast<NodeIndex>(nodes_.size() - 1);
  }
  void reserve(std::size_t nodes) { nodes_.reserve(nodes); }

 private:
  std::vector<Node> nodes_;
};

}  // namespace cobot_command::rapid
