#include "expressions/expression_check.h"

#include <boost/locale/utf.hpp>

#include "cobot_command/rapid/source/literals.h"

namespace cobot_command::rapid {

namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

/// The first character of a text that ISO 8859-1 does not have.
Span foreignCharacter(const Token& token, std::string_view written) {
  constexpr boost::locale::utf::code_point kLast = 0xFF;
  const char* at = written.data();
  const char* const end = at + written.size();
  while (at != end) {
    const char* const begin = at;
    if (Utf8::decode(at, end) <= kLast) continue;
    const auto offset = static_cast<std::uint32_t>(begin - written.data());
    return {token.begin + offset, token.begin + static_cast<std::uint32_t>(at - written.data())};
  }
  return {token.begin, token.begin};
}

}  // namespace

Typed ExpressionCheck::check(NodeIndex node, TypeIndex context) {
  file_.countStep();
  const Typed typed = checkKind(node, context);
  Meaning& meaning = file_.at(node);
  meaning.type = typed.type;
  meaning.constant = typed.constant;
  if (draft_.data_cells > kMostCells) file_.reportTooLarge(file_[node].first);
  return typed;
}

Typed ExpressionCheck::checkKind(NodeIndex node, TypeIndex context) {
  switch (file_[node].kind) {
    case NodeKind::Number:
      return number(node);
    case NodeKind::String:
      return text(node);
    case NodeKind::Bool:
      return value(kBool, boolCell(file_[node].word == TokenKind::True));
    case NodeKind::Reference:
      return reference(node, context);
    case NodeKind::Function:
      return function(node);
    case NodeKind::Aggregate:
      return aggregate(node, context);
    case NodeKind::Parentheses:
      return check(file_[node].child, context);
    case NodeKind::Sign:
      return sign(node, context);
    case NodeKind::Not:
      return negation(node);
    case NodeKind::Chain:
      return chain(node);
    default:  // a placeholder, `*`: of unknown type
      return {};
  }
}

Typed ExpressionCheck::expect(NodeIndex node, TypeIndex type) {
  const Typed typed = check(node, type);
  if (!fits(typed.type, type)) reportWrongType(node, type, typed.type);
  return fits(typed.type, type) ? typed : Typed{};
}

void ExpressionCheck::condition(NodeIndex node) {
  const Typed typed = check(node);
  if (fits(typed.type, kBool)) return;
  file_.reportNode(kinds::kNoCondition, node, file_.typeName(typed.type));
}

bool ExpressionCheck::fits(TypeIndex found, TypeIndex wanted) const {
  if (found == wanted || found == kNoType || wanted == kNoType) return true;
  const TypeTable& types = draft_.types();
  const Type& from = types[found];
  const Type& to = types[wanted];
  if (to.kind == TypeKind::Anytype) return from.kind != TypeKind::Switch;
  if (from.kind == TypeKind::SemiValue) return wanted == kNum;
  return from.kind == TypeKind::Array && to.kind == TypeKind::Array && from.element == to.element &&
         from.dimensions == to.dimensions && (types.isConformant(found) || types.isConformant(wanted));
}

void ExpressionCheck::reportWrongType(NodeIndex node, TypeIndex wanted, TypeIndex found) {
  file_.reportNode(kinds::kWrongType, node, file_.typeName(wanted), file_.typeName(found));
}

Typed ExpressionCheck::value(TypeIndex type, Cell cell) {
  const ConstantIndex place = draft_.reserve(1);
  if (place != kNoConstant) *draft_.cells(place) = cell;
  return {type, place};
}

Typed ExpressionCheck::number(NodeIndex node) {
  const auto number = numberValue(file_.source().textOf(file_[node].first));
  return number ? value(kNum, numCell(*number)) : Typed{kNum, kNoConstant};
}

Typed ExpressionCheck::text(NodeIndex node) {
  const Token& token = file_.source().tokens()[file_[node].first];
  const std::string_view written = file_.source().textOf(file_[node].first);
  const auto bytes = latin1(textValue(written));
  if (!bytes) {
    const Span place = foreignCharacter(token, written);
    const std::string_view found = file_.source().text().substr(place.begin, place.end - place.begin);
    file_.reportAt(kinds::kNotLatin, place, quoted(found));
  }
  if (!bytes || bytes->size() > kMostTextCharacters) return {kString, kNoConstant};
  const ConstantIndex constant = draft_.reserve(kStringCells);
  if (constant != kNoConstant) putString(*bytes, draft_.cells(constant));
  return {kString, constant};
}

}  // namespace cobot_command::rapid
