// Trees and texts of scripts, tried on random ones. A failure prints the seed: RC_PARAMS="seed=..." repeats
// it.
#include <algorithm>
#include <charconv>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/tm_script/parser.h"

namespace cobot_command::tm_script {
namespace {

using Bytes = std::string;

Bytes anyName() {
  return *rc::gen::element<Bytes>("a", "var_i", "x1", "_", "iff", "newlines");
}

Scalar anyScalar() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return *rc::gen::arbitrary<std::uint8_t>();
    case 1:
      return 256 + *rc::gen::inRange(0, 1000000);
    case 2:
      return static_cast<float>(*rc::gen::inRange(0, 100000)) / 128.0F;
    case 3:
      return *rc::gen::arbitrary<bool>();
    default:
      return *rc::gen::container<Bytes>(rc::gen::element('a', '"', '/', '*', ' ', ',', '(', '\xC3'));
  }
}

Expression anyExpression(int depth);

Expressions anyExpressions(int depth, int least, int most) {
  Expressions expressions;
  for (int count = *rc::gen::inRange(least, most + 1); count > 0; --count) {
    expressions.push_back(anyExpression(depth));
  }
  return expressions;
}

Expression anyLeaf() {
  return *rc::gen::arbitrary<bool>() ? Expression{Literal{anyScalar()}} : Expression{Name{anyName()}};
}

Expression anyPrefix(int depth) {
  Prefix prefix{{}, anyExpression(depth)};
  for (int count = *rc::gen::inRange(1, 4); count > 0; --count) {
    if (*rc::gen::arbitrary<bool>()) {
      prefix.steps.emplace_back(
          Type{static_cast<ScalarType>(*rc::gen::inRange(0, 6)), *rc::gen::arbitrary<bool>()});
    } else {
      prefix.steps.emplace_back(static_cast<PrefixOperator>(*rc::gen::inRange(0, 6)));
    }
  }
  return {std::move(prefix)};
}

/// Of one precedence, as the reader makes it.
Expression anyChain(int depth) {
  using B = BinaryOperator;
  const std::vector<std::vector<B>> families{{B::Add, B::Subtract},
                                             {B::Multiply, B::Divide, B::Modulo},
                                             {B::Or},
                                             {B::And},
                                             {B::Equal, B::NotEqual},
                                             {B::Less, B::LessEqual, B::Greater, B::GreaterEqual},
                                             {B::ShiftLeft, B::ShiftRight},
                                             {B::BitOr}};
  const auto family = *rc::gen::elementOf(families);
  Chain chain{anyExpressions(depth, 2, 4), {}};
  while (chain.operators.size() + 1 < chain.operands.size()) {
    chain.operators.push_back(*rc::gen::elementOf(family));
  }
  return {std::move(chain)};
}

Expression anyConditional(int depth) {
  Conditional conditional{anyExpressions(depth, 1, 2), {}, anyExpression(depth)};
  while (conditional.results.size() < conditional.conditions.size()) {
    conditional.results.push_back(anyExpression(depth));
  }
  return {std::move(conditional)};
}

Expression anyExpression(int depth) {
  if (depth == 0) return anyLeaf();
  switch (*rc::gen::inRange(0, 9)) {
    case 0:
      return {ArrayLiteral{anyExpressions(depth - 1, 0, 3)}};
    case 1:
      return {Call{anyName(), anyExpressions(depth - 1, 0, 3)}};
    case 2:
      return {Attribute{"IO", anyExpressions(depth - 1, 1, 2), "DO"}};
    case 3:
      return {Element{Expression{Name{anyName()}}, anyExpression(depth - 1)}};
    case 4:
      return anyPrefix(depth - 1);
    case 5:
      return {Postfix{Expression{Name{anyName()}},
                      *rc::gen::element(PostfixOperator::Increment, PostfixOperator::Decrement)}};
    case 6:
      return anyChain(depth - 1);
    case 7:
      return anyConditional(depth - 1);
    default:
      return {Assignment{{Expression{Name{anyName()}}}, {std::nullopt}, anyExpression(depth - 1)}};
  }
}

Statement anyStatement() {
  const Expression expression = anyExpression(4);
  if (*rc::gen::arbitrary<bool>()) return {1, expression};
  return {1, Declaration{{ScalarType::Float, *rc::gen::arbitrary<bool>()}, anyName(), expression}};
}

RC_GTEST_PROP(ScriptTreeProperty, isReadAsItWasWritten, ()) {
  const Bytes text = toText(anyStatement());
  const ParsedScript read = parse(text);
  RC_ASSERT(read.faults.empty());
  RC_ASSERT(toText(read.statements) == text);
}

RC_GTEST_PROP(ScriptTreeProperty, hasTheNearestDoubleOfEachNumeral, ()) {
  const auto digits = rc::gen::nonEmpty(rc::gen::container<Bytes>(rc::gen::inRange('0', ':')));
  const Bytes numeral = *digits + '.' + *digits + *rc::gen::element<Bytes>("", "e3", "E-12");
  const ParsedScript script = parse("double d = " + numeral);
  RC_ASSERT(script.faults.empty());
  const auto& declaration = std::get<Declaration>(script.statements.at(0).content);
  const Scalar& value = std::get<Literal>(declaration.initial->node).value;
  double nearest = 0;  // not by strtod(), which goes by the locale
  std::from_chars(numeral.data(), numeral.data() + numeral.size(), nearest);
  RC_ASSERT(value == Scalar(nearest) || value == Scalar(static_cast<float>(nearest)));
}

RC_GTEST_PROP(ScriptTreeProperty, ofAnyTextIsStatementsOrFaultsOfItsLines, ()) {
  const auto token =
      rc::gen::oneOf(rc::gen::element<Bytes>("int", "float[]", " a", "=", "(", ")", "[", "]", "{", "}", ",",
                                             "\"", "\"CPP\"", "1", "1.5", "0x", "0b1", "true", "\r\n", "\n",
                                             "//", "/*", "*/", " ", "+", "-", "++", "&&", "?", ":", ".Value",
                                             "IO[0].DI", "99999999999999999999", "1e999", "if"),
                     rc::gen::arbitrary<Bytes>());
  Bytes text;
  for (const Bytes& t : *rc::gen::container<std::vector<Bytes>>(token)) text += t;
  const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  const ParsedScript script = parse(text);
  int last = 0;
  for (const Fault& fault : script.faults) {
    RC_ASSERT(fault.line > last && fault.line <= lines);
    RC_ASSERT(!fault.reason.empty());
    last = fault.line;
  }
  const ParsedScript again = parse(toText(script.statements));
  RC_ASSERT(again.faults.empty());
  RC_ASSERT(toText(again.statements) == toText(script.statements));
}

}  // namespace
}  // namespace cobot_command::tm_script
