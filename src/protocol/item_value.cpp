#include <cmath>
#include <limits>
#include <type_traits>

#include "item_json.h"
#include "item_string.h"
#include "little_endian.h"

#include "cobot_command/protocol/item_content.h"

namespace cobot_command::protocol {

namespace {

constexpr std::string_view kBinarySeparator("\0\0", 2);  // between the elements of string[]

template <class T>
struct IsArray : std::false_type {};
template <class T>
struct IsArray<std::vector<T>> : std::true_type {};

// --- To the wire -------------------------------------------------------------------------------------------

void appendBinary(std::string& bytes, const std::string& text) {
  bytes += text;
}
template <class Number>
void appendBinary(std::string& bytes, Number number) {
  if constexpr (std::is_same_v<Number, bool>) {
    bytes += number ? '\1' : '\0';
  } else {
    appendNumber(bytes, number);
  }
}

/// The library writes the shortest digits of its own type of reals.
using FloatJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

template <class T>
std::string jsonText(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return toText(JsonTree(value));
  } else if constexpr (std::is_same_v<T, float>) {
    return upperExponent(FloatJson(value).dump());
  } else if constexpr (std::is_same_v<T, double>) {
    return upperExponent(JsonTree(value).dump());
  } else {
    return JsonTree(value).dump();
  }
}

template <class T>
std::string stringText(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return inQuotes(value);
  } else {
    std::string text = jsonText(value);
    const std::string_view whole = ".0";
    if (text.size() > whole.size() && text.compare(text.size() - whole.size(), whole.size(), whole) == 0) {
      text.resize(text.size() - whole.size());
    }
    return text;
  }
}

template <class T>
std::string scalarText(ItemFormat format, const T& value) {
  if (format == ItemFormat::String) return stringText(value);
  if (format == ItemFormat::Json) return jsonText(value);
  std::string bytes;
  appendBinary(bytes, value);
  return bytes;
}

template <class T>
std::string arrayText(ItemFormat format, const std::vector<T>& values) {
  std::string_view separator = ",";
  if (format == ItemFormat::Binary) separator = std::is_same_v<T, std::string> ? kBinarySeparator : "";
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += separator;
    text += scalarText<T>(format, values[i]);
  }
  if (format == ItemFormat::String) return '{' + text + '}';
  if (format == ItemFormat::Json) return '[' + text + ']';
  return text;
}

// --- From the wire -----------------------------------------------------------------------------------------

template <class T>
bool assign(const JsonTree& json, T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) return false;
    value = json.template get<std::string>();
  } else if constexpr (std::is_same_v<T, bool>) {
    const bool is_bit = json.is_number_integer() && (json == 0 || json == 1);
    if (!json.is_boolean() && !is_bit) return false;
    value = json.is_boolean() ? json.template get<bool>() : json == 1;
  } else {
    if (!json.is_number() || (std::is_integral_v<T> && !json.is_number_integer())) return false;
    const auto number = json.template get<double>();
    if constexpr (std::is_floating_point_v<T>) {
      value = static_cast<T>(number);
      return std::isfinite(value);
    } else {
      if (number < std::numeric_limits<T>::min() || number > std::numeric_limits<T>::max()) return false;
      value = static_cast<T>(number);
    }
  }
  return true;
}

std::optional<ItemValue> fromJson(const JsonTree& json, const ItemValue& type) {
  return std::visit(
      [&](auto value) -> std::optional<ItemValue> {
        using T = decltype(value);
        if constexpr (IsArray<T>::value) {
          if (!json.is_array()) return std::nullopt;
          value.clear();
          for (const JsonTree& element : json) {
            typename T::value_type scalar{};
            if (!assign(element, scalar)) return std::nullopt;
            value.push_back(scalar);
          }
        } else if (!assign(json, value)) {
          return std::nullopt;
        }
        return ItemValue(std::move(value));
      },
      type);
}

template <class T>
constexpr std::size_t binarySize() {
  return std::is_same_v<T, bool> ? 1 : sizeof(T);
}

template <class T>
bool assignBinary(std::string_view bytes, T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    value = bytes;
  } else {
    if (bytes.size() != binarySize<T>()) return false;
    if constexpr (std::is_same_v<T, bool>) {
      value = bytes.front() != '\0';
    } else {
      value = readNumber<T>(bytes);
      if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
    }
  }
  return true;
}

std::vector<std::string_view> binaryElements(std::string_view bytes, std::size_t size) {
  std::vector<std::string_view> elements;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(size, bytes.size()))) {
    elements.push_back(bytes.substr(0, size));
  }
  return elements;
}

std::vector<std::string_view> separatedElements(std::string_view bytes) {
  std::vector<std::string_view> elements;
  while (true) {
    const std::size_t end = bytes.find(kBinarySeparator);
    elements.push_back(bytes.substr(0, end));
    if (end == std::string_view::npos) return elements;
    bytes.remove_prefix(end + kBinarySeparator.size());
  }
}

std::optional<ItemValue> fromBinary(std::string_view bytes, const ItemValue& type) {
  return std::visit(
      [&](auto value) -> std::optional<ItemValue> {
        using T = decltype(value);
        if constexpr (IsArray<T>::value) {
          using Element = typename T::value_type;
          value.clear();
          for (const std::string_view element : std::is_same_v<Element, std::string>
                                                    ? separatedElements(bytes)
                                                    : binaryElements(bytes, binarySize<Element>())) {
            Element scalar{};
            if (!assignBinary(element, scalar)) return std::nullopt;
            value.push_back(std::move(scalar));
          }
        } else if (!assignBinary(bytes, value)) {
          return std::nullopt;
        }
        return ItemValue(std::move(value));
      },
      type);
}

}  // namespace

std::size_t elementCount(const ItemValue& value) {
  return std::visit(
      [](const auto& held) -> std::size_t {
        if constexpr (IsArray<std::decay_t<decltype(held)>>::value) return held.size();
        return 1;
      },
      value);
}

std::string encodeValue(ItemFormat format, const ItemValue& value) {
  return std::visit(
      [&](const auto& held) {
        if constexpr (IsArray<std::decay_t<decltype(held)>>::value) {
          return arrayText(format, held);
        } else {
          return scalarText(format, held);
        }
      },
      value);
}

std::optional<ItemValue> parseValue(ItemFormat format, std::string_view bytes, const ItemValue& type) {
  if (format == ItemFormat::Binary) return fromBinary(bytes, type);
  const std::optional<JsonTree> json = format == ItemFormat::Json ? parseJson(bytes) : readStringValue(bytes);
  return json ? fromJson(*json, type) : std::nullopt;
}

}  // namespace cobot_command::protocol
