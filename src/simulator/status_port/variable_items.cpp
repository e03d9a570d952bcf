#include "status_port/variable_items.h"

#include <utility>
#include <variant>
#include <vector>

namespace cobot_command::simulator {

namespace {

using protocol::ItemValue;
using tm_script::Array;
using tm_script::Scalar;

template <class T>
ItemValue elementsOf(const Array& array) {
  std::vector<T> elements;
  elements.reserve(array.items.size());
  for (const Scalar& item : array.items) elements.push_back(std::get<T>(item));
  return elements;
}

ItemValue toItem(const Array& array) {
  switch (array.element) {
    case tm_script::ScalarType::Byte:
      return elementsOf<std::uint8_t>(array);
    case tm_script::ScalarType::Int:
      return elementsOf<std::int32_t>(array);
    case tm_script::ScalarType::Float:
      return elementsOf<float>(array);
    case tm_script::ScalarType::Double:
      return elementsOf<double>(array);
    case tm_script::ScalarType::Bool:
      return elementsOf<bool>(array);
    case tm_script::ScalarType::String:
      break;
  }
  return elementsOf<std::string>(array);
}

template <class T>
tm_script::Value fromItem(const T& scalar) {
  return Scalar(scalar);
}
template <class T>
tm_script::Value fromItem(const std::vector<T>& elements) {
  Array array{tm_script::typeOf(Scalar(T())), {}};
  for (const T& element : elements) array.items.emplace_back(element);
  return array;
}

}  // namespace

ItemValue toItem(const tm_script::Value& value) {
  if (const auto* array = std::get_if<Array>(&value)) return toItem(*array);
  return std::visit([](const auto& scalar) { return ItemValue(scalar); }, std::get<Scalar>(value));
}

tm_script::Value toLanguage(const ItemValue& value) {
  return std::visit([](const auto& content) { return fromItem(content); }, value);
}

}  // namespace cobot_command::simulator
