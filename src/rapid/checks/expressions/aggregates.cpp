// Aggregates: [1,2,3] of a record or an array.
#include <algorithm>
#include <cmath>

#include "expressions/expression_check.h"
#include <fmt/format.h>

namespace cobot_command::rapid {

namespace {

constexpr std::uint32_t kConfdataParts = 4;

std::uint32_t count(const Tree& tree, NodeIndex node) {
  std::uint32_t children = 0;
  for (NodeIndex at = tree[node].child; at != kNoNode; at = tree[at].next) ++children;
  return children;
}

std::uint32_t partsOf(const Type& type) {
  return type.kind == TypeKind::Record ? static_cast<std::uint32_t>(type.components.size())
                                       : type.sizes.front();
}

}  // namespace

Typed ExpressionCheck::aggregate(NodeIndex node, TypeIndex context) {
  if (context == kNoContext || context == kAnytype) {
    file_.report(kinds::kUntypedAggregate, file_[node].first);
    return leaveOpen(node);
  }
  if (context == kNoType) return leaveOpen(node);
  const TypeKind kind = draft_.types()[context].kind;
  if (kind != TypeKind::Record && kind != TypeKind::Array) {
    file_.report(kinds::kWrongType, file_[node].first, file_.typeName(context), "an aggregate");
    return leaveOpen(node);
  }
  const TypeIndex type = draft_.types().isConformant(context) ? sizedBy(node, context) : context;
  const std::uint32_t given = count(file_.tree(), node);
  const std::uint32_t wanted = partsOf(draft_.types()[type]);
  const bool is_old_confdata = type == draft_.known.confdata && given + 1 == kConfdataParts;
  if (is_old_confdata) {
    file_.report(kinds::kThreePartConfdata, file_[node].first);
  } else if (given != wanted) {
    file_.report(kinds::kParts, file_[node].first, file_.typeName(type), wanted, given);
    return leaveOpen(node);
  }
  return parts(node, type, given);
}

/// Only the names in it are bound.
Typed ExpressionCheck::leaveOpen(NodeIndex aggregate) {
  for (const NodeIndex child : file_.tree().children(aggregate)) check(child, kNoType);
  return {};
}

TypeIndex ExpressionCheck::partType(TypeIndex type, std::uint32_t position) {
  const Type& at = draft_.types()[type];
  if (at.kind == TypeKind::Record) return at.components[position].type;
  if (at.dimensions == 1) return at.element;
  return draft_.parts.types.arrayOf(at.element, static_cast<std::uint8_t>(at.dimensions - 1),
                                    {at.sizes[1], at.sizes[2], 0});
}

/// The array that an aggregate is, where a parameter leaves the sizes open.
TypeIndex ExpressionCheck::sizedBy(NodeIndex aggregate, TypeIndex conformant) {
  const Type array = draft_.types()[conformant];
  Dimensions sizes{};
  NodeIndex at = aggregate;
  for (std::size_t i = 0; i < array.dimensions; ++i) {
    const bool is_aggregate = at != kNoNode && file_[at].kind == NodeKind::Aggregate;
    sizes.at(i) = is_aggregate ? count(file_.tree(), at) : 1;
    at = is_aggregate ? file_[at].child : kNoNode;
  }
  return draft_.parts.types.arrayOf(array.element, array.dimensions, sizes);
}

Typed ExpressionCheck::parts(NodeIndex node, TypeIndex type, std::uint32_t count) {
  const std::uint32_t cells = draft_.types()[type].cells;
  // Of an array all parts have one type.
  const bool is_array = draft_.types()[type].kind == TypeKind::Array;
  const TypeIndex element = is_array ? partType(type, 0) : kNoType;
  bool is_constant = true;
  std::uint32_t position = 0;
  for (const NodeIndex child : file_.tree().children(node)) {
    const Typed part = expect(child, is_array ? element : partType(type, position));
    is_constant = is_constant && part.constant != kNoConstant;
    ++position;
  }
  if (!is_constant || cells == 0) return {type, kNoConstant};
  const bool has_no_cfx = type == draft_.known.confdata && count < kConfdataParts;
  const ConstantIndex constant = joined(node, cells, has_no_cfx ? draft_.reserve(1) : kNoConstant);
  if (type == draft_.known.orient && constant != kNoConstant) checkQuaternion(node, constant);
  return {type, constant};
}

/// The value of an aggregate whose parts are constant. Literals follow each other already, and `last`, if
/// there is such a cell, follows them.
ConstantIndex ExpressionCheck::joined(NodeIndex aggregate, std::uint32_t cells, ConstantIndex last) {
  const Tree& tree = file_.tree();
  const ConstantIndex first = file_.at(tree[aggregate].child).constant;
  ConstantIndex next = first;
  bool is_joined = true;
  for (const NodeIndex child : tree.children(aggregate)) {
    const Meaning& part = file_.at(child);
    is_joined = is_joined && part.constant == next;
    next += draft_.types()[part.type].cells;
  }
  if (is_joined && (next == first + cells || next == last)) return first;
  ConstantIndex place = draft_.reserve(cells);
  if (place == kNoConstant) return kNoConstant;
  Cell* target = draft_.cells(place);
  for (const NodeIndex child : tree.children(aggregate)) {
    const Meaning& part = file_.at(child);
    const std::uint32_t size = draft_.types()[part.type].cells;
    std::copy_n(draft_.cells(part.constant), size, target);
    target += size;
  }
  return place;
}

void ExpressionCheck::checkQuaternion(NodeIndex node, ConstantIndex constant) {
  constexpr float kExact = 0.001F;
  constexpr float kMost = 0.01F;
  double squares = 0;
  for (int i = 0; i < 4; ++i) {
    const double part = draft_.cells(constant)[i];
    squares += part * part;
  }
  const double length = std::sqrt(squares);
  const double off = std::abs(length - 1);
  if (off <= kExact) return;
  file_.report(off <= kMost ? kinds::kQuaternionOff : kinds::kNoQuaternion, file_[node].first,
               fmt::format("{:.6g}", length));
}

}  // namespace cobot_command::rapid
