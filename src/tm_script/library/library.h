// The general functions of the language, by the chapters of the manual, and what they share.
//
// They get arguments of exactly the declared types, fewer where parameters may be left out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::tm_script {

void defineByteFunctions(FunctionTable& table);      ///< 2.1-2.10, bytes to numbers and texts
void defineStringFunctions(FunctionTable& table);    ///< 2.11-2.22
void defineArrayFunctions(FunctionTable& table);     ///< 2.23-2.31
void defineTextFunctions(FunctionTable& table);      ///< 2.32 on: values as bytes and texts, tokens
void defineChecksumFunctions(FunctionTable& table);  ///< XOR8 to CRC32, ListenPacket
void defineMathematics(FunctionTable& table);        ///< 3
void definePoseFunctions(FunctionTable& table);      ///< 3, dist to points2coord

using Computed = Result<Value, std::string>;

/// In every TMflow that the simulator knows.
inline constexpr Version kSinceEver{1, 68};

// The argument at a place; its type must be that of the declaration.
template <class T>
[[nodiscard]] const T& scalarAt(const Arguments& arguments, std::size_t place) {
  return std::get<T>(std::get<Scalar>(arguments[place]));
}
[[nodiscard]] inline const std::string& textAt(const Arguments& arguments, std::size_t place) {
  return scalarAt<std::string>(arguments, place);
}
[[nodiscard]] inline int intAt(const Arguments& arguments, std::size_t place, int left_out) {
  return place < arguments.size() ? scalarAt<std::int32_t>(arguments, place) : left_out;
}
[[nodiscard]] inline const Array& arrayAt(const Arguments& arguments, std::size_t place) {
  return std::get<Array>(arguments[place]);
}
template <class T>
[[nodiscard]] std::vector<T> itemsAt(const Arguments& arguments, std::size_t place) {
  std::vector<T> items;
  for (const Scalar& item : arrayAt(arguments, place).items) items.push_back(std::get<T>(item));
  return items;
}
template <class T>
[[nodiscard]] Array arrayOf(const std::vector<T>& items) {
  return {static_cast<ScalarType>(Scalar(T{}).index()), {items.begin(), items.end()}};
}

using Bytes = std::vector<std::uint8_t>;
[[nodiscard]] Bytes bytesOf(const std::string& text);
[[nodiscard]] std::string textOf(const Bytes& bytes);
/// Little endian, a text as it is.
[[nodiscard]] Bytes bytesOf(const Scalar& scalar);
/// Two hexadecimal digits each.
[[nodiscard]] std::string hexOf(const Bytes& bytes);

}  // namespace cobot_command::tm_script
