#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

#include "item_json.h"
#include "item_string.h"
#include "little_endian.h"
#include <fmt/format.h>

#include "cobot_command/protocol/item_content.h"

namespace cobot_command::protocol {

namespace {

constexpr std::string_view kBinarySeparator("\0\0", 2);  // between the elements of string[]

template <class T>
struct IsArray : std::false_type {};
template <class T>
struct IsArray<std::vector<T>> : std::true_type {};

// --- To the wire -------------------------------------------------------------------------------------------

std::size_t binarySize(const std::string& text) {
  return text.size();
}
template <class Number>
std::size_t binarySize(Number) {
  return sizeof(Word<Number>);
}
template <class T>
std::size_t binarySize(const std::vector<T>& values) {
  if constexpr (std::is_same_v<T, std::string>) {
    std::size_t size = values.empty() ? 0 : (values.size() - 1) * kBinarySeparator.size();
    for (const std::string& text : values) size += text.size();
    return size;
  } else {
    return values.size() * sizeof(Word<T>);
  }
}

// Each writes binarySize() bytes, and gives the place behind them.
char* writeBinary(char* place, std::string_view text) {
  return std::copy(text.begin(), text.end(), place);
}
template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
char* writeBinary(char* place, Number number) {
  writeNumber(place, number);
  return place + sizeof(Word<Number>);
}
template <class T>
char* writeBinary(char* place, const std::vector<T>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && std::is_same_v<T, std::string>) place = writeBinary(place, kBinarySeparator);
    place = writeBinary(place, static_cast<const T&>(values[i]));
  }
  return place;
}

/// As a captured controller writes them: with so many digits where these make the same number, else with two
/// more, which always do.
template <class Real>
constexpr int kUsualDigits = std::numeric_limits<Real>::digits10 + (std::is_same_v<Real, float> ? 1 : 0);

/// Without ".0"; finite.
template <class Real>
std::string realText(Real value) {
  if (value == 0) return "0";  // also of -0
  std::string text = fmt::format("{:.{}g}", value, kUsualDigits<Real>);
  Real read{};
  std::from_chars(text.data(), text.data() + text.size(), read);
  if (read != value) text = fmt::format("{:.{}g}", value, kUsualDigits<Real> + 2);
  std::replace(text.begin(), text.end(), 'e', 'E');
  return text;
}

template <class T>
std::string jsonText(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return toText(JsonTree(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(value)) return "null";
    const std::string text = realText(value);
    return text.find_first_of(".E") == std::string::npos ? text + ".0" : text;
  } else {
    return JsonTree(value).dump();
  }
}

template <class T>
std::string stringText(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return inQuotes(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value) ? realText(value) : "null";
  } else {
    return jsonText(value);
  }
}

template <class T>
std::string scalarText(ItemFormat format, const T& value) {
  return format == ItemFormat::String ? stringText(value) : jsonText(value);
}

template <class T>
std::string arrayText(ItemFormat format, const std::vector<T>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += scalarText<T>(format, values[i]);
  }
  return format == ItemFormat::String ? '{' + text + '}' : '[' + text + ']';
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

bool appendBinaryItem(std::string& content, std::string_view name, const ItemValue& value) {
  assert(!name.empty());
  return std::visit(
      [&](const auto& held) {
        const std::size_t size = binarySize(held);
        if (size > kMaxItemBytes) return false;
        // The fields of encodeBinaryItems(), in one go: a status stream writes fifty of them in each frame. A
        // small one is put together beside the content, which then need not be filled with zeros first.
        const auto write = [&](char* place) {
          place = writeBinary(place, static_cast<std::uint16_t>(name.size()));
          place = writeBinary(place, name);
          writeBinary(writeBinary(place, static_cast<std::uint16_t>(size)), held);
        };
        const std::size_t whole = 2 * sizeof(std::uint16_t) + name.size() + size;
        std::array<char, 96> beside;
        if (whole <= beside.size()) {
          write(beside.data());
          content.append(beside.data(), whole);
        } else {
          content.resize(content.size() + whole);
          write(content.data() + content.size() - whole);
        }
        return true;
      },
      value);
}

std::string encodeValue(ItemFormat format, const ItemValue& value) {
  return std::visit(
      [&](const auto& held) -> std::string {
        if (format == ItemFormat::Binary) {
          std::string bytes(binarySize(held), '\0');
          writeBinary(bytes.data(), held);
          return bytes;
        }
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
