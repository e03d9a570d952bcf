// Instructions with lists: IF, FOR, WHILE, TEST.
#include <cmath>

#include "routines/routine_check.h"

namespace cobot_command::rapid {

/// A list, or a part with a list: the branch begins where the instruction does.
void RoutineCheck::branch(NodeIndex node, Reach before, Reach& after) {
  reach_ = before;
  if (file_[node].kind == NodeKind::List) {
    list(node);
  } else {
    const NodeIndex inner = file_.tree().childOf(node, NodeKind::List);
    if (inner != kNoNode) list(inner);
  }
  after = meet(after, reach_);
}

/// Also the compact form, whose second part is an instruction.
void RoutineCheck::ifInstruction(NodeIndex node) {
  const Reach before = reach_;
  Reach after = closed(before);
  bool has_else = false;
  for (const NodeIndex child : file_.tree().children(node)) {
    const Node& at = file_[child];
    if (isExpression(at.kind) && child == file_[node].child) {
      if (!file_[node].has(Node::Faulty)) expressions_.condition(child);
    } else if (file_[node].kind == NodeKind::CompactIf) {
      reach_ = before;
      instruction(child);
      after = meet(after, reach_);
    } else {
      has_else = has_else || at.kind == NodeKind::Else;
      const bool is_condition = at.kind == NodeKind::Elseif && !at.has(Node::Faulty) && at.child != kNoNode;
      if (is_condition && isExpression(file_[at.child].kind)) expressions_.condition(at.child);
      branch(child, before, after);
    }
  }
  reach_ = has_else ? after : meet(after, before);
}

void RoutineCheck::forInstruction(NodeIndex node) {
  const Reach before = reach_;
  if (!file_[node].has(Node::Faulty)) bounds(node);
  const NodeIndex body = file_.tree().childOf(node, NodeKind::List);
  const TokenIndex name = file_[node].name;
  if (file_.isName(name)) {
    Symbol counter = file_.symbolOf(SymbolKind::Counter, node, routine_);
    counter.flags = Symbol::ReadOnly;
    counter.type = kNum;
    const SymbolIndex hidden = names_.set(file_.nameAt(name), file_.declare(counter));
    if (body != kNoNode) list(body);
    names_.set(file_.nameAt(name), hidden);
  } else if (body != kNoNode) {
    list(body);
  }
  reach_ = before;
}

/// From, to and step.
void RoutineCheck::bounds(NodeIndex node) {
  bool has_fraction = false;
  for (const NodeIndex child : file_.tree().children(node)) {
    const bool is_step = file_[child].kind == NodeKind::Step;
    const NodeIndex bound = is_step ? file_[child].child : child;
    if (bound == kNoNode || !isExpression(file_[bound].kind)) continue;
    const Typed typed = expressions_.expect(bound, kNum);
    const Cell* const value = typed.type == kNum ? expressions_.valueOf(typed) : nullptr;
    if (value == nullptr) continue;
    if (is_step && *value == 0) file_.reportNode(kinds::kStepZero, bound);
    const bool is_first_fraction = *value != std::trunc(*value) && !has_fraction;
    if (is_first_fraction) file_.reportNode(kinds::kStepNotWhole, bound);
    has_fraction = has_fraction || is_first_fraction;
  }
}

void RoutineCheck::whileInstruction(NodeIndex node) {
  const Reach before = reach_;
  bool is_endless = false;
  for (const NodeIndex child : file_.tree().children(node)) {
    if (file_[child].kind == NodeKind::List) {
      list(child);
    } else if (!file_[node].has(Node::Faulty)) {
      expressions_.condition(child);
      const Meaning& meaning = file_.at(child);
      is_endless =
          meaning.type == kBool && meaning.constant != kNoConstant && isTrue(*draft_.cells(meaning.constant));
    }
  }
  reach_ = is_endless ? closed(before) : before;
}

void RoutineCheck::testInstruction(NodeIndex node) {
  const Reach before = reach_;
  Reach after = closed(before);
  TypeIndex type = kNoType;
  bool has_default = false;
  std::set<std::string> values;
  for (const NodeIndex child : file_.tree().children(node)) {
    const Node& at = file_[child];
    if (at.kind == NodeKind::Case || at.kind == NodeKind::DefaultCase) {
      has_default = at.kind == NodeKind::DefaultCase;  // nothing may follow it (E615)
      for (const NodeIndex value : file_.tree().children(child)) {
        if (!at.has(Node::Faulty) && isExpression(file_[value].kind)) caseValue(value, type, values);
      }
      branch(child, before, after);
    } else if (isExpression(at.kind) && child == file_[node].child && !file_[node].has(Node::Faulty)) {
      type = expressions_.check(child).type;
      const Type& tested = draft_.types()[type];
      if (!tested.has_values) file_.reportNode(kinds::kNoValues, child, file_.typeName(type));
      if (!tested.has_values) type = kNoType;
      if (tested.kind == TypeKind::SemiValue) type = kNum;
    }
  }
  reach_ = has_default ? after : meet(after, before);
}

void RoutineCheck::caseValue(NodeIndex node, TypeIndex type, std::set<std::string>& earlier) {
  const Typed typed = expressions_.expect(node, type);
  const Cell* const value = expressions_.valueOf(typed);
  if (value == nullptr || typed.type != type) return;
  const std::size_t bytes = draft_.types()[type].cells * sizeof(Cell);
  const bool is_new = earlier.emplace(reinterpret_cast<const char*>(value), bytes).second;
  if (!is_new) file_.reportNode(kinds::kEarlierCase, node);
}

}  // namespace cobot_command::rapid
