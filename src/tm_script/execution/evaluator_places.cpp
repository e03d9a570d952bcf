// Attributes, elements, and what can be changed.
#include <utility>

#include "execution/evaluator.h"
#include "execution/operators.h"
#include "values/conversion.h"
#include "values/written_numbers.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

Result<AttributeName, Stop> Evaluator::nameOf(const Attribute& attribute) {
  AttributeName name{attribute.object, {}, attribute.name};
  for (const Expression& key : attribute.keys) {
    auto value = valueOf(key);
    if (!value) return refuse(std::move(value.error()));
    name.keys.push_back(std::get<Scalar>(std::move(*value)));
  }
  return name;
}

Result<Value, Stop> Evaluator::of(const Attribute& attribute) {
  const auto name = nameOf(attribute);
  if (!name) return refuse(name.error());
  return readAttribute(*name);
}

Result<Value, Stop> Evaluator::readAttribute(const AttributeName& name) {
  if (auto answer = known()) return std::move(*answer);
  auto value = robot_.read(name);
  if (!value) return fault(std::move(value.error()));
  return remember(std::move(*value), false);
}

Result<std::size_t, Stop> Evaluator::indexOf(const Expression& index, std::size_t size) {
  const auto value = valueOf(index);
  if (!value) return refuse(value.error());
  const auto number = convert(std::get<Scalar>(*value), ScalarType::Int);
  if (!number) return fault(number.error());
  const auto at = std::get<std::int32_t>(*number);
  if (at < 0 || static_cast<std::size_t>(at) >= size) {
    return fault(fmt::format("index {} is outside of an array of {}", at, size));
  }
  return static_cast<std::size_t>(at);
}

Result<Value, Stop> Evaluator::of(const Element& element) {
  auto array = valueOf(*element.array);
  if (!array) return array;
  const auto index = indexOf(*element.index, std::get<Array>(*array).items.size());
  if (!index) return refuse(index.error());
  return Value(std::get<Array>(*array).items[*index]);
}

Result<Evaluator::Target, Stop> Evaluator::targetOf(const Expression& expression) {
  Target target;
  const auto* element = std::get_if<Element>(&expression.node);
  const Expression& whole = element ? *element->array : expression;
  if (const auto* attribute = std::get_if<Attribute>(&whole.node)) {
    auto name = nameOf(*attribute);
    if (!name) return refuse(std::move(name.error()));
    target.attribute = std::move(*name);
    auto shape =
        robot_.shapeOf(target.attribute.object, {target.attribute.keys.begin(), target.attribute.keys.end()},
                       target.attribute.name);
    if (!shape) return fault(std::move(shape.error()));
    target.shape = *shape;
  } else {
    target.variable = std::get<Name>(whole.node).name;
    target.whole = *find(target.variable);
    target.shape = {typeOf(*target.whole), true, std::nullopt};
  }
  if (!element) return target;
  const auto size = sizeOfTarget(target);
  if (!size) return refuse(size.error());
  const auto index = indexOf(*element->index, *size);
  if (!index) return refuse(index.error());
  target.index = *index;
  return target;
}

Result<std::size_t, Stop> Evaluator::sizeOfTarget(Target& target) {
  if (target.shape.length) return *target.shape.length;
  const auto whole = readTarget(target);
  if (!whole) return refuse(whole.error());
  return std::get<Array>(*whole).items.size();
}

Result<Value, Stop> Evaluator::readTarget(Target& target) {
  if (!target.whole) {
    auto value = readAttribute(target.attribute);
    if (!value) return value;
    target.whole = std::move(*value);
  }
  if (!target.index) return *target.whole;
  return Value(std::get<Array>(*target.whole).items[*target.index]);
}

Result<Value, Stop> Evaluator::assign(Target target, const Value& value, const Expression* source) {
  const Type type{target.shape.type.scalar, target.shape.type.is_array && !target.index};
  auto converted = source ? convertAsWritten(*source, value, type) : convert(value, type);
  if (!converted) return fault(std::move(converted.error()));
  if (target.variable.empty()) return writeAttribute(target, *converted);
  if (target.index) {
    std::get<Array>(*target.whole).items[*target.index] = std::get<Scalar>(*converted);
  } else {
    target.whole = *converted;
  }
  if (sizeOf(*target.whole) > kMaxValueBytes) {
    return fault(fmt::format("a value of more than {} bytes", kMaxValueBytes));
  }
  changed_[target.variable] = std::move(*target.whole);
  return std::move(*converted);
}

/// What cannot be written is left alone, as the controller does.
Result<Value, Stop> Evaluator::writeAttribute(const Target& target, const Value& value) {
  if (!target.shape.is_writable) return value;
  const auto* array = std::get_if<Array>(&value);
  if (array && target.shape.length && array->items.size() != *target.shape.length) {
    return fault(fmt::format("{} elements are expected, not {}", *target.shape.length, array->items.size()));
  }
  if (known()) return value;
  if (auto reason = robot_.write(target.attribute, target.index, value)) return fault(std::move(*reason));
  return remember(value, false);
}

Result<Value, Stop> Evaluator::step(const Expression& expression, int by, bool gives_old) {
  auto target = targetOf(expression);
  if (!target) return refuse(target.error());
  auto old = readTarget(*target);
  if (!old) return old;
  const auto next = applyOperator(BinaryOperator::Add, *old, Scalar(by));
  if (!next) return fault(next.error());
  auto assigned = assign(*target, *next);
  if (!assigned || !gives_old) return assigned;
  return old;
}

Result<Value, Stop> Evaluator::of(const Assignment& assignment) {
  auto value = valueOf(*assignment.value);
  for (std::size_t i = assignment.targets.size(); value && i-- > 0;) {
    auto target = targetOf(assignment.targets[i]);
    if (!target) return refuse(std::move(target.error()));
    const bool is_last = i + 1 == assignment.targets.size();
    const Expression* source = is_last && !assignment.operators[i] ? &*assignment.value : nullptr;
    if (const auto& binary = assignment.operators[i]) {
      const auto old = readTarget(*target);
      if (!old) return refuse(old.error());
      auto result = applyOperator(*binary, *old, *value);
      if (!result) return fault(std::move(result.error()));
      value = std::move(*result);
    }
    value = assign(std::move(*target), *value, source);
  }
  return value;
}

}  // namespace cobot_command::tm_script
