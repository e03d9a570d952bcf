#include "values/written_numbers.h"

#include <optional>

#include "values/conversion.h"

namespace cobot_command::tm_script {

namespace {

std::optional<double> writtenReal(const Expression& expression) {
  if (const auto* literal = std::get_if<Literal>(&expression.node)) return literal->written;
  const auto* prefix = std::get_if<Prefix>(&expression.node);
  if (!prefix || prefix->steps.size() != 1 || prefix->steps[0] != Prefix::Step(PrefixOperator::Minus)) {
    return std::nullopt;
  }
  const auto positive = writtenReal(*prefix->operand);
  return positive ? std::optional(-*positive) : std::nullopt;
}

}  // namespace

Result<Value, std::string> convertAsWritten(const Expression& source, const Value& value, Type to) {
  if (to.scalar != ScalarType::Double) return convert(value, to);
  const auto real = to.is_array ? std::nullopt : writtenReal(source);
  if (real) return Value(Scalar(*real));
  auto converted = convert(value, to);
  const auto* literal = std::get_if<ArrayLiteral>(&source.node);
  if (!converted || !literal) return converted;
  auto& items = std::get<Array>(*converted).items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (const auto element = writtenReal(literal->elements[i])) items[i] = *element;
  }
  return converted;
}

}  // namespace cobot_command::tm_script
