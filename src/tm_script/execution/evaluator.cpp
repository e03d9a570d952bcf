#include "execution/evaluator.h"

#include <algorithm>
#include <utility>

#include "execution/operators.h"
#include "execution/quoted_names.h"
#include "values/conversion.h"
#include "values/written_numbers.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

/// A reason becomes a stop.
Result<Value, Stop> orFault(Result<Value, std::string> result) {
  if (!result) return fault(std::move(result.error()));
  return std::move(*result);
}

/// Ours and the manual's limits; a script must not use up the memory.
Result<Value, Stop> limited(Value value) {
  const auto* array = std::get_if<Array>(&value);
  if (array && array->items.size() > kMaxElements) {
    return fault(fmt::format("an array of more than {} elements", kMaxElements));
  }
  if (sizeOf(value) > kMaxValueBytes) {
    return fault(fmt::format("a value of more than {} bytes", kMaxValueBytes));
  }
  return value;
}

}  // namespace

Evaluator::Evaluator(const FunctionTable& functions, Scope scope, Environment& robot,
                     std::vector<Answer>& answers)
    : functions_(functions),
      scope_(scope),
      robot_(robot),
      answers_(answers),
      typing_(functions, robot, [this](const std::string& name) {
        const Value* value = find(name);
        return value ? std::optional<Type>(typeOf(*value)) : std::nullopt;
      }) {}

Result<bool, Stop> Evaluator::run(const Statement& statement) {
  if (const auto* declaration = std::get_if<Declaration>(&statement.content)) {
    auto value = declaration->initial ? valueOf(*declaration->initial) : initialValue(declaration->type);
    if (value) {
      value =
          orFault(declaration->initial ? convertAsWritten(*declaration->initial, *value, declaration->type)
                                       : convert(*value, declaration->type));
    }
    if (!value) return refuse(std::move(value.error()));
    changed_[declaration->name] = std::move(*value);
  } else if (auto value = valueOf(std::get<Expression>(statement.content)); !value) {
    return refuse(std::move(value.error()));
  }
  for (auto& [name, value] : changed_) {
    Variables& variables = scope_.project.find(name) ? scope_.project : scope_.locals;
    if (!variables.set(name, std::move(value))) return fault("no room for more variables");
  }
  return ends_script_;
}

const Value* Evaluator::find(const std::string& name) const {
  const auto changed = changed_.find(name);
  if (changed != changed_.end()) return &changed->second;
  const Value* local = scope_.locals.find(name);
  return local ? local : scope_.project.find(name);
}

std::optional<Value> Evaluator::known() {
  if (next_answer_ == answers_.size()) return std::nullopt;
  const Answer& answer = answers_[next_answer_++];
  ends_script_ = ends_script_ || answer.ends_script;
  return answer.value;
}

Value Evaluator::remember(Value value, bool ends_script) {
  answers_.push_back({std::move(value), ends_script});
  return *known();
}

Result<Value, Stop> Evaluator::valueOf(const Expression& expression) {
  auto value = std::visit([this](const auto& node) { return of(node); }, expression.node);
  if (!value) return value;
  const auto* array = std::get_if<Array>(&*value);
  work_ += sizeof(Value) + (array ? array->items.size() * sizeof(Scalar) : sizeOf(*value));
  if (work_ > kMaxLineWork) return fault("the line takes too much work");
  return value;
}

Result<Value, Stop> Evaluator::of(const Literal& literal) {
  const auto* text = std::get_if<std::string>(&literal.value);
  if (!text || text->find('\'') == std::string::npos) return Value(literal.value);
  std::size_t size = 0;
  std::string replaced = withQuotedNames(*text, [&](std::string_view name) -> std::optional<std::string> {
    const Value* value = size > kMaxValueBytes ? nullptr : find(std::string(name));
    if (!value) return std::nullopt;
    std::string value_text = tm_script::textOf(*value);
    size += value_text.size();
    return value_text;
  });
  return limited(Scalar(std::move(replaced)));
}

Result<Value, Stop> Evaluator::of(const Name& name) {
  const Value* value = find(name.name);
  if (value) return *value;
  return Value(Scalar(name.name));  // the checker let it pass: a text without its quotes
}

Result<Value, Stop> Evaluator::of(const ArrayLiteral& array) {
  std::vector<Scalar> items;
  ScalarType type = ScalarType::Byte;
  std::size_t bytes = 0;
  for (const Expression& element : array.elements) {
    auto value = valueOf(element);
    if (!value) return value;
    bytes += sizeOf(*value);
    if (bytes > kMaxValueBytes) return fault(fmt::format("a value of more than {} bytes", kMaxValueBytes));
    items.push_back(std::get<Scalar>(*value));
    type = std::max(type, typeOf(items.back()));
  }
  for (Scalar& item : items) {
    auto converted = convert(item, type);
    if (!converted) return fault(std::move(converted.error()));
    item = std::move(*converted);
  }
  return Value(Array{type, std::move(items)});
}

Result<Value, Stop> Evaluator::of(const Chain& chain) {
  auto value = valueOf(chain.operands.front());
  for (std::size_t i = 0; value && i < chain.operators.size(); ++i) {
    const BinaryOperator binary = chain.operators[i];
    const bool decides = binary == BinaryOperator::Or;
    if ((decides || binary == BinaryOperator::And) && *value == Value(Scalar(decides))) return value;
    auto operand = valueOf(chain.operands[i + 1]);
    if (!operand) return operand;
    value = orFault(applyOperator(binary, *value, *operand));
  }
  return value;
}

Result<Value, Stop> Evaluator::of(const Conditional& conditional) {
  const auto type = typing_.typeOf({conditional});
  if (!type) return fault(type.error());
  const Expression* chosen = &*conditional.otherwise;
  for (std::size_t i = 0; i < conditional.conditions.size(); ++i) {
    auto condition = valueOf(conditional.conditions[i]);
    if (!condition) return condition;
    if (*condition != Value(Scalar(true))) continue;
    chosen = &conditional.results[i];
    break;
  }
  auto value = valueOf(*chosen);
  if (!value) return value;
  return orFault(convert(*value, *type));
}

Result<Value, Stop> Evaluator::of(const Prefix& prefix) {
  const auto* innermost = std::get_if<PrefixOperator>(&prefix.steps.back());
  const bool steps =
      innermost && (*innermost == PrefixOperator::Increment || *innermost == PrefixOperator::Decrement);
  auto value = steps ? step(*prefix.operand, *innermost == PrefixOperator::Increment ? 1 : -1, false)
                     : valueOf(*prefix.operand);
  for (std::size_t i = prefix.steps.size() - (steps ? 1 : 0); value && i-- > 0;) {
    const auto* symbol = std::get_if<PrefixOperator>(&prefix.steps[i]);
    value =
        orFault(symbol ? applyOperator(*symbol, *value) : convert(*value, std::get<Type>(prefix.steps[i])));
  }
  return value;
}

Result<Value, Stop> Evaluator::of(const Postfix& postfix) {
  return step(*postfix.operand, postfix.step == PostfixOperator::Increment ? 1 : -1, true);
}

Result<Arguments, Stop> Evaluator::argumentsOf(const Call& call) {
  Arguments arguments;
  for (const Expression& argument : call.arguments) {
    auto value = valueOf(argument);
    if (!value) return refuse(std::move(value.error()));
    arguments.push_back(std::move(*value));
  }
  return arguments;
}

Result<Value, Stop> Evaluator::of(const Call& call) {
  auto arguments = argumentsOf(call);
  if (!arguments) return refuse(std::move(arguments.error()));
  std::vector<Type> types;
  for (const Value& argument : *arguments) types.push_back(typeOf(argument));
  const auto match = functions_.find(call.function, types);
  if (!match) return fault(match.error());
  for (std::size_t i = 0; i < arguments->size(); ++i) {
    auto converted = convertAsWritten(call.arguments[i], (*arguments)[i], match->arguments[i]);
    if (!converted) {
      return fault(fmt::format("argument {} of {}: {}", i + 1, call.function, converted.error()));
    }
    const std::size_t length = match->function->parameters[i].length;
    const auto* array = std::get_if<Array>(&*converted);
    if (length > 0 && array && array->items.size() != length) {
      return fault(fmt::format("argument {} of {}: {} elements are expected, not {}", i + 1, call.function,
                               length, array->items.size()));
    }
    (*arguments)[i] = std::move(*converted);
  }
  auto result = match->function->compute ? orFault(match->function->compute(*arguments))
                                         : callRobot(call.function, *arguments);
  if (result) result = orFault(convert(*result, match->result));
  if (!result) {
    return refuse(
        Stop{result.error().waits, result.error().waits ? "" : call.function + ": " + result.error().reason});
  }
  return limited(std::move(*result));
}

Result<Value, Stop> Evaluator::callRobot(const std::string& function, const Arguments& arguments) {
  if (auto answer = known()) return std::move(*answer);
  CallAnswer answer = robot_.call(function, arguments);
  if (auto* value = std::get_if<Value>(&answer)) return remember(std::move(*value), false);
  if (auto* end = std::get_if<EndScript>(&answer)) return remember(std::move(end->result), true);
  if (auto* failure = std::get_if<CallFailure>(&answer)) return fault(std::move(failure->reason));
  return refuse(Stop{true, ""});
}

}  // namespace cobot_command::tm_script
