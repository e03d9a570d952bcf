#include "values/numerals.h"
#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

namespace {

/// Does it need brackets as an operand?
bool hasOperator(const Expression& expression) {
  return std::visit(Overloaded{[](const Prefix&) { return true; }, [](const Postfix&) { return true; },
                               [](const Chain&) { return true; }, [](const Conditional&) { return true; },
                               [](const Assignment&) { return true; }, [](const auto&) { return false; }},
                    expression.node);
}

std::string operandText(const Expression& expression) {
  return hasOperator(expression) ? '(' + toText(expression) + ')' : toText(expression);
}

std::string listText(const Expressions& expressions) {
  std::string text;
  for (const Expression& expression : expressions) {
    if (!text.empty()) text += ", ";
    text += toText(expression);
  }
  return text;
}

std::string quoted(const std::string& content) {
  if (content == "\r\n") return "newline";  // the only line break that a script can name
  std::string text = "\"";
  for (const char c : content) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

/// With a point or an exponent, so that it is read as a real again.
std::string realText(double value, int digits) {
  std::string text = textOfReal(value, digits);
  return text.find_first_of(".E") == std::string::npos ? text + ".0" : text;
}

std::string literalText(const Scalar& value) {
  return std::visit(Overloaded{[](const std::string& text) { return quoted(text); },
                               [](bool flag) { return std::string(flag ? "true" : "false"); },
                               [](float number) { return realText(number, 7); },
                               [](double number) { return realText(number, 17); },
                               [](std::uint8_t byte) { return std::to_string(byte); },
                               // No literal is negative, but hexadecimal ones of 32 bits mean the number with
                               // these bits. What fits into a byte would be read as one.
                               [](std::int32_t number) {
                                 return number < 0
                                            ? fmt::format("0x{:08X}", static_cast<std::uint32_t>(number))
                                            : std::to_string(number);
                               }},
                    value);
}

std::string prefixText(const Prefix& prefix) {
  std::string text;
  for (const Prefix::Step& step : prefix.steps) {
    const std::string step_text = std::holds_alternative<Type>(step)
                                      ? '(' + toText(std::get<Type>(step)) + ')'
                                      : toText(std::get<PrefixOperator>(step));
    // "- -a" is not "--a".
    if (!text.empty() && (text.back() == '+' || text.back() == '-') && text.back() == step_text.front()) {
      text += ' ';
    }
    text += step_text;
  }
  return text + operandText(*prefix.operand);
}

std::string chainText(const Chain& chain) {
  std::string text = operandText(chain.operands.front());
  for (std::size_t i = 0; i < chain.operators.size(); ++i) {
    text += ' ' + toText(chain.operators[i]) + ' ' + operandText(chain.operands[i + 1]);
  }
  return text;
}

std::string conditionalText(const Conditional& conditional) {
  std::string text;
  for (std::size_t i = 0; i < conditional.conditions.size(); ++i) {
    text += operandText(conditional.conditions[i]) + " ? ";
    text += operandText(conditional.results[i]) + " : ";
  }
  return text + operandText(*conditional.otherwise);
}

std::string assignmentText(const Assignment& assignment) {
  std::string text;
  for (std::size_t i = 0; i < assignment.targets.size(); ++i) {
    const auto& binary = assignment.operators[i];
    text += operandText(assignment.targets[i]) + ' ' + (binary ? toText(*binary) : "") + "= ";
  }
  return text + operandText(*assignment.value);
}

}  // namespace

std::string toText(BinaryOperator binary) {
  constexpr const char* kTexts[] = {
      "||", "&&", "|", "^", "&", "==", "!=", "<", "<=", ">", ">=", "<<", ">>", "+", "-", "*", "/", "%"};
  return kTexts[static_cast<std::size_t>(binary)];
}

std::string toText(PrefixOperator prefix) {
  constexpr const char* kTexts[] = {"++", "--", "+", "-", "!", "~"};
  return kTexts[static_cast<std::size_t>(prefix)];
}

std::string toText(PostfixOperator postfix) {
  return postfix == PostfixOperator::Increment ? "++" : "--";
}

std::string toText(const Expression& expression) {
  return std::visit(
      Overloaded{[](const Literal& literal) { return literalText(literal.value); },
                 [](const Name& name) { return name.name; },
                 [](const ArrayLiteral& array) { return '{' + listText(array.elements) + '}'; },
                 [](const Call& call) { return call.function + '(' + listText(call.arguments) + ')'; },
                 [](const Attribute& attribute) {
                   return attribute.object + '[' + listText(attribute.keys) + "]." + attribute.name;
                 },
                 [](const Element& element) {
                   return operandText(*element.array) + '[' + toText(*element.index) + ']';
                 },
                 [](const Prefix& prefix) { return prefixText(prefix); },
                 [](const Postfix& postfix) { return operandText(*postfix.operand) + toText(postfix.step); },
                 [](const Chain& chain) { return chainText(chain); },
                 [](const Conditional& conditional) { return conditionalText(conditional); },
                 [](const Assignment& assignment) { return assignmentText(assignment); }},
      expression.node);
}

std::string toText(const Statement& statement) {
  if (const auto* expression = std::get_if<Expression>(&statement.content)) return toText(*expression);
  const auto& declaration = std::get<Declaration>(statement.content);
  std::string text = toText(declaration.type) + ' ' + declaration.name;
  if (declaration.initial) text += " = " + toText(*declaration.initial);
  return text;
}

std::string toText(const Script& script) {
  std::string text;
  for (const Statement& statement : script) {
    if (!text.empty()) text += "\r\n";
    text += toText(statement);
  }
  return text;
}

}  // namespace cobot_command::tm_script
