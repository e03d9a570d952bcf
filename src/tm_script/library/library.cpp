#include "library/library.h"

#include <cstring>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::tm_script {

Bytes bytesOf(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string textOf(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

Bytes bytesOf(const Scalar& scalar) {
  return std::visit(Overloaded{[](const std::string& text) { return bytesOf(text); },
                               [](const auto& number) {  // the machine is little endian, as is the controller
                                 Bytes bytes(sizeof(number));
                                 std::memcpy(bytes.data(), &number, sizeof(number));
                                 return bytes;
                               }},
                    scalar);
}

std::string hexOf(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
  return text;
}

}  // namespace cobot_command::tm_script
