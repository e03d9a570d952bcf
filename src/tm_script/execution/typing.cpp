#include "execution/typing.h"

#include <algorithm>

#include "execution/operators.h"
#include "execution/quoted_names.h"
#include "values/conversion.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

constexpr Type kBool{ScalarType::Bool};
constexpr Type kString{ScalarType::String};

bool isEmptyArray(const Expression& expression) {
  const auto* array = std::get_if<ArrayLiteral>(&expression.node);
  return array && array->elements.empty();
}

/// The literal, if it is one, or one with a sign.
bool isLiteral(const Expression& expression) {
  if (const auto* prefix = std::get_if<Prefix>(&expression.node)) {
    return prefix->steps.size() == 1 && prefix->steps[0] == Prefix::Step(PrefixOperator::Minus) &&
           isLiteral(*prefix->operand);
  }
  return std::holds_alternative<Literal>(expression.node);
}

/// A literal, with its sign.
std::optional<Scalar> literalIn(const Expression& expression) {
  if (const auto* literal = std::get_if<Literal>(&expression.node)) return literal->value;
  const auto* prefix = std::get_if<Prefix>(&expression.node);
  const auto number = prefix && isLiteral(expression) ? literalIn(*prefix->operand) : std::nullopt;
  if (!number) return std::nullopt;
  const auto negative = applyOperator(PrefixOperator::Minus, *number);
  return negative ? std::optional<Scalar>(std::get<Scalar>(*negative)) : std::nullopt;
}

std::vector<std::optional<Scalar>> literalsIn(const Expressions& expressions) {
  std::vector<std::optional<Scalar>> literals;
  for (const Expression& expression : expressions) literals.push_back(literalIn(expression));
  return literals;
}

/// Integers that an attribute does not take, where they are written.
std::optional<std::string> beyond(const AttributeShape& shape, const Expression& value) {
  if (!shape.most) return std::nullopt;
  if (const auto* array = std::get_if<ArrayLiteral>(&value.node)) {
    for (const Expression& element : array->elements) {
      if (auto reason = beyond(shape, element)) return reason;
    }
    return std::nullopt;
  }
  const auto literal = literalIn(value);
  const auto number = literal ? convert(*literal, ScalarType::Int) : Result<Scalar, std::string>(Scalar(0));
  if (!number) return number.error();
  const auto integer = std::get<std::int32_t>(*number);
  if (integer >= 0 && integer <= *shape.most) return std::nullopt;
  return fmt::format("{} is not 0 to {}", integer, *shape.most);
}

Result<AttributeShape, std::string> asShape(const Result<Type, std::string>& type) {
  if (!type) return refuse(type.error());
  return AttributeShape{*type, true, std::nullopt};
}

/// A number of elements that does not fit is found before the script runs where it is written.
std::optional<std::string> wrongLength(const Expression& expression, std::size_t length) {
  const auto* array = std::get_if<ArrayLiteral>(&expression.node);
  if (length == 0 || !array || array->elements.size() == length) return std::nullopt;
  return fmt::format("{} elements are expected, not {}", length, array->elements.size());
}

}  // namespace

bool Typing::isBareWord(const Expression& expression) const {
  const auto* name = std::get_if<Name>(&expression.node);
  return name && !type_of_name_(name->name);
}

/// Once, however often a part of a line is looked at.
void Typing::warnOfQuotes(const Expression& bare_word) {
  std::string warning = fmt::format("{} is interpreted as a text without quotes", toText(bare_word));
  if (warnings_.empty() || warnings_.back() != warning) warnings_.push_back(std::move(warning));
}

Result<Type, std::string> Typing::typeOf(const Expression& expression) {
  return std::visit([this](const auto& node) { return of(node); }, expression.node);
}

std::optional<std::string> Typing::accept(const Expression& expression, Type wanted) {
  if (wanted == kString && isBareWord(expression)) {
    warnOfQuotes(expression);
    return std::nullopt;
  }
  const auto type = typeOf(expression);
  if (!type) return type.error();
  if (wanted.is_array && isEmptyArray(expression)) return std::nullopt;
  const Conversion conversion = conversionOf(*type, wanted);
  if (conversion == Conversion::None) return fmt::format("{} is no {}", toText(*type), toText(wanted));
  if (isWarned(conversion)) warnings_.push_back(fmt::format("{} becomes {}", toText(*type), toText(wanted)));
  return std::nullopt;
}

Result<Match, std::string> Typing::match(const Call& call) {
  std::vector<Type> types;
  for (const Expression& argument : call.arguments) {
    auto type = isBareWord(argument) ? Typed(kString) : typeOf(argument);
    if (!type) return refuse(std::move(type.error()));
    types.push_back(*type);
  }
  return functions_.find(call.function, types);
}

Result<AttributeShape, std::string> Typing::shapeOf(const Attribute& attribute) {
  std::vector<std::optional<Scalar>> keys;
  for (const Expression& key : attribute.keys) {
    if (isBareWord(key)) {
      warnOfQuotes(key);
      keys.emplace_back(std::get<Name>(key.node).name);
      continue;
    }
    const auto type = typeOf(key);
    if (!type) return refuse(type.error());
    if (type->is_array || !(isInteger(type->scalar) || type->scalar == ScalarType::String)) {
      return refuse(fmt::format("{} is no name and no number of a {}", toText(*type), attribute.object));
    }
    keys.push_back(literalIn(key));
  }
  return environment_.shapeOf(attribute.object, keys, attribute.name);
}

Result<Type, std::string> Typing::of(const Literal& literal) {
  if (const auto* text = std::get_if<std::string>(&literal.value)) {
    (void)withQuotedNames(*text, [this](std::string_view name) -> std::optional<std::string> {
      if (!type_of_name_(std::string(name))) return std::nullopt;
      warnings_.push_back(fmt::format("the variable '{}' is inside a text", name));
      return std::string();
    });
  }
  return Type{tm_script::typeOf(literal.value)};
}

Result<Type, std::string> Typing::of(const Name& name) {
  const auto type = type_of_name_(name.name);
  if (!type) return refuse(fmt::format("there is no variable {}", name.name));
  return *type;
}

/// The type that holds all of them.
Result<Type, std::string> Typing::commonOf(const Expressions& expressions) {
  std::optional<Type> common;
  for (const Expression& expression : expressions) {
    auto type = typeOf(expression);
    if (!type) return type;
    if (!common || *common == *type) {
      common = *type;
      continue;
    }
    const auto number =
        type->is_array || common->is_array ? std::nullopt : commonType(common->scalar, type->scalar);
    if (!number) return refuse(fmt::format("{} and {} have no common type", toText(*type), toText(*common)));
    common = Type{*number};
  }
  return common.value_or(Type{ScalarType::Byte});
}

Result<Type, std::string> Typing::of(const ArrayLiteral& array) {
  if (array.elements.size() > kMaxElements) {
    return refuse(fmt::format("an array of more than {} elements", kMaxElements));
  }
  auto element = commonOf(array.elements);
  if (!element) return element;
  if (element->is_array) return refuse(std::string("arrays have one dimension"));
  return Type{element->scalar, true};
}

Result<Type, std::string> Typing::of(const Call& call) {
  const auto matched = match(call);
  if (!matched) return refuse(matched.error());
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expression& argument = call.arguments[i];
    const Parameter& parameter = matched->function->parameters[i];
    const auto place = [&](const std::string& reason) {
      return refuse(fmt::format("argument {} of {}: {}", i + 1, call.function, reason));
    };
    if (isBareWord(argument)) {
      const bool takes_text = parameter.kind == Parameter::Kind::Fixed && parameter.type == kString;
      if (!takes_text) return place(typeOf(argument).error());
      warnOfQuotes(argument);
    }
    if (parameter.is_literal && !isLiteral(argument)) return place("must be written as a literal");
    if (const auto wrong = wrongLength(argument, parameter.length)) return place(*wrong);
  }
  if (!matched->function->compute) {
    if (auto objection = environment_.objectionTo(call.function, literalsIn(call.arguments))) {
      return refuse(std::move(*objection));
    }
  }
  if (matched->is_warned) warnings_.push_back(fmt::format("an argument of {} is converted", call.function));
  return matched->result;
}

Result<Type, std::string> Typing::of(const Attribute& attribute) {
  const auto shape = shapeOf(attribute);
  if (!shape) return refuse(shape.error());
  return shape->type;
}

Result<Type, std::string> Typing::of(const Element& element) {
  const auto* attribute = std::get_if<Attribute>(&element.array->node);
  auto shape = AttributeShape{};
  if (auto found = attribute ? shapeOf(*attribute) : asShape(typeOf(*element.array)); found) {
    shape = *found;
  } else {
    return refuse(std::move(found.error()));
  }
  if (!shape.type.is_array) return refuse(fmt::format("{} has no elements", toText(shape.type)));
  auto index = typeOf(*element.index);
  if (!index) return index;
  if (index->is_array || !isInteger(index->scalar)) {
    return refuse(fmt::format("{} is no index", toText(*index)));
  }
  const auto literal = literalIn(*element.index);
  if (literal && shape.length) {
    const auto at = std::get<std::int32_t>(*convert(*literal, ScalarType::Int));
    if (at < 0 || static_cast<std::size_t>(at) >= *shape.length) {
      return refuse(
          fmt::format("index {} is outside of {}, which has {}", at, toText(*element.array), *shape.length));
    }
  }
  return Type{shape.type.scalar};
}

Result<Type, std::string> Typing::of(const Prefix& prefix) {
  std::optional<Type> type;
  for (auto step = prefix.steps.rbegin(); step != prefix.steps.rend(); ++step) {
    const auto* symbol = std::get_if<PrefixOperator>(&*step);
    const bool steps =
        symbol && (*symbol == PrefixOperator::Increment || *symbol == PrefixOperator::Decrement);
    if (steps && type) return refuse(fmt::format("{} needs a variable", toText(*symbol)));
    auto next = steps  ? stepped(*prefix.operand, toText(*symbol).c_str())
                : type ? Typed(*type)
                       : typeOf(*prefix.operand);
    if (!next) return next;
    if (symbol && !steps) next = resultOf(*symbol, *next);
    if (!next) return next;
    if (!symbol) {
      const Type cast = std::get<Type>(*step);
      if (conversionOf(*next, cast) == Conversion::None) {
        return refuse(fmt::format("{} is no {}", toText(*next), toText(cast)));
      }
      next = cast;
    }
    type = *next;
  }
  return *type;
}

/// The target of ++ or --.
Result<Type, std::string> Typing::stepped(const Expression& target, const char* step) {
  const auto shape = targetShape(target);
  if (!shape) return refuse(shape.error());
  if (shape->type.is_array || !isInteger(shape->type.scalar)) {
    return refuse(fmt::format("{} needs an integer", step));
  }
  return shape->type;
}

Result<Type, std::string> Typing::of(const Postfix& postfix) {
  return stepped(*postfix.operand, toText(postfix.step).c_str());
}

Result<Type, std::string> Typing::of(const Chain& chain) {
  auto type = typeOf(chain.operands.front());
  for (std::size_t i = 0; type && i < chain.operators.size(); ++i) {
    auto operand = typeOf(chain.operands[i + 1]);
    if (!operand) return operand;
    type = resultOf(chain.operators[i], *type, *operand);
  }
  return type;
}

Result<Type, std::string> Typing::of(const Conditional& conditional) {
  for (const Expression& condition : conditional.conditions) {
    auto type = typeOf(condition);
    if (!type) return type;
    if (*type != kBool) return refuse(fmt::format("{} is no condition", toText(*type)));
  }
  Expressions results = conditional.results;
  results.push_back(*conditional.otherwise);
  return commonOf(results);
}

Result<AttributeShape, std::string> Typing::targetShape(const Expression& target) {
  if (const auto* attribute = std::get_if<Attribute>(&target.node)) return shapeOf(*attribute);
  const auto* element = std::get_if<Element>(&target.node);
  const Expression& whole = element ? *element->array : target;
  if (!std::holds_alternative<Name>(whole.node) && !std::holds_alternative<Attribute>(whole.node)) {
    return refuse(fmt::format("{} cannot be changed", toText(target)));
  }
  auto shape = asShape(typeOf(target));
  const auto* attribute = std::get_if<Attribute>(&whole.node);
  if (shape && attribute) {
    if (const auto whole_shape = shapeOf(*attribute)) shape->most = whole_shape->most;
  }
  return shape;
}

/// The type of what is assigned to the last target.
Result<Type, std::string> Typing::valueFor(const AttributeShape& target, const Assignment& assignment) {
  const Expression& value = *assignment.value;
  if (assignment.operators.back()) return typeOf(value);
  if (auto reason = accept(value, target.type)) return refuse(std::move(*reason));
  if (auto reason = wrongLength(value, target.length.value_or(0))) return refuse(std::move(*reason));
  if (auto reason = beyond(target, value)) return refuse(std::move(*reason));
  return target.type;
}

Result<Type, std::string> Typing::of(const Assignment& assignment) {
  std::optional<Type> value;
  for (std::size_t i = assignment.targets.size(); i-- > 0;) {
    const auto target = targetShape(assignment.targets[i]);
    if (!target) return refuse(target.error());
    auto given = value ? Typed(*value) : valueFor(*target, assignment);
    if (!given) return given;
    const auto& compound = assignment.operators[i];
    auto result = compound ? resultOf(*compound, target->type, *given) : given;
    if (!result) return result;
    if (conversionOf(*result, target->type) == Conversion::None) {
      return refuse(fmt::format("{} is no {}", toText(*result), toText(target->type)));
    }
    // "b += 1" computes an int; it is the operand that may lose something. A text takes any operand.
    const bool appends = compound && target->type == kString;
    if (isWarned(conversionOf(*given, target->type)) && !appends) {
      warnings_.push_back(fmt::format("{} becomes {}", toText(*given), toText(target->type)));
    }
    value = target->type;
  }
  return *value;
}

}  // namespace cobot_command::tm_script
