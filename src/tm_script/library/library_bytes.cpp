// Numbers and texts out of bytes.
#include <algorithm>
#include <cstring>

#include "library/library.h"

namespace cobot_command::tm_script {

namespace {

constexpr int kBigEndian = 1;
enum Encoding { Utf8 = 0, Hex = 1, Ascii = 2 };

/// The number at a place; bytes that are missing are 0.
template <class Number>
Number numberAt(const Bytes& bytes, std::size_t first, int endian) {
  Bytes own(sizeof(Number), 0);
  for (std::size_t i = 0; i < own.size() && first + i < bytes.size(); ++i) own[i] = bytes[first + i];
  if (endian == kBigEndian) std::reverse(own.begin(), own.end());
  Number number{};
  std::memcpy(&number, own.data(), sizeof(number));
  return number;
}

template <class Number>
std::vector<Number> numbersOf(const Bytes& bytes, int endian) {
  std::vector<Number> numbers;
  for (std::size_t first = 0; first < bytes.size(); first += sizeof(Number)) {
    numbers.push_back(numberAt<Number>(bytes, first, endian));
  }
  return numbers;
}

template <class Number>
Builtin one() {
  return [](const Arguments& arguments) -> Computed {
    return Scalar(numberAt<Number>(itemsAt<std::uint8_t>(arguments, 0), 0, intAt(arguments, 1, 0)));
  };
}

template <class Number>
Builtin many() {
  return [](const Arguments& arguments) -> Computed {
    return arrayOf(numbersOf<Number>(itemsAt<std::uint8_t>(arguments, 0), intAt(arguments, 1, 0)));
  };
}

/// Signed unless the third argument is 1.
int int16Of(std::uint16_t bits, const Arguments& arguments) {
  return intAt(arguments, 2, 0) == 1 ? int{bits} : int{static_cast<std::int16_t>(bits)};
}

Computed int16(const Arguments& arguments) {
  const auto bits = numberAt<std::uint16_t>(itemsAt<std::uint8_t>(arguments, 0), 0, intAt(arguments, 1, 0));
  return Scalar(int16Of(bits, arguments));
}

Computed int16s(const Arguments& arguments) {
  std::vector<std::int32_t> numbers;
  for (const auto bits :
       numbersOf<std::uint16_t>(itemsAt<std::uint8_t>(arguments, 0), intAt(arguments, 1, 0))) {
    numbers.push_back(int16Of(bits, arguments));
  }
  return arrayOf(numbers);
}

Computed string(const Arguments& arguments) {
  Bytes bytes = itemsAt<std::uint8_t>(arguments, 0);
  const int encoding = intAt(arguments, 1, Utf8);
  if (encoding == Hex) return Scalar(hexOf(bytes));
  if (encoding != Utf8 && encoding != Ascii) return refuse(std::string("the encoding is 0, 1 or 2"));
  bytes.erase(std::find(bytes.begin(), bytes.end(), 0), bytes.end());
  if (encoding == Ascii) {
    std::replace_if(
        bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte > 0x7F; }, '?');
  }
  return Scalar(textOf(bytes));
}

Computed concat(const Arguments& arguments) {
  Bytes bytes = itemsAt<std::uint8_t>(arguments, 0);
  const Bytes more = itemsAt<std::uint8_t>(arguments, 1);
  const int length = intAt(arguments, 2, -1);
  const std::size_t taken =
      length < 0 ? more.size() : std::min(more.size(), static_cast<std::size_t>(length));
  bytes.insert(bytes.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(taken));
  return arrayOf(bytes);
}

Computed concatOne(const Arguments& arguments) {
  Bytes bytes = itemsAt<std::uint8_t>(arguments, 0);
  bytes.push_back(scalarAt<std::uint8_t>(arguments, 1));
  return arrayOf(bytes);
}

}  // namespace

void defineByteFunctions(FunctionTable& table) {
  table.define("int Byte_ToInt16(byte[], int?, int?)", kSinceEver, int16);
  table.define("int Byte_ToInt32(byte[], int?)", kSinceEver, one<std::int32_t>());
  table.define("float Byte_ToFloat(byte[], int?)", kSinceEver, one<float>());
  table.define("double Byte_ToDouble(byte[], int?)", kSinceEver, one<double>());
  table.define("int[] Byte_ToInt16Array(byte[], int?, int?)", kSinceEver, int16s);
  table.define("int[] Byte_ToInt32Array(byte[], int?)", kSinceEver, many<std::int32_t>());
  table.define("float[] Byte_ToFloatArray(byte[], int?)", kSinceEver, many<float>());
  table.define("double[] Byte_ToDoubleArray(byte[], int?)", kSinceEver, many<double>());
  table.define("string Byte_ToString(byte[], int?)", kSinceEver, string);
  table.define("byte[] Byte_Concat(byte[], byte)", kSinceEver, concatOne);
  table.define("byte[] Byte_Concat(byte[], byte[], int?)", kSinceEver, concat);
}

}  // namespace cobot_command::tm_script
