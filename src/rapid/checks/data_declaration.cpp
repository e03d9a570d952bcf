#include "data_declaration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "type_reference.h"

namespace cobot_command::rapid {

namespace {

/// Predefined functions whose result depends on their arguments alone: constants may call them, in irc5.
constexpr std::array<std::string_view, 31> kPureFunctions{
    "Offs",     "RelTool", "PoseMult", "PoseInv",  "PoseVect", "DefFrame", "OrientZYX", "EulerZYX",
    "Distance", "Abs",     "Sqrt",     "Exp",      "Pow",      "Sin",      "Cos",       "Tan",
    "ASin",     "ACos",    "ATan",     "ATan2",    "Round",    "Trunc",    "NumToStr",  "ValToStr",
    "StrLen",   "StrPart", "StrFind",  "StrMatch", "StrMemb",  "StrMap",   "StrOrder"};

bool isLiteral(NodeKind kind) {
  return kind == NodeKind::Number || kind == NodeKind::String || kind == NodeKind::Bool ||
         kind == NodeKind::Placeholder;
}

}  // namespace

void DataDeclaration::declare(SymbolIndex data, bool is_of_system_module) {
  const NodeIndex node = draft_.symbol(data).node;
  const TypeIndex type = withDimensions(typeOfData(file_, expressions_.names(), node), node);
  draft_.symbol(data).type = type;
  draft_.ready[data] = 1;
  const bool fits = draft_.takeData(draft_.types()[type].cells);
  if (!fits) file_.reportTooLarge(file_[node].name);
  if (!file_[node].has(Node::Faulty)) initialValue(node, data, is_of_system_module);
}

TypeIndex DataDeclaration::withDimensions(TypeIndex element, NodeIndex data) {
  const NodeIndex node = file_.tree().childOf(data, NodeKind::Dimensions);
  if (node == kNoNode || file_[data].has(Node::Faulty)) return node == kNoNode ? element : kNoType;
  Dimensions sizes{};
  std::uint64_t elements = 1;
  std::uint8_t dimensions = 0;
  for (const NodeIndex child : file_.tree().children(node)) {
    if (dimensions == kMostDimensions) {
      file_.reportNode(kinds::kThreeDimensions, child);
      return kNoType;
    }
    const std::uint64_t errors = file_.errors();
    const Typed typed = expressions_.check(child);
    const Cell* const size = typed.type == kNum ? expressions_.valueOf(typed) : nullptr;
    const bool is_size = size != nullptr && *size >= 1 && *size == std::trunc(*size);
    const bool is_open = errors != file_.errors() || draft_.is_too_large;  // then nothing is folded
    if (!is_size && !is_open) file_.reportNode(kinds::kDimension, child);
    if (!is_size) return kNoType;
    sizes.at(dimensions++) = static_cast<std::uint32_t>(std::min(*size, 1E9F));
    elements *= sizes.at(dimensions - 1U);
    if (elements > kMostElements) {
      file_.reportNode(kinds::kLargeArray, child, kMostElements);
      return kNoType;
    }
  }
  return element == kNoType ? kNoType : draft_.parts.types.arrayOf(element, dimensions, sizes);
}

void DataDeclaration::initialValue(NodeIndex data, SymbolIndex symbol, bool is_of_system_module) {
  const NodeIndex value = file_.tree().expressionOf(data);
  if (value == kNoNode) return;
  const TypeIndex type = draft_.symbol(symbol).type;
  if (!draft_.types()[type].has_values) {
    return file_.reportNode(kinds::kNoInitialValue, value, file_.typeName(type));
  }
  const std::uint64_t errors = file_.errors();
  const Typed typed = expressions_.expect(value, type);
  draft_.symbol(symbol).value = typed.constant;
  if (errors != file_.errors()) return;
  const bool is_persistent = file_[data].word == TokenKind::Pers;
  const NodeIndex wrong =
      is_persistent ? firstNoLiteral(value, is_of_system_module) : firstNotConstant(value);
  if (wrong == kNoNode) return;
  file_.reportNode(kinds::kInitialValue, wrong, is_persistent ? "a literal" : "constant");
  draft_.symbol(symbol).value = kNoConstant;
}

/// The first part that is neither a literal nor, in a system module, predefined data.
NodeIndex DataDeclaration::firstNoLiteral(NodeIndex node, bool may_be_predefined) const {
  const Node& at = file_[node];
  if (isLiteral(at.kind)) return kNoNode;
  if (at.kind == NodeKind::Sign) return isLiteral(file_[at.child].kind) ? kNoNode : node;
  if (at.kind == NodeKind::Reference && may_be_predefined) {
    const SymbolIndex symbol = file_.at(node).symbol;
    const bool is_predefined = symbol != kNoSymbol && draft_.symbol(symbol).file < kPredefinedFiles;
    return is_predefined && file_.at(node).constant != kNoConstant ? kNoNode : node;
  }
  if (at.kind != NodeKind::Aggregate) return node;
  for (const NodeIndex child : file_.tree().children(node)) {
    const NodeIndex wrong = firstNoLiteral(child, may_be_predefined);
    if (wrong != kNoNode) return wrong;
  }
  return kNoNode;
}

/// The first part whose value only a run can know; the whole, if it has none although all parts have one.
NodeIndex DataDeclaration::firstNotConstant(NodeIndex node) const {
  const NodeKind kind = file_[node].kind;
  const bool is_value = isExpression(kind);
  if (isLiteral(kind) || (is_value && file_.at(node).constant != kNoConstant)) return kNoNode;
  const bool is_leaf = kind == NodeKind::Reference || kind == NodeKind::Function;
  if (is_leaf && !isConstantLeaf(node)) return node;
  bool has_open_part = is_leaf || !is_value;
  for (const NodeIndex child : file_.tree().children(node)) {
    const NodeIndex wrong = firstNotConstant(child);
    if (wrong != kNoNode) return wrong;
    const NodeIndex operand = file_[child].kind == NodeKind::Operation ? file_[child].child : child;
    has_open_part = has_open_part || file_.at(operand).constant == kNoConstant;
  }
  return has_open_part ? kNoNode : node;
}

/// A CONST whose value is a function of others, or the call of such a function.
bool DataDeclaration::isConstantLeaf(NodeIndex node) const {
  const SymbolIndex index = file_.at(node).symbol;
  if (index == kNoSymbol) return true;
  const Symbol& symbol = draft_.symbol(index);
  if (symbol.kind == SymbolKind::Function) {
    const bool is_pure =
        symbol.file < kPredefinedFiles &&
        std::find(kPureFunctions.begin(), kPureFunctions.end(), symbol.name) != kPureFunctions.end();
    return is_pure && draft_.dialect == Dialect::Irc5;
  }
  return symbol.kind == SymbolKind::Data && symbol.word == TokenKind::Const && draft_.ready[index] != 0;
}

}  // namespace cobot_command::rapid
