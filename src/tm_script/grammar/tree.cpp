#include "grammar/tree.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace cobot_command::tm_script {

namespace {

/// The manual's table of operators (1.4): the tighter, the larger.
int precedence(BinaryOperator binary) {
  switch (binary) {
    case BinaryOperator::Or:
      return 5;
    case BinaryOperator::And:
      return 6;
    case BinaryOperator::BitOr:
      return 7;
    case BinaryOperator::BitXor:
      return 8;
    case BinaryOperator::BitAnd:
      return 9;
    case BinaryOperator::Equal:
    case BinaryOperator::NotEqual:
      return 10;
    case BinaryOperator::Less:
    case BinaryOperator::LessEqual:
    case BinaryOperator::Greater:
    case BinaryOperator::GreaterEqual:
      return 11;
    case BinaryOperator::ShiftLeft:
    case BinaryOperator::ShiftRight:
      return 12;
    case BinaryOperator::Add:
    case BinaryOperator::Subtract:
      return 13;
    default:
      return 14;
  }
}

/// The tree of operands[first..last] and the operators between them.
Expression treeOf(FlatChain& flat, std::size_t first, std::size_t last) {
  if (first == last) return std::move(flat.operands[first]);
  int loosest = std::numeric_limits<int>::max();
  for (std::size_t i = first; i < last; ++i) loosest = std::min(loosest, precedence(flat.operators[i]));
  Chain chain;
  std::size_t start = first;
  for (std::size_t i = first; i < last; ++i) {
    if (precedence(flat.operators[i]) != loosest) continue;
    chain.operands.push_back(treeOf(flat, start, i));
    chain.operators.push_back(flat.operators[i]);
    start = i + 1;
  }
  chain.operands.push_back(treeOf(flat, start, last));
  return {std::move(chain)};
}

/// IO["ControlBox"].DO: an object, keys and a name.
bool isAttribute(const Expression& primary, const std::vector<Suffix>& suffixes) {
  return std::holds_alternative<Name>(primary.node) && suffixes.size() >= 2 &&
         std::holds_alternative<Expressions>(suffixes[0]) && std::holds_alternative<std::string>(suffixes[1]);
}

Expression attributeOf(const Expression& primary, std::vector<Suffix>& suffixes) {
  Attribute attribute{std::get<Name>(primary.node).name, std::get<Expressions>(std::move(suffixes[0])),
                      std::get<std::string>(std::move(suffixes[1]))};
  suffixes.erase(suffixes.begin(), suffixes.begin() + 2);
  return {std::move(attribute)};
}

}  // namespace

Result<Expression, std::string> withSuffixes(Expression primary, std::vector<Suffix> suffixes) {
  if (isAttribute(primary, suffixes)) primary = attributeOf(primary, suffixes);
  bool indexed = false;
  for (std::size_t i = 0; i < suffixes.size(); ++i) {
    if (auto* indices = std::get_if<Expressions>(&suffixes[i])) {
      if (indexed || indices->size() != 1) return refuse(std::string("arrays have one dimension"));
      primary = {Element{std::move(primary), std::move(indices->front())}};
      indexed = true;
    } else if (std::holds_alternative<std::string>(suffixes[i])) {
      return refuse(std::string("only objects such as Robot[0] have attributes"));
    } else if (i + 1 != suffixes.size()) {
      return refuse(std::string("nothing can follow ++ or --"));
    } else {
      primary = {Postfix{std::move(primary), std::get<PostfixOperator>(suffixes[i])}};
    }
  }
  return primary;
}

Expression withPrefixes(std::vector<Prefix::Step> steps, Expression operand) {
  if (steps.empty()) return operand;
  // The one int that cannot be written without its sign.
  constexpr double kBeyondInt = 2147483648.0;
  const auto* literal = std::get_if<Literal>(&operand.node);
  const auto* real = literal ? std::get_if<double>(&literal->value) : nullptr;
  const auto* sign = std::get_if<PrefixOperator>(&steps.back());
  if (real && *real == kBeyondInt && sign && *sign == PrefixOperator::Minus) {
    steps.pop_back();
    return withPrefixes(std::move(steps), {Literal{std::numeric_limits<std::int32_t>::min()}});
  }
  return {Prefix{std::move(steps), std::move(operand)}};
}

Expression tree(FlatChain chain) {
  return treeOf(chain, 0, chain.operands.size() - 1);
}

Expression tree(FlatConditional conditional) {
  Expression last = std::move(conditional.values.back());
  if (conditional.results.empty()) return last;
  conditional.values.pop_back();
  return {Conditional{std::move(conditional.values), std::move(conditional.results), std::move(last)}};
}

Expression tree(FlatAssignment assignment) {
  Expression value = std::move(assignment.values.back());
  if (assignment.operators.empty()) return value;
  assignment.values.pop_back();
  return {Assignment{std::move(assignment.values), std::move(assignment.operators), std::move(value)}};
}

}  // namespace cobot_command::tm_script
